"""Tests of blocking code run in a background thread so that Ctrl-C works: results, errors and interrupts."""

from __future__ import annotations

import contextvars
import gc
import os
import signal
import subprocess
import sys
import threading
import time
import traceback
import weakref
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from nearfar._base import background
from tests.support import need


class Work:
    """Work that ends on command, whatever is raised in the meantime."""

    def __init__(self) -> None:
        self.began, self.may_end = threading.Event(), threading.Event()
        self.result: Any = None

    def __call__(self) -> Any:
        self.began.set()
        self.may_end.wait()
        return self.result


def interrupt_once(begun: threading.Event) -> None:
    """Send this process Ctrl-C as soon as something has begun."""

    def send() -> None:
        begun.wait()
        signal.raise_signal(signal.SIGINT) if os.name == "nt" else os.kill(os.getpid(), signal.SIGINT)

    threading.Thread(target=send, daemon=True).start()


def test_results_errors_and_context_come_through() -> None:
    variable: contextvars.ContextVar[int] = contextvars.ContextVar("variable", default=0)
    variable.set(3)
    assert background.run(lambda: (variable.get(), threading.get_ident() != threading.main_thread().ident)) == (3, True)

    def fail() -> None:
        raise LookupError("missing")

    with pytest.raises(LookupError, match="missing") as caught:
        background.run(fail)
    assert traceback.extract_tb(caught.value.__traceback__)[-1].name == "fail"


def test_other_threads_call_directly() -> None:
    seen: list[bool] = []

    def call() -> None:
        seen.append(background.run(threading.get_ident) == threading.get_ident())

    thread = threading.Thread(target=call)
    thread.start()
    thread.join()
    assert seen == [True]


def test_ctrl_c_abandons_endless_work() -> None:
    work = Work()
    interrupt_once(work.began)
    with pytest.raises(KeyboardInterrupt):
        background.run(work)
    # The abandoned work still waits, although its caller has returned.
    work.may_end.set()
    assert background.run(lambda: 4) == 4


def test_results_of_abandoned_work_are_dropped() -> None:
    class Large:
        pass

    work = Work()
    work.result = Large()
    dropped = weakref.ref(work.result)
    interrupt_once(work.began)
    with pytest.raises(KeyboardInterrupt):
        background.run(work, alone=True)
    work.may_end.set()
    background.run(lambda: None, alone=True)
    del work
    gc.collect()
    assert dropped() is None


def test_work_that_runs_alone_waits_for_abandoned_work_and_other_work_does_not() -> None:
    first, second = Work(), Work()
    interrupt_once(first.began)
    with pytest.raises(KeyboardInterrupt):
        background.run(first, alone=True)
    assert background.run(lambda: 4) == 4
    # The next call waits for the first, and can be interrupted as well.
    waits = threading.Timer(0.2, signal.raise_signal, [signal.SIGINT])
    if os.name != "nt":
        waits = threading.Timer(0.2, os.kill, [os.getpid(), signal.SIGINT])
    with pytest.raises(KeyboardInterrupt):
        waits.start()
        background.run(second, alone=True)
    assert not second.began.is_set()
    first.may_end.set()
    second.may_end.set()
    background.run(second, alone=True)
    assert second.began.is_set()


def test_an_interrupted_import_is_complete_the_next_time(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    # Like trimesh, it catches exceptions in the import of a part, and would then work without that part.
    (tmp_path / "slow_part.py").write_text("import importing\nimporting.began.set()\nimporting.may_end.wait()\n")
    (tmp_path / "careless.py").write_text("try:\n    import slow_part\nexcept BaseException:\n    slow_part = None\n")
    work = Work()
    monkeypatch.setitem(sys.modules, "importing", work)
    monkeypatch.syspath_prepend(tmp_path)
    interrupt_once(work.began)
    with pytest.raises(KeyboardInterrupt):
        background.module("careless")
    work.may_end.set()
    assert background.module("careless").slow_part.__name__ == "slow_part"
    for name in ("careless", "slow_part"):
        monkeypatch.delitem(sys.modules, name)


def test_a_forked_child_does_not_wait_for_its_parents_thread() -> None:
    need("fork")
    work = Work()
    interrupt_once(work.began)
    with pytest.raises(KeyboardInterrupt):
        background.run(work, alone=True)
    child = os.fork()
    if child == 0:
        os._exit(background.run(lambda: 7, alone=True))
    deadline = time.monotonic() + 60
    while (status := os.waitpid(child, os.WNOHANG)) == (0, 0) and time.monotonic() < deadline:
        time.sleep(0.01)
    if status == (0, 0):
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
    work.may_end.set()
    assert os.waitstatus_to_exitcode(status[1]) == 7


ENDS: dict[str, Callable[[], str]] = {
    "an import": lambda: "background.module('trimesh')",
    "Python": lambda: "background.run(lambda: exec('while True: pass'))",
    "code that catches all": lambda: "background.run(careless)",
    "a compiled function": lambda: "background.run(lambda: time.sleep(20))",
    "code in a destructor": lambda: "background.run(lambda: [None for _ in iter(Slow, None)])",
}


@pytest.mark.parametrize("name", ENDS)
def test_a_program_with_abandoned_work_ends(name: str) -> None:
    code = f"""
import os, signal, threading, time
from nearfar._base import background

def careless():
    while True:
        try:
            time.sleep(0.001)
        except BaseException:
            pass

class Slow:
    def __del__(self):
        time.sleep(0.01)
        time.sleep(0.01)

try:
    threading.Timer(0.3, os.kill, [os.getpid(), signal.SIGINT]).start()
    {ENDS[name]()}
    time.sleep(9)
except KeyboardInterrupt:
    print("left", flush=True)
"""
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    process = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, text=True, timeout=300)
    assert (process.returncode, process.stdout, process.stderr) == (0, "left\n", "")
