"""Manifests and results in columns."""

import json
import shutil
import subprocess
from pathlib import Path

import parkade
import pyarrow.parquet as pq
import pytest
from parkade import batch

ROOT = Path(__file__).parents[2]
FAMILIES = [{"family": "random", "size": 15, "seed": seed} for seed in range(12)]


def test_a_sweep_is_all_combinations():
    assert batch.sweep(margin=[0.03, 0.1], reverseCost=[1, 2]) == [
        {"margin": 0.03, "reverseCost": 1},
        {"margin": 0.03, "reverseCost": 2},
        {"margin": 0.1, "reverseCost": 1},
        {"margin": 0.1, "reverseCost": 2},
    ]
    assert batch.sweep() == [{}]


def test_a_manifest_is_planned_in_parts_and_goes_on_where_it_stopped(tmp_path):
    tasks = batch.manifest(FAMILIES, ["four", "eight"])
    assert tasks.num_rows == 24
    assert len(set(tasks["key"].to_pylist())) == 24
    whole = batch.plan_table(tasks)
    first = batch.plan_table(tasks.slice(0, 7))
    batch.write(first, tmp_path / "first.parquet")
    rest = batch.remaining(tasks, batch.read(tmp_path / "first.parquet"))
    assert rest.num_rows == 17
    batch.write(batch.plan_table(rest), tmp_path / "rest.parquet")
    both = batch.read(tmp_path / "rest.parquet", tmp_path / "first.parquet")
    assert batch.remaining(tasks, both).num_rows == 0
    assert batch.digest(both) == batch.digest(whole)
    assert batch.digest(first) != batch.digest(whole)


def test_results_are_those_of_single_plans():
    scenes = {name: parkade.scenario(name) for name in ("perpendicular", "parallel")}
    settings = batch.sweep(margin=[0.03, 0.1])
    rows = batch.plan_table(batch.manifest(scenes, ["hybrid"], settings)).to_pylist()
    assert len(rows) == 4
    for row in rows:
        plan = parkade.plan(scenes[row["scene"]], row["planner"], json.loads(row["settings"]))
        assert row["hash"] == plan.hash
        assert row["length"] == plan.metrics["length"]
        assert row["expanded"] == plan.stats["expanded"]
        assert row["verdict"] == "ok"
        assert row["seconds"] > 0
    assert len({row["hash"] for row in rows}) > 2


def test_refused_scenes_are_results():
    scene = json.dumps({**parkade.scenario("perpendicular"), "vehicle": "lorri"})
    (row,) = batch.plan_table(batch.manifest({"wrong": scene}, ["hybrid"])).to_pylist()
    assert row["outcome"] is None
    assert row["error_code"] == "bad-vehicle"
    assert row["error_path"] == "vehicle"


def test_wrong_batches_are_answered_by_a_sentence(tmp_path):
    def refused(call):
        with pytest.raises(parkade.ParkadeError) as raised:
            call()
        return str(raised.value)

    assert "margin: must be a list of values, got 0.1" in refused(lambda: batch.sweep(margin=0.1))
    assert "did you mean margin?" in refused(lambda: batch.manifest(FAMILIES, ["hybrid"], [{"margn": 1}]))
    assert "did you mean hybrid?" in refused(lambda: batch.manifest(FAMILIES, ["hybrd"]))
    assert "dicts of family, size and seed" in refused(lambda: batch.manifest([{"seed": 1}]))
    assert "family" in refused(lambda: batch.manifest([{"family": "x", "size": 9, "seed": 1}]))
    assert "key: missing column" in refused(lambda: batch.plan_table(batch.manifest(FAMILIES).drop(["key"])))
    pq.write_table(batch.manifest(FAMILIES), tmp_path / "tasks.parquet")
    assert "must be results of version 1, got another file" in refused(lambda: batch.read(tmp_path / "tasks.parquet"))
    assert "files: must name a file" in refused(batch.read)
    changed = batch.manifest(FAMILIES).slice(0, 1).to_pylist()[0] | {"seed": 99}
    (row,) = batch.plan_table(batch.pa.Table.from_pylist([changed], batch.MANIFEST)).to_pylist()
    assert row["error_message"].startswith("scene_hash: must be that of the scene")


@pytest.mark.skipif(
    not (ROOT / "pkg/cli/main.js").exists() or not shutil.which("node"), reason="the npm package is not built"
)
def test_keys_hashes_and_the_digest_are_the_commands(tmp_path):
    scenes = {f"{tmp_path}/{name}.json": json.dumps(parkade.scenario(name)) for name in ("perpendicular", "parallel")}
    for name, text in scenes.items():
        Path(name).write_text(text)
    command = [
        "node",
        ROOT / "pkg/cli/main.js",
        "batch",
        tmp_path,
        "--set",
        "margin=0.05",
        "--planner",
        "hybrid,hybrid-forward",
    ]
    out = tmp_path / "results.jsonl"
    done = subprocess.run([*command, "--out", out, "--quiet"], capture_output=True, text=True, check=True)
    expected = {one["key"]: one["hash"] for one in map(json.loads, out.read_text().splitlines())}
    results = batch.plan_table(batch.manifest(scenes, ["hybrid", "hybrid-forward"], [{"margin": 0.05}]))
    assert dict(zip(results["key"].to_pylist(), results["hash"].to_pylist(), strict=True)) == expected
    assert batch.digest(results) in done.stdout

    def run(*arguments):
        return subprocess.run(
            ["node", ROOT / "pkg/cli/main.js", *arguments], capture_output=True, text=True, check=True
        )

    columns = tmp_path / "node.parquet"
    run("columns", out, "--out", columns)
    theirs = sorted(batch.read(columns).to_pylist(), key=lambda row: row["key"])
    ours = sorted(results.to_pylist(), key=lambda row: row["key"])
    # Memory is what a platform's arrays have; seconds are measured here alone.
    measured = ("seconds", "memory_bytes")
    for row, other in zip(ours, theirs, strict=True):
        assert {name: row[name] for name in batch.SCHEMA.names if name not in measured} == {
            name: other[name] for name in batch.SCHEMA.names if name not in measured
        }
    batch.write(results, tmp_path / "python.parquet")
    said = run("report", tmp_path / "python.parquet", "--out", tmp_path / "report.html")
    assert "4 results of 2 planners with settings" in said.stdout
    assert "Time, s" in (tmp_path / "report.html").read_text()
