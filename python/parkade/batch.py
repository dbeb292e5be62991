"""Many plans in columns: manifests, results as Arrow tables and Parquet files, for one machine or a cluster.

A manifest has a row per task: scene, planner and settings. `plan_table` turns manifest rows into result rows; Ray,
Dask and plain loops call it on as many rows as they like. Results have the columns of `SCHEMA`, whoever wrote them.
"""

from __future__ import annotations

import hashlib
import itertools
import json
import os
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from . import _native
from ._errors import ParkadeError
from ._plan import Planner, Scene

try:
    import pyarrow as pa
    import pyarrow.compute as pc
    import pyarrow.parquet as pq
except ImportError as error:
    raise ImportError("parkade.batch needs pyarrow: pip install 'parkade[parquet]'") from error

#: Version of the columns; a new column keeps it, another meaning does not.
VERSION = 1
#: Key of the version in a file's metadata.
MARK = b"parkade.results"

#: The columns of results.
SCHEMA = pa.schema(
    [
        pa.field("key", pa.string(), nullable=False),
        pa.field("scene", pa.string(), nullable=False),
        pa.field("scene_hash", pa.string()),
        pa.field("seed", pa.int64()),
        pa.field("planner", pa.string(), nullable=False),
        pa.field("settings", pa.string(), nullable=False),
        pa.field("version", pa.string(), nullable=False),
        pa.field("outcome", pa.string()),
        pa.field("detail", pa.string()),
        pa.field("verdict", pa.string()),
        pa.field("drivable", pa.bool_()),
        pa.field("length", pa.float64()),
        pa.field("direction_changes", pa.int64()),
        pa.field("max_curvature", pa.float64()),
        pa.field("min_clearance", pa.float64()),
        pa.field("mean_clearance", pa.float64()),
        pa.field("cost", pa.float64()),
        pa.field("expanded", pa.int64()),
        pa.field("generated", pa.int64()),
        pa.field("open_peak", pa.int64()),
        pa.field("collision_checks", pa.int64()),
        pa.field("memory_bytes", pa.int64()),
        pa.field("seconds", pa.float64()),
        pa.field("hash", pa.string()),
        pa.field("error_code", pa.string()),
        pa.field("error_path", pa.string()),
        pa.field("error_message", pa.string()),
    ],
    metadata={MARK: str(VERSION).encode()},
)

#: The columns of manifests. A scene is its JSON text, or a seeded family's, which takes no room.
MANIFEST = pa.schema(
    [
        pa.field("key", pa.string(), nullable=False),
        pa.field("scene", pa.string(), nullable=False),
        pa.field("scene_hash", pa.string(), nullable=False),
        pa.field("scene_json", pa.string()),
        pa.field("family", pa.string()),
        pa.field("size", pa.int64()),
        pa.field("seed", pa.int64()),
        pa.field("planner", pa.string(), nullable=False),
        pa.field("settings", pa.string(), nullable=False),
    ],
    metadata={b"parkade.manifest": str(VERSION).encode()},
)

#: Figures of results: the column, and where the plan has it.
FIGURES = {
    "length": ("metrics", "length"),
    "direction_changes": ("metrics", "directionChanges"),
    "max_curvature": ("metrics", "maxCurvature"),
    "min_clearance": ("metrics", "minClearance"),
    "mean_clearance": ("metrics", "meanClearance"),
    "cost": ("metrics", "cost"),
    "expanded": ("stats", "expanded"),
    "generated": ("stats", "generated"),
    "open_peak": ("stats", "openPeak"),
    "collision_checks": ("stats", "collisionChecks"),
    "memory_bytes": ("stats", "memoryBytes"),
}


def sweep(**values: Iterable[Any]) -> list[dict[str, Any]]:
    """All combinations of settings: `sweep(margin=[0.03, 0.1], reverseCost=[1, 2])` has four."""
    for name, some in values.items():
        if isinstance(some, (str, bytes)) or not isinstance(some, Iterable):
            raise ParkadeError(f"{name}: must be a list of values, got {some!r}", "bad-input", name)
    return [dict(zip(values, some, strict=True)) for some in itertools.product(*values.values())]


def manifest(
    scenes: Mapping[str, Scene] | Iterable[Mapping[str, Any]],
    planners: Sequence[str] = ("hybrid",),
    settings: Iterable[Mapping[str, Any]] = ({},),
) -> pa.Table:
    """A row per scene, planner and settings. Scenes are given by name, or as families: dicts of family, size and seed.

    Unknown planners, settings and families are refused here, before any machine starts.
    """
    written = [_canonical(one) for one in settings]
    for planner, some in itertools.product(planners, written):
        known = _native.default_config(planner)
        for name in json.loads(some):
            if name not in known:
                words = f'{planner} has no setting "{name}"; there are {", ".join(known)}'
                raise ParkadeError(words, "bad-config", name)
    rows: list[dict[str, Any]] = []
    for scene in _described(scenes):
        for planner, some in itertools.product(planners, written):
            key = key_of(scene["scene_hash"], planner, some)
            rows.append({**scene, "key": key, "planner": planner, "settings": some})
    return pa.Table.from_pylist(rows, MANIFEST)


