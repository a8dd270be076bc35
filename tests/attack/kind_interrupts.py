"""Cases of Ctrl-C at a random time within an operation: it takes effect soon, and the process continues normally."""

from __future__ import annotations

import functools
import itertools
import os
import random
import select
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from tests.attack import operations
from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan
from tests.attack.saves import SAVES, Save, check_saved, save_of

LATEST = 0.5
"""Seconds from the signal to the exception."""

_SENDER = """
import os, signal, sys, time
parent = int(sys.argv[1])
for line in sys.stdin:
    number, delay = line.split()
    time.sleep(float(delay))
    sent = time.monotonic()
    if os.getppid() == parent:
        os.kill(parent, signal.SIGINT)
    print(number, sent, flush=True)
"""


def kinds() -> list[Kind]:
    return [Kind("interrupts", make, run, share=1.0, has_limits=False)]


def make(dice: random.Random) -> tuple[Plan, dict[str, bytes]]:
    name = dice.choice([*operations.operations(), *(f"save {name}" for name in SAVES)])
    return {"operation": name, "share": dice.uniform(0, 1.1)}, {}


@functools.cache
def _sender() -> subprocess.Popen[bytes]:
    """Return a process that sends signals: a thread of this one might not run while an operation holds the lock."""
    command = [sys.executable, "-c", _SENDER, str(os.getpid())]
    return subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)


@functools.cache
def _seconds(name: str) -> float:
    """Return the time of an operation once everything that it needs is made."""
    save = _save(name)
    if save is None:
        operations.expected(name)
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        _perform(name, Path(folder))
        return time.perf_counter() - start


def _save(name: str) -> Save | None:
    return save_of(name.removeprefix("save ")) if name.startswith("save ") else None


def _perform(name: str, folder: Path) -> None:
    save = _save(name)
    if save is None:
        operations.result(name)
    else:
        save.write(save.second, folder / save.name)


def run(case: Case, folder: Path) -> str:
    """Interrupt an operation, and run it again."""
    name = case.plan["operation"]
    save = _save(name)
    seconds = _seconds(name)
    if save is not None:
        save.write(save.first, folder / save.name)
    late = _interrupted(name, folder, case.plan["share"] * seconds)
    if save is not None:
        check_saved(save, folder)
    elif operations.wrong([name], [operations.result(name)]):
        raise Finding(f"{name} gives another result after an interruption")
    if late > LATEST and os.environ.get("NEARFAR_ATTACK_LIMITS"):
        raise Finding(f"late: Ctrl-C in {name} arrived after {late:.2f} s")
    return ACCEPTED


_numbers = itertools.count()


class _Signal:
    """A signal to this process after a delay, and the time when it was sent."""

    def __init__(self) -> None:
        self._number, self._sender = next(_numbers), _sender()
        self._answer = b""

    def send(self, delay: float) -> None:
        assert self._sender.stdin is not None
        os.write(self._sender.stdin.fileno(), f"{self._number} {delay}\n".encode())

    def fileno(self) -> int:
        """Return what can be read once it is sent."""
        assert self._sender.stdout is not None
        return self._sender.stdout.fileno()

    def time_sent(self) -> float:
        """Return the time when it was sent; not to be interrupted."""
        begin = f"{self._number} ".encode()
        while True:
            for line in self._answer.split(b"\n")[:-1]:
                if line.startswith(begin):
                    return float(line.removeprefix(begin))
            self._answer += os.read(self.fileno(), 4096)


def _interrupted(name: str, folder: Path, delay: float) -> float:
    """Run an operation and send a signal meanwhile; returns how late it arrived, 0 if after the end."""
    ignored: list[str] = []
    hook, interrupt = sys.unraisablehook, _Signal()
    sys.unraisablehook = lambda raised: ignored.append(f"{raised.exc_type.__name__} in {raised.object!r:.80}")
    has_ended, arrived = False, None
    try:
        try:
            interrupt.send(delay)
            _perform(name, folder)
            has_ended = True
            select.select([interrupt], [], [])
            for _ in range(200):
                time.sleep(0.001)
        except KeyboardInterrupt:
            arrived = time.monotonic()
        sent = interrupt.time_sent()
    finally:
        sys.unraisablehook = hook
    if arrived is None:
        raise Finding(f"Ctrl-C in {name} was lost" + (f": ignored {ignored[0]}" if ignored else ""))
    return 0.0 if has_ended else arrived - sent
