"""Every misuse is answered by a sentence that names the field, the value and the rule."""

import copy

import numpy as np
import parkade
import pytest
from parkade import _native

SCENE = parkade.scenario("perpendicular")


def changed(path, value):
    scene = copy.deepcopy(SCENE)
    place = scene
    for step in path[:-1]:
        place = place[step]
    place[path[-1]] = value
    return scene


def occupancy(blocked=((0, 1), (0, 0)), **more):
    return parkade.from_occupancy(blocked, **{"resolution": 1, "start": (0, 0, 0), "goal": (1, 1, 0), **more})


def grid_message(**more):
    origin = {
        "position": {"x": 0, "y": 0},
        "orientation": {"x": 0, "y": 0, "z": more.pop("z", 0), "w": more.pop("w", 1)},
    }
    info = {"width": 2, "height": 1, "resolution": 1.0, "origin": origin, **more}
    return parkade.from_occupancy_grid({"info": info, "data": [0, 100]}, start=(0, 0, 0), goal=(1, 0, 0))


class Unequal:
    """Found where "path" is looked for, and raises when it is compared."""

    def __hash__(self):
        return hash("path")

    def __eq__(self, other):
        raise RuntimeError("no two are equal")


DRIVEN = {"path": [[4.0, 3.0, 0.0], [4.05, 3.0, 0.0]]}
nested = []
nested.append(nested)

