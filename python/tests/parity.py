"""Answers the questions of a file and compares with the native answers in it: python parity.py questions.jsonl

`cargo xtask parity` makes the questions: every planner on every built-in scene, and random scenes with random settings,
of which some are wrong and are refused in the same words.
"""

import json
import sys
from pathlib import Path

import parkade


def answer(question):
    """The plan's hash, or why there is none, and whether it is a hash."""
    try:
        planner = parkade.Planner(question["planner"], question["scene"], question["settings"])
    except parkade.ParkadeError as error:
        return str(error.args[0]), False
    return planner.plan().hash, True


def main():
    asked, hashes, different = 0, 0, []
    with Path(sys.argv[1]).open() as lines:
        for asked, line in enumerate(lines, 1):
            question = json.loads(line)
            found, planned = answer(question)
            hashes += planned
            if found != question["answer"]:
                different.append(f"line {asked}, {question['planner']}: {found}, natively {question['answer']}")
    print(f"Python {sys.version.split()[0]}: {asked} questions, {hashes} of them planned, {len(different)} differ")
    print("\n".join(different[:10]))
    sys.exit(1 if different or asked == 0 or hashes == 0 else 0)


if __name__ == "__main__":
    main()
