"""Calls with little memory end with a result or a MemoryError; Rust would abort the process."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from tests.support import short_memory

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="limits of the address space are those of Linux")

ENVIRONMENT = {"MALLOC_MMAP_THRESHOLD_": "131072", "OPENBLAS_NUM_THREADS": "1", "NEARFAR_NUM_THREADS": "2"}
"""Large arrays return to the system when they are freed; threads, which need address space, are few."""


@pytest.mark.slow
def test_calls_with_little_memory_end_with_a_result_or_a_memory_error() -> None:
    command = [sys.executable, "-m", "tests.support.short_memory"]
    run = subprocess.run(command, env={**os.environ, **ENVIRONMENT}, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    found = {name: [int(status) for status in statuses] for name, *statuses in map(str.split, run.stdout.splitlines())}
    accepted = {short_memory.RESULT, short_memory.REFUSAL}
    assert {name: statuses for name, statuses in found.items() if not {*statuses} <= accepted} == {}, run.stderr
    ends = {name: (statuses[0], statuses[-1]) for name, statuses in found.items()}
    assert ends == dict.fromkeys(found, (short_memory.REFUSAL, short_memory.RESULT)), run.stderr
    assert len(found) > 10
