"""Planners and plans."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native

#: A scene: plain data as in `scenario.schema.json`, or its JSON text.
Scene = Mapping[str, Any] | str | bytes


@dataclasses.dataclass(frozen=True, slots=True, eq=False)
class Plan:
    """A planner's answer; SI units, angles in radians. Plans are equal if their hashes are.

    The dictionaries have the names of the JavaScript API and of the command's results.
    """

    planner: str
    #: "found", "no-path", "budget-spent", "start-blocked", "goal-blocked", "start-outside" or "goal-outside"
    outcome: str
    #: a finer word for the outcome
    detail: str | None
    #: a sentence for people, where there is no path
    reason: str | None
    #: poses from start to goal, at most 0.1 m apart: x, y, heading in each row
    path: NDArray[np.float64]
    #: per pose, the gear of the way to the next one, 1 or -1
    directions: NDArray[np.int8]
    #: per pose, the signed curvature of the way to the next one, 1/m; NaN at a corner
    curvatures: NDArray[np.float64]
    #: per pose, the distance from the body to the nearest obstacle, metres
    clearances: NDArray[np.float64]
    #: the planner's unprocessed path: x, y in each row
    raw_path: NDArray[np.float64]
    #: counters of the search
    stats: dict[str, Any]
    #: figures of the path
    metrics: dict[str, Any]
    #: the independent validator's verdict
    check: dict[str, Any]
    #: the goal that the path leads to, where the scene has several
    goal: dict[str, Any] | None
    #: hybrid A*: the search of its portfolio that answered
    member: dict[str, Any] | None
    #: the search's expansions, if asked for: arrays `cells` (indices) or `arcs` (x, y, heading, curvature, length)
    trace: dict[str, Any] | None
    #: hybrid A*'s other paths, if asked for
    alternatives: list[Plan]
    #: FNV-1a-64 over everything but words for people: equal wherever the same version plans the same scene
    hash: str

    @property
    def found(self) -> bool:
        """True if there is a path."""
        return self.outcome == "found"

    def to_dict(self) -> dict[str, Any]:
        """Plain data for `json.dumps`, with the names of the JavaScript API; NaN is None. Without the trace."""
        return {
            "planner": self.planner,
            "outcome": self.outcome,
            "detail": self.detail,
            "reason": self.reason,
            "path": self.path.ravel().tolist(),
            "directions": self.directions.tolist(),
            "curvatures": [None if np.isnan(k) else k for k in self.curvatures.tolist()],
            "clearances": self.clearances.tolist(),
            "rawPath": self.raw_path.ravel().tolist(),
            "stats": self.stats,
            "metrics": self.metrics,
            "check": self.check,
            "goal": self.goal,
            "member": self.member,
            "alternatives": [one.to_dict() for one in self.alternatives],
            "hash": self.hash,
        }

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Plan) and other.hash == self.hash

    def __hash__(self) -> int:
        return hash(self.hash)

    def __repr__(self) -> str:
        if not self.found:
            return f"<Plan {self.planner}: {self.outcome}, {self.reason}>"
        length, changes = self.metrics["length"], self.metrics["directionChanges"]
        gears = f"{changes} gear change{'' if changes == 1 else 's'}"
        return f"<Plan {self.planner}: found, {length:.2f} m, {gears}, check {self.check['verdict']}>"


class Planner:
    """A planner on one scene: settings checked once, map prepared once, memory reused between plans.

    Each thread needs a Planner of its own; planning lets other threads run.
    """

    __slots__ = ("_arguments", "_planner")

    def __init__(self, planner: str, scene: Scene, settings: Mapping[str, Any] | None = None) -> None:
        """Raises ParkadeError for an unknown planner and a wrong scene or setting."""
        self._arguments = (planner, scene, settings)
        self._planner = _native.Planner(planner, scene, settings)

    def plan(
        self,
        *,
        start: Mapping[str, Any] | None = None,
        goal: Mapping[str, Any] | None = None,
        trace: bool = False,
        prefer: str | None = None,
        alternatives: bool = False,
        stickiness: float = 0.0,
        on_progress: Callable[[int], object] | None = None,
    ) -> Plan:
        """Plans, and checks the answer; without `start` and `goal` between the scene's own.

        `start` and `goal` are poses (x, y, heading) or slots (slot, entry). `prefer` is what hybrid A* chooses its
        path by: "shortest", "fewest-changes", "widest" or "fastest". `on_progress` is told of the expansions so far;
        what it raises ends the search, as Ctrl-C does.
        """
        options = {
            "start": start,
            "goal": goal,
            "trace": trace,
            "prefer": prefer,
            "alternatives": alternatives,
            "stickiness": stickiness,
        }
        return _plan(self._planner.plan(options, on_progress))

    def layer(self, name: str, *, every: int = 1) -> NDArray[Any]:
        """A raster by its name, "occupancy", "clearance", "risk", …: row 0 is the map's southern one."""
        return self._planner.layer(name, every)

    def __reduce__(self) -> tuple[type[Planner], tuple[Any, ...]]:
        return Planner, self._arguments


def plan(scene: Scene, planner: str = "hybrid", settings: Mapping[str, Any] | None = None, **options: Any) -> Plan:
    """Plans a scene once; `options` are those of `Planner.plan`."""
    return Planner(planner, scene, settings).plan(**options)


def _plan(fields: dict[str, Any]) -> Plan:
    fields["alternatives"] = [_plan(one) for one in fields["alternatives"]]
    return Plan(**fields)


def as_dict(scene: Scene) -> dict[str, Any]:
    """A checked copy of a scene as plain data, all defaults written out."""
    checked: dict[str, Any] = json.loads(_native.normalise(scene))
    return checked
