"""Tests of the attack itself: it detects every kind of defect, names the case, and continues."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from tests.attack import mutate, mutate_json
from tests.attack.case import Case, from_json, make, to_json
from tests.attack.engine import Engine
from tests.attack.kind_probe import DEEDS, KIND, SLOW
from tests.attack.report import Report
from tests.support import need


def engine(*, limits: bool = True, patience: float = 60.0) -> Engine:
    return Engine({KIND.name: KIND}, limits=limits, patience=patience, most_seconds=SLOW / 2)


@pytest.mark.parametrize("deed", DEEDS)
def test_every_defect_is_detected(deed: str) -> None:
    need("linux")
    case = Case("probe", {"does": deed})
    (result,) = engine(patience=0.5 if deed == "hang" else 60.0).run([case])
    assert result.finding.startswith(DEEDS[deed])
    assert bool(result.finding) == (deed != "nothing")
    assert result.case == case


def test_without_limits_a_refusal_may_take_long() -> None:
    need("linux")
    (result,) = engine(limits=False).run([Case("probe", {"does": "take time"})])
    assert result.finding == ""


def test_a_crash_does_not_stop_later_cases(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    need("linux")
    report, cases = Report(tmp_path / "findings"), [make(KIND, 3, number) for number in range(12)]
    deeds = [case.plan["does"] for case in cases]
    assert {"abort", "raise", "nothing"} == set(deeds)
    for result in engine(limits=False).run(cases):
        report.add(result)
    assert [report.count(name) for name in ("cases", "accepted")] == [12, deeds.count("nothing")]
    assert report.count("findings") == 12 - deeds.count("nothing")
    # Findings of the same cause are reported once.
    assert len(report.causes) == len(list((tmp_path / "findings").iterdir())) == 2
    assert "| probe | 12 |" in report.table()
    assert capsys.readouterr().out.count("\n") == 4


def test_cases_are_reproducible_from_seed_and_text() -> None:
    assert make(KIND, 1, 2) == make(KIND, 1, 2)
    plans = {make(KIND, 1, number).plan["does"] for number in range(50)}
    assert len(plans) == 3
    case = Case("probe", {"does": "nothing", "number": 1.5}, {"a.bin": bytes(range(256))}, "seed 1, case 2")
    assert from_json(to_json(case)) == case


def test_damage_depends_on_the_random_numbers_alone_and_reaches_all_parts() -> None:
    data = b"v 1.0 2.0 3.0\nf 1 2 3\n" * 9
    first = [mutate.damaged(data, random.Random(seed), [b"other"]) for seed in range(300)]
    assert first == [mutate.damaged(data, random.Random(seed), [b"other"]) for seed in range(300)]
    assert len(set(first)) > 200
    document = {"a": [1, 2, {"b": "text"}], "c": None}
    texts = [mutate_json.text(mutate_json.damaged(document, dice), dice) for dice in map(random.Random, range(300))]
    assert len(set(texts)) > 150
    assert document == {"a": [1, 2, {"b": "text"}], "c": None}


def test_documents_with_numbers_beyond_float64_are_damaged_too() -> None:
    document = {"a": 10**400, "b": [-(10**400), 1e308]}
    results = [mutate_json.damaged(document, random.Random(seed)) for seed in range(300)]
    assert len({repr(result) for result in results}) > 50
