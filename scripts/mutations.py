"""Seeds faults of the kinds that engineers make, one at a time, and finds out which tests catch them.

python scripts/mutations.py [--only NAME ...] [--list] [--at COMMIT] [--beside EARLIER.json] [--out FOLDER]

Each table of tests/mutations/*.toml is named by a stage and the fault: `where` is the file or folder in which the text
`old` occurs exactly once, and `new` takes its place. Texts instead of patches: they hold when lines and files move.
`tests` lists what pytest runs (by default tests/STAGE), `slow` the files of slow tests that run if nothing else fails.

A copy of the checkout lies in a folder of its own (`--copy`), which stays, so that Rust is compiled as a whole only
once. All tests must pass there before a fault counts. A fault that no longer applies, that does not compile, or after
which tests fail to run, is an error and not caught.
"""

from __future__ import annotations

import argparse
import io
import json
import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tarfile
import tempfile
import tomllib
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

CHECKOUT = Path(__file__).resolve().parents[1]
FAULTS = CHECKOUT / "tests" / "mutations"
LONGEST = 900
"""Seconds after which tests that have not ended are stopped; some faults let them wait for ever."""
MODULES = ("web", "tests/readers", "tests/exporters")
"""Folders with packages of npm."""
RUST = (".rs", ".wgsl")
BROKEN = re.compile(r"\b(ImportError|ModuleNotFoundError|SyntaxError|IndentationError|NameError|UnboundLocalError)\b")
"""Failures by which a fault would give itself away whatever tests do."""


class Refused(Exception):  # noqa: N818
    """A fault of which nothing can be said."""


@dataclass(frozen=True)
class Fault:
    """A text that takes the place of another one."""

    name: str
    stage: str
    where: str
    old: str
    new: str
    tests: tuple[str, ...]
    slow: tuple[str, ...] = ()


@dataclass(frozen=True)
class Result:
    """What became of a fault."""

    name: str
    stage: str
    language: str
    caught: str
    """The first test that failed; empty for none."""
    message: str
    seconds: float
    """Of the processors, for building and testing."""


def faults(folder: Path = FAULTS) -> list[Fault]:
    """All faults of a folder's tables, by file, stage and name."""
    found = []
    for path in sorted(folder.glob("*.toml")):
        for stage, named in tomllib.loads(path.read_text(encoding="utf-8")).items():
            for name, entry in named.items():
                lists = {"tests": tuple(entry.pop("tests", [f"tests/{stage}"])), "slow": tuple(entry.pop("slow", []))}
                found.append(Fault(f"{stage}.{name}", stage, **lists, **entry))
    return found


def place(tree: Path, fault: Fault) -> Path:
    """Return the file in which a fault's text occurs exactly once; Refused otherwise."""
    root = tree / fault.where
    files = [root] if root.is_file() else [path for path in sorted(root.rglob("*")) if path.is_file()]
    readable = (path for path in files if path.suffix in {".py", ".ts", *RUST})
    counts = {path: path.read_text(encoding="utf-8").count(fault.old) for path in readable}
    if sum(counts.values()) != 1:
        raise Refused(f"does not apply: its text occurs {sum(counts.values())} times in {fault.where}")
    return next(path for path, count in counts.items() if count)


