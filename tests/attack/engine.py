"""Runs cases in worker processes, which are restarted when a case kills them, hangs or exceeds a limit."""

from __future__ import annotations

import json
import os
import random
import select
import signal
import subprocess
import sys
import tempfile
import threading
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tests.attack.case import Case, Kind, make, to_json

CHECKOUT = Path(__file__).resolve().parents[2]

MAX_SECONDS = 2.0
"""Maximum seconds of a refusal."""
MAX_MEMORY = 1 << 30
"""Maximum memory of a refusal, bytes beyond the file."""
HANG_SECONDS = 60.0
"""Time after which a case counts as hanging."""
START_SECONDS = 300.0
BATCH = 50
"""Cases in a batch of one process."""
FOLDER = Path("/dev/shm")
"""Files lie in memory if possible, because saves wait for the disk."""


@dataclass(frozen=True)
class Result:
    """The outcome of a case."""

    case: Case
    outcome: str
    seconds: float = 0.0
    memory: int = 0
    """Peak memory beyond that before the case, bytes."""
    finding: str = ""
    trace: str = ""


@dataclass(frozen=True)
class Engine:
    """Runs cases of some kinds."""

    kinds: Mapping[str, Kind]
    limits: bool = False
    """Whether refusals have limits on time and memory, and Ctrl-C one on time."""
    own_only: bool = True
    """Whether cases use only seed files generated here, which are the same on every machine."""
    patience: float = HANG_SECONDS
    """Seconds after which a case counts as hanging."""
    most_seconds: float = MAX_SECONDS
    """Seconds that a refusal may take."""

    def run(self, cases: Sequence[Case]) -> Iterator[Result]:
        """Run cases one after another; cases that die, exceed a limit or are late run again alone."""
        cases = list(cases)
        while cases:
            results = list(self._process(cases))
            for result in results:
                yield self._confirmed(result) if self._is_suspect(result) and len(cases) > 1 else self._judged(result)
            cases = cases[len(results) :] if results[-1].outcome == "died" else []

    def _is_suspect(self, result: Result) -> bool:
        return result.outcome == "died" or result.finding.startswith("late") or bool(self._excess(result))

    def _judged(self, result: Result) -> Result:
        return replace(result, finding=result.finding or self._excess(result))

    def _confirmed(self, result: Result) -> Result:
        """Return the result of a second run alone if a case has a finding or exceeds a limit."""
        *_, again = self.run([result.case])
        if result.outcome == "died" and not again.finding:
            return replace(result, finding=f"{result.finding} (only after the cases before it)")
        return again  # Without a finding, another process may have taken the cores.

    def _excess(self, result: Result) -> str:
        """Return by how much a refusal exceeds the limits."""
        if not (self.limits and self.kinds[result.case.kind].has_limits and result.outcome.startswith("refused")):
            return ""
        if result.memory > MAX_MEMORY + result.case.size:
            return f"the refusal took {result.memory >> 20} MB"
        return f"the refusal took {result.seconds:.1f} s" if result.seconds > self.most_seconds else ""

    def _process(self, cases: Sequence[Case]) -> Iterator[Result]:
        """Yield results of a new process until it ends; the last one may be a crash."""
        with tempfile.TemporaryDirectory(
            prefix="nearfar-attack-", ignore_cleanup_errors=True, dir=FOLDER if FOLDER.is_dir() else None
        ) as folder:
            worker = _Worker(folder, probe="probe" in self.kinds, limits=self.limits, cases=cases)
            done = 0
            for event in worker.events(self.patience):
                yield Result(cases[done], **event)
                done += 1
            if worker.ending:
                # After the last case it died at exit, or left files open.
                yield Result(cases[min(done, len(cases) - 1)], "died", finding=worker.ending, trace=worker.last_words())


