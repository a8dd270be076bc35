"""Writes the files of vectors next to this module: `python -m tests.vectors.write`."""

from __future__ import annotations

from pathlib import Path

from tests.vectors import bend, collect, fit_4pl, lens, lookup, morph_cases, rooms

FOLDER = Path(__file__).parent


def files() -> dict[str, str]:
    """Texts of all files by name."""
    return {
        name: text
        for oracle in (morph_cases, bend, lookup, lens, fit_4pl, rooms, collect)
        for name, text in oracle.files().items()
    }


def main() -> None:
    """Write every file."""
    for name, text in files().items():
        (FOLDER / name).write_text(text, encoding="utf-8", newline="\n")


if __name__ == "__main__":
    main()
