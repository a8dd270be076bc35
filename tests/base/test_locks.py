"""File locks between processes, with the system's locks and on file systems without locks."""

from __future__ import annotations

import errno
import fcntl
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

from nearfar._base import locks

pytestmark = pytest.mark.filterwarnings("ignore:flock not supported")

HOLD = """
import errno, fcntl, sys
from pathlib import Path
def no_locks(*_):
    raise OSError(errno.ENOSYS, "no locks")
if sys.argv[2] == "no locks":
    fcntl.flock = no_locks
from nearfar._base import locks
print("ready", flush=True)
with locks.hold(Path(sys.argv[1]), None):
    print("held", flush=True)
    sys.stdin.read()
"""


@pytest.fixture(params=["locks", "no locks"])
def file_system(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> str:
    def no_locks(*_: object) -> None:
        raise OSError(errno.ENOSYS, "no locks")

    if request.param == "no locks":
        monkeypatch.setattr(fcntl, "flock", no_locks)
    return str(request.param)


def start(path: Path, file_system: str) -> subprocess.Popen[str]:
    """Start a process that takes the lock, reports it, and holds it until its input ends; it may still be waiting."""
    command = [sys.executable, "-W", "ignore", "-c", HOLD, str(path), file_system]
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, env=environment)
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    return process


@contextmanager
def holder(path: Path, file_system: str) -> Iterator[subprocess.Popen[str]]:
    """Yield another process that holds the lock; it is killed at the end."""
    with start(path, file_system) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == "held\n"
        yield process
        process.kill()


def test_one_process_holds_a_lock_until_it_ends(tmp_path: Path, file_system: str) -> None:
    path = tmp_path / "folder" / "lock"
    with holder(path, file_system) as process:
        with (
            pytest.raises(BlockingIOError, match="lock: another build writes"),
            locks.hold(path, "another build writes"),
        ):
            pass
        assert locks.try_hold(path) is None
        process.kill()
        process.wait()
        with locks.hold(path, "another build writes"):
            assert locks.try_hold(path) is None
    lock = locks.try_hold(path)
    assert lock is not None
    locks.remove(lock)
    assert list(path.parent.iterdir()) == []


def test_a_process_waits_for_the_end_of_another(tmp_path: Path, file_system: str) -> None:
    path = tmp_path / "lock"
    with holder(path, file_system):
        waiting = start(path, file_system)
        with pytest.raises(subprocess.TimeoutExpired):
            waiting.wait(timeout=0.5)
    assert waiting.communicate()[0] == "held\n"
    assert waiting.returncode == 0
