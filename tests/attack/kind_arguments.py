"""Cases of hostile arguments to all public callables: one to three arguments of a valid call are replaced at once."""

from __future__ import annotations

import functools
import os
import random
import tempfile
from pathlib import Path

from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan, refused
from tests.support import argument_cases
from tests.support.hostile_values import Hostile, hostile_values, verdict
from tests.support.valid_objects import Valid


def kinds() -> list[Kind]:
    return [Kind("arguments", make, run, share=3.0)]


@functools.cache
def _valid() -> Valid:
    return Valid(Path(tempfile.mkdtemp()))


@functools.cache
def _calls() -> dict[str, argument_cases.Case]:
    return argument_cases.cases(_valid())


@functools.cache
def _values() -> dict[str, Hostile]:
    objects = {name: getattr(_valid(), name) for name in argument_cases.OBJECTS}
    return {value.name: value for value in hostile_values(_valid().folder, objects)}


def make(dice: random.Random) -> tuple[Plan, dict[str, bytes]]:
    name = dice.choice([name for name, call in _calls().items() if call.parameters])
    parameters = _calls()[name].parameters
    changed = dice.sample(parameters, min(len(parameters), dice.choice((1, 2, 2, 3))))
    values = list(_values())
    return {"call": name, "changes": {parameter: dice.choice(values) for parameter in changed}}, {}


def run(case: Case, folder: Path) -> str:
    """Call; the folder is the current one, because some texts are valid names of files."""
    call = _calls()[case.plan["call"]]
    names = case.plan["changes"]
    before = Path.cwd()
    os.chdir(folder)
    try:
        error = call.attempt(**{parameter: _values()[name].make() for parameter, name in names.items()})
    finally:
        os.chdir(before)
    if error is None:
        return ACCEPTED
    if call.name.endswith(".__getitem__") and isinstance(error, IndexError | TypeError | ValueError | MemoryError):
        # Containers raise what Python's and NumPy's raise.
        return refused(error)
    if names.get("report") == "class":
        # It is called, and its errors are the caller's own.
        return refused(error)
    # Where arguments contradict each other, a message may name any of them.
    flaw = verdict(error, next(iter(names)), call.parameters)
    if flaw is not None:
        shown = ", ".join(f"{parameter}={name}" for parameter, name in names.items())
        raise Finding(f"{call.name}({shown}) raised {flaw}"[:400]) from error
    return refused(error)
