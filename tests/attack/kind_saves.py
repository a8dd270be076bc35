"""Cases of saves that are killed or run out of space or descriptors: the old or the new file remains complete."""

from __future__ import annotations

import os
import random
import select
import signal
import time
from contextlib import suppress
from pathlib import Path

from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan, refused
from tests.attack.saves import SAVES, Save, check_saved, save_of

LONGEST_START = 60.0
"""Seconds until a forked child has saved once."""


def kinds() -> list[Kind]:
    return [
        Kind("kills", _make_kill, run_kill, share=0.7, has_limits=False),
        Kind("full disks", _make_limit, run_limit, has_limits=False),
    ]


def _make_kill(dice: random.Random) -> tuple[Plan, dict[str, bytes]]:
    delays = [dice.uniform(0, 0.03) for _ in range(dice.choice((1, 1, 1, 2, 3)))]
    return {"save": dice.choice(SAVES), "delays": delays}, {}


def run_kill(case: Case, folder: Path) -> str:
    """Let children save again and again, and kill each after its delay."""
    save = save_of(case.plan["save"])
    save.write(save.first, folder / save.name)
    children = [_writer(save, folder / save.name) for _ in case.plan["delays"]]
    try:
        for child, ready in children:
            begun, _, _ = select.select([ready], [], [], LONGEST_START)
            if not begun:
                raise Finding(f"a forked child that saves {save.name} hangs")
            if not os.read(ready, 1):
                _, status = os.waitpid(child, 0)
                raise Finding(f"a forked child cannot save {save.name}, status {os.waitstatus_to_exitcode(status)}")
        for (child, _), delay in zip(children, case.plan["delays"], strict=True):
            time.sleep(delay)
            os.kill(child, signal.SIGKILL)
    finally:
        for child, ready in children:
            with suppress(ProcessLookupError, ChildProcessError):
                os.kill(child, signal.SIGKILL)
                os.waitpid(child, 0)
            os.close(ready)
    check_saved(save, folder)
    return ACCEPTED


def _writer(save: Save, path: Path) -> tuple[int, int]:
    """Fork a child that saves both versions in turns; returns it and the pipe on which it reports its first save."""
    ready, tell = os.pipe()
    child = os.fork()
    if child:
        os.close(tell)
        return child, ready
    try:
        save.write(save.second, path)
        os.write(tell, b"x")
        while True:
            save.write(save.first, path)
            save.write(save.second, path)
    finally:
        os._exit(1)


def _make_limit(dice: random.Random) -> tuple[Plan, dict[str, bytes]]:
    limit = dice.choice(("bytes", "bytes", "descriptors"))
    amount = int(2 ** dice.uniform(0, 14)) if limit == "bytes" else dice.randrange(4)
    return {"save": dice.choice(SAVES), "limit": limit, "amount": amount}, {}


def run_limit(case: Case, folder: Path) -> str:
    """Save under a limit on file size or on open files."""
    import resource

    save, amount = save_of(case.plan["save"]), case.plan["amount"]
    path = folder / save.name
    save.write(save.first, path)
    if case.plan["limit"] == "bytes":
        what, most = resource.RLIMIT_FSIZE, amount
    else:
        what, most = resource.RLIMIT_NOFILE, max(map(int, os.listdir("/proc/self/fd"))) + amount
    before = resource.getrlimit(what)
    outcome = ACCEPTED
    try:
        resource.setrlimit(what, (most, before[1]))
        try:
            save.write(save.second, path)
        finally:
            resource.setrlimit(what, before)
    except OSError as error:
        outcome = refused(error)
    left = [item.name for item in folder.iterdir() if item.name != save.name]
    # Without descriptors a folder cannot be cleared; the next save does that.
    if left and case.plan["limit"] == "bytes":
        raise Finding(f"a save of {save.name} that failed left {', '.join(left)}")
    found = check_saved(save, folder)
    if (found == "new") != (outcome == ACCEPTED):
        raise Finding(f"the save of {save.name} was {outcome}, but the {found} version is there")
    return outcome
