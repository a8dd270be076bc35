"""Runs some of the slow tests: those of the stages that a change touches, or a third of the others.

`python -m tests.slow changed COMMIT` runs the first for changes since a commit, `python -m tests.slow third COMMIT`
the second. With `--list` both only print what they would run. Without the commit everything counts as changed.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
from pathlib import Path

from tests.support.changes import ALL, choose

CHECKOUT = Path(__file__).resolve().parents[1]
PYTEST = ("-m", "pytest", "-n", "auto", "--dist", "worksteal", "-m", "slow and not stress")

Reasons = dict[str, str]
"""Folders of tests, and why they were selected."""


def main() -> int:
    """Run what the command line requests; returns the exit status."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("which", choices=("changed", "third"))
    parser.add_argument("base", nargs="?", help="the commit before the change")
    parser.add_argument("--list", action="store_true", help="only say what would run")
    arguments = parser.parse_args()
    paths, source = changes(arguments.base)
    reasons = {ALL: source} if paths is None else choose(paths)
    if arguments.which == "third":
        return run(third(reasons), is_listed=arguments.list)
    print(f"slow tests of what changed since {source}:" if paths is not None else f"all slow tests, because {source}:")
    for folder, path in reasons.items():
        print(f"  {folder}: {path}")
    return run(files_of(reasons), is_listed=arguments.list)


def changes(base: str | None) -> tuple[list[str] | None, str]:
    """Changed files and the previous commit; None and the reason if it is unknown."""
    if base is None:
        return None, "no commit is given"
    if git("merge-base", "--is-ancestor", base, "HEAD") is None:
        return None, f"{base} is no commit before this one"
    listed = (git("diff", "--name-only", base), git("ls-files", "--others", "--exclude-standard"))
    return [line for text in listed if text is not None for line in text.splitlines()], base


def git(*arguments: str) -> str | None:
    """Output of git; None if it fails."""
    try:
        process = subprocess.run(["git", *arguments], cwd=CHECKOUT, capture_output=True, text=True, check=False)
    except FileNotFoundError:
        return None
    return process.stdout if process.returncode == 0 else None


def slow_files() -> list[str]:
    """Files with slow tests."""
    paths = sorted((CHECKOUT / "tests").glob("*/test_*.py"))
    return [str(path.relative_to(CHECKOUT)) for path in paths if "mark.slow" in path.read_text(encoding="utf-8")]


def files_of(reasons: Reasons) -> list[str]:
    """Files with slow tests in the chosen folders."""
    return [path for path in slow_files() if ALL in reasons or Path(path).parts[1] in reasons]


def third(reasons: Reasons) -> list[str]:
    """One third of the files with slow tests that were not selected: the next one with each commit."""
    count = git("rev-list", "--count", "HEAD") if git("rev-parse", "--is-shallow-repository") == "false\n" else None
    turn = int(count or 0) % 3
    chosen = set(files_of(reasons))
    others = [path for path in slow_files() if path not in chosen]
    print(f"slow tests of other stages: third {turn + 1} of 3, {len(others[turn::3])} of {len(others)} files")
    return others[turn::3]


def run(files: list[str], *, is_listed: bool) -> int:
    """Run the slow tests of files; returns the exit status."""
    if is_listed or not files:
        print("\n".join(files) or "none")
        return 0
    return subprocess.run([sys.executable, *PYTEST, *files], cwd=CHECKOUT, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
