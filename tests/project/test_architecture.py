"""Rules of ARCHITECTURE.md for the Rust crates and for all files: dependencies of kernels, file lengths, words."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Callable
from pathlib import Path

from tests.support import need

CHECKOUT = Path(__file__).resolve().parents[2]
CORE = CHECKOUT / "rust" / "core" / "src"
GPU = CHECKOUT / "rust" / "gpu" / "src"
BINDINGS = CHECKOUT / "rust" / "py" / "src"
PACKAGE = CHECKOUT / "python" / "nearfar"
BUILT = PACKAGE / "view" / "dist"
"""The page's generated script."""

# Limits of a file's number of lines: above the first one it is listed, above the second one the test fails.
THINK, SPLIT = 400, 500


def rust_files(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.rs"))


def rust_code(path: Path) -> str:
    """Code without comments, strings and the tests at the end."""
    text = re.split(r"#\[cfg\(test\)\]\s*mod \w+ \{", path.read_text(encoding="utf-8"))[0]
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"', "", text, flags=re.DOTALL)


def is_rust_test(path: Path) -> bool:
    return "tests" in {path.stem, path.parent.name}


def test_the_gpu_crate_uses_the_core_alone() -> None:
    manifest = (GPU.parent / "Cargo.toml").read_text(encoding="utf-8")
    assert re.findall(r"^nearfar-\w+", manifest, re.MULTILINE) == ["nearfar-core"]
    assert "pyo3" not in manifest


# Kernels only compute: no interpreter, no files, no clock, no environment except the pool's variable, no printing.
FORBIDDEN_IN_CORE = {
    r"\bpyo3\b|\bnumpy::": "",
    r"\bstd::fs\b|\bFile::(?:open|create)\b": "",
    r"\bstd::time::(?:Instant|SystemTime)\b|\bInstant::now\b": "",
    r"\bstd::env\b|\benv::var\b": "base/pool.rs",
    r"\b(?:e?println|dbg|todo|unimplemented)!": "",
}


def test_the_core_has_no_python_files_or_clock() -> None:
    wrong = []
    for path in [*rust_files(CORE), *rust_files(GPU)]:
        if is_rust_test(path):
            continue
        for pattern, exception in FORBIDDEN_IN_CORE.items():
            found = re.search(pattern, rust_code(path))
            if found and (not exception or not path.as_posix().endswith(f"core/src/{exception}")):
                wrong.append(f"{path.relative_to(CHECKOUT)}: {found[0]}")
    assert wrong == []
    manifest = (CORE.parent / "Cargo.toml").read_text(encoding="utf-8")
    assert "pyo3" not in manifest
    assert "numpy" not in manifest


def test_kernels_do_not_panic_on_purpose() -> None:
    wrong = []
    for path in [*rust_files(CORE), *rust_files(GPU), *rust_files(BINDINGS)]:
        if not is_rust_test(path):
            # Strings are removed, so that `.expect("…")` reads `.expect()`; Progress has a method of that name.
            found = re.findall(r"\.unwrap\(\)|\.expect\(\)|\bpanic!|\bunreachable!", rust_code(path))
            wrong += [f"{path.relative_to(CHECKOUT)}: {name}" for name in found]
    assert wrong == []


def test_bindings_hold_no_arithmetic() -> None:
    """A loop with arithmetic is a kernel, which belongs to the core."""
    wrong = []
    for path in rust_files(BINDINGS):
        code = rust_code(path)
        for loop in re.finditer(r"\b(?:for\b[^{;]*\bin\b|while\b)[^{;]*\{", code):
            body = _block(code, loop.end() - 1)
            if re.search(r"[\w\])]\s[*/%]=?\s[\w(]|[\w\])]\s[-+]=\s", body):
                wrong.append(f"{path.relative_to(CHECKOUT)}: {' '.join(loop[0].split())}")
        assert not re.search(r"\.(?:sqrt|sin|cos|tan|hypot|atan2|powi|powf)\(", code), path
    assert wrong == []


def _block(text: str, start: int) -> str:
    depth = 0
    for end in range(start, len(text)):
        depth += {"{": 1, "}": -1}.get(text[end], 0)
        if depth == 0:
            return text[start:end]
    return text[start:]


def tracked() -> list[Path]:
    """Files under version control, and untracked files that are not ignored."""
    need("git")
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, check=True)
    return [path for line in listed.stdout.splitlines() if (path := CHECKOUT / line).is_file()]


SOURCES = {".rs", ".py", ".pyi", ".sh", ".md", ".wgsl", ".ts", ".js", ".toml"}


def test_files_are_short(record_property: Callable[[str, object], None]) -> None:
    lengths = {
        path.relative_to(CHECKOUT).as_posix(): path.read_text(encoding="utf-8").count("\n")
        for path in tracked()
        if path.suffix in SOURCES and BUILT not in path.parents
    }
    long = {name: length for name, length in lengths.items() if length > THINK}
    record_property("files to think about", sorted(long.items()))
    assert {name: length for name, length in long.items() if length > SPLIT} == {}


def test_nothing_in_the_tree_is_unfinished_or_tied_to_a_machine() -> None:
    # The words are split, so that this file does not match itself.
    words = [a + b for a, b in (("TO", "DO"), ("FIX", "ME"), ("XX", "X"), ("raise Not", "ImplementedError"))]
    words += [a + b for a, b in (("/ho", "me/"), ("/Us", "ers/"), ("/wo", "rk/"))]
    pattern = re.compile("|".join(rf"(?<![\w.~]){re.escape(word)}" for word in words))
    wrong = []
    for path in tracked():
        if path.suffix in SOURCES or path.name in {"Makefile", "run"}:
            text = path.read_text(encoding="utf-8")
            # The pattern takes seconds for all files, the words alone a moment.
            for number, line in enumerate(text.splitlines() if any(word in text for word in words) else (), 1):
                if pattern.search(line):
                    wrong.append(f"{path.relative_to(CHECKOUT)}:{number}: {line.strip()}")
    assert wrong == []
