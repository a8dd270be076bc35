"""Tests of the attack itself: it sees every kind of defect, names the case, and goes on."""

from __future__ import annotations

import random

import pytest

from tests.attack import mutate, mutate_json
from tests.attack.attack import Attack
from tests.attack.case import Case, from_json, make, to_json
from tests.attack.kind_probe import DEEDS, KIND, SLOW
from tests.attack.report import Report
from tests.attack.runner import Runner
from tests.support import need


def runner(*, limits: bool = True, patience: float = 60.0) -> Runner:
    return Runner({KIND.name: KIND}, limits=limits, own_only=True, patience=patience, most_seconds=SLOW / 2)


@pytest.mark.parametrize("deed", DEEDS)
def test_every_defect_is_seen(deed: str) -> None:
    need("linux")
    case = Case("probe", {"does": deed})
    with runner(patience=0.5 if deed == "hang" else 60.0) as engine:
        result = engine.confirmed(engine.once(case), case)
    assert result.finding.startswith(DEEDS[deed])
    assert bool(result.finding) == (result.case is not None) == (deed != "nothing")


def test_a_refusal_may_take_its_time_without_limits() -> None:
    need("linux")
    case = Case("probe", {"does": "take time"})
    with runner(limits=False) as engine:
        assert engine.confirmed(engine.once(case), case).finding == ""


def test_a_batch_goes_on_after_a_case_that_dies() -> None:
    need("linux")
    report = Report()
    Attack({KIND.name: KIND}, 3, report, limits=False, own_only=True).run(1, cases=12)
    deeds = [make(KIND, 3, number).plan["does"] for number in range(12)]
    assert {"abort", "raise", "nothing"} == set(deeds)
    row = report.rows["probe"]
    assert (row.cases, row.accepted) == (12, deeds.count("nothing"))
    assert row.findings == 12 - row.accepted
    # Those of one cause are one.
    assert len(report.causes) == 2
    assert "| probe | 12 |" in report.table()


def test_cases_come_from_their_seed_and_survive_as_text() -> None:
    assert make(KIND, 1, 2) == make(KIND, 1, 2)
    plans = {make(KIND, 1, number).plan["does"] for number in range(50)}
    assert len(plans) == 3
    case = Case("probe", {"does": "nothing", "number": 1.5}, {"a.bin": bytes(range(256))}, "seed 1, case 2")
    assert from_json(to_json(case)) == case


def test_damage_depends_on_the_dice_alone_and_hits_everything() -> None:
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
