"""The exception for wrong input."""

from __future__ import annotations

import difflib
import re


class ParkadeError(ValueError):
    """Wrong input, named by field, value and rule. A search that finds no path is no error: see ``Plan.outcome``.

    ``code`` is the kind of input ("bad-config", "bad-scenario", "bad-vehicle", "bad-input", "bad-import",
    "unknown-planner", "unknown-scenario"), ``path`` the field, such as "obstacles[2].points[0]".
    """

    code: str
    path: str

    def __init__(self, message: str, code: str = "bad-input", path: str = "") -> None:
        super().__init__(message, code, path)
        self.code = code
        self.path = path

    def __str__(self) -> str:
        message = str(self.args[0])
        return message + _meant(message, self.path)


def _meant(message: str, path: str) -> str:
    """The known word that was probably meant, where the message lists them."""
    if listed := re.search(r"; there are (.+)$", message):
        got = re.search(r'"([^"]*)"; there are ', message)
        word, words = (got[1] if got else path.rsplit(".", 1)[-1]), listed[1].split(", ")
    elif ruled := re.search(r'must be (.+), got "(.*)"$', message):
        word, words = ruled[2], re.split(r", | or ", ruled[1])
    else:
        return ""
    near = difflib.get_close_matches(word.lower(), [one.lower() for one in words], 1, 0.6)
    by_letters = {one.lower(): one for one in words}
    return f"; did you mean {by_letters[near[0]]}?" if near else ""
