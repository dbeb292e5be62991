"""Scenes from occupancy grids: NumPy arrays and ROS messages in, ROS paths out.

No ROS is needed: messages are objects with the fields of `nav_msgs`, as rclpy has them, or dictionaries of these.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._errors import ParkadeError
from ._plan import Plan

#: Largest number of cells on a side of the map.
MAX_CELLS = 4096
#: `nav_msgs/OccupancyGrid` counts a cell as occupied from here on, as `map_server` does by default.
OCCUPIED = 65
#: A turn of the map's origin below this is rounding, radians.
NO_TURN = 1e-6


def from_occupancy(
    blocked: ArrayLike,
    *,
    resolution: float,
    start: Any,
    goal: Any,
    origin: Sequence[float] = (0.0, 0.0),
    vehicle: str | Mapping[str, Any] = "sedan",
    name: str | None = None,
) -> dict[str, Any]:
    """A scene from a two-dimensional array that is true (or not 0) where a cell is blocked.

    Row 0 is the southern one and column 0 the western one; `origin` is the lower left corner of that cell, metres.
    Pictures have their first row in the north: pass `picture[::-1]`. `start` and `goal` are poses: (x, y, heading),
    a dictionary of these, or a ROS pose.
    """
    cells = np.asarray(blocked)
    if cells.ndim != 2 or not 0 < cells.shape[0] <= MAX_CELLS or not 0 < cells.shape[1] <= MAX_CELLS:
        rule = (
            f"must be a two-dimensional array of at most {MAX_CELLS} × {MAX_CELLS} cells, got the shape {cells.shape}"
        )
        raise ParkadeError(f"blocked: {rule}", "bad-input", "blocked")
    if cells.dtype.kind not in "biuf":
        rule = f"must hold booleans or numbers, got the type {cells.dtype}"
        raise ParkadeError(f"blocked: {rule}", "bad-input", "blocked")
    if cells.dtype.kind == "f" and np.isnan(cells).any():
        raise ParkadeError("blocked: must be numbers, got NaN: which cells are blocked?", "bad-input", "blocked")
    scene: dict[str, Any] = {
        "version": 1,
        "map": {
            "origin": _origin(origin),
            "width": int(cells.shape[1]),
            "height": int(cells.shape[0]),
            "resolution": _positive(resolution, "resolution"),
        },
        "obstacles": [{"type": "cells", "runs": _runs(cells != 0).tolist()}],
        "vehicle": vehicle,
        "start": _pose(start, "start"),
        "goal": goal if isinstance(goal, Mapping) and "slot" in goal else _pose(goal, "goal"),
    }
    return scene if name is None else {**scene, "name": name}


def from_occupancy_grid(
    message: Any,
    *,
    start: Any,
    goal: Any,
    occupied: int = OCCUPIED,
    unknown_is_blocked: bool = True,
    vehicle: str | Mapping[str, Any] = "sedan",
) -> dict[str, Any]:
    """A scene from a `nav_msgs/OccupancyGrid`; cells from `occupied` (0 to 100) on are blocked.

    A map that is turned against its frame is refused: scenes have none.
    """
    info = _field(message, "info", "message")
    width, height = (_count(_field(info, name, "info"), f"info.{name}") for name in ("width", "height"))
    try:
        data = np.asarray(_field(message, "data", "message"), dtype=np.int64)
    except (TypeError, ValueError, OverflowError):
        raise ParkadeError("data: must be a list of whole numbers", "bad-input", "data") from None
    if not isinstance(occupied, int):
        raise ParkadeError(f"occupied: must be a whole number, got {occupied!r:.60}", "bad-input", "occupied")
    if data.size != width * height:
        rule = f"must have width × height = {width * height} cells, got {data.size}"
        raise ParkadeError(f"data: {rule}", "bad-input", "data")
    origin = _pose(_field(info, "origin", "info"), "info.origin")
    if abs(origin["heading"]) > NO_TURN:
        rule = f"must not be turned, got {origin['heading']:.6f} rad: rotate the map before"
        raise ParkadeError(f"info.origin.orientation: {rule}", "bad-input", "info.origin.orientation")
    blocked = data >= occupied
    if unknown_is_blocked:
        blocked |= data < 0
    return from_occupancy(
        blocked.reshape(height, width),
        resolution=_positive(_field(info, "resolution", "info"), "info.resolution"),
        origin=(origin["x"], origin["y"]),
        start=start,
        goal=goal,
        vehicle=vehicle,
    )


def to_path(plan: Plan, *, frame_id: str = "map", stamp: tuple[int, int] = (0, 0)) -> dict[str, Any]:
    """A plan as a `nav_msgs/Path` dictionary; `stamp` is seconds and nanoseconds.

    Headings are the car's, also where it drives backwards; `plan.directions` says where it does.
    """
    if not plan.found:
        raise ParkadeError(f"plan: must have a path, got {plan.outcome}: {plan.reason}", "bad-input", "plan")
    try:
        sec, nanosec = (int(part) for part in stamp)
    except (TypeError, ValueError):
        raise ParkadeError(f"stamp: must be (seconds, nanoseconds), got {stamp!r:.60}", "bad-input", "stamp") from None

    def header() -> dict[str, Any]:
        return {"stamp": {"sec": sec, "nanosec": nanosec}, "frame_id": frame_id}

    def pose(x: float, y: float, heading: float) -> dict[str, Any]:
        turn = {"x": 0.0, "y": 0.0, "z": math.sin(heading / 2), "w": math.cos(heading / 2)}
        return {"header": header(), "pose": {"position": {"x": x, "y": y, "z": 0.0}, "orientation": turn}}

    return {"header": header(), "poses": [pose(*row) for row in plan.path.tolist()]}


def _runs(blocked: NDArray[np.bool_]) -> NDArray[np.int64]:
    """Runs of blocked cells: column of the first, row, number of cells eastward."""
    edges = np.diff(np.pad(blocked.astype(np.int8), ((0, 0), (1, 1))), axis=1)
    rows, first = np.nonzero(edges == 1)
    _, after = np.nonzero(edges == -1)
    return np.stack([first, rows, after - first], axis=1)


def _field(message: Any, name: str, path: str) -> Any:
    found = message.get(name) if isinstance(message, Mapping) else getattr(message, name, None)
    if found is None:
        raise ParkadeError(
            f"{path}: must have the field {name} (nav_msgs/OccupancyGrid), got {message!r:.60}", "bad-input", path
        )
    return found


def _positive(value: Any, path: str) -> float:
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = math.nan
    if not 0 < number < math.inf:
        raise ParkadeError(f"{path}: must be a number above 0, got {value!r:.60}", "bad-input", path)
    return number


def _count(value: Any, path: str) -> int:
    if isinstance(value, (int, np.integer)) and value >= 0:
        return int(value)
    raise ParkadeError(f"{path}: must be a whole number of cells, got {value!r:.60}", "bad-input", path)


def _origin(value: Any) -> list[float]:
    try:
        x, y = (float(part) for part in value)
    except (TypeError, ValueError):
        raise ParkadeError(f"origin: must be (x, y) in metres, got {value!r:.60}", "bad-input", "origin") from None
    return [x, y]


def _pose(value: Any, path: str) -> dict[str, float]:
    """A pose from (x, y, heading), a dictionary of these, a geometry_msgs/Pose or a PoseStamped."""

    def part(of: Any, name: str) -> Any:
        return of.get(name) if isinstance(of, Mapping) else getattr(of, name, None)

    inner = part(value, "pose")
    value = value if inner is None else inner
    place, turn = part(value, "position"), part(value, "orientation")
    try:
        if place is not None and turn is not None:
            x, y, z, w = (float(part(turn, name)) for name in ("x", "y", "z", "w"))
            heading = math.atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
            return {"x": float(part(place, "x")), "y": float(part(place, "y")), "heading": heading}
        numbers = [part(value, name) for name in ("x", "y", "heading")] if isinstance(value, Mapping) else list(value)
        pose_x, pose_y, heading = (float(number) for number in numbers)
    except (TypeError, ValueError):
        rule = f"must be (x, y, heading), a dictionary of these or a geometry_msgs/Pose, got {value!r:.60}"
        raise ParkadeError(f"{path}: {rule}", "bad-input", path) from None
    return {"x": pose_x, "y": pose_y, "heading": heading}
