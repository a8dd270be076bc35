"""Cases that misbehave on purpose, for the tests of the engine."""

from __future__ import annotations

import os
import random
import time
import warnings
from pathlib import Path

from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan, refused

SLOW = 0.4
"""Seconds of a slow refusal."""

DEEDS = {
    "nothing": "",
    "raise": "wrong exception AttributeError: no such thing",
    "find": "something is wrong",
    "warn": "a warning reached the user: RuntimeWarning",
    "print": "text was printed",
    "leave": "temporary files were left: .a.exr",
    "abort": "died of SIGABRT",
    "exit": "ended with status 3",
    "hang": "hung for ",
    "take memory": "the refusal took 1",
    "take time": "the refusal took ",
}
"""Misbehaviours of a case, and the beginnings of their findings."""


def make(dice: random.Random) -> tuple[Plan, dict[str, bytes]]:
    return {"does": dice.choice(("nothing", "nothing", "nothing", "raise", "abort"))}, {}


def run(case: Case, folder: Path) -> str:
    match case.plan["does"]:
        case "raise":
            raise AttributeError("no such thing")
        case "find":
            raise Finding("something is wrong")
        case "warn":
            warnings.warn("odd", RuntimeWarning, stacklevel=1)
        case "print":
            print("text")
        case "leave":
            (folder / ".a.exr").touch()
        case "abort":
            os.abort()
        case "exit":
            os._exit(3)
        case "hang":
            time.sleep(1e6)
        case "take memory":
            taken = bytearray(1300 << 20)
            return refused(ValueError(len(taken)))
        case "take time":
            time.sleep(SLOW)
            return refused(ValueError())
    return ACCEPTED


KIND = Kind("probe", make, run)
