"""Setup of the tests."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Iterator
from typing import Any

import pytest
from hypothesis import HealthCheck, settings

from tests.support import PARTS, marks, need, required
from tests.support.browser import hidden_loop, programs, started
from tests.support.skips import untested

# No deadline, because other work on the machine would decide the result. The thorough profile is for `make stress`.
settings.register_profile("fast", deadline=None, max_examples=50, suppress_health_check=[HealthCheck.too_slow])
settings.register_profile("thorough", deadline=None, max_examples=2000, suppress_health_check=list(HealthCheck))
settings.load_profile(os.environ.get("NEARFAR_HYPOTHESIS", "fast"))

os.environ.setdefault("NEARFAR_PROGRESS", "0")

# Jupyter installs a grammar of addresses for jsonschema, which takes two seconds to import, and no schema here uses.
sys.modules["rfc3987_syntax"] = None  # type: ignore[assignment]


def pytest_configure(config: pytest.Config) -> None:
    """Refuse unknown names of required parts; a misspelt name would always skip tests."""
    unknown = required() - PARTS.keys()
    if unknown:
        raise pytest.UsageError(f"NEARFAR_REQUIRE: expected names from {sorted(PARTS)}, got {sorted(unknown)}")
    # Shells start background jobs with Ctrl-C ignored, and Python inherits that: tests of Ctrl-C would hang.
    if threading.current_thread() is threading.main_thread():
        signal.signal(signal.SIGINT, signal.default_int_handler)


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Tell `need` which marks the test has."""
    marks.clear()
    marks.update(mark.name for mark in item.iter_markers())


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    """Print in one line what was not tested."""
    reasons = [report.longrepr[2] for report in terminalreporter.stats.get("skipped", ())]
    if line := untested(reasons):
        terminalreporter.line(line)


@pytest.fixture(autouse=True)
def _own_cache(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> None:
    """Give tests a separate cache folder."""
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path_factory.getbasetemp() / "cache"))


@pytest.fixture(scope="session", autouse=True)
def _no_flushes() -> Iterator[None]:
    """Write files without waiting for the disk, which takes milliseconds each: no test simulates a power failure."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(os, "fsync", lambda descriptor: None)
        yield


_shared: list[Any] = []


@pytest.fixture(scope="session")
def chromium() -> Iterator[Any]:
    """A browser for all tests of a process."""
    need("browser")
    with started() as program:
        _shared.append(program)
        yield program


@pytest.fixture(autouse=True)
def _own_loop(request: pytest.FixtureRequest) -> Iterator[None]:
    """Let tests without a browser run their own asyncio loop; other browsers belong to their tests."""
    if "chromium" in request.fixturenames or len(programs) > len(_shared):
        yield
    else:
        with hidden_loop():
            yield
