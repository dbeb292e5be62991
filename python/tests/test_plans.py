"""Plans, arrays in and out, and the package's shape."""

import copy
import json
import pickle
import re
import signal
import threading
from pathlib import Path

import numpy as np
import parkade
import pytest

ROOT = Path(__file__).parents[2]
SCENE = parkade.scenario("perpendicular")


def test_a_plan_is_arrays_and_figures():
    plan = parkade.plan(SCENE, "hybrid", {"reverseCost": 1.5})
    poses = len(plan.path)
    assert plan.found
    assert plan.path.dtype == np.float64
    assert plan.path.shape == (poses, 3)
    assert plan.directions.dtype == np.int8
    assert set(plan.directions) <= {-1, 1}
    assert plan.curvatures.shape == plan.clearances.shape == plan.directions.shape == (poses,)
    assert plan.raw_path.shape[1] == 2
    steps = np.hypot(*np.diff(plan.path[:, :2], axis=0).T)
    assert steps.max() <= 0.1 + 1e-9
    assert plan.metrics["length"] == pytest.approx(steps.sum(), rel=1e-3)
    assert plan.metrics["directionChanges"] == np.count_nonzero(np.diff(plan.directions[:-1]))
    assert plan.metrics["minClearance"] == plan.clearances.min()
    assert plan.check["verdict"] == "ok"
    assert repr(plan).startswith("<Plan hybrid: found, 17.28 m, 1 gear change")


def test_plans_are_pickled_compared_and_written():
    plan = parkade.plan(SCENE, "risk-field")
    again = pickle.loads(pickle.dumps(plan))
    assert again == plan
    assert hash(again) == hash(plan)
    assert np.array_equal(again.path, plan.path)
    assert plan != parkade.plan(SCENE, "eight")
    written = json.loads(json.dumps(plan.to_dict(), allow_nan=False))
    assert written["hash"] == plan.hash
    assert written["path"] == plan.path.ravel().tolist()


