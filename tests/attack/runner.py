"""Runs batches of cases in a worker process, and one by one again if the process dies, hangs or exceeds a limit."""

from __future__ import annotations

import json
import os
import select
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tests.attack.case import Case, Kind, make, to_json

CHECKOUT = Path(__file__).resolve().parents[2]

MOST_SECONDS = 2.0
"""Time of a refusal."""
MOST_MEMORY = 1 << 30
"""Memory of a refusal, bytes beyond the file."""
HANG_SECONDS = 60.0
"""Time after which a case counts as hanging."""
START_SECONDS = 300.0
FOLDER = Path("/dev/shm")
"""Files lie in memory where that can be, because saves wait for the disk."""


@dataclass(frozen=True)
class Result:
    """The outcome of a case."""

    kind: str
    number: int
    outcome: str
    seconds: float = 0.0
    memory: int = 0
    """Greatest memory beyond that before the case, bytes."""
    size: int = 0
    """Bytes of the case's files."""
    finding: str = ""
    trace: str = ""
    case: Case | None = None
    """The case itself, of findings."""


class Runner:
    """A worker process, which is started again when it dies.

    Parameters
    ----------
    kinds
        Kinds of cases by name.
    limits
        Whether refusals must keep to time and memory.
    own_only
        Whether cases are made from files made here alone.
    patience
        Seconds after which a case counts as hanging.
    most_seconds
        Seconds that a refusal may take.
    """

    def __init__(
        self,
        kinds: dict[str, Kind],
        *,
        limits: bool,
        own_only: bool,
        patience: float = HANG_SECONDS,
        most_seconds: float = MOST_SECONDS,
    ) -> None:
        self._kinds, self._limits, self._own_only = kinds, limits, own_only
        self._patience, self._most_seconds = patience, most_seconds
        self._process: subprocess.Popen[bytes] | None = None
        self._has_stopped = False
        self._ending, self._is_told = "", False
        self._events, self._rest = -1, b""
        self._log = tempfile.TemporaryFile()  # noqa: SIM115  # `__exit__` closes it
        self._folder: tempfile.TemporaryDirectory[str] | None = None

    def __enter__(self) -> Runner:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()
        self._log.close()

    def batch(self, kind: str, seed: int, first: int, count: int) -> list[Result]:
        """Run cases together; those that die, hang, exceed a limit or are late run again alone."""
        found: list[Result] = []
        end = first + count
        while first < end and not self._has_stopped:
            results = list(self._serve(kind, {"kind": kind, "seed": seed, "first": first, "count": end - first}))
            for result in results:
                if self._is_suspect(result):
                    result = self.confirmed(result, make(self._kinds[kind], seed, result.number))
                found.append(result)
            last = results[-1] if results else None
            # The cases after one that died have not run yet; between two cases the whole batch died.
            first = last.number + 1 if last is not None and last.outcome == "died" and last.number >= 0 else end
        return found

    def confirmed(self, result: Result, case: Case) -> Result:
        """Return what remains of a result when its case runs again alone."""
        if not self._is_suspect(result):
            return result
        if result.outcome == "died":
            again = self.alone(case, result.number)
            if again.outcome != "died":
                again = replace(result, finding=f"{result.finding} (only after the cases before it)")
            return replace(again, case=case)
        if not self._over(result) and not result.finding.startswith("late"):
            return replace(result, case=case)
        # Another process may have taken the cores.
        again = self.alone(case, result.number)
        finding = self._over(again) or again.finding
        return replace(again, finding=finding, case=case if finding else None)

    def _is_suspect(self, result: Result) -> bool:
        return result.number >= 0 and bool(result.finding or self._over(result))

    def _over(self, result: Result) -> str:
        """Return how a refusal exceeds the limits."""
        if not (self._limits and self._kinds[result.kind].has_limits and result.outcome.startswith("refused")):
            return ""
        if result.memory > MOST_MEMORY + result.size:
            return f"the refusal took {result.memory >> 20} MB"
        if result.seconds > self._most_seconds:
            return f"the refusal took {result.seconds:.1f} s"
        return ""

    def alone(self, case: Case, number: int = 0) -> Result:
        """Run a case in a new process."""
        if self._has_stopped:
            return Result(case.kind, number, "stopped")
        before = self.close()
        result = self.once(case)
        ending = self.close()
        self._ending = before
        if ending and not result.finding:
            result = replace(result, outcome="died", finding=ending)
        return replace(result, number=number, case=case if result.finding else None)

    def once(self, case: Case) -> Result:
        """Run a case in the present process."""
        results = list(self._serve(case.kind, {"case": to_json(case)}))
        return replace(results[0], case=case if results[0].finding else None)

    def _serve(self, kind: str, request: dict[str, Any]) -> Iterator[Result]:
        """Send a request and yield results until the worker is idle or dead; -1 numbers a finding about the batch."""
        process = self._started()
        assert process.stdin is not None
        with suppress(BrokenPipeError):
            process.stdin.write(json.dumps(request).encode() + b"\n")
            process.stdin.flush()
        running: int | None = None
        while True:
            event = self._next(self._patience)
            if isinstance(event, str):
                # Between two cases it is the batch that died.
                yield Result(kind, -1 if running is None else running, "died", finding=event, trace=self._last_words())
                return
            match event.pop("event"):
                case "start":
                    running = event["number"]
                case "end":
                    yield Result(kind, **event)
                    running = None
                case "idle":
                    if event["leak"]:
                        yield Result(kind, -1, "leak", finding=event["leak"])
                    return

    def _started(self) -> subprocess.Popen[bytes]:
        if self._process is None or self._process.poll() is not None:
            before = self._ending
            self.close()
            self._ending = before
            self._events, report = os.pipe()
            self._log.truncate(0)
            self._log.seek(0)
            options = [*(["own"] if self._own_only else []), *(["probe"] if "probe" in self._kinds else [])]
            # Files that a worker leaves when it dies go with this folder.
            self._folder = tempfile.TemporaryDirectory(
                prefix="nearfar-attack-", ignore_cleanup_errors=True, dir=FOLDER if FOLDER.is_dir() else None
            )
            environment = os.environ | {
                "PYTHONPATH": os.pathsep.join([str(CHECKOUT), *filter(None, sys.path)]),
                "NEARFAR_PROGRESS": "0",
                "NEARFAR_CACHE": f"{self._folder.name}/cache",
                "TMPDIR": self._folder.name,
                "NEARFAR_ATTACK_LIMITS": "1" if self._limits else "",
            }
            self._is_told = False
            self._process = subprocess.Popen(
                [sys.executable, "-u", "-m", "tests.attack.worker", str(report), *options],
                cwd=CHECKOUT, stdin=subprocess.PIPE, stdout=self._log, stderr=self._log, env=environment,
                pass_fds=[report], start_new_session=True,
            )  # fmt: skip
            os.close(report)
            event = self._next(START_SECONDS)
            if isinstance(event, str):
                raise RuntimeError(f"the worker does not start: {event}: {self._last_words()}")
        return self._process

    def _next(self, seconds: float) -> dict[str, Any] | str:
        """Return the next event, or how the worker ended."""
        deadline = time.monotonic() + seconds
        while b"\n" not in self._rest:
            ready, _, _ = select.select([self._events], [], [], max(0.0, deadline - time.monotonic()))
            if not ready:
                self._is_told = True
                self.kill(signal.SIGUSR1)
                return f"hung for {seconds:g} s"
            more = os.read(self._events, 1 << 16)
            if not more:
                self._is_told = True
                assert self._process is not None
                return _ending(self._process.wait())
            self._rest += more
        line, _, self._rest = self._rest.partition(b"\n")
        event: dict[str, Any] = json.loads(line)
        return event

    def stop(self) -> None:
        """Let `batch` return soon, from another thread."""
        self._has_stopped = True
        self.kill()

    def kill(self, before: signal.Signals | None = None) -> None:
        """End the worker with all its children; a signal before that lets it write where its threads are."""
        process = self._process
        if process is None:
            return
        if before is not None:
            process.send_signal(before)
            time.sleep(0.5)
        with suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait()

    def _last_words(self) -> str:
        self._log.seek(0)
        lines = self._log.read().decode("utf-8", "replace").splitlines()
        told = [line.strip() for line in lines if "nearfar" in line or "panicked" in line or "Fatal" in line]
        return " < ".join((told or lines)[-6:])[:1000]

    def close(self) -> str:
        """End the worker; returns how it, or one before that nobody asked about, ended if that was wrong."""
        before, self._ending = self._ending, ""
        if self._process is None:
            return before
        process, self._process = self._process, None
        assert process.stdin is not None
        with suppress(BrokenPipeError):
            process.stdin.close()
        try:
            status = process.wait(60)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            status = process.wait()
        os.close(self._events)
        self._rest = b""
        if self._folder is not None:
            self._folder.cleanup()
        return before if status == 0 or self._is_told else f"at exit it {_ending(status)}"


def _ending(status: int) -> str:
    return f"died of {signal.Signals(-status).name}" if status < 0 else f"ended with status {status}"
