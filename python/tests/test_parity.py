"""Plans have the hashes of the crate, which are also those of Node and the browsers."""

import json
from pathlib import Path

import parkade
import pytest

DATA = Path(__file__).parents[2] / "tests" / "data"
HASHES = json.loads((DATA / "plan-hashes.json").read_text())


@pytest.mark.parametrize("scene", HASHES)
def test_presets_have_the_hashes_of_the_crate(scene):
    assert sorted(HASHES[scene]) == sorted(planner["id"] for planner in parkade.planners())
    for planner, expected in HASHES[scene].items():
        prepared = parkade.Planner(planner, parkade.scenario(scene))
        assert prepared.plan().hash == expected, planner
        assert prepared.plan(trace=True).hash == expected, f"{planner}, a second time and traced"
