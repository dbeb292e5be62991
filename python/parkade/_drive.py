"""Trajectories: what a car drives, second by second, and the referee's verdict."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _native
from ._errors import ParkadeError
from ._plan import Plan, Scene


@dataclasses.dataclass(frozen=True, slots=True, eq=False)
class Trajectory:
    """States of a drive, at most 0.05 s apart; SI units, angles in radians. The controls are constant between rows."""

    #: the time of each row, from 0
    t: NDArray[np.float64]
    #: poses: x, y, heading in each row
    path: NDArray[np.float64]
    #: distance driven, metres
    stations: NDArray[np.float64]
    #: m/s, negative backwards
    speeds: NDArray[np.float64]
    #: m/s²
    accelerations: NDArray[np.float64]
    #: angle of the front wheels
    steering: NDArray[np.float64]
    #: rad/s
    steering_rates: NDArray[np.float64]
    duration: float
    length: float
    #: "optimised", "continuous-curvature" or "stop-and-steer"
    stage: str
    #: the referee's verdict, as of `judge`
    check: dict[str, Any]
    #: equal wherever the same version optimises the same plan
    hash: str

    def to_csv(self) -> str:
        """The rows as `parkade judge` and the playground read them."""
        columns = [self.t, *self.path.T, self.speeds, self.steering, self.accelerations, self.steering_rates]
        rows = [",".join(map(repr, row)) for row in np.column_stack(columns).tolist()]
        return "\n".join(["t,x,y,theta,v,phi,a,omega", *rows]) + "\n"


Drivable = Plan | Trajectory | Mapping[str, Any]


def optimise(scene: Scene, plan: Drivable, **options: float) -> Trajectory:
    """The trajectory of a plan: the least time within the car's limits, at a distance from obstacles.

    `options` are `speed`, `acceleration`, `deceleration`, `steeringRate`, `lateralAcceleration` and `margin`. `plan` is
    a plan, or a dict with `path`, `directions` and `curvatures`. Raises ParkadeError where no car can drive it.
    """
    return Trajectory(**_native.optimise(scene, _columns(plan, "plan", "path", "directions", "curvatures"), options))


def judge(scene: Scene, trajectory: Drivable | str, **limits: float) -> dict[str, Any]:
    """The referee's verdict on a trajectory or a path, by the protocol of the public benchmarks.

    `trajectory` is a trajectory, a plan, CSV with a header, or a dict with `path` and, optional, `t`, `speeds` and
    `steering`, or `directions`. Without `t` a simulated car drives the path. `limits` are those of `optimise`.
    """
    if isinstance(trajectory, str):
        return _native.judge(scene, trajectory, limits)
    names = ("path", "t", "speeds", "steering", "directions")
    return _native.judge(scene, _columns(trajectory, "trajectory", *names), limits)


def _columns(value: Any, what: str, *names: str) -> dict[str, Any]:
    if isinstance(value, (Plan, Trajectory)):
        return {name: getattr(value, name, None) for name in names}
    if not isinstance(value, Mapping):
        raise ParkadeError(f"{what}: must be a plan, a trajectory or a dict, got {value!r:.60}", path=what)
    return {name: value.get(name) for name in names}
