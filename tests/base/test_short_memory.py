"""Public calls with little memory end with a result or an error about memory; Rust would abort the process."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import pytest

from tests.support.growing_memory import FRACTIONS
from tests.support.short_memory import LARGEST, REFUSAL, RESULT, SHORTAGE, Outcome
from tests.support.valid_calls.calls import CALLABLES

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="limits of the address space are those of Linux")

ENVIRONMENT = {
    "MALLOC_ARENA_MAX": "1", "MALLOC_MMAP_THRESHOLD_": "131072", "MPLBACKEND": "agg", "NEARFAR_NUM_THREADS": "2",
    "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1",
}  # fmt: skip
"""Large arrays return to the system when they are freed; threads, which need address space, are few. Forked children of
a process with OpenMP's threads, such as flip-evaluator's, would wait for them forever."""

STAGES = sorted({entry.stage for entry in CALLABLES.values()})


def outcomes(*arguments: str) -> tuple[dict[str, Outcome], str]:
    """Return the outcomes of a stage's calls by name, and what their processes printed."""
    command = [sys.executable, "-m", "tests.support.short_memory", *arguments]
    run = subprocess.run(command, env={**os.environ, **ENVIRONMENT}, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    return {name: Outcome(*others) for name, *others in map(json.loads, run.stdout.splitlines())}, run.stderr


@pytest.mark.slow
def test_calls_whose_memory_grows_with_their_input_are_refused_with_a_size() -> None:
    """Also without headroom; with enough memory they return."""
    found, printed = outcomes("growing")
    ends = {name: one.statuses for name, one in found.items()}
    assert ends == {name: [REFUSAL, *[REFUSAL] * len(FRACTIONS), RESULT] for name in found}, printed


@pytest.mark.stress
@pytest.mark.parametrize("stage", STAGES)
def test_calls_with_little_memory_end_with_a_result_or_an_error_about_memory(stage: str) -> None:
    found, printed = outcomes(stage)
    allowed = {RESULT, REFUSAL, SHORTAGE}
    assert {name: one.statuses for name, one in found.items() if not {*one.statuses} <= allowed} == {}, printed
    of_large = {name: one for name, one in found.items() if one.needs_much}
    ends = {name: (one.statuses[0] in (REFUSAL, SHORTAGE), one.statuses[-1]) for name, one in of_large.items()}
    assert ends == dict.fromkeys(of_large, (True, RESULT)), printed
    assert {*LARGEST.get(stage, "").split()} <= {*of_large}
