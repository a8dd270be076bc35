"""Tests of shell conventions: negative points, axes with a sign, progress in logs, plain words in help."""

from __future__ import annotations

import re
import subprocess
import sys
import time
from pathlib import Path

import pytest

from nearfar._base import progress
from nearfar.cli._app import app
from nearfar.cli._output import Clock
from tests.support.cli_cases import city as city, command, document


@pytest.mark.parametrize("point", ["-30,2,40", "-30 2 40", "-30, 2, 40"])
def test_points_may_be_negative_and_separated_by_spaces(
    point: str, city: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, out, err = command(capsys, "partition", "-i", city, "--center", point, "--json")
    assert status == 0, err
    assert document(out, "partition")["center"] == [-30, 2, 40]


@pytest.mark.parametrize(("up", "height"), [("y", 25.0), ("-y", 25.0), ("x", 200.0), ("-z", 200.0)])
def test_axes_may_have_a_sign(up: str, height: float, city: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, out, err = command(capsys, "info", "-i", city, "--up", up, "--json")
    assert status == 0, err
    low, high = document(out, "info")["bounds"]
    assert high[1] - low[1] == pytest.approx(height, abs=0.01)


def test_progress_is_written_as_lines_without_a_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    clock = [0.0]
    monkeypatch.setenv("NEARFAR_PROGRESS", "1")
    monkeypatch.setattr(time, "monotonic", lambda: clock[0])
    with progress.bar("baking") as report:
        clock[0] = 60.0
        report(1, 4)
    assert capsys.readouterr().err == ""
    with progress.lines():
        for label in ("baking", "rendering"):
            with progress.bar(label) as report:
                for second in range(1, 26):
                    clock[0] += 1.0
                    report(second, 50)
        lines = capsys.readouterr().err.splitlines()
        assert len(lines) == 5
        assert lines[0] == "nearfar: baking, 20 %, 10 s, about 40 s left"
        assert lines[-1].startswith("nearfar: rendering, ")
        with progress.bar("resuming") as report:  # half of the work is passed over; then the speed counts
            for second in range(1, 21):
                clock[0] += 1.0
                report(1000 + second, 2000)
        assert capsys.readouterr().err.splitlines()[-1] == "nearfar: resuming, 51 %, 20 s, about 16 min left"
        with Clock().step("impostors"), progress.bar("casting rays") as report:
            clock[0] += 10.0
            report(1, 2)
        assert capsys.readouterr().err == "nearfar: impostors: casting rays, 50 %, 10 s, about 10 s left\n"
        monkeypatch.setenv("NEARFAR_PROGRESS", "0")
        with progress.bar("hidden") as report:
            clock[0] += 60.0
            report(1, 4)
    assert capsys.readouterr().err == ""


def test_help_and_tables_use_plain_words(city: Path, capsys: pytest.CaptureFixture[str]) -> None:
    texts = [command(capsys, name, "--help")[1] for name in (c.name or "" for c in app.registered_commands)]
    texts.append(command(capsys, "partition", "-i", city, "--center", "0,1.7,0", "--r1", "10", "--r2", "20")[1])
    for text in texts:
        assert not re.search(r"\b(nsf|sf|examined)\b", text, re.IGNORECASE)
    assert "near zone" in " ".join(texts)
    for words in ("near, within r1", "intermediate, between r1 and r2", "they cross r2"):
        assert words in texts[-1]


def test_ctrl_c_during_imports_ends_quietly() -> None:
    program = """
import os, signal, sys
from nearfar.cli import main

class Finder:
    def find_spec(self, name, *_):
        if name == "typer":
            os.kill(os.getpid(), signal.SIGINT)

sys.meta_path.insert(0, Finder())
main()
"""
    ended = subprocess.run([sys.executable, "-c", program, "info", "city"], capture_output=True, text=True, check=False)
    assert (ended.returncode, ended.stdout, ended.stderr) == (130, "", "nearfar: interrupted\n")
