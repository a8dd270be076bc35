"""Tests of the threads that read the parts that a flight wants."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager

import pytest

import nearfar as nf
from nearfar.orthoview import _loader
from nearfar.orthoview._cut import GEOMETRY, RECORD, Part
from nearfar.orthoview._loader import Loader
from tests.support.flight_cases import readers
from tests.support.waiting import wait_until

LONG = 120.0
"""Timeout of a test in seconds."""


def view(number: int) -> Part:
    return 0, (number, 0, 0), 4


def leaf(number: int) -> Part:
    return 0, (number, 0, 0), GEOMETRY


class Store:
    """Reads parts under control of the test, and records requests."""

    def __init__(self) -> None:
        self.asked_for: list[Part] = []
        self.held: set[Part] = set()
        self.damaged: set[Part] = set()
        self.is_away = False
        self.may_go, self.asked = threading.Event(), threading.Event()
        self.may_go.set()

    def read(self, part: Part) -> bool:
        self.asked_for.append(part)
        self.asked.set()
        assert self.may_go.wait(LONG)
        if self.is_away:
            raise OSError("the server is away")
        if part in self.damaged:
            raise nf.FormatError(f"damaged: {part}")
        self.held.add(part)
        return True


@contextmanager
def loading(store: Store, threads: int = 1) -> Iterator[Loader]:
    loader = Loader(store.read, store.held.__contains__, threads)
    try:
        yield loader
    finally:
        store.may_go.set()
        loader.close()


@contextmanager
def held_up(store: Store, loader: Loader) -> Iterator[None]:
    """A context in which the only thread is busy with one part, so that others gather."""
    store.may_go.clear()
    loader.want([view(1000)])
    assert store.asked.wait(LONG)
    yield
    store.may_go.set()


def messages(errors: Sequence[Exception]) -> list[str]:
    return [str(error) for error in errors]


def test_parts_are_read_in_order() -> None:
    store = Store()
    records: list[Part] = [(1, (n, 0, 0), RECORD) for n in range(2)]
    wanted = [*records, view(0), leaf(0), leaf(1), *(view(n) for n in range(1, 12)), leaf(2)]
    with loading(store) as loader:
        with held_up(store, loader):
            loader.want(wanted)
            assert loader.waiting == len(wanted) + 1
        assert loader.wait(LONG)
        assert loader.waiting == 0
        assert loader.errors() == []
    assert store.asked_for == [view(1000), *wanted]


def test_only_the_last_request_counts() -> None:
    store = Store()
    with loading(store) as loader:
        with held_up(store, loader):
            loader.want([view(n) for n in range(5)])
            loader.want([view(7), view(1000), view(3)])
            assert loader.waiting == 3
        assert loader.wait(LONG)
        store.held.add(view(20))
        loader.want([view(7), view(20)])
        assert loader.waiting == 0
    assert store.asked_for == [view(1000), view(7), view(3)]


def test_a_damaged_part_is_reported_once_and_others_are_read() -> None:
    store = Store()
    store.damaged = {view(2), view(5)}
    wanted = [view(n) for n in range(7)]
    with loading(store) as loader:
        with held_up(store, loader):
            loader.want(wanted)
        assert loader.wait(LONG)
        assert store.held == {view(1000), *wanted} - store.damaged
        assert messages(loader.errors()) == [f"damaged: {view(n)}" for n in (2, 5)]
        assert loader.errors() == []
        count = len(store.asked_for)
        loader.want(wanted)
        assert loader.wait(LONG)
        assert len(store.asked_for) == count
        # After an update they are tried again.
        store.damaged.remove(view(2))
        loader.forget()
        loader.want(wanted)
        assert loader.wait(LONG)
        assert store.asked_for[count:] == [view(2), view(5)]
        assert store.held == {view(1000), *wanted} - {view(5)}
        assert messages(loader.errors()) == [f"damaged: {view(5)}"]


def test_each_server_outage_is_reported_once(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(_loader, "FIRST_PAUSE", 1e-4)
    monkeypatch.setattr(_loader, "MAX_PAUSE", 1e-3)
    store = Store()
    with loading(store) as loader:
        for number, times in enumerate((5, 3)):
            store.is_away, before = True, len(store.asked_for)
            wanted = [view(10 * number + n) for n in range(3)]
            loader.want(wanted)
            wait_until(lambda before=before, times=times: len(store.asked_for) >= before + times)  # type: ignore[misc]
            assert loader.waiting == 3
            assert loader.wait(LONG) is False
            assert messages(loader.errors()) == ["the server is away"]
            store.is_away = False
            wait_until(lambda wanted=wanted: store.held.issuperset(wanted))  # type: ignore[misc]
            assert loader.wait(LONG)
            # The part that could not be read stays the first one.
            again = store.asked_for[before:]
            assert again == [wanted[0]] * (len(again) - 2) + wanted[1:]
        assert loader.errors() == []


def test_pauses_double_until_a_part_arrives(monkeypatch: pytest.MonkeyPatch) -> None:
    """A fake clock advances by each pause as soon as a thread waits for it."""
    now, pauses = [100.0], []
    store = Store()
    store.is_away = True

    class Condition(threading.Condition):
        def wait(self, timeout: float | None = None) -> bool:
            if timeout is None or threading.current_thread() is threading.main_thread():
                return super().wait(timeout)
            pauses.append(timeout)
            now[0] += timeout
            store.is_away = len(store.asked_for) < 9
            return True

    monkeypatch.setattr("nearfar.orthoview._loader.threading.Condition", Condition)
    monkeypatch.setattr("nearfar.orthoview._loader.time.monotonic", lambda: now[0])
    with loading(store) as loader:
        loader.want([view(0)])
        wait_until(lambda: view(0) in store.held)
        assert len(store.asked_for) == 10
        store.asked_for.clear()
        store.is_away = True
        loader.want([view(1)])
        wait_until(lambda: view(1) in store.held)
    expected = [min(0.5 * 2**n, 30.0) for n in range(9)]
    assert expected[-3:] == [30, 30, 30]
    assert pauses == pytest.approx([*expected, *expected])


def test_waiting_ends() -> None:
    store = Store()
    with loading(store) as loader:
        assert loader.wait(0.0)
        with held_up(store, loader):
            assert not loader.wait(0.0)
        assert loader.wait(None)
        assert loader.wait(LONG)


def test_threads_begin_with_the_first_request_and_end_with_the_loader() -> None:
    store = Store()
    store.may_go.clear()
    others = readers()
    loader = Loader(store.read, store.held.__contains__, 3)
    assert not readers() - others
    loader.want([view(n) for n in range(5)])
    wait_until(lambda: len(store.asked_for) == 3)
    assert len(readers() - others) == 3
    closing = threading.Thread(target=loader.close)
    closing.start()
    wait_until(lambda: loader.waiting == 3)  # Reads in progress are completed, and nothing else is read.
    store.may_go.set()
    closing.join(LONG)
    assert not readers() - others
    assert store.held == {view(n) for n in range(3)}
    loader.want([view(99)])
    assert loader.waiting == 0
    assert not readers() - others
    loader.close()


def test_threads_share_the_wanted_parts() -> None:
    """Nothing is read twice, even if other parts are wanted meanwhile."""
    store = Store()
    wanted = [view(n) for n in range(300)]
    with loading(store, 4) as loader:
        for first in range(0, 300, 10):
            loader.want(wanted[first:] + wanted[:first])
        assert loader.wait(LONG)
    assert sorted(store.asked_for) == wanted
