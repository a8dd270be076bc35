"""Seeds typical engineering faults, one at a time, and reports which tests catch them.

python -m scripts.mutations [--only NAME ...] [--list] [--at COMMIT] [--beside EARLIER.json] [--out FOLDER]

Each table of tests/mutations/*.toml is named by a stage and the fault: `where` is the file or folder in which the text
`old` occurs exactly once, and `new` replaces it. Texts, unlike patches, remain valid when lines and files move. `tests`
lists what pytest runs (by default tests/STAGE), `slow` the files of slow tests that run if nothing else fails.

A copy of the checkout is kept in a separate folder (`--copy`), so that Rust is compiled completely only once. Tests
first run there without a fault; up to three failing ones of a suite are printed and left out. A fault that no longer
applies, that does not compile, or after which tests fail to run, is an error and does not count as caught.
"""

from __future__ import annotations

import argparse
import json
import re
import resource
import shutil
import sys
import tempfile
import tomllib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from scripts.checkout_copy import RUST, TEST_TIMEOUT, Copy, Refused, content_at

CHECKOUT = Path(__file__).resolve().parents[1]
FAULTS = CHECKOUT / "tests" / "mutations"
LANGUAGES = {".py": "Python", ".ts": "TypeScript", ".rs": "Rust"}
"""Languages by suffix of files that may have faults, besides shaders."""
BROKEN = re.compile(r"\b(ImportError|ModuleNotFoundError|SyntaxError|IndentationError|NameError|UnboundLocalError)\b")
"""Failures that reveal a fault independently of the tests."""
MAX_LEFT_OUT = 3
"""Maximum number of tests of a suite that may fail without a fault."""


@dataclass(frozen=True)
class Fault:
    """A text and its replacement."""

    name: str
    stage: str
    where: str
    old: str
    new: str
    tests: tuple[str, ...]
    slow: tuple[str, ...] = ()


def faults(folder: Path = FAULTS) -> list[Fault]:
    """Read all faults of a folder's tables, by file, stage and name."""
    all_faults = []
    for path in sorted(folder.glob("*.toml")):
        for stage, named in tomllib.loads(path.read_text(encoding="utf-8")).items():
            for name, given in named.items():
                tests, slow = given.pop("tests", [f"tests/{stage}"]), given.pop("slow", [])
                all_faults.append(Fault(f"{stage}.{name}", stage, **given, tests=tuple(tests), slow=tuple(slow)))
    return all_faults


def place(tree: Path, fault: Fault) -> Path:
    """Return the file in which a fault's text occurs exactly once; Refused otherwise."""
    root = tree / fault.where
    files = [root] if root.is_file() else [path for path in sorted(root.rglob("*")) if path.is_file()]
    readable = (path for path in files if path.suffix in {*LANGUAGES, *RUST})
    counts = {path: path.read_text(encoding="utf-8").count(fault.old) for path in readable}
    if sum(counts.values()) != 1:
        raise Refused(f"does not apply: its text occurs {sum(counts.values())} times in {fault.where}")
    return next(path for path, count in counts.items() if count)


Suite = tuple[str, ...]
"""Name of a program that runs tests, and its arguments."""


def suites(fault: Fault, path: Path, tree: Path) -> list[Suite]:
    """The tests of a fault, those most likely to catch it first."""
    missing = [name for name in (*fault.tests, *fault.slow) if not (tree / name).exists()]
    if missing:
        raise Refused(f"names tests that are not there: {', '.join(missing)}")
    pytest, slow = [("pytest", *fault.tests)], [("slow", *fault.slow)] if fault.slow else []
    parts = path.relative_to(tree).parts
    if path.suffix == ".ts":
        return [("node", "build/tests"), *slow]
    if parts[:2] == ("rust", "serve"):
        return [("cargo", "nearfar-serve", ""), *pytest, *slow]
    if parts[:2] == ("rust", "core"):
        return [*pytest, ("cargo", "nearfar-core", f"{Path(parts[3]).stem}::"), *slow]
    return [*pytest, *slow]


def failures(copy: Copy, suite: Suite, left_out: Sequence[str] | None = None) -> list[tuple[str, str]]:
    """Run tests and return the first failure with its message; Refused if they do not run.

    `left_out` names tests of pytest that fail without a fault; None runs all tests and returns all that fail.
    """
    kind, *rest = suite
    if kind == "node":
        status, output = copy.run("node", "--test", "--test-reporter=tap", *rest, folder="web")
        pattern = r"^\s*not ok \d+ - (?P<name>.*?)\n(?:.*\n)*?\s*error: (?:\|-\n)?(?P<message>.*)"
    elif kind == "cargo":
        status, output = copy.run("cargo", "test", "--quiet", "-p", rest[0], "--lib", *filter(None, rest[1:]))
        pattern = r"^---- (?P<name>\S+) stdout ----\n+(?P<message>.*\n.*)"
    else:
        # Examples by which another fault was caught.
        shutil.rmtree(copy.folder / ".hypothesis", ignore_errors=True)
        marks = ["-m", "slow and not stress"] if kind == "slow" else []
        stop = [] if left_out is None else ["-x", *(f"--deselect={name}" for name in left_out)]
        options = [*stop, "-rfE", "--tb=short", "-p", "no:cacheprovider", *marks]
        status, output = copy.run(sys.executable, "-m", "pytest", *options, *rest)
        pattern = r"^(?:FAILED|ERROR) (?P<name>\S+::.*?)(?: - (?P<message>.*))?$"
    if status == 0:
        return []
    if status < 0:
        if left_out is None:
            raise Refused(f"{' '.join(suite)} never ends or crashes without a fault")
        return [(f"{' '.join(suite)} never ends or crashes", f"ended by a signal, or after {TEST_TIMEOUT} s")]
    failed = []
    for found in re.finditer(pattern, output, re.MULTILINE):
        message = " ".join((found["message"] or "").split())[:200]
        if BROKEN.search(message):
            raise Refused(f"{found['name']} fails for another reason: {message}")
        failed.append((found["name"] if kind in {"pytest", "slow"} else f"{kind}: {found['name']}", message))
    if not failed or failed[0][0].endswith(".mjs"):
        raise Refused(f"{' '.join(suite)} does not run: {output.strip()[-600:]}")
    return failed


