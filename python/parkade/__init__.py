"""Vehicle path planners: grid A*, risk-field A*, hybrid A*.

The same core as the crate and the JavaScript package: equal input gives equal plans, and `Plan.hash` proves it.

>>> import parkade
>>> plan = parkade.plan(parkade.scenario("perpendicular"), "hybrid")
>>> plan.outcome, plan.path.shape[1]
('found', 3)
"""

from . import _native
from ._drive import Trajectory, judge, optimise
from ._errors import ParkadeError
from ._plan import Plan, Planner, Scene, as_dict, plan
from ._scenes import (
    check_path,
    default_config,
    generate_scenario,
    import_scene,
    load,
    planners,
    scenario,
    scenarios,
)
from .grid import from_occupancy, from_occupancy_grid, to_path

#: The version of the package, the crate and the npm package, which are published together.
__version__: str = _native.VERSION

__all__ = [
    "ParkadeError",
    "Plan",
    "Planner",
    "Scene",
    "Trajectory",
    "__version__",
    "as_dict",
    "check_path",
    "default_config",
    "from_occupancy",
    "from_occupancy_grid",
    "generate_scenario",
    "import_scene",
    "judge",
    "load",
    "optimise",
    "plan",
    "planners",
    "scenario",
    "scenarios",
    "to_path",
]
