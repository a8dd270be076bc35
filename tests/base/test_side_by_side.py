"""Jobs in threads: results in order, a limited number at a time, and errors in order."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Iterator
from functools import partial

import pytest

from nearfar import _core
from nearfar._base import side_by_side


def test_results_come_in_the_order_of_jobs() -> None:
    def slow(number: int) -> int:
        time.sleep(0.02 if number % 3 == 0 else 0.0)
        return number

    assert list(side_by_side.results(partial(slow, number) for number in range(20))) == list(range(20))
    assert list(side_by_side.results([])) == []


def test_jobs_are_drawn_when_earlier_ones_have_begun() -> None:
    taken = 0

    def jobs() -> Iterator[Callable[[], int]]:
        nonlocal taken
        for number in range(100):
            taken += 1
            yield partial(int, number)

    results = side_by_side.results(jobs())
    assert next(results) == 0
    assert taken <= _core.thread_count() + 1


def test_an_error_is_raised_in_order() -> None:
    def fail() -> int:
        raise RuntimeError("of the job")

    jobs: list[Callable[[], int]] = [partial(int, 1), fail, partial(int, 2)]
    results = side_by_side.results(jobs)
    assert next(results) == 1
    with pytest.raises(RuntimeError, match="of the job"):
        next(results)


def test_without_threads_jobs_run_in_the_caller(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(_: threading.Thread) -> None:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr(threading.Thread, "start", refuse)
    found = list(side_by_side.results([threading.current_thread] * 5))
    assert found == [threading.current_thread()] * 5
