"""Tests of the script that injects faults, on made-up faults and outputs of test runs."""

from __future__ import annotations

from pathlib import Path

import pytest

from scripts.checkout_copy import Copy, Refused
from scripts.mutations import Fault, failures, faults, place, suites, without_fault

CARGO = "failures:\n\n---- a::tests::holds stdout ----\n\nthread panicked at a.rs:1:\nleft: 1\n"
TAP = "TAP version 13\n# Subtest: it walks\nnot ok 1 - it walks\n  ---\n  failureType: 'x'\n  error: 'two is one'\n"
CRASH = "TAP version 13\nnot ok 1 - build/tests/walk.test.mjs\n  ---\n  error: 'test failed'\n"


class Ran(Copy):
    """A copy in which every program has a given result."""

    def __init__(self, status: int, output: str) -> None:
        self.folder, self.ended = Path("none"), (status, output)

    def run(self, *command: str, folder: str = ".") -> tuple[int, str]:
        return self.ended


def test_a_fault_that_does_not_apply_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "package").mkdir()
    (tmp_path / "package" / "one.py").write_text("a = 1\nb = 1\n")

    def fault(old: str) -> Fault:
        return Fault("made.up", "made", "package", old, "2", ("tests/made",))

    assert place(tmp_path, fault("a = 1")) == tmp_path / "package" / "one.py"
    for old, count in (("c = 1", 0), ("= 1", 2)):
        with pytest.raises(Refused, match=f"{count} times"):
            place(tmp_path, fault(old))
    with pytest.raises(Refused, match="tests/made"):
        suites(fault("a = 1"), tmp_path / "package" / "one.py", tmp_path)


def test_every_fault_applies() -> None:
    tree = Path(__file__).parents[2]
    for fault in faults():
        suites(fault, place(tree, fault), tree)


def test_faults_are_read_from_tables(tmp_path: Path) -> None:
    (tmp_path / "some.toml").write_text("[view.turned]\nwhere = 'web'\nold = '+'\nnew = '-'\nslow = ['a.py']\n")
    assert faults(tmp_path) == [Fault("view.turned", "view", "web", "+", "-", ("tests/view",), ("a.py",))]


@pytest.mark.parametrize(
    ("suite", "status", "output", "expected"),
    [
        (("pytest", "t"), 0, "3 passed", []),
        (("pytest", "t"), 1, "FAILED t/a.py::test_b[c d] - assert 1 == 2", [("t/a.py::test_b[c d]", "assert 1 == 2")]),
        (("slow", "t"), 1, "ERROR t/a.py::test_b - OSError: gone", [("t/a.py::test_b", "OSError: gone")]),
        (("cargo", "core", "a::"), 101, CARGO, [("cargo: a::tests::holds", "thread panicked at a.rs:1: left: 1")]),
        (("node", "t"), 1, TAP, [("node: it walks", "'two is one'")]),
    ],
)
def test_failures_are_parsed_from_program_output(
    suite: tuple[str, ...], status: int, output: str, expected: list[tuple[str, str]]
) -> None:
    assert failures(Ran(status, output), suite) == expected


def test_a_few_tests_that_fail_without_a_fault_are_ignored() -> None:
    lines = [f"FAILED t/a.py::test_{number} - OSError: gone\n" for number in range(4)]
    assert without_fault(Ran(1, "".join(lines[:3])), ("pytest", "t")) == [
        f"t/a.py::test_{number}" for number in range(3)
    ]
    for status, output, suite in (
        (1, "".join(lines), ("pytest", "t")),
        (1, CARGO, ("cargo", "core", "a::")),
        (-9, "", ("pytest", "t")),
    ):
        with pytest.raises(Refused):
            without_fault(Ran(status, output), suite)


@pytest.mark.parametrize(
    ("suite", "status", "output"),
    [
        (("pytest", "t"), 1, "FAILED t/a.py::test_b - NameError: name 'x' is not defined"),
        (("pytest", "t"), 2, "ERROR t/a.py - ImportError: no x"),
        (("pytest", "t"), 5, "no tests ran"),
        (("cargo", "core", ""), 101, "error[E0308]: mismatched types"),
        (("node", "t"), 1, CRASH),
    ],
)
def test_suites_that_do_not_run_detect_nothing(suite: tuple[str, ...], status: int, output: str) -> None:
    with pytest.raises(Refused):
        failures(Ran(status, output), suite)
