"""Tests of ARCHITECTURE.md's rules for the Python package: public names, small files, each stage's folders."""

from __future__ import annotations

import ast
import statistics
import subprocess
from collections.abc import Iterator
from pathlib import Path

from tests.support import need
from tests.support.stages import PACKAGE as STAGES

CHECKOUT = Path(__file__).resolve().parents[2]
PACKAGE = CHECKOUT / "python" / "nearfar"

PRIVATE_TO_COMMANDS = {
    "nearfar._camera.density",
    "nearfar._reduce.default_radii",
    "nearfar._reduce.findings",
    "nearfar._reduce.folder",
    "nearfar._scene.preview",
    "nearfar._source.protocol",
    "nearfar._trace.crossing",
    "nearfar._trace.viewpoint",
}
"""Modules that the command line uses besides the public names and `_base`."""

# Each stage's tests, benchmark and page; instead of a benchmark a reason why nothing is timed.
ROOMS = {
    "base": "policies, which compute nothing",
    "datasets": "scenes to test with",
    "scene": "",
    "source": "",
    "camera": "",
    "cubemap": "",
    "trace": "",
    "partition": "",
    "morph": "",
    "bend": "",
    "tessellate": "",
    "bounds": "",
    "render": "",
    "reduce": "",
    "impostor": "",
    "metrics": "",
    "lens": "",
    "hmd": "profiles of headsets, which are read once",
    "stereo": "",
    "gpu": "",
    "lod": "",
    "orthoview": "",
    "stream": "",
    "view": "",
    "serve": "",
    "cli": "calls of the other stages",
}

MAX_ENTRIES = 31
"""Maximum number of files and folders in python/nearfar."""

MEDIAN_LINES, MAX_LINES = 150, 400
"""Maximum median and maximum number of lines of the package's Python files; the stub may be longer."""

MAX_PUBLIC_PARAMETERS, MAX_PRIVATE_PARAMETERS = 10, 8
"""Maximum numbers of parameters; more mean that a type is missing."""


def test_the_command_line_uses_only_public_names() -> None:
    wrong = []
    for path in sorted((PACKAGE / "cli").glob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ImportFrom) and node.module and node.module.startswith("nearfar._"):
                names = {node.module, *(f"{node.module}.{alias.name}" for alias in node.names)}
                if not node.module.startswith("nearfar._base") and not names & PRIVATE_TO_COMMANDS:
                    wrong.append(f"{path.name}: {node.module}")
    assert wrong == []


def test_the_package_lists_names_in_the_order_of_the_pipeline() -> None:
    stub = ast.parse((PACKAGE / "__init__.pyi").read_text(encoding="utf-8"))
    modules = [node.module for node in stub.body if isinstance(node, ast.ImportFrom) and node.module]
    opened = [module.partition(".")[0] for module in modules]
    order = list(STAGES)
    assert opened == sorted(opened, key=order.index)


def tracked(folder: Path) -> list[Path]:
    need("git")
    listed = subprocess.run(["git", "ls-files", folder], cwd=CHECKOUT, capture_output=True, text=True, check=True)
    return [path for line in listed.stdout.splitlines() if (path := CHECKOUT / line).is_file()]


def test_files_and_folders_of_the_package_are_small() -> None:
    files = tracked(PACKAGE)
    assert len({path.relative_to(PACKAGE).parts[0] for path in files}) <= MAX_ENTRIES
    lines = {path: path.read_text(encoding="utf-8").count("\n") for path in files if path.suffix == ".py"}
    assert statistics.median(lines.values()) < MEDIAN_LINES
    assert {path.name: count for path, count in lines.items() if count > MAX_LINES} == {}


def test_every_stage_has_its_tests_benchmarks_and_page() -> None:
    stages = {stage.strip("_") for stage in STAGES if stage != "__init__"}
    assert stages == set(ROOMS), "a new stage needs its rooms"
    for stage, why_no_benchmark in ROOMS.items():
        assert list((CHECKOUT / "tests" / stage).glob("test_*.py")), f"{stage} has no tests"
        assert (CHECKOUT / "docs" / f"{stage}.md").is_file(), f"{stage} has no page"
        runs = [path for path in (CHECKOUT / "benchmarks" / stage).glob("*.py") if not path.name.startswith("_")]
        assert bool(runs) != bool(why_no_benchmark), f"{stage}: expected a benchmark, or the reason why there is none"
    folders = {path.name for path in (CHECKOUT / "tests").iterdir() if any(path.glob("test_*.py"))}
    assert folders <= set(ROOMS) | {"attack", "project", "vectors"}


def public_names() -> set[str]:
    """Return the names that the package and its subpackages export."""
    names: set[str] = set()
    for path in [PACKAGE / "__init__.pyi", *PACKAGE.rglob("__init__.py")]:
        for node in ast.parse(path.read_text(encoding="utf-8")).body:
            match node:
                case ast.Assign(targets=[ast.Name(id="__all__")], value=ast.List() as listed):
                    names.update(ast.literal_eval(listed))
    return names


def parameter_counts(path: Path) -> Iterator[tuple[str, str, int]]:
    """Yield outer name, own name and number of parameters of each function; self and cls do not count."""

    def visit(node: ast.AST, outer: str) -> Iterator[tuple[str, str, int]]:
        # Expressions contain no functions with names.
        for child in ast.iter_child_nodes(node):
            if not isinstance(child, ast.stmt | ast.excepthandler | ast.match_case):
                continue
            name = getattr(child, "name", "")
            if isinstance(child, ast.FunctionDef | ast.AsyncFunctionDef):
                args = child.args
                named = [
                    arg for arg in (*args.posonlyargs, *args.args, *args.kwonlyargs) if arg.arg not in ("self", "cls")
                ]
                yield outer or name, name, len(named) + bool(args.vararg) + bool(args.kwarg)
            yield from visit(child, outer or (name if isinstance(child, ast.ClassDef) else ""))

    yield from visit(ast.parse(path.read_text(encoding="utf-8")), "")


def test_functions_take_few_parameters() -> None:
    public, wrong = public_names(), []
    for path in sorted(PACKAGE.rglob("*.py")):
        is_command = path.parent.name == "cli"
        for outer, name, count in parameter_counts(path):
            # A public class may inherit its methods from others, whose names tell nothing about that.
            is_method = outer != name and not outer.startswith("_") and (name == "__init__" or not name.startswith("_"))
            is_public = is_command or is_method or name in public
            if count > (MAX_PUBLIC_PARAMETERS if is_public else MAX_PRIVATE_PARAMETERS):
                wrong.append(f"{path.relative_to(PACKAGE)}: {outer}.{name} takes {count}")
    assert wrong == []
