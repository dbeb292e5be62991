"""The widget's side of the kernel; `cargo xtask notebooks` drives it in JupyterLab and marimo."""

import gzip
import json
from pathlib import Path

import parkade
import pytest
from parkade import widget
from parkade.widget import Playground

SCENE = parkade.scenario("parallel")


def test_the_scene_is_a_synced_traitlet_and_plans_are_those_of_the_scene():
    playground = Playground(planners=["eight", "hybrid"])
    seen = []
    playground.observe(lambda change: seen.append(change["new"]), "scene")
    assert playground.scene == parkade.scenario("perpendicular")
    playground.scene = SCENE
    assert seen == [SCENE]
    assert "scene" in playground.keys
    assert playground.plans() == {name: parkade.plan(SCENE, name) for name in ("eight", "hybrid")}


def test_the_playground_is_sent_when_it_is_asked_for(monkeypatch):
    sent = []
    playground = Playground()
    monkeypatch.setattr(playground, "send", lambda content, buffers: sent.append((content, buffers)))
    playground._handle_custom_msg({"kind": "files", "names": ["worker", "module", "../secret", "playground"]}, [])
    playground._handle_custom_msg({"kind": "other"}, [])
    ((content, buffers),) = sent
    assert content == {"kind": "files", "names": ["worker", "module", "playground"]}
    worker, module, page = map(gzip.decompress, buffers)
    assert module.startswith(b"\0asm")
    assert b"parkade-playground" in page
    assert b"parkadeAddresses" in worker
    # Nothing in a notebook can be fetched by a name.
    assert b"/assets/" not in page
    assert sum(map(len, buffers)) < 1_100_000


def test_the_state_in_a_notebook_is_small():
    assert len(json.dumps(Playground().get_state(), default=str)) < 60_000


def refused(call):
    with pytest.raises(parkade.ParkadeError) as raised:
        call()
    return str(raised.value)


def test_misuse_is_answered_by_a_sentence():
    playground = Playground()
    before = playground.scene
    assert "did you mean sedan?" in refused(lambda: setattr(playground, "scene", {**SCENE, "vehicle": "seden"}))
    assert playground.scene == before
    assert "did you mean hybrid?" in refused(lambda: Playground(planners=["hybird"]))
    assert "map.width" in refused(lambda: Playground({**SCENE, "map": {**SCENE["map"], "width": 0}}))
    assert "did you mean height?" in refused(lambda: Playground(hieght=3))


def test_a_build_without_the_playground_says_how_to_make_one(monkeypatch, tmp_path):
    monkeypatch.setattr(widget, "FOLDER", Path(tmp_path))
    assert "`cargo xtask wheel` makes one" in refused(Playground)
