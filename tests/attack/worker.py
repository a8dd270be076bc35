"""A process that runs cases one after another and reports each before it begins and after it ended."""

from __future__ import annotations

import faulthandler
import json
import os
import shutil
import signal
import sys
import tempfile
import time
import traceback
import warnings
from pathlib import Path
from typing import Any, NoReturn

from tests.attack import own_process
from tests.attack.case import Case, Finding, Kind, from_json, make

MOST_ADDRESSES = 12 << 30
"""Bytes of address space, so that a defect does not take the machine's memory."""

MOST_DESCRIPTORS_MORE = 16
"""Open files that a batch may leave: caches and pools open some once."""


class Worker:
    """Runs cases and writes one line of JSON for each event to `report`."""

    def __init__(self, report: int, kinds: dict[str, Kind]) -> None:
        self._report, self._kinds = report, kinds
        self._warnings: list[str] = []
        self._printed = os.fstat(2).st_size
        warnings.simplefilter("always")
        # A file may state places from which a picture folds.
        warnings.filterwarnings("ignore", "the picture folds")
        warnings.showwarning = self._note_warning  # type: ignore[assignment]

    def _note_warning(self, message: object, category: type[Warning], filename: str, lineno: int, *_: object) -> None:
        # A file that an exception leaves open between two steps of Python is closed with its last reference.
        if issubclass(category, ResourceWarning):
            return
        place = "/".join(Path(filename).parts[-3:])
        self._warnings.append(f"{category.__name__} at {place}:{lineno}: {str(message).splitlines()[0]}")

    def tell(self, **event: Any) -> None:
        """Report an event."""
        os.write(self._report, json.dumps(event).encode() + b"\n")

    def batch(self, kind: str, seed: int, first: int, count: int) -> None:
        """Make cases and run them."""
        before = _descriptors()
        for number in range(first, first + count):
            case = make(self._kinds[kind], seed, number)
            self.run(case, number)
        more = _descriptors() - before
        self.tell(event="idle", leak="" if more <= MOST_DESCRIPTORS_MORE else f"{more} files are left open")

    def run(self, case: Case, number: int) -> None:
        """Run a case in a folder of its own."""
        folder = Path(tempfile.mkdtemp())
        try:
            for name, data in case.files.items():
                (folder / name).parent.mkdir(exist_ok=True)
                (folder / name).write_bytes(data)
            self.tell(event="start", number=number)
            self._warnings.clear()
            before = own_process.reset_peak()
            start = time.perf_counter()
            outcome, finding, trace = self._outcome(case, folder)
            seconds, peak = time.perf_counter() - start, own_process.peak() - before
            finding = finding or self._aftermath(folder)
            self.tell(
                event="end", number=number, outcome=outcome, seconds=seconds, memory=max(0, peak), size=case.size,
                finding=finding, trace=trace,
            )  # fmt: skip
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def _outcome(self, case: Case, folder: Path) -> tuple[str, str, str]:
        """Outcome, finding and traceback of a case."""
        try:
            return self._kinds[case.kind].run(case, folder), "", ""
        except Finding as error:
            return "finding", str(error), _trace(error.__cause__ or error)
        except BaseException as error:
            text = next(iter(str(error).splitlines()), "")
            return "finding", f"wrong exception {type(error).__name__}: {text[:300]}", _trace(error)

    def _aftermath(self, folder: Path) -> str:
        """Return a finding about what a case left behind."""
        printed, self._printed = self._printed, os.fstat(2).st_size
        if self._printed > printed:
            return "text was printed"
        if self._warnings:
            return f"a warning reached the user: {self._warnings[0]}"
        left = [path.name for path in folder.iterdir() if path.name.startswith(".") and path.name != ".results"]
        return f"temporary files were left: {', '.join(left)}" if left else ""


def _descriptors() -> int:
    return len(os.listdir("/proc/self/fd")) if os.path.isdir("/proc/self/fd") else 0


def _trace(error: BaseException) -> str:
    """Return the last calls of a traceback, those of the package first of all."""
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if "/nearfar/" in frame.filename] or frames
    return " < ".join(f"{'/'.join(Path(f.filename).parts[-2:])}:{f.lineno} {f.name}" for f in reversed(own[-3:]))


def _kinds(options: list[str]) -> dict[str, Kind]:
    if "probe" in options:  # without the package
        from tests.attack import kind_probe

        return {kind_probe.KIND.name: kind_probe.KIND}
    from tests.attack.kinds import all_kinds

    return all_kinds(own_only="own" in options)


def main() -> NoReturn:
    """Serve requests, one line of JSON each, until there are no more."""
    report = int(sys.argv[1])
    faulthandler.enable(all_threads=True)
    faulthandler.register(signal.SIGUSR1, all_threads=True)
    own_process.limit_addresses(MOST_ADDRESSES)
    own_process.die_with_parent()
    worker = Worker(report, _kinds(sys.argv[2:]))
    worker.tell(event="ready")
    for line in sys.stdin:
        request = json.loads(line)
        if "case" in request:
            worker.run(from_json(request["case"]), 0)
            worker.tell(event="idle", leak="")
        else:
            worker.batch(**request)
    # Code that runs at exit is part of the attack: a crash there counts as a death.
    sys.exit(0)


if __name__ == "__main__":
    main()
