"""Tests of the benchmarks' harness: options, tables, timing, comparison, plots."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
from PIL import Image

from benchmarks.harness import compare, report, timing
from benchmarks.harness.compare import Case, Comparison, Limits, Result, Work
from benchmarks.harness.report import FOLDER, start, table
from benchmarks.harness.timing import Timing
from tests.support import PARTS, need
from tests.support.skips import INSTALLERS, untested


def test_cells_of_a_table_have_the_formats_of_their_columns() -> None:
    rows = [["a", 1.234, (5, 6), None], ["b", "–", (7, 8), 9000]]
    text = table("Title", "|x| | ms {:.1f} | of {} of {} | n {:,}", rows)
    lines = ["### Title", "", "| |x| | ms | of | n |", "| --- | --- | --- | --- |"]
    assert text.splitlines() == [*lines, "| a | 1.2 | 5 of 6 |  |", "| b | – | 7 of 8 | 9,000 |"]


def test_options_have_the_types_of_their_defaults(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    given = ["--quick", "--sides", "2", "4", "--place", "here", "--real", "one", "two"]
    monkeypatch.setattr("sys.argv", ["benchmark", *given])
    monkeypatch.setenv(FOLDER, str(tmp_path / "plots"))
    own = {"sides": [1.0], "place": (str, "a place"), "real": (bool, "really"), "tables": {"nargs": "*"}}
    options = start("Text.", "--quick", "--plots", **own, repeat=3)
    assert (options.quick, options.sides, options.place, options.real) == (True, [2.0, 4.0], "here", True)
    assert (options.repeat, options.tables) == (3, ["one", "two"])
    assert options.plots == tmp_path / "plots"
    assert options.plots.is_dir()
    assert capsys.readouterr().out == f"{report.machine()}\n\n"


def test_jobs_take_turns_and_the_least_times_count(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = [0.0]
    steps = {"a": iter([3.0, 1.0, 2.0]), "b": iter([5.0, 6.0, 4.0])}
    monkeypatch.setattr(timing, "time", SimpleNamespace(perf_counter=lambda: clock[0], process_time=lambda: 0.0))
    order: list[str] = []

    def job(name: str) -> None:
        order.append(name)
        clock[0] += next(steps[name])

    found = timing.best_in_turns({name: lambda name=name: job(name) for name in steps}, 3, lambda: 2 * clock[0])  # type: ignore[misc]
    assert found == {"a": Timing(1.0, 2.0), "b": Timing(4.0, 8.0)}
    assert order == ["a", "b"] * 3


def test_cases_are_timed_and_compared(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    need("matplotlib")
    monkeypatch.setenv(FOLDER, str(tmp_path))
    calls: list[str] = []
    clock = [0.0]
    clocks = SimpleNamespace(perf_counter=lambda: clock[0], process_time=lambda: clock[0])
    monkeypatch.setattr(timing, "time", clocks)

    def job(name: str, seconds: float, value: float) -> Case:
        def run() -> float:
            calls.append(name)
            clock[0] += seconds
            return value

        return Case(name, run, lambda found: abs(found - 1.0))

    text = compare.compare("A job", [job(compare.OURS, 0.002, 1.0), job("a peer", 0.02, 1.5)], repeat=2, unit="m")
    lines = [line for line in text.splitlines() if line.startswith("|")]
    assert lines[0] == "|  | wall ms | CPU ms | × nearfar | error, m |"
    ours, peer = (line.split(" | ") for line in lines[2:])
    assert ours[0] == "| nearfar"
    assert ours[3:] == ["1.00", "0.0e+00 |"]
    assert peer[3] == "10.00"
    assert peer[4] == "5.0e-01 |"
    assert calls[:4] == ["nearfar", "a peer", "nearfar", "nearfar"]
    assert "![A job](a-job.png)" in text
    with Image.open(tmp_path / "a-job.png") as picture:
        assert np.asarray(picture.convert("L")).std() > 1


def test_plots_are_drawn_only_on_request_and_with_errors(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    exact = Comparison("exact", [Result(compare.OURS, Timing(1.0, 1.0), 0.0)], None, "")
    torn = Comparison("torn", [Result(compare.OURS, Timing(1.0, 1.0), 0.1)], None, "")
    assert compare.draw([torn], "torn") is None
    monkeypatch.setenv(FOLDER, str(tmp_path))
    assert compare.draw([exact], "exact") is None
    assert list(tmp_path.iterdir()) == []


def test_the_pareto_front_contains_undominated_points() -> None:
    points = [(1.0, 5.0), (2.0, 1.0), (3.0, 1.0), (0.5, 9.0), (4.0, 8.0)]
    front = [point for point in points if not any(compare._dominates(other, point) for other in points)]
    assert sorted(front) == [(0.5, 9.0), (1.0, 5.0), (2.0, 1.0)]


def test_limits_apply_to_slower_results() -> None:
    here = Limits({False: 100.0, True: 50.0}, 10.0)
    assert here.seconds(Work(multiply_adds=1000, bytes=10)) == 10
    assert here.seconds(Work(multiply_adds=1000, double=True)) == 20
    assert here.seconds(Work(multiply_adds=10, bytes=1000)) == 100


def test_skipped_tests_are_counted_by_requirement() -> None:
    reasons = ["Skipped: vulkan: no adapter", "Skipped: vulkan: no adapter", "Skipped: data: none", "Skipped: rare"]
    assert untested([]) == ""
    assert untested(reasons) == (
        "not tested: 4, which need vulkan (2), data (1), rare (1); "
        "to test them: sudo scripts/system-packages.sh, NEARFAR_DATA=FOLDER, make setup"
    )
    assert set().union(*INSTALLERS.values()) <= PARTS.keys()
