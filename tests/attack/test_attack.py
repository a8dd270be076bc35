"""A short attack with fixed cases; `make attack` runs others for an hour."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.attack import kind_saved, kind_scenes
from tests.attack.case import Kind, from_json, make
from tests.attack.engine import Engine
from tests.attack.report import Report
from tests.attack.worker import all_kinds
from tests.support import need

SEED = int(os.environ.get("NEARFAR_ATTACK_SEED", "19"))

CASES = 20
"""Number of cases of a kind with share 1."""

GROUPS = ("scene gl", "scene obj", "scene ", "saved ", "arguments", "interrupts", "")
"""Prefixes of kinds that run together; each kind belongs to the first prefix that matches."""

EARLIER = sorted((Path(__file__).parent / "cases").glob("*.json"))
"""Cases that once showed a defect, stored unchanged."""


@pytest.mark.slow
@pytest.mark.parametrize("group", GROUPS)
def test_the_attack_finds_nothing(group: str, tmp_path: Path) -> None:
    need("linux")
    every = {name: kind for name, kind in all_kinds(own_only=True).items() if name != "long interrupts"}
    kinds = {name: kind for name, kind in every.items() if next(b for b in GROUPS if name.startswith(b)) == group}
    report = Report(tmp_path / "findings")
    cases = [make(kind, SEED, number) for kind in kinds.values() for number in range(max(1, round(CASES * kind.share)))]
    for result in Engine(kinds).run(cases):
        report.add(result)
    print(f"seed {SEED}\n{report.table()}")
    assert report.count() == len(cases)
    assert report.causes == {}, f"seed {SEED}\n{report.table()}"


FILES = (*kind_scenes.kinds(own_only=True), *kind_saved.kinds())


@pytest.mark.parametrize("kind", FILES, ids=[kind.name for kind in FILES])
def test_damaged_files_load_or_are_refused(kind: Kind, tmp_path: Path) -> None:
    """Other cases, in this process, whose time and memory have no limit."""
    outcomes = set()
    for number in range(1000, 1020):
        case, folder = make(kind, SEED, number), tmp_path / str(number)
        case.write(folder)
        outcomes.add(kind.run(case, folder))
    assert len(outcomes) > 1


@pytest.mark.slow
def test_former_findings_stay_fixed() -> None:
    need("linux")
    cases = [from_json(path.read_text(encoding="utf-8")) for path in EARLIER]
    results = list(Engine(all_kinds(own_only=True)).run(cases))
    assert [f"{result.case}: {result.finding} at {result.trace}" for result in results if result.finding] == []
    assert len(results) == len(EARLIER) > 20


def test_cases_are_small() -> None:
    assert max(path.stat().st_size for path in EARLIER) < 16_384
