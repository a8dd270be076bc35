"""Tests that the files of vectors equal the output of their oracles."""

from __future__ import annotations

from tests.vectors.write import FOLDER, files


def test_files_equal_the_output_of_the_oracles() -> None:
    written = {path.name: path.read_text(encoding="utf-8") for path in FOLDER.glob("*.json")}
    expected = files()
    assert sorted(written) == sorted(expected)
    changed = [name for name, text in expected.items() if written[name] != text]
    assert changed == [], "run `python -m tests.vectors.write`"


def test_files_are_small() -> None:
    assert {path.name for path in FOLDER.glob("*.json") if path.stat().st_size > 60_000} == set()
