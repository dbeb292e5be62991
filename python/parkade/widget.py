"""The playground in notebooks: Jupyter, marimo and VS Code, with the scene as a synced traitlet.

>>> from parkade.widget import Playground
>>> playground = Playground(scene=parkade.scenario("parallel"), planners=["eight", "hybrid"])
>>> playground  # the last line of a cell shows it; what is drawn is then in playground.scene
"""

from __future__ import annotations

import gzip
from functools import cache
from pathlib import Path
from typing import Any

from . import _native
from ._errors import ParkadeError
from ._plan import Plan, Planner, as_dict

try:
    import anywidget
    import traitlets
except ImportError as error:
    raise ImportError("parkade.widget needs anywidget: pip install 'parkade[widget]'") from error

FOLDER = Path(__file__).parent
#: The playground's files by their names in the messages.
FILES = {"playground": "playground.js", "worker": "worker.js", "module": "parkade_bg.wasm"}
#: Planners that a new playground shows.
FIRST_PLANNERS = ["four", "eight", "risk-field", "hybrid"]


@cache
def _compressed(name: str) -> bytes:
    return gzip.compress((FOLDER / "static" / FILES[name]).read_bytes(), mtime=0)


class Playground(anywidget.AnyWidget):
    """An editable scene and its plans."""

    _esm = FOLDER / "widget.js"

    #: the scene, synced in both directions: assign to it, observe it, or draw
    scene = traitlets.Dict().tag(sync=True)
    #: ids of the planners that are shown
    planners = traitlets.List(traitlets.Unicode(), FIRST_PLANNERS).tag(sync=True)
    #: "grid", "overlay", "focus" or "single"
    view = traitlets.Enum(["grid", "overlay", "focus", "single"], "grid").tag(sync=True)
    #: pixels
    height = traitlets.Int(520).tag(sync=True)
    #: "full", "minimal" or "none"
    controls = traitlets.Enum(["full", "minimal", "none"], "full").tag(sync=True)
    #: "auto" (as the notebook), "light" or "dark"
    theme = traitlets.Enum(["auto", "light", "dark"], "auto").tag(sync=True)
    #: "en" or "zh"
    lang = traitlets.Enum(["en", "zh"], "en").tag(sync=True)
    #: what the page's planners found last, by planner: outcome, reason, hash, metrics, verdict, drivable
    results = traitlets.Dict().tag(sync=True)

    def __init__(self, scene: Any = None, **traits: Any) -> None:
        missing = [name for name in FILES.values() if not (FOLDER / "static" / name).exists()]
        if missing:
            raise ParkadeError(
                f"this build of parkade has no playground ({', '.join(missing)}): `cargo xtask wheel` makes one"
            )
        unknown = [name for name in traits if name not in self.trait_names()]
        if unknown:
            names = "planners, view, height, controls, theme, lang"
            raise ParkadeError(
                f"{unknown[0]}: no trait of Playground; there are scene, {names}", "bad-input", unknown[0]
            )
        super().__init__(scene=_native.scenario("perpendicular") if scene is None else scene, **traits)
        self.on_msg(self._answer)

    @traitlets.validate("scene")
    def _checked(self, proposal: Any) -> dict[str, Any]:
        _native.normalise(proposal["value"])
        scene: dict[str, Any] = proposal["value"]
        return scene

    @traitlets.validate("planners")
    def _known(self, proposal: Any) -> list[str]:
        for planner in proposal["value"]:
            _native.default_config(planner)
        ids: list[str] = proposal["value"]
        return ids

    def plans(self) -> dict[str, Plan]:
        """Plans the scene here, with the hashes that the page shows."""
        scene = as_dict(self.scene)
        return {planner: Planner(planner, scene).plan() for planner in self.planners}

    def _answer(self, _: Any, content: Any, __: Any) -> None:
        if isinstance(content, dict) and content.get("kind") == "files":
            names = [name for name in content.get("names", []) if name in FILES]
            self.send({"kind": "files", "names": names}, [_compressed(name) for name in names])