class _Worker:
    """A process that runs cases.

    Parameters
    ----------
    folder
        Folder for all files that it makes.
    probe
        Whether its cases are those that test the engine.
    limits
        Whether Ctrl-C has to arrive in time.
    cases
        The cases, which the process reads from a file.
    """

    def __init__(self, folder: str, *, probe: bool, limits: bool, cases: Iterable[Case]) -> None:
        self.ending = ""
        """How the process ended, if abnormally."""
        self._log = Path(folder) / "log"
        listed = Path(folder) / "cases.json"
        listed.write_text(json.dumps([to_json(case) for case in cases]), encoding="utf-8")
        environment = os.environ | {
            "PYTHONPATH": os.pathsep.join([str(CHECKOUT), *filter(None, sys.path)]),
            "NEARFAR_PROGRESS": "0",
            "NEARFAR_CACHE": f"{folder}/cache",
            "TMPDIR": folder,
            "NEARFAR_ATTACK_LIMITS": "1" if limits else "",
        }
        self._events, report = os.pipe()
        command = [
            sys.executable,
            "-u",
            "-m",
            "tests.attack.worker",
            str(report),
            str(listed),
            "probe" if probe else "",
        ]
        with self._log.open("wb") as log:
            self._process = subprocess.Popen(
                command, cwd=CHECKOUT, stdin=subprocess.DEVNULL, stdout=log, stderr=log, env=environment,
                pass_fds=[report], start_new_session=True,
            )  # fmt: skip
        os.close(report)

    def events(self, patience: float) -> Iterator[dict[str, Any]]:
        """Yield the outcomes of cases until the process ends."""
        seconds, rest = START_SECONDS, b""
        try:
            while True:
                ready, _, _ = select.select([self._events], [], [], seconds)
                more = os.read(self._events, 1 << 16) if ready else b""
                if not more:
                    break
                *lines, rest = (rest + more).split(b"\n")
                for event in map(json.loads, lines):
                    seconds = patience
                    if "outcome" in event:
                        yield event
            self.ending = "" if ready else f"hung for {seconds:g} s"
            if not ready:
                self._process.send_signal(signal.SIGUSR1)  # Its standard error holds the stacks of its threads.
                time.sleep(0.5)
        finally:
            os.close(self._events)
            if self.ending or (self._process.poll() is None and not self._is_over()):
                with suppress(ProcessLookupError):
                    os.killpg(self._process.pid, signal.SIGKILL)
            status = self._process.wait()
        self.ending = self.ending or _ending(status)

    def _is_over(self) -> bool:
        with suppress(subprocess.TimeoutExpired):
            self._process.wait(HANG_SECONDS)
        return self._process.poll() is not None

    def last_words(self) -> str:
        """Return the last lines of its standard error, lines about the package first."""
        lines = self._log.read_text("utf-8", "replace").splitlines()
        told = [line.strip() for line in lines if "nearfar" in line or "panicked" in line or "Fatal" in line]
        return " < ".join((told or lines)[-6:])[:1000]


def _ending(status: int) -> str:
    if status < 0:
        return f"died of {signal.Signals(-status).name}"
    return f"ended with status {status}" if status else ""


def attack(engine: Engine, seed: int, note: Any, *, workers: int, until: float) -> None:
    """Run cases of all kinds in proportion to their shares, in parallel processes, until a time.

    `note` receives each result; `until` is a time of the monotonic clock.
    """
    lock, numbers = threading.Lock(), Counter[str]()
    names, shares = list(engine.kinds), [kind.share for kind in engine.kinds.values()]

    def serve(dice: random.Random) -> None:
        while time.monotonic() < until:
            with lock:
                chosen = dice.choices(names, shares, k=BATCH)
                cases = []
                for name in chosen:
                    cases.append(make(engine.kinds[name], seed, numbers[name]))
                    numbers[name] += 1
            for result in engine.run(cases):
                with lock:
                    note(result)

    # A worker process dies with its parent; threads end with this one.
    threads = [
        threading.Thread(target=serve, args=(random.Random(f"{seed} {n}"),), daemon=True) for n in range(workers)
    ]
    for thread in threads:
        thread.start()
    while any(thread.is_alive() for thread in threads):
        time.sleep(0.2)