CASES = [
    (lambda: parkade.plan("perpendicular"), "bad-scenario", "`parkade.scenario(id)` gives a built-in scene"),
    (lambda: parkade.plan("scenes/a.json"), "bad-scenario", "`parkade.load(file)` reads one"),
    (lambda: parkade.plan('{"version": 1,'), "bad-scenario", "not JSON: EOF"),
    (lambda: parkade.plan(b"\xff\xfe"), "bad-scenario", "not JSON"),
    (lambda: parkade.plan(None), "bad-scenario", "must be a dict or JSON text, got a NoneType"),
    (lambda: parkade.plan(7), "bad-scenario", "must be a dict or JSON text, got an int"),
    (lambda: parkade.plan([]), "bad-scenario", "must be a dict or JSON text, got a list"),
    (lambda: parkade.plan({}), "bad-scenario", "missing field"),
    (lambda: parkade.plan({1: 2}), "bad-scenario", "must have text as its keys, got an int"),
    (lambda: parkade.plan(SCENE, "hybird"), "unknown-planner", "did you mean hybrid?"),
    (lambda: parkade.plan(SCENE, "astar"), "unknown-planner", 'no planner "astar"; there are four, eight'),
    (lambda: parkade.plan(SCENE, "hybrid", {"margn": 1}), "bad-config", "did you mean margin?"),
    (lambda: parkade.plan(SCENE, "hybrid", {"margin": "wide"}), "bad-config", "margin: must be a number"),
    (lambda: parkade.plan(SCENE, "hybrid", {"margin": -1}), "bad-config", "margin: must be"),
    (lambda: parkade.plan(SCENE, "hybrid", {"margin": float("nan")}), "bad-config", "margin: must be a finite number"),
    (lambda: parkade.plan(SCENE, "hybrid", ["margin"]), "bad-config", "settings must be a dict or JSON text"),
    (lambda: parkade.plan(SCENE, "hybrid", "margin=1"), "bad-config", "settings must be a dict or JSON text"),
    (lambda: parkade.plan(SCENE, "hybrid", {"margin": object()}), "bad-config", "margin: must be plain data"),
    (lambda: parkade.plan(changed(["map", "width"], 0)), "bad-scenario", "map.width: must be"),
    (lambda: parkade.plan(changed(["map", "width"], 2.5)), "bad-scenario", "map.width: must be a whole number"),
    (
        lambda: parkade.plan(changed(["map", "width"], 10**30)),
        "bad-scenario",
        "map.width: must be a number, got an int",
    ),
    (lambda: parkade.plan(changed(["map", "widht"], 3)), "bad-scenario", "did you mean width?"),
    (
        lambda: parkade.plan(changed(["start", "x"], np.nan)),
        "bad-scenario",
        "start.x: must be a finite number, got NaN",
    ),
    (
        lambda: parkade.plan(changed(["start", "x"], np.inf)),
        "bad-scenario",
        "start.x: must be a finite number, got inf",
    ),
    (lambda: parkade.plan(changed(["start", "x"], "3")), "bad-scenario", 'start.x: must be a number, got "3"'),
    (lambda: parkade.plan(changed(["start", "x"], 1 + 2j)), "bad-scenario", "start.x: must be plain data"),
    (lambda: parkade.plan(changed(["start"], (1, 2, 3))), "bad-scenario", "start: must be an object"),
    (lambda: parkade.plan(changed(["obstacles"], {})), "bad-scenario", "obstacles: must be"),
    (lambda: parkade.plan(changed(["obstacles", 0], {"type": "rectangel"})), "bad-scenario", "obstacles[0]"),
    (lambda: parkade.plan(changed(["obstacles"], nested)), "bad-scenario", "must have at most 64 lists"),
    (lambda: parkade.plan(changed(["obstacles"], {1, 2})), "bad-scenario", "obstacles: must be plain data"),
    (lambda: parkade.plan(changed(["vehicle"], "seden")), "bad-vehicle", "did you mean sedan?"),
    (lambda: parkade.plan(changed(["version"], 2)), "bad-scenario", "version: must be"),
    (lambda: parkade.plan(changed(["name"], b"x")), "bad-scenario", "name: must be plain data"),
    (lambda: parkade.plan(changed(["goal"], {"slot": "none"})), "bad-scenario", "goal"),
    (lambda: parkade.Planner("hybrid", SCENE).plan(start={"x": 1}), "bad-input", "start.y: missing field"),
    (lambda: parkade.Planner("hybrid", SCENE).plan(start=[1, 2, 3]), "bad-input", "must be an object, got 1"),
    (lambda: parkade.plan(SCENE, goal={"slot": "x", "entry": "reverse-in"}), "bad-input", "goal.slot"),
    (lambda: parkade.Planner("hybrid", SCENE).plan(prefer="shortes"), "bad-input", "did you mean shortest?"),
    (lambda: parkade.Planner("hybrid", SCENE).plan(trace=1), "bad-input", "trace: must be true or false, got 1"),
    (lambda: parkade.Planner("hybrid", SCENE).plan(stickiness=2), "bad-input", "stickiness: must be between 0 and 1"),
    (lambda: parkade.Planner("eight", SCENE).plan(prefer="widest"), "bad-input", "eight finds one path"),
    (lambda: parkade.Planner("hybrid", SCENE).layer("clearence"), "bad-input", "clearance"),
    (lambda: parkade.Planner("hybrid", SCENE).layer("risk"), "bad-input", "risk"),
    (lambda: parkade.Planner("risk-field", SCENE).layer("risk", every=0), "bad-input", "every: must be"),
    (lambda: parkade.scenario("perpendiculer"), "unknown-scenario", "did you mean perpendicular?"),
    (lambda: parkade.default_config("x"), "unknown-planner", "there are four"),
    (lambda: parkade.generate_scenario(family="randm", size=20, seed=1), "bad-input", "family"),
    (lambda: parkade.generate_scenario(family="random", size=-5, seed=1), "bad-input", "size: must be"),
    (lambda: parkade.generate_scenario(family="random", size=20, seed=-1), "bad-input", "seed: must be"),
    (lambda: parkade.generate_scenario(family="random", size=20, seed="a"), "bad-input", "seed: must be"),
    (lambda: parkade.check_path(SCENE, [[1, 2]]), "bad-input", "path: must"),
    (lambda: parkade.check_path(SCENE, "path"), "bad-input", "path: must be numbers"),
    (lambda: parkade.check_path(SCENE, [[0, 0, np.nan]]), "bad-input", "path"),
    (lambda: parkade.check_path(SCENE, np.zeros((2, 3)), [0, 1]), "bad-input", "directions[0]: must be 1 or -1"),
    (lambda: parkade.check_path(SCENE, np.zeros((2, 3)), [1]), "bad-input", "directions"),
    (lambda: occupancy([1, 2]), "bad-input", "blocked: must be a two-dimensional array"),
    (lambda: occupancy(np.zeros((5000, 2))), "bad-input", "at most 4096 × 4096 cells, got the shape (5000, 2)"),
    (lambda: occupancy([["a"]]), "bad-input", "blocked: must hold booleans or numbers"),
    (lambda: occupancy([[np.nan]]), "bad-input", "which cells are blocked?"),
    (lambda: occupancy(start=(1, 2)), "bad-input", "start: must be (x, y, heading)"),
    (lambda: occupancy(goal="slot"), "bad-input", "goal: must be (x, y, heading)"),
    (lambda: occupancy(resolution=-1), "bad-input", "resolution: must be a number above 0, got -1"),
    (lambda: occupancy(resolution="fine"), "bad-input", "resolution: must be a number above 0, got 'fine'"),
    (lambda: occupancy(origin=(0,)), "bad-input", "origin: must be (x, y) in metres, got (0,)"),
    (lambda: occupancy(origin=None), "bad-input", "origin: must be (x, y) in metres"),
    (lambda: grid_message(width=3), "bad-input", "data: must have width × height = 3 cells, got 2"),
    (lambda: grid_message(z=1, w=0), "bad-input", "must not be turned, got 3.141593 rad: rotate the map before"),
    (lambda: grid_message(height=None), "bad-input", "info: must have the field height"),
    (lambda: parkade.from_occupancy_grid(3, start=0, goal=0), "bad-input", "message: must have the field info"),
    (lambda: parkade.optimise(SCENE, 7), "bad-input", "plan: must be a plan, a trajectory or a dict, got 7"),
    (lambda: parkade.optimise(SCENE, {}), "bad-input", "plan.path: missing field"),
    (
        lambda: _native.optimise(SCENE, {Unequal(): 1}, {}),
        "bad-input",
        "plan.path: cannot be read: RuntimeError: no two are equal",
    ),
    (lambda: parkade.optimise(SCENE, {"path": [1, 2]}), "bad-input", "plan.path: must be x, y, heading"),
    (lambda: parkade.optimise(SCENE, {"path": "way"}), "bad-input", "plan.path: must be numbers"),
    (lambda: parkade.optimise(SCENE, DRIVEN | {"directions": [2]}), "bad-input", "plan.directions[0]: must be 1 or -1"),
    (
        lambda: parkade.optimise(SCENE, parkade.plan(SCENE, "eight")),
        "bad-input",
        "must have no corners, turns on the spot",
    ),
    (lambda: parkade.optimise(SCENE, DRIVEN, sped=1), "bad-config", "did you mean speed?"),
    (lambda: parkade.optimise(SCENE, DRIVEN, speed=-1), "bad-config", "speed: must be"),
    (lambda: parkade.optimise(SCENE, DRIVEN, margin="wide"), "bad-config", "margin: must be a number"),
    (lambda: parkade.judge(SCENE, 7), "bad-input", "trajectory: must be a plan, a trajectory or a dict, got 7"),
    (lambda: parkade.judge(SCENE, "a,b\n1,2"), "bad-import", "must be one of t, x, y"),
    (lambda: parkade.judge(SCENE, ""), "bad-import", "must be a header, got an empty text"),
    (lambda: parkade.judge(SCENE, DRIVEN | {"t": [0]}), "bad-input", "t: must"),
    (lambda: parkade.judge(SCENE, DRIVEN, acceleration=0), "bad-config", "acceleration: must be"),
    (lambda: parkade.import_scene({"a.txt": b""}), "bad-import", "a.txt: must end in .map"),
    (lambda: parkade.import_scene({}), "bad-import", "files: must hold a file"),
    (lambda: parkade.import_scene({"a.map": b"x"}), "bad-import", "a.map:1"),
    (lambda: parkade.import_scene({"a.json": b"{}"}), "bad-import", "a.json"),
    (lambda: parkade.import_scene({"a.map": b"x"}, {"resolutoin": 1}), "bad-input", "resolutoin"),
]


@pytest.mark.parametrize("case", range(len(CASES)))
def test_wrong_input_is_answered_by_a_sentence(case):
    call, code, words = CASES[case]
    with pytest.raises(parkade.ParkadeError) as raised:
        call()
    error = raised.value
    assert isinstance(error, ValueError)
    assert words in str(error), str(error)
    assert error.code == code, str(error)
    assert len(str(error)) < 1000


def test_errors_name_the_field():
    with pytest.raises(parkade.ParkadeError) as raised:
        parkade.plan(changed(["obstacles", 0], {"type": "wall", "points": [[0, 0], [1, "a"]], "thickness": 0}))
    assert raised.value.path == "obstacles[0].points[1][1]"
    assert raised.value.code == "bad-scenario"