def test_a_planner_is_used_again_between_other_ends_and_pickled():
    planner = parkade.Planner("hybrid", SCENE, {"margin": 0.05})
    first = planner.plan()
    x, y, heading = first.path[len(first.path) // 2].tolist()
    other = planner.plan(start={"x": x, "y": y, "heading": heading})
    assert other.found
    assert other.path[0].tolist() == pytest.approx([x, y, heading])
    assert planner.plan() == first
    assert pickle.loads(pickle.dumps(planner)).plan() == first


def test_scenes_may_be_text_tuples_arrays_and_numpys_numbers():
    expected = parkade.plan(SCENE).hash
    assert parkade.plan(json.dumps(SCENE)).hash == expected
    assert parkade.plan(json.dumps(SCENE).encode()).hash == expected
    scene = copy.deepcopy(SCENE)
    scene["map"]["width"] = np.int64(scene["map"]["width"])
    scene["map"]["height"] = float(scene["map"]["height"])
    scene["map"]["origin"] = np.array(scene["map"]["origin"], float)
    scene["start"]["x"] = np.float64(scene["start"]["x"])
    scene["obstacles"] = tuple(scene["obstacles"])
    assert parkade.plan(scene).hash == expected
    assert parkade.plan(parkade.as_dict(scene)).hash == expected


def test_any_path_is_checked():
    plan = parkade.plan(SCENE)
    for path in (plan.path, plan.path.ravel(), plan.path.tolist(), plan.path[:, ::-1][:, ::-1]):
        check = parkade.check_path(SCENE, path, plan.directions)
        assert check["verdict"] == "ok"
        assert np.allclose(check["clearances"], plan.clearances)
    moved = plan.path + np.array([0, 0, 0.5])
    assert parkade.check_path(SCENE, moved)["verdict"] != "ok"


def test_layers_are_arrays_of_the_map():
    planner = parkade.Planner("risk-field", SCENE)
    shape = (SCENE["map"]["height"], SCENE["map"]["width"])
    occupancy = planner.layer("occupancy")
    assert occupancy.shape == shape
    assert occupancy.dtype == np.uint8
    clearance = planner.layer("clearance")
    assert clearance.shape == shape
    assert np.all(clearance[occupancy == 1] == 0)
    assert planner.layer("risk", every=3).shape[0] == shape[0] // 3


def test_traces_alternatives_and_preferences():
    planner = parkade.Planner("hybrid", parkade.scenario("parallel"))
    plan = planner.plan(trace=True, alternatives=True)
    assert plan.trace["kind"] == "arcs"
    assert plan.trace["arcs"].shape[1] == 5
    assert all(isinstance(one, parkade.Plan) for one in plan.alternatives)
    lengths = [one.metrics["length"] for one in plan.alternatives]
    assert lengths == sorted(lengths)
    assert planner.plan(prefer="shortest").metrics["length"] <= planner.plan(prefer="widest").metrics["length"]
    cells = parkade.plan(SCENE, "eight", trace=True)
    assert len(cells.trace["cells"]) == cells.stats["expanded"]


def test_progress_is_told_and_exceptions_end_the_search():
    planner = parkade.Planner("hybrid-classic", SCENE)
    told = []
    plan = planner.plan(on_progress=told.append)
    assert plan == planner.plan()
    assert told == sorted(told)
    assert told
    assert told[-1] <= plan.stats["expanded"]

    def stop(expanded):
        raise LookupError(f"seen {expanded}")

    with pytest.raises(LookupError, match=r"seen \d+"):
        planner.plan(on_progress=stop)
    assert planner.plan() == plan


def test_ctrl_c_ends_a_search():
    planner = parkade.Planner("hybrid", {**SCENE, "goal": {"x": 0.4, "y": 0.4, "heading": 1}})

    def press(_):
        signal.raise_signal(signal.SIGINT)

    slow = parkade.Planner("hybrid-classic", SCENE)
    # Processes that a shell starts in the background ignore the signal.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            slow.plan(on_progress=press)
    finally:
        signal.signal(signal.SIGINT, before)
    assert not planner.plan().found


def test_a_planner_in_use_says_so_and_threads_have_their_own():
    planner = parkade.Planner("hybrid-classic", SCENE)

    def again(_):
        planner.plan()

    with pytest.raises(RuntimeError, match="give each thread a Planner of its own"):
        planner.plan(on_progress=again)
    hashes = []
    threads = [threading.Thread(target=lambda: hashes.append(parkade.plan(SCENE).hash)) for _ in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert set(hashes) == {parkade.plan(SCENE).hash}
    assert len(hashes) == 4


def test_no_path_is_an_outcome_with_a_reason():
    walls = [{"type": "wall", "points": [[15, 0], [15, 10]], "thickness": 0.2}]
    scene = {
        "version": 1,
        "map": {"origin": [0, 0], "width": 60, "height": 20, "resolution": 0.5},
        "obstacles": walls,
        "start": {"x": 5, "y": 5, "heading": 0},
        "goal": {"x": 23, "y": 5, "heading": 0},
    }
    plan = parkade.plan(scene)
    assert plan.outcome == "no-path"
    assert plan.path.shape == (0, 3)
    assert len(plan.reason) > 20
    assert "no-path" in repr(plan)


def test_files_of_other_programs_are_read(tmp_path):
    (tmp_path / "room.map").write_bytes(b"type octile\nheight 2\nwidth 3\nmap\n..@\n...\n")
    scene = parkade.load(tmp_path / "room.map")
    assert (scene["map"]["width"], scene["map"]["height"]) == (3, 2)
    (tmp_path / "own.json").write_text(json.dumps(SCENE))
    assert parkade.plan(parkade.load(tmp_path / "own.json")) == parkade.plan(SCENE)


def test_versions_are_one():
    def version_of(file):
        return re.search(r'^version = "(.+)"', (ROOT / file).read_text(), re.M)[1]

    assert parkade.__version__ == version_of("Cargo.toml") == version_of("python/Cargo.toml")


def test_types_cover_the_native_part():
    stubs = (ROOT / "python/parkade/_native.pyi").read_text()
    public = [name for name in dir(parkade._native) if not name.startswith("_")]
    assert len(public) > 8
    for name in public:
        assert re.search(rf"\b{name}\b", stubs), name
    assert all(hasattr(parkade, name) for name in parkade.__all__)


def test_licenses_are_those_of_the_crate():
    for name in ("LICENSE-APACHE", "LICENSE-MIT"):
        assert (ROOT / "python/licenses" / name).read_text() == (ROOT / name).read_text()


def test_a_plan_becomes_a_trajectory_that_the_referee_passes():
    plan = parkade.plan(SCENE)
    drive = parkade.optimise(SCENE, plan)
    assert drive.stage == "optimised"
    assert drive.check["passes"]
    assert len(drive.path) == len(drive.t) == len(drive.steering_rates)
    assert drive.duration == drive.t[-1] == drive.check["duration"]
    expected = json.loads((ROOT / "tests/data/trajectory-hashes.json").read_text())
    assert drive.hash == expected["perpendicular"]
    assert (
        parkade.optimise(SCENE, {"path": plan.path, "directions": plan.directions, "curvatures": plan.curvatures}).hash
        == drive.hash
    )
    assert parkade.judge(SCENE, drive)["passes"]
    assert parkade.judge(SCENE, drive.to_csv())["attained"]
    assert parkade.judge(SCENE, plan)["gearChanges"] == plan.metrics["directionChanges"]
    assert parkade.optimise(SCENE, plan, speed=1).duration > drive.duration
    assert pickle.loads(pickle.dumps(drive)).hash == drive.hash