class Copy:
    """A copy of the checkout, with what is built there."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        sys.path.insert(0, str(CHECKOUT / "python"))
        from nearfar._base import data

        python = os.pathsep.join([str(folder / "python"), str(folder)])
        self._environment = os.environ | {"PYTHONPATH": python, "PYTHONDONTWRITEBYTECODE": "1"}
        self._environment["COLUMNS"] = "1000"  # so that pytest does not cut messages
        self._environment |= {"CARGO_TARGET_DIR": str(folder / "target"), "PYO3_PYTHON": sys.executable}
        if root := data.root():
            self._environment["NEARFAR_DATA"] = str(root)

    def fill(self, content: Mapping[str, tuple[bytes, int]]) -> None:
        """Let the files be these; what has not changed keeps its time, by which cargo sees what to compile."""
        listing = self.folder / ".mutations.json"
        before = json.loads(listing.read_text()) if listing.exists() else []
        for name in set(before) - content.keys():
            (self.folder / name).unlink(missing_ok=True)
        for name, (data, mode) in content.items():
            path = self.folder / name
            if not path.is_file() or path.read_bytes() != data:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(data)
                path.chmod(mode)
        listing.write_text(json.dumps(sorted(content)))
        for name in MODULES:
            modules = CHECKOUT / name / "node_modules"
            if modules.is_dir() and not (self.folder / name / "node_modules").exists():
                (self.folder / name / "node_modules").symlink_to(modules.resolve())

    def run(self, *command: str, folder: str = ".") -> tuple[int, str]:
        """Run a program; its status, below 0 if it had to be stopped, and its output."""
        process = subprocess.Popen(
            command,
            cwd=self.folder / folder,
            env=self._environment,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
            start_new_session=True,
        )
        try:
            output, _ = process.communicate(timeout=LONGEST)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, _ = process.communicate()
            return -1, output
        return process.returncode, output

    def must(self, *command: str, folder: str = ".") -> None:
        """Run a program that has to succeed; Refused otherwise."""
        status, output = self.run(*command, folder=folder)
        if status:
            raise Refused(f"does not build: {' '.join(command)}: {output.strip()[-400:]}")

    def build(self, suffix: str) -> None:
        """Build what files with a suffix are part of."""
        if suffix in RUST:
            self.must("cargo", "build", "--quiet", "--profile", "quick", "-p", "nearfar-py")
            new = self.folder / "python" / "nearfar" / "_core.abi3.so.new"
            shutil.copy(self.folder / "target" / "quick" / "lib_core.so", new)
            new.replace(new.with_suffix(""))
        elif suffix == ".ts":
            self.must("npx", "tsc", "--noEmit", folder="web")
            self.must("node", "build.mjs", folder="web")
            self.must("node", "build.mjs", "--tests", "build/tests", folder="web")
        else:
            self.must(sys.executable, "-c", f"import nearfar; assert nearfar.__file__.startswith({str(self.folder)!r})")


Suite = tuple[str, ...]
"""Name of a program that runs tests, and its arguments."""


def suites(fault: Fault, path: Path, tree: Path) -> list[Suite]:
    """The tests of a fault, those that are most likely to catch it first."""
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


def failure(copy: Copy, suite: Suite) -> tuple[str, str] | None:
    """Run tests: the first that fails and its message, or None; Refused if they do not run."""
    kind, *rest = suite
    if kind == "node":
        status, output = copy.run("node", "--test", "--test-reporter=tap", *rest, folder="web")
        pattern = r"^\s*not ok \d+ - (?P<name>.*?)\n(?:.*\n)*?\s*error: (?:\|-\n)?(?P<message>.*)"
    elif kind == "cargo":
        status, output = copy.run("cargo", "test", "--quiet", "-p", rest[0], "--lib", *filter(None, rest[1:]))
        pattern = r"^---- (?P<name>\S+) stdout ----\n+(?P<message>.*\n.*)"
    else:
        marks = ["-m", "slow and not stress"] if kind == "slow" else []
        options = ["-x", "-rfE", "--tb=short", "-p", "no:cacheprovider", *marks]
        status, output = copy.run(sys.executable, "-m", "pytest", *options, *rest)
        pattern = r"^(?:FAILED|ERROR) (?P<name>\S+::.*?)(?: - (?P<message>.*))?$"
    if status == 0:
        return None
    if status < 0:
        return f"{' '.join(suite)} does not end", f"stopped after {LONGEST} s or by a signal"
    found = re.search(pattern, output, re.MULTILINE)
    if not found or found["name"].endswith(".mjs"):
        raise Refused(f"{' '.join(suite)} does not run: {output.strip()[-600:]}")
    message = " ".join((found["message"] or "").split())[:200]
    if BROKEN.search(message):
        raise Refused(f"{found['name']} fails for another reason: {message}")
    return (found["name"] if kind in {"pytest", "slow"} else f"{kind}: {found['name']}"), message


def seconds() -> float:
    """Seconds of the processors that ended processes took."""
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def seeded(copy: Copy, fault: Fault, sound: dict[Suite, bool]) -> Result:
    """Seed one fault and run its tests, of which it is known whether they pass without it."""
    path, begin = place(copy.folder, fault), seconds()
    chosen = suites(fault, path, copy.folder)
    if broken := [" ".join(suite) for suite in chosen if not sound[suite]]:
        raise Refused(f"its tests fail without it: {', '.join(broken)}")
    text = path.read_text(encoding="utf-8")
    try:
        path.write_text(text.replace(fault.old, fault.new), encoding="utf-8")
        copy.build(path.suffix)
        found = next(filter(None, (failure(copy, suite) for suite in chosen)), ("", ""))
    finally:
        path.write_text(text, encoding="utf-8")
    language = {".py": "Python", ".ts": "TypeScript", ".rs": "Rust", ".wgsl": "WGSL"}[path.suffix]
    language = "GLSL" if "shaders" in path.parts and path.suffix == ".ts" else language
    return Result(fault.name, fault.stage, language, *found, round(seconds() - begin, 1))


def table(results: Iterable[Mapping[str, Any]], earlier: Mapping[str, str]) -> str:
    """Results as Markdown, beside those of another run."""
    head = ["fault", "language", *(["caught before by"] if earlier else []), "caught by", "CPU s"]
    lines = [head, ["---"] * len(head)]
    for row in results:
        before = [earlier.get(row["name"], "–") or "MISSED"] if earlier else []
        caught = row["caught"] or "MISSED"
        lines.append([row["name"], row["language"], *before, caught, f"{row['seconds']:.0f}"])
    return "".join(f"| {' | '.join(cell.replace('|', '/') for cell in line)} |\n" for line in lines)


def content_at(commit: str | None) -> dict[str, tuple[bytes, int]]:
    """Bytes and mode of each file of a commit, or of the working tree without what git ignores."""
    git = ["git", "-C", str(CHECKOUT)]
    if commit:
        archive = subprocess.run([*git, "archive", commit], check=True, capture_output=True).stdout
        with tarfile.open(fileobj=io.BytesIO(archive)) as files:
            members = [(member, files.extractfile(member)) for member in files if member.isfile()]
            return {member.name: (file.read(), member.mode) for member, file in members if file}
    listed = subprocess.run([*git, "ls-files", "-coz", "--exclude-standard"], check=True, capture_output=True).stdout
    paths = {name: CHECKOUT / name for name in listed.decode().split("\0") if name}
    return {name: (path.read_bytes(), path.stat().st_mode & 0o777) for name, path in paths.items() if path.is_file()}


def main() -> None:
    """Seed all faults, or those named; exit with status 1 if one is missed or refused."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--only", nargs="+", metavar="NAME", help="names of faults or stages")
    parser.add_argument("--list", action="store_true", help="print the names and end")
    parser.add_argument("--at", metavar="COMMIT", help="a commit instead of the working tree")
    parser.add_argument("--beside", type=Path, metavar="FILE", help="results of an earlier run, for the table")
    parser.add_argument("--out", type=Path, default=CHECKOUT / "out" / "mutations")
    parser.add_argument("--copy", type=Path, default=Path(tempfile.gettempdir()) / "nearfar-mutations")
    chosen = parser.parse_args()
    wanted = [fault for fault in faults() if not chosen.only or {fault.name, fault.stage} & {*chosen.only}]
    if chosen.list or not wanted:
        print("\n".join(fault.name for fault in wanted))
        return
    chosen.copy.mkdir(parents=True, exist_ok=True)
    copy = Copy(chosen.copy.resolve())
    copy.fill(content_at(chosen.at))
    sound, kinds, refused = {}, set(), {}
    for fault in list(wanted):
        try:
            path = place(copy.folder, fault)
            sound.update(dict.fromkeys(suites(fault, path, copy.folder), True))
            kinds.add(path.suffix)
        except Refused as error:
            refused[fault.name] = str(error)
            wanted.remove(fault)
    for kind in (".rs", ".ts", ".py"):
        copy.build(kind)
    for suite in sound:
        found = failure(copy, suite)
        sound[suite] = found is None
        print(f"{' '.join(suite)}: {'passes' if found is None else found}", flush=True)
    results: list[dict[str, Any]] = []
    last = ""
    for fault in wanted:
        try:
            suffix = place(copy.folder, fault).suffix
            if last and last != suffix:
                copy.build(last)
            last = suffix
            result = seeded(copy, fault, sound)
            results.append(vars(result))
            print(f"{fault.name}: {result.caught or 'MISSED'} ({result.message})", flush=True)
        except Refused as error:
            refused[fault.name] = str(error)
            print(f"{fault.name}: REFUSED {error}", flush=True)
    earlier = json.loads(chosen.beside.read_text(encoding="utf-8")) if chosen.beside else []
    chosen.out.mkdir(parents=True, exist_ok=True)
    (chosen.out / "mutations.json").write_text(json.dumps(results, indent=1, ensure_ascii=False), encoding="utf-8")
    text = table(results, {row["name"]: row["caught"] for row in earlier})
    (chosen.out / "mutations.md").write_text(text, encoding="utf-8")
    missed = [row["name"] for row in results if not row["caught"]]
    if missed or refused:
        sys.exit("\n".join([*(f"missed: {name}" for name in missed), *(f"{n}: {why}" for n, why in refused.items())]))


if __name__ == "__main__":
    main()
