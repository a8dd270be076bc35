"""Cases of many concurrent operations: in eight threads, forked children and new processes, with the results of one."""

from __future__ import annotations

import os
import random
import select
import signal
import subprocess
import sys
import threading
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

from tests.attack import operations
from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan

THREADS = 8
LONGEST = 50.0
"""Seconds for a child, less than what a case may take."""


def kinds() -> list[Kind]:
    return [
        Kind("threads", _make(THREADS, 3), run_threads, share=0.3, has_limits=False),
        Kind("fork", _make(2, 3), run_fork, share=0.3, has_limits=False),
        Kind("spawn", _make(1, 12), run_spawn, share=0.02, has_limits=False),
    ]


def _make(count: int, most: int) -> Callable[[random.Random], tuple[Plan, dict[str, bytes]]]:
    def make(dice: random.Random) -> tuple[Plan, dict[str, bytes]]:
        names = list(operations.operations())
        lists = [[dice.choice(names) for _ in range(dice.randint(1, most))] for _ in range(count)]
        return {"operations": lists, "threads": dice.randint(1, 5)}, {}

    return make


def _expect(lists: list[list[str]]) -> None:
    """Compute the expected results, before anything runs concurrently."""
    for name in {name for names in lists for name in names}:
        operations.expected(name)


def run_threads(case: Case, folder: Path) -> str:
    """Run lists of operations in threads that start together."""
    lists = case.plan["operations"]
    _expect(lists)
    start = threading.Barrier(len(lists))
    faults: list[Exception] = []

    def work(names: list[str]) -> None:
        try:
            start.wait()
            wrong = operations.wrong(names, [operations.result(name) for name in names])
            if wrong:
                raise Finding(f"in a thread beside others {', '.join(wrong)} differ")
        except Exception as error:
            faults.append(error)

    threads = [threading.Thread(target=work, args=(names,)) for names in lists]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    if faults:
        raise faults[0]
    return ACCEPTED


def run_fork(case: Case, folder: Path) -> str:
    """Fork children that run operations while this process runs some as well."""
    mine, theirs = case.plan["operations"]
    _expect([mine, theirs])
    told, tell = os.pipe()
    child = os.fork()
    if child == 0:
        code = 1
        try:
            os.write(tell, ",".join(operations.result(name) for name in theirs).encode())
            code = 0
        finally:
            os._exit(code)
    os.close(tell)
    try:
        wrong = operations.wrong(mine, [operations.result(name) for name in mine])
        if wrong:
            raise Finding(f"beside a forked child {', '.join(wrong)} differ")
        ready, _, _ = select.select([told], [], [], LONGEST)
        if not ready:
            raise Finding(f"a forked child hangs in one of {', '.join(theirs)}")
        digests = os.read(told, 1 << 16).decode()
        if not digests:
            raise Finding(f"a forked child fails in one of {', '.join(theirs)}")
        wrong = operations.wrong(theirs, digests.split(","))
        if wrong:
            raise Finding(f"in a forked child {', '.join(wrong)} differ")
    finally:
        os.close(told)
        with suppress(ProcessLookupError):
            os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
    return ACCEPTED


_CHILD = """
import sys
from tests.attack import operations
print(",".join(operations.result(name) for name in sys.argv[1:]))
"""


def run_spawn(case: Case, folder: Path) -> str:
    """Run operations in a new process with another number of threads."""
    (names,) = case.plan["operations"]
    _expect([names])
    environment = os.environ | {"NEARFAR_NUM_THREADS": str(case.plan["threads"])}
    command = [sys.executable, "-c", _CHILD, *names]
    process = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=LONGEST, check=False)
    if process.returncode or process.stderr:
        lines = [*process.stderr.splitlines(), ""]
        raise Finding(f"a new process ended with status {process.returncode}: {lines[-2][:300]}")
    wrong = operations.wrong(names, process.stdout.strip().split(","))
    if wrong:
        raise Finding(f"in a new process with {case.plan['threads']} threads {', '.join(wrong)} differ")
    return ACCEPTED
