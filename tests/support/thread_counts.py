"""Processes with a given number of threads, each of which runs one program after another: it imports nearfar once."""

from __future__ import annotations

import atexit
import functools
import json
import os
import subprocess
import sys
import threading

SECONDS = 300
"""Timeout of a program in seconds."""

LOOP = """
import contextlib, io, json, sys, traceback
out = sys.stdout
for line in sys.stdin:
    printed, problem = io.StringIO(), ""
    try:
        with contextlib.redirect_stdout(printed):
            exec(json.loads(line), {"__name__": "__main__"})
    except BaseException:
        problem = traceback.format_exc()
    print(json.dumps([printed.getvalue(), problem]), file=out, flush=True)
"""


class Process:
    """A process that runs programs until this one ends."""

    def __init__(self, threads: str) -> None:
        environment = os.environ | {"NEARFAR_NUM_THREADS": threads, "PYTHONPATH": os.pathsep.join(sys.path)}
        self._process = subprocess.Popen(
            [sys.executable, "-c", LOOP], env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        atexit.register(self._end)

    def output_of(self, code: str) -> str:
        """Return the text that a program prints; AssertionError with its traceback if it fails."""
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        limit = threading.Timer(SECONDS, self._process.kill)
        limit.start()
        try:
            self._process.stdin.write(json.dumps(code) + "\n")
            self._process.stdin.flush()
            answer = self._process.stdout.readline()
        finally:
            limit.cancel()
        assert answer, f"the process ended: {self._process.wait()}"
        text, problem = json.loads(answer)
        assert not problem, problem
        return str(text)

    def _end(self) -> None:
        self._process.kill()
        self._process.communicate()


@functools.cache
def process(threads: str) -> Process:
    """Return the process with a number of threads, which starts on first use."""
    return Process(threads)


def output_of(code: str) -> str:
    """Return the output of a program that runs in another process."""
    return process("1").output_of(code)


def printed_by_threads(code: str, counts: str = "123") -> set[str]:
    """Return the output of a program in processes with these numbers of threads; one text if all agree."""
    return {process(threads).output_of(code) for threads in counts}