def seconds() -> float:
    """CPU seconds of the ended child processes."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def without_fault(copy: Copy, suite: Suite) -> list[str]:
    """Run tests that should pass; return the few of pytest that fail, to be left out; Refused if there are more."""
    failed = [name for name, _ in failures(copy, suite)]
    if failed:
        print(f"fails without a fault: {', '.join(failed)}"[:400], flush=True)
    if len(failed) > MAX_LEFT_OUT or (failed and suite[0] not in {"pytest", "slow"}):
        raise Refused(f"its tests fail without it: {', '.join(failed)}"[:400])
    return failed


def seeded(copy: Copy, fault: Fault, left_out: Mapping[Suite, Sequence[str]]) -> dict[str, Any]:
    """Seed one fault and run its tests without those that fail anyway.

    Returns its name, its language, the first test that failed (empty for none), its message, the CPU seconds for
    building and testing, and the tests that were left out.
    """
    path, begin = place(copy.folder, fault), seconds()
    fault_suites = suites(fault, path, copy.folder)
    text = path.read_text(encoding="utf-8")
    try:
        path.write_text(text.replace(fault.old, fault.new), encoding="utf-8")
        copy.build(path.suffix)
        match = next(
            (failed[0] for suite in fault_suites if (failed := failures(copy, suite, left_out[suite]))), ("", "")
        )
    finally:
        path.write_text(text, encoding="utf-8")
    language = LANGUAGES[path.suffix] if path.parent.name != "shaders" else "shaders"
    cpu_seconds = round(seconds() - begin, 1)
    skipped = sorted({name for suite in fault_suites for name in left_out[suite]})
    row = {"name": fault.name, "language": language, "caught": match[0], "message": match[1], "seconds": cpu_seconds}
    return row | {"left out": skipped}


def table(results: Iterable[Mapping[str, Any]], earlier: Mapping[str, str]) -> str:
    """Format results as Markdown, with those of another run."""
    head = ["fault", "language", *(["caught before by"] if earlier else []), "caught by", "CPU s"]
    lines = [head, ["---"] * len(head)]
    for row in results:
        before = [earlier.get(row["name"], "–") or "MISSED"] if earlier else []
        caught = row["caught"] or "MISSED"
        lines.append([row["name"], row["language"], *before, caught, f"{row['seconds']:.0f}"])
    return "".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |\n" for line in lines)


def main() -> None:
    """Seed all faults, or those named; exit with status 1 if one is missed or refused."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="+", metavar="NAME", help="names of faults or stages")
    parser.add_argument("--list", action="store_true", help="print the names and end")
    parser.add_argument("--at", metavar="COMMIT", help="a commit instead of the working tree")
    parser.add_argument("--beside", type=Path, metavar="FILE", help="results of an earlier run, for the table")
    parser.add_argument("--out", type=Path, default=CHECKOUT / "out" / "mutations")
    parser.add_argument("--copy", type=Path, default=Path(tempfile.gettempdir()) / "nearfar-mutations")
    options = parser.parse_args()
    selected = [fault for fault in faults() if not options.only or {fault.name, fault.stage} & {*options.only}]
    if options.list or not selected:
        print("\n".join(fault.name for fault in selected))
        return
    copy = Copy(options.copy.resolve())
    copy.fill(CHECKOUT, content_at(CHECKOUT, options.at))
    results, refused = run_all(copy, selected)
    earlier = json.loads(options.beside.read_text(encoding="utf-8")) if options.beside else []
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "mutations.json").write_text(json.dumps(results, indent=1, ensure_ascii=False), encoding="utf-8")
    text = table(results, {row["name"]: row["caught"] for row in earlier})
    (options.out / "mutations.md").write_text(text, encoding="utf-8")
    missed = [f"{row['name']}: missed" for row in results if not row["caught"]]
    if missed or refused:
        sys.exit("\n".join([*missed, *(f"{name}: {why}" for name, why in refused.items())]))


def run_all(copy: Copy, wanted: Iterable[Fault]) -> tuple[list[dict[str, Any]], dict[str, str]]:
    """Run the tests without faults and then with each; return rows of results, and reasons of refusals."""
    results, refused, left_out = [], {}, dict[Suite, list[str]]()
    for kind in LANGUAGES:
        copy.build(kind)
    # Faults of one language follow each other, so that builds of other languages stay valid.
    kinds = dict.fromkeys(wanted, "")
    for fault in kinds:
        try:
            path = place(copy.folder, fault)
            kinds[fault] = path.suffix
            for suite in suites(fault, path, copy.folder):
                if suite not in left_out:
                    left_out[suite] = without_fault(copy, suite)
        except Refused as error:
            refused[fault.name] = str(error)
    last = ""
    for fault in sorted((fault for fault in kinds if fault.name not in refused), key=kinds.__getitem__):
        try:
            if last and last != kinds[fault]:
                copy.build(last)
            last = kinds[fault]
            results.append(seeded(copy, fault, left_out))
            print(f"{fault.name}: {results[-1]['caught'] or 'MISSED'} ({results[-1]['message']})", flush=True)
        except Refused as error:
            refused[fault.name] = str(error)
            print(f"{fault.name}: {error}", flush=True)
    return results, refused


if __name__ == "__main__":
    main()
