"""Cases of Ctrl-C at a random time in operations that take seconds, each in a separate process."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from contextlib import suppress
from pathlib import Path

from nearfar._base import memory
from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan
from tests.attack.kind_interrupts import LATEST
from tests.attack.long_operations import OPERATIONS, LongOperation
from tests.support import missing

LONGEST = 50.0
"""Seconds, less than what a case may take."""


def kinds() -> list[Kind]:
    return [Kind("long interrupts", make, run, share=0.02, has_limits=False)]


def make(dice: random.Random) -> tuple[Plan, dict[str, bytes]]:
    usable = [operation for operation in OPERATIONS if not (operation.needs and missing(operation.needs))]
    names = [operation.name for operation in usable if 1e9 * operation.gigabytes < 0.8 * memory.installed()]
    return {"operation": dice.choice(names), "delay": dice.uniform(0, 1.5)}, {}


def run(case: Case, folder: Path) -> str:
    """Interrupt a script; only one runs at a time over all workers, because some take gigabytes."""
    import fcntl

    (operation,) = (operation for operation in OPERATIONS if operation.name == case.plan["operation"])
    lock = os.open(__file__, os.O_RDONLY)
    try:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            # A waiting case would count as hanging.
            return "another one runs"
        return _run(operation, case.plan["delay"], folder)
    finally:
        os.close(lock)


def _run(operation: LongOperation, delay: float, folder: Path) -> str:
    import resource

    script = folder / "operation.py"
    script.write_text(operation.code, encoding="utf-8")

    def free() -> None:
        resource.setrlimit(resource.RLIMIT_AS, (resource.getrlimit(resource.RLIMIT_AS)[1],) * 2)
        signal.signal(signal.SIGINT, signal.default_int_handler)

    process = subprocess.Popen(
        [sys.executable, str(script)], cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        preexec_fn=free,
    )  # fmt: skip
    assert process.stdout is not None
    try:
        if process.stdout.readline().strip() != "ready":
            raise Finding(f"{operation.name} does not begin: {process.communicate()[1][-300:]!r}")
        time.sleep(delay)
        sent = time.monotonic()
        process.send_signal(signal.SIGINT)
        words = process.stdout.readline().strip()
        late = time.monotonic() - sent
        errors = process.communicate(timeout=LONGEST)[1]
    finally:
        with suppress(ProcessLookupError):
            process.kill()
        process.wait()
    # Python also dies by the signal if it was interrupted in generated code, such as that of dataclasses.
    if words != "interrupted" or process.returncode not in (0, -signal.SIGINT) or errors:
        raise Finding(f"{operation.name} ended with {words!r}, status {process.returncode}: {errors[-300:]!r}")
    if late > LATEST and os.environ.get("NEARFAR_ATTACK_LIMITS"):
        raise Finding(f"late: Ctrl-C in {operation.name} arrived after {late:.2f} s")
    return ACCEPTED
