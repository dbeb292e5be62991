"""Scenes: built in, generated, and read from files."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any

from . import _native
from ._plan import Scene


def planners() -> list[dict[str, Any]]:
    """All planners: id, family, titles, paper, and parameters with units, ranges, defaults and descriptions."""
    return _native.planners()


def default_config(planner: str) -> dict[str, Any]:
    """A planner's settings."""
    return _native.default_config(planner)


def scenarios() -> list[dict[str, Any]]:
    """All built-in scenes: id, group, titles and questions."""
    return _native.scenarios()


def scenario(id: str) -> dict[str, Any]:
    """A built-in scene."""
    return _native.scenario(id)


def generate_scenario(*, family: str, size: int, seed: int) -> dict[str, Any]:
    """A scene of a seeded family ("random", "clustered", …), `size` cells wide: the same in every language."""
    return _native.generate_scenario({"family": family, "size": size, "seed": seed})


def import_scene(
    files: Mapping[str, bytes] | Iterable[str | os.PathLike[str]], options: Mapping[str, Any] | None = None
) -> dict[str, Any]:
    """Reads files of another program that belong together: paths, or contents by name.

    Formats: MovingAI .map and .scen, ROS .yaml and .pgm, TPCAP .csv, scenes and lots as .json. The answer has
    `format`, `scenes`, `queries` (MovingAI's) and `notes`.
    """
    if isinstance(files, (str, os.PathLike)):
        files = [files]
    if isinstance(files, Mapping):
        pairs = [(str(name), bytes(content)) for name, content in files.items()]
    else:
        pairs = [(os.fspath(file), Path(file).read_bytes()) for file in files]
    return _native.import_scene(pairs, options)


def load(file: str | os.PathLike[str], *more: str | os.PathLike[str]) -> dict[str, Any]:
    """The first scene of a file, or of files that belong together: `import_scene(...)["scenes"][0]`."""
    first: dict[str, Any] = import_scene([file, *more])["scenes"][0]
    return first


def check_path(scene: Scene, path: Any, directions: Any = None) -> dict[str, Any]:
    """What the independent checker says of any path: rows of x, y, heading, and gears (1 or -1) between them."""
    return _native.check_path(scene, path, directions)
