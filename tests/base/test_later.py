"""Tests of background work whose caller continues meanwhile."""

from __future__ import annotations

import contextvars
import os
import signal
import subprocess
import sys
import threading
import time

import pytest

from nearfar._base import background, progress
from tests.support import need


def wait_until(later: background.Later[int]) -> None:
    """Wait for the end of work without asking for its result."""
    deadline = time.monotonic() + 60
    while not later.ready and time.monotonic() < deadline:
        time.sleep(0.001)
    assert later.ready


def test_the_caller_continues_and_may_read_the_result_repeatedly() -> None:
    may_end, calls = threading.Event(), []

    def work() -> int:
        may_end.wait()
        calls.append(threading.get_ident())
        return 7

    later = background.Later(work)
    assert not later.ready
    may_end.set()
    assert (later.result(), later.result(), later.ready) == (7, 7, True)
    assert len(calls) == 1
    assert calls[0] != threading.get_ident()


def test_errors_are_raised_when_the_result_is_read() -> None:
    def work() -> int:
        raise LookupError("missing")

    later = background.Later(work)
    wait_until(later)
    for _ in range(2):
        with pytest.raises(LookupError, match="missing"):
            later.result()


def test_ctrl_c_ends_the_wait_and_not_the_work() -> None:
    began, may_end = threading.Event(), threading.Event()

    def work() -> int:
        began.set()
        may_end.wait()
        return 7

    later = background.Later(work)
    interrupt = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
    if os.name != "nt":
        interrupt = threading.Timer(0.2, os.kill, [os.getpid(), signal.SIGINT])
    with pytest.raises(KeyboardInterrupt):
        interrupt.start()
        later.result()
    assert not later.ready
    may_end.set()
    assert later.result() == 7


def test_work_sees_the_callers_context_and_shows_no_progress() -> None:
    variable: contextvars.ContextVar[int] = contextvars.ContextVar("variable", default=0)
    variable.set(3)
    assert background.Later(lambda: (variable.get(), progress._hidden.get())).result() == (3, True)
    assert not progress._hidden.get()


def test_without_threads_reading_the_result_does_the_work(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> int:
        raise RuntimeError("can't start new thread")

    monkeypatch.setattr("_thread.start_new_thread", refuse)
    calls: list[int] = []

    def work() -> int:
        calls.append(1)
        return 7

    later = background.Later(work)
    assert (later.ready, calls) == (False, [])
    assert (later.result(), later.result(), calls) == (7, 7, [1])


def test_a_forked_child_does_the_work_itself() -> None:
    need("fork")
    began, may_end = threading.Event(), threading.Event()
    process = os.getpid()

    def work() -> int:
        if os.getpid() == process:
            began.set()
            may_end.wait()
        return 7

    later = background.Later(work)
    began.wait()
    child = os.fork()
    if child == 0:
        os._exit(later.result())
    deadline = time.monotonic() + 60
    while (status := os.waitpid(child, os.WNOHANG)) == (0, 0) and time.monotonic() < deadline:
        time.sleep(0.01)
    may_end.set()
    assert os.waitstatus_to_exitcode(status[1]) == 7


def test_a_program_ends_despite_unfinished_work() -> None:
    code = "from nearfar._base import background\nbackground.Later(lambda: exec('while True: pass'))\nprint('end')"
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=False)
    assert (process.returncode, process.stdout, process.stderr) == (0, "end\n", "")
