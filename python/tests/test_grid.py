"""Occupancy grids in, ROS paths out."""

import math
from types import SimpleNamespace

import numpy as np
import parkade
import pytest

RANDOM = np.random.default_rng(7)


def unpacked(scene):
    cells = np.zeros((scene["map"]["height"], scene["map"]["width"]), bool)
    for x, y, count in scene["obstacles"][0]["runs"]:
        assert not cells[y, x : x + count].any()
        cells[y, x : x + count] = True
    return cells


@pytest.mark.parametrize("shape", [(1, 1), (3, 7), (40, 25)])
@pytest.mark.parametrize("share", [0, 0.3, 1])
def test_arrays_become_runs_of_the_same_cells(shape, share):
    blocked = RANDOM.random(shape) < share
    scene = parkade.from_occupancy(blocked, resolution=0.5, start=(0, 0, 0), goal=(1, 1, 0))
    assert np.array_equal(unpacked(scene), blocked)
    planner = parkade.Planner("eight", scene)
    assert np.array_equal(planner.layer("occupancy") == 1, blocked)


def grid(data, width, height, turn=0.0):
    """As rclpy's messages: objects with attributes."""
    orientation = SimpleNamespace(x=0.0, y=0.0, z=math.sin(turn / 2), w=math.cos(turn / 2))
    origin = SimpleNamespace(position=SimpleNamespace(x=-10.0, y=-5.0, z=0.0), orientation=orientation)
    info = SimpleNamespace(resolution=0.25, width=width, height=height, origin=origin)
    return SimpleNamespace(info=info, data=data)


def test_a_ros_map_is_planned_and_the_path_is_a_message():
    data = np.zeros((60, 100), np.int8)
    data[20:30, 50:52] = 100
    data[:, 0] = -1
    data[5, 5] = 64
    start = SimpleNamespace(
        header=None,
        pose=SimpleNamespace(position=SimpleNamespace(x=-6.0, y=2.0), orientation=SimpleNamespace(x=0, y=0, z=0, w=1)),
    )
    scene = parkade.from_occupancy_grid(grid(data.ravel(), 100, 60), start=start, goal=(9.0, 2.0, 0.0))
    assert scene["map"]["origin"] == [-10.0, -5.0]
    assert np.array_equal(unpacked(scene), (data >= 65) | (data < 0))
    free = parkade.from_occupancy_grid(
        grid(data.ravel().tolist(), 100, 60), start=start, goal=(9, 2, 0), unknown_is_blocked=False, occupied=50
    )
    assert np.array_equal(unpacked(free), data >= 50)
    plan = parkade.plan(scene)
    assert plan.found, plan
    path = parkade.to_path(plan, frame_id="odom", stamp=(3, 4))
    assert path["header"] == {"stamp": {"sec": 3, "nanosec": 4}, "frame_id": "odom"}
    assert len(path["poses"]) == len(plan.path)
    for row, pose in zip(plan.path.tolist(), path["poses"], strict=True):
        place, turn = pose["pose"]["position"], pose["pose"]["orientation"]
        assert [place["x"], place["y"]] == row[:2]
        assert math.isclose(math.hypot(turn["z"], turn["w"]), 1)
        assert math.isclose(math.remainder(2 * math.atan2(turn["z"], turn["w"]) - row[2], math.tau), 0, abs_tol=1e-12)
    with pytest.raises(parkade.ParkadeError, match="plan: must have a path"):
        parkade.to_path(parkade.plan({**scene, "start": {"x": -9.9, "y": 0, "heading": 0}}))