def _described(scenes: Mapping[str, Scene] | Iterable[Mapping[str, Any]]) -> Iterator[dict[str, Any]]:
    if isinstance(scenes, Mapping):
        for name, scene in scenes.items():
            text = _text(scene)
            yield {"scene": name, "scene_hash": hash_of(text), "scene_json": text}
        return
    for given in scenes:
        if set(given) != {"family", "size", "seed"}:
            raise ParkadeError(f"scenes: must be named scenes, or dicts of family, size and seed, got {given!r:.80}")
        name = "{family}-{size}-{seed}".format(**given)
        yield {"scene": name, "scene_hash": hash_of(_generated(given)), **given}


def plan_table(rows: pa.Table) -> pa.Table:
    """Plans the rows of a manifest: one result each, also for scenes that are refused."""
    missing = [name for name in MANIFEST.names if name not in rows.column_names]
    if missing:
        raise ParkadeError(f"{missing[0]}: missing column; a manifest has {', '.join(MANIFEST.names)}", path=missing[0])
    return pa.Table.from_pylist([_planned(row) for row in rows.to_pylist()], SCHEMA)


def _planned(row: Mapping[str, Any]) -> dict[str, Any]:
    names = ("key", "scene", "scene_hash", "seed", "planner", "settings")
    result: dict[str, Any] = {**{name: row[name] for name in names}, "version": _native.VERSION}
    try:
        text = row["scene_json"] or _generated(row)
        if hash_of(text) != row["scene_hash"]:
            raise ParkadeError("scene_hash: must be that of the scene: it has changed since the manifest was made")
        started = time.perf_counter()
        plan = Planner(row["planner"], text, json.loads(row["settings"])).plan()
        result["seconds"] = time.perf_counter() - started
    except ParkadeError as error:
        return {**result, "error_code": error.code, "error_path": error.path, "error_message": str(error)}
    result.update(outcome=plan.outcome, detail=plan.detail, hash=plan.hash)
    result.update(verdict=plan.check["verdict"], drivable=plan.check["drivable"])
    for column, (group, name) in FIGURES.items():
        result[column] = getattr(plan, group).get(name)
    return result


def remaining(manifest: pa.Table, results: pa.Table) -> pa.Table:
    """The rows of a manifest that have no result yet."""
    done = pc.is_in(manifest["key"], value_set=results["key"].combine_chunks())
    return manifest.filter(pc.invert(done))


def digest(results: pa.Table) -> str:
    """One hash over results in any order, that of the command's `digest` for the same ones."""
    columns = (results[name].to_pylist() for name in ("key", "hash", "error_message"))
    return hash_of(
        "\n".join(sorted(f"{key} {plan or message or ''}" for key, plan, message in zip(*columns, strict=True)))
    )


def write(results: pa.Table, file: str | os.PathLike[str]) -> None:
    """Writes results as a Parquet file, which `parkade report` also reads."""
    pq.write_table(results.cast(SCHEMA), file, compression="snappy")


def read(*files: str | os.PathLike[str]) -> pa.Table:
    """Reads the results of Parquet files; columns that a later version added are left out."""
    tables = []
    for file in files:
        schema = pq.read_schema(file)
        version = (schema.metadata or {}).get(MARK)
        if version is None or int(version) > VERSION:
            got = "another file" if version is None else f"version {version.decode()}"
            raise ParkadeError(f"{os.fspath(file)}: must be results of version {VERSION}, got {got}", "bad-import")
        tables.append(pq.read_table(file, columns=SCHEMA.names).cast(SCHEMA))
    if not tables:
        raise ParkadeError("files: must name a file", "bad-input", "files")
    return pa.concat_tables(tables)


def key_of(scene_hash: str, planner: str, settings: str) -> str:
    """What identifies a result: scene, planner, settings and the package's version; the command's key."""
    entries = json.dumps(sorted([name, value] for name, value in json.loads(settings).items()), **COMPACT)
    return hash_of("\n".join([_native.VERSION, planner, entries, scene_hash]))


def hash_of(text: str) -> str:
    """Half a SHA-256, in hex."""
    return hashlib.sha256(text.encode()).hexdigest()[:32]


COMPACT: dict[str, Any] = {"separators": (",", ":"), "ensure_ascii": False}


def _canonical(settings: Mapping[str, Any]) -> str:
    return json.dumps(dict(sorted(settings.items())), **COMPACT)


def _text(scene: Scene) -> str:
    if isinstance(scene, str):
        return scene
    return scene.decode() if isinstance(scene, bytes) else _native.normalise(scene)


def _generated(given: Mapping[str, Any]) -> str:
    fields = {name: given[name] for name in ("family", "size", "seed")}
    return json.dumps(_native.generate_scenario(fields), sort_keys=True, **COMPACT)
