"""Cases of hostile arguments to all public callables: two or three arguments of a valid call are replaced at once."""

from __future__ import annotations

import functools
import os
import random
import tempfile
from pathlib import Path

from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan, refused
from tests.support import missing
from tests.support.hostile import Hostile, hostile_values
from tests.support.hostile_calls import Call
from tests.support.valid_calls.calls import NAMES, needs
from tests.support.valid_calls.objects import Valid
from tests.support.verdict import verdict


def kinds() -> list[Kind]:
    return [Kind("arguments", make, run, share=3.0)]


@functools.cache
def _valid() -> Valid:
    return Valid(Path(tempfile.mkdtemp()))


@functools.cache
def _calls() -> dict[str, Call]:
    usable = [name for name in NAMES if not any(map(missing, needs(name)))]
    calls = [Call(name, _valid()) for name in usable]
    return {call.name: call for call in calls if len(call.parameters) > 1}


@functools.cache
def _values() -> dict[str, Hostile]:
    return {value.name: value for value in hostile_values(_valid())}


def make(dice: random.Random) -> tuple[Plan, dict[str, bytes]]:
    call = _calls()[dice.choice(list(_calls()))]
    changed = dice.sample(call.parameters, min(len(call.parameters), dice.choice((2, 2, 3))))
    return {"call": call.name, "changes": {name: dice.choice(list(_values())) for name in changed}}, {}


def run(case: Case, folder: Path) -> str:
    """Call in the case's folder as working directory, because some texts are valid file names."""
    call, names = _calls()[case.plan["call"]], case.plan["changes"]
    before = Path.cwd()
    os.chdir(folder)
    try:
        error = call.attempt({parameter: _values()[name].make() for parameter, name in names.items()})
    finally:
        os.chdir(before)
    if error is None:
        return ACCEPTED
    if names.get("report") == "class":
        # The value is called as a callback, and its errors are the caller's own.
        return refused(error)
    # If arguments contradict each other, a message may name any of them.
    flaw = verdict(error, next(iter(names)), (*names, *call.names))
    if flaw is not None:
        shown = ", ".join(f"{parameter}={name}" for parameter, name in names.items())
        raise Finding(f"{call.name}({shown}) raised {flaw}"[:400]) from error
    return refused(error)
