"""A short attack, always the same cases; `make attack` runs others for an hour."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.attack.attack import Attack
from tests.attack.kinds import all_kinds
from tests.attack.report import Report
from tests.support import need

SEED = int(os.environ.get("NEARFAR_ATTACK_SEED", "19"))

CASES = int(os.environ.get("NEARFAR_ATTACK_CASES", "40"))
"""Cases of a kind with share 1."""

GROUPS = ("scene gl", "scene obj", "scene ", "saved ", "arguments", "interrupts", "")
"""Beginnings of the names of kinds that run together; each kind belongs to the first that fits."""


@pytest.mark.slow
@pytest.mark.parametrize("group", GROUPS)
def test_nothing_is_found(group: str, tmp_path: Path) -> None:
    need("linux")
    first = {name: next(begin for begin in GROUPS if name.startswith(begin)) for name in all_kinds(own_only=True)}
    kinds = {name: kind for name, kind in all_kinds(own_only=True).items() if first[name] == group}
    report = Report(tmp_path / "findings", print)
    Attack(kinds, SEED, report, limits=False, own_only=True).run(1, cases=CASES)
    print(f"seed {SEED}\n{report.table()}")
    assert report.cases >= CASES
    assert report.causes == {}, f"seed {SEED}\n{report.table()}"
