"""Tests of `distribute`: equal results in this process, in worker processes and on a cluster, and errors."""

from __future__ import annotations

import functools
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import pytest

from nearfar._base import progress
from nearfar._base.distribute import distribute
from tests.support import need
from tests.support.distribute_cases import environment, squared

SQUARED = functools.partial(squared, offset=1)


@pytest.mark.slow
def test_results_come_in_the_order_of_the_items() -> None:
    expected = [1, 10, 5, 2, 26]
    for workers in (None, 1, 2):
        assert distribute(SQUARED, [0, 3, 2, 1, 5], label="squaring", workers=workers) == expected
        assert distribute(SQUARED, [], label="squaring", workers=workers) == []


@pytest.mark.slow
def test_a_cluster_gives_the_same() -> None:
    need("distributed")
    from distributed import Client, LocalCluster

    with (
        LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=":0") as cluster,
        Client(cluster) as client,
    ):
        assert distribute(SQUARED, (0, 3, 2), label="squaring", client=client) == [1, 10, 5]
        assert distribute(SQUARED, (), label="squaring", client=client) == []
        with pytest.raises(ValueError, match="item: expected a number of at least 0, got -1"):
            distribute(SQUARED, [3, -1], label="squaring", client=client)


@pytest.mark.parametrize("workers", [None, 1])
def test_the_first_error_is_raised(workers: int | None) -> None:
    with pytest.raises(ValueError, match="item: expected a number of at least 0, got -2"):
        distribute(SQUARED, [3, -2, 4], label="squaring", workers=workers)


@pytest.mark.slow
def test_processes_share_the_threads_of_the_machine(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NEARFAR_NUM_THREADS", raising=False)
    monkeypatch.setattr(os, "cpu_count", lambda: 6)
    outcomes = distribute(environment, ["NEARFAR_NUM_THREADS", "NEARFAR_PROGRESS"], label="looking", workers=8)
    assert [value for _, value in outcomes] == ["3", "0"]
    assert os.getpid() not in {process for process, _ in outcomes}
    monkeypatch.setenv("NEARFAR_NUM_THREADS", "1")
    assert distribute(environment, ["NEARFAR_NUM_THREADS"], label="looking", workers=1)[0][1] == "1"
    assert distribute(environment, ["NEARFAR_NUM_THREADS"], label="looking") == [(os.getpid(), "1")]


def test_progress_covers_all_items(monkeypatch: pytest.MonkeyPatch) -> None:
    shown: list[Any] = []

    @contextmanager
    def bar(label: str) -> Iterator[progress.Report]:
        shown.append(label)
        yield lambda finished, total: shown.append(finished / total)

    monkeypatch.setattr(progress, "bar", bar)
    distribute(squared, [1, 2], label="squaring")
    assert shown == ["squaring", 0.25, 0.75]


# Ctrl-C and scripts without a guard ----------------------------------------------------------------------------------
UNGUARDED = """
from nearfar._base.distribute import distribute
from tests.support.distribute_cases import squared
distribute(squared, [1], label="squaring", workers=1)
"""

ENDLESS = """
import multiprocessing, sys, time
from pathlib import Path
from nearfar._base.distribute import distribute
from tests.support import distribute_cases

if __name__ == "__main__":
    own = multiprocessing.get_context("spawn").Process(target=time.sleep, args=(1000,))
    own.start()
    try:
        work = getattr(distribute_cases, sys.argv[2])
        distribute(work, [Path(sys.argv[1]) / str(n) for n in range(4)], label="waiting", workers=2)
    finally:
        Path(sys.argv[1], "own").write_text(str(own.is_alive()))
        own.kill()
"""

DEAF = """
import sys
from pathlib import Path
from nearfar._base.distribute import distribute
from tests.support.distribute_cases import deaf

if __name__ == "__main__":
    distribute(deaf, [Path(sys.argv[1]) / str(n) for n in range(4)], label="waiting", workers=2)
"""


def start_script(folder: Path, code: str, *arguments: str) -> subprocess.Popen[str]:
    script = folder / "script.py"
    script.write_text(code)
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, str(script), str(folder), *arguments]
    return subprocess.Popen(command, env=environment, stderr=subprocess.PIPE, text=True)


@pytest.mark.slow
def test_a_script_without_a_main_guard_is_told_so(tmp_path: Path) -> None:
    program = start_script(tmp_path, UNGUARDED)
    message = program.communicate(timeout=120)[1]
    assert message.splitlines()[-1].startswith("RuntimeError: workers: a process ended at once")


def until(is_reached: Callable[[], bool]) -> bool:
    deadline = time.monotonic() + 600
    while not is_reached() and time.monotonic() < deadline:
        time.sleep(0.05)
    return is_reached()


def started_items(folder: Path) -> list[str]:
    """Process numbers of the workers that have started one of the script's items."""
    return [text for number in range(4) if (path := folder / str(number)).exists() and (text := path.read_text())]


def have_ended(processes: Iterable[str]) -> bool:
    """Whether no process runs; one whose parent has not read its status counts as ended."""
    states = []
    for name in processes:
        # Linux raises either error for a process that has just ended.
        with suppress(FileNotFoundError, ProcessLookupError):
            states.append(Path(f"/proc/{name}/stat").read_text())
    return all(state.rpartition(")")[2].split()[0] == "Z" for state in states)


@pytest.mark.slow
@pytest.mark.parametrize("work", ["endless", "half_written"])
def test_ctrl_c_ends_all_processes(tmp_path: Path, work: str) -> None:
    need("linux")
    program = start_script(tmp_path, ENDLESS, work)
    try:
        assert until(lambda: len(started_items(tmp_path)) == 2)
        program.send_signal(signal.SIGINT)
        message = program.communicate(timeout=600)[1]
        assert message.splitlines()[-1] == "KeyboardInterrupt"
        assert until(lambda: have_ended(started_items(tmp_path)))
        assert (tmp_path / "own").read_text() == "True"  # a process that others made goes on
        # An executor starts one item more than it has workers; that one ends at its first report.
        assert len(started_items(tmp_path)) <= 3
    finally:
        program.kill()
        program.wait()


@pytest.mark.slow
def test_workers_end_with_a_killed_program(tmp_path: Path) -> None:
    need("linux")
    # Leaving the block waits for the program's end.
    with start_script(tmp_path, DEAF) as program:
        try:
            assert until(lambda: len(started_items(tmp_path)) == 2)
        finally:
            program.kill()
    workers = started_items(tmp_path)
    try:
        assert until(lambda: have_ended(workers))
    finally:
        for worker in workers:
            # The numbers of processes that have ended may belong to others.
            if not have_ended([worker]):
                os.kill(int(worker), signal.SIGKILL)
