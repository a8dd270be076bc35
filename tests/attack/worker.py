"""A process that runs cases one after another and reports each: `python -m tests.attack.worker PIPE FILE [probe]`."""

from __future__ import annotations

import ctypes
import faulthandler
import json
import os
import resource
import shutil
import signal
import sys
import tempfile
import time
import traceback
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tests.attack.case import Case, Finding, Kind, from_json

MAX_ADDRESSES = 12 << 30
"""Bytes of address space, so that a defect does not take the machine's memory."""

MAX_EXTRA_DESCRIPTORS = 16
"""Open files that a batch may leave: caches and pools open some once."""

_SET_DEATH_SIGNAL = 1


class Worker:
    """Runs cases and writes one line of JSON for each event to `report`."""

    def __init__(self, report: int, kinds: Mapping[str, Kind]) -> None:
        self._report, self._kinds = report, kinds
        self._warnings: list[str] = []
        self._printed = os.fstat(2).st_size
        warnings.simplefilter("always")
        # A damaged file may contain places at which a picture folds.
        warnings.filterwarnings("ignore", "the picture folds")
        warnings.showwarning = self._note_warning  # type: ignore[assignment]

    def _note_warning(self, message: object, category: type[Warning], filename: str, lineno: int, *_: object) -> None:
        # A file that an exception leaves open between two Python instructions is closed with its last reference.
        if issubclass(category, ResourceWarning):
            return
        place = "/".join(Path(filename).parts[-3:])
        self._warnings.append(f"{category.__name__} at {place}:{lineno}: {str(message).splitlines()[0]}")

    def tell(self, **event: Any) -> None:
        """Report an event."""
        os.write(self._report, json.dumps(event).encode() + b"\n")

    def run(self, case: Case) -> None:
        """Run a case in its own folder."""
        folder = Path(tempfile.mkdtemp())
        try:
            case.write(folder)
            self.tell(begins=case.origin)
            self._warnings.clear()
            Path("/proc/self/clear_refs").write_text("5", encoding="ascii")  # Resets the peak.
            before, start = memory("VmRSS"), time.perf_counter()
            outcome, finding, trace = self._outcome(case, folder)
            seconds, more = time.perf_counter() - start, max(0, memory("VmHWM") - before)
            finding = finding or self._aftermath(folder)
            self.tell(outcome=outcome, seconds=seconds, memory=more, finding=finding, trace=trace)
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def _outcome(self, case: Case, folder: Path) -> tuple[str, str, str]:
        """Return outcome, finding and traceback of a case."""
        try:
            return self._kinds[case.kind].run(case, folder), "", ""
        except Finding as error:
            return "finding", str(error), _trace(error.__cause__ or error)
        except BaseException as error:
            text = next(iter(str(error).splitlines()), "")
            return "finding", f"wrong exception {type(error).__name__}: {text[:300]}", _trace(error)

    def _aftermath(self, folder: Path) -> str:
        """Return a finding about resources that a case did not release."""
        printed, self._printed = self._printed, os.fstat(2).st_size
        if self._printed > printed:
            return "text was printed"
        if self._warnings:
            return f"a warning reached the user: {self._warnings[0]}"
        left = [path.name for path in folder.iterdir() if path.name.startswith(".") and path.name != ".results"]
        return f"temporary files were left: {', '.join(left)}" if left else ""


def memory(name: str) -> int:
    """Return a number of bytes from the status of this process."""
    lines = Path("/proc/self/status").read_text(encoding="ascii", errors="replace").splitlines()
    return 1024 * int(next(line for line in lines if line.startswith(name)).split()[1])


def _trace(error: BaseException) -> str:
    """Return the last calls of a traceback, calls within the package first."""
    frames = traceback.extract_tb(error.__traceback__)
    own = [frame for frame in frames if "/nearfar/" in frame.filename] or frames
    return " < ".join(f"{'/'.join(Path(f.filename).parts[-2:])}:{f.lineno} {f.name}" for f in reversed(own[-3:]))


def all_kinds(*, own_only: bool) -> dict[str, Kind]:
    """Return the kinds by name; `own_only` restricts them to generated files."""
    from tests.attack import (
        kind_arguments,
        kind_interrupts,
        kind_long,
        kind_saved,
        kind_saves,
        kind_scenes,
        kind_together,
    )

    modules = (kind_saved, kind_arguments, kind_saves, kind_interrupts, kind_together, kind_long)
    listed = [*kind_scenes.kinds(own_only=own_only), *(kind for module in modules for kind in module.kinds())]
    return {kind.name: kind for kind in listed}


def main(report: int, listed: Path, *, probe: bool) -> str:
    """Run the cases of a file; returns what is wrong at the end."""
    faulthandler.enable(all_threads=True)
    faulthandler.register(signal.SIGUSR1, all_threads=True)
    resource.setrlimit(resource.RLIMIT_AS, (MAX_ADDRESSES, resource.getrlimit(resource.RLIMIT_AS)[1]))
    # The system kills this process when the one that started it dies, so that no hanging case stays behind.
    ctypes.CDLL(None).prctl(_SET_DEATH_SIGNAL, signal.SIGKILL)
    if probe:  # Imported before the package.
        from tests.attack.kind_probe import KIND

        worker = Worker(report, {KIND.name: KIND})
    else:
        worker = Worker(report, all_kinds(own_only=True))
    before = len(os.listdir("/proc/self/fd"))
    for text in json.loads(listed.read_text(encoding="utf-8")):
        worker.run(from_json(text))
    more = len(os.listdir("/proc/self/fd")) - before
    return f"{more} files are left open" if more > MAX_EXTRA_DESCRIPTORS else ""


if __name__ == "__main__":
    # Code that runs at exit is part of the attack: a crash there counts as a death.
    sys.exit(main(int(sys.argv[1]), Path(sys.argv[2]), probe=sys.argv[3] == "probe") or None)
