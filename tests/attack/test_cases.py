"""Every case that showed a defect once, as it was then."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.attack.case import from_json
from tests.attack.kinds import all_kinds
from tests.attack.runner import Runner
from tests.support import need

CASES = sorted((Path(__file__).parent / "cases").glob("*.json"))


@pytest.mark.slow
def test_nothing_is_found_again() -> None:
    need("linux")
    found = {}
    with Runner(all_kinds(own_only=True), limits=False, own_only=True) as runner:
        for path in CASES:
            result = runner.once(from_json(path.read_text(encoding="utf-8")))
            if result.finding:
                found[path.name] = f"{result.finding} at {result.trace}"
        ending = runner.close()
    assert (found, ending) == ({}, "")


def test_cases_are_small() -> None:
    assert CASES
    assert max(path.stat().st_size for path in CASES) < 16_384
