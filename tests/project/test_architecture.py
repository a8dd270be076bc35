"""The rules of ARCHITECTURE.md that a machine can check: who may use whom, file lengths, documented public names."""

from __future__ import annotations

import ast
import inspect
import re
import subprocess
import types
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from nearfar import _core
from support import need

CHECKOUT = Path(__file__).resolve().parent.parent
CORE = CHECKOUT / "rust" / "core" / "src"
GPU = CHECKOUT / "rust" / "gpu" / "src"
BINDINGS = CHECKOUT / "rust" / "py" / "src"
PACKAGE = CHECKOUT / "python" / "nearfar"

# What each stage may use, in the order of the data flow: nothing that comes later. A name that is missing here fails:
# adding a stage is a decision.
RUST_STAGES: dict[str, set[str]] = {
    "base": set(),
    "bvh": {"base"},
    "scene": {"base", "bvh"},
    "camera": {"base"},
    "cubemap": {"base", "camera"},
    "trace": {"base", "bvh", "scene"},
    "partition": {"base", "scene"},
    "morph": {"base"},
    "bend": {"base", "morph"},
    "tessellate": {"base", "scene", "morph"},
    "render": {"base", "scene", "camera", "cubemap", "trace", "partition", "morph", "bend", "tessellate"},
    "exr": {"base"},
    "metrics": {"base", "camera"},
    "bounds": {"base"},
    "lens": {"base", "camera", "bounds"},
    "lod": {"base", "camera", "trace", "bounds", "lens"},
}
"""The order is that of lib.rs."""

# The same for the GPU back end: of other crates it uses the core alone.
GPU_MODULES: dict[str, set[str]] = {
    "device": {"compute", "draw", "upload"},
    "upload": {"device"},
    "draw": {"device", "upload"},
    "truth": {"device", "draw"},
    "bake": {"device", "draw"},
    "reduced": {"device", "draw", "upload"},
    "compute": {"device", "draw"},
}
"""A device owns what is kept on it between frames: tables of `upload`, pipelines and slots of `draw`, programs
of `compute`."""

POLICIES = {
    "_check",
    "_progress",
    "_files",
    "_formats",
    "_cache",
    "_random",
    "_data",
    "_errors",
    "_version",
    "_core",
    "_twin",
}

PYTHON_STAGES: dict[str, set[str]] = {
    "_version": set(),
    "_core": set(),
    "_errors": {"_core"},
    "_check": set(),
    "_twin": set(),
    "_progress": set(),
    "_files": set(),
    "_data": set(),
    "_formats": {"_errors", "_version"},
    "_cache": {"_files"},
    "_random": {"_check", "_core"},
    "_geometry": set(),
    "_names": set(),
    "_report": set(),
    "_assembly": {"_geometry"},
    "_materials": set(),
    "_source": {"_assembly", "_materials", "_report"},
    "_from_trimesh": {"_materials", "_report", "_source"},
    "_gltf": {"_materials", "_report", "_source"},
    "_load": {"_assembly", "_from_trimesh", "_gltf", "_source"},
    "_leveled": {"_names"},
    "_scene_parts": set(),
    "_scene": {
        "_assembly",
        "_from_trimesh",
        "_geometry",
        "_leveled",
        "_load",
        "_names",
        "_report",
        "_scene_parts",
        "_source",
    },
    "_camera": set(),
    "_warp": {"_camera"},
    "_lens": {"_camera", "_warp"},
    "_depth": {"_camera"},
    "_eyes": {"_camera"},
    "_hmd_file": {"_camera", "_eyes", "_lens"},
    "_hmdq": {"_camera", "_eyes", "_hmd_file"},
    "_hmd": {"_camera", "_eyes", "_hmd_file", "_hmdq", "_lens"},
    "_exr": set(),
    "_frame": {"_camera", "_exr"},
    "_choice": {"_camera", "_frame", "_leveled", "_scene"},
    "_glb": set(),
    "_scene_glb": {"_glb", "_materials", "_names"},
    "_backend": set(),
    "_painter": {"_backend", "_camera", "_frame", "_scene"},
    "_render": {"_camera", "_choice", "_frame", "_painter", "_scene"},
    "_morph": set(),
    "_tessellate": {"_camera", "_from_trimesh", "_scene"},
    "_bend": {"_morph"},
    "_partition": {"_scene"},
    "_plot": set(),
    "_load_curve": {"_plot", "_scene"},
    "_cubemap": set(),
    "_layouts": {"_cubemap"},
    "_envmap": {"_cubemap", "_exr"},
    "_trace": {"_scene"},
    "_nearest": {"_scene"},
    "_pictures": {"_frame"},
    "_metrics": {"_frame", "_pictures"},
    "_similarity": {"_frame", "_pictures"},
    "_discontinuity": {"_camera", "_frame"},
    "_bounds": set(),
    "_bundle": {"_envmap", "_names", "_scene", "_scene_glb"},
    "_reduced": {"_bundle", "_camera", "_envmap", "_frame", "_painter", "_partition", "_render", "_scene"},
    "_reduce": {"_backend", "_bundle", "_envmap", "_frame", "_partition", "_reduced", "_render", "_scene"},
    "_path": {"_camera", "_choice", "_frame", "_leveled", "_painter", "_reduced", "_render", "_scene"},
    "gpu": {"_backend", "_camera", "_frame", "_morph", "_painter", "_path", "_reduced", "_scene"},
    "lod": {
        "_backend",
        "_bounds",
        "_camera",
        "_eyes",
        "_frame",
        "_geometry",
        "_glb",
        "_hmd",
        "_lens",
        "_leveled",
        "_names",
        "_painter",
        "_path",
        "_pictures",
        "_plot",
        "_render",
        "_scene",
        "_scene_glb",
        "_scene_parts",
        "_similarity",
    },
    "datasets": {"_scene"},
    "hmd": {"_eyes", "_hmd"},
}

# Lines of a file. Above the first number a file is listed, above the second it fails.
THINK, SPLIT = 400, 500


def rust_files(folder: Path) -> list[Path]:
    return sorted(folder.rglob("*.rs"))


def rust_code(path: Path) -> str:
    """Without comments, strings and the tests at the end."""
    text = re.split(r"#\[cfg\(test\)\]\s*mod \w+ \{", path.read_text(encoding="utf-8"))[0]
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"', "", text, flags=re.DOTALL)


def is_rust_test(path: Path) -> bool:
    return "tests" in {path.stem, path.parent.name}


def stage_of(path: Path, root: Path) -> str:
    return path.relative_to(root).parts[0].removesuffix(".rs").removesuffix(".py")


def test_rust_stages_use_only_what_they_may() -> None:
    wrong = []
    for path in rust_files(CORE):
        stage = stage_of(path, CORE)
        if stage == "lib" or is_rust_test(path):
            continue
        assert stage in RUST_STAGES, f"{path.name} is a new stage: say above what it may use"
        used = set(re.findall(r"\bcrate::\{?\s*(\w+)", rust_code(path))) - {stage}
        wrong += [f"{path.relative_to(CORE)} uses {name}" for name in sorted(used - RUST_STAGES[stage])]
    assert wrong == []


def test_rust_stages_stand_in_the_order_of_the_pipeline() -> None:
    listed = re.findall(r"^pub mod (\w+);", (CORE / "lib.rs").read_text(encoding="utf-8"), re.MULTILINE)
    assert listed == list(RUST_STAGES)
    later = {name: set(listed[i + 1 :]) for i, name in enumerate(listed)}
    backwards = {(name, used) for name in listed for used in RUST_STAGES[name] & later[name]}
    assert backwards == set()


def test_modules_of_the_gpu_use_only_what_they_may() -> None:
    wrong = []
    for path in rust_files(GPU):
        module = stage_of(path, GPU)
        if module == "lib":
            continue
        assert module in GPU_MODULES, f"{path.name} is a new module: say above what it may use"
        used = set(re.findall(r"\bcrate::\{?\s*(\w+)", rust_code(path))) - {module}
        wrong += [f"{path.relative_to(GPU)} uses {name}" for name in sorted(used - GPU_MODULES[module])]
    assert wrong == []
    manifest = (GPU.parent / "Cargo.toml").read_text(encoding="utf-8")
    assert re.findall(r"^nearfar-\w+", manifest, re.MULTILINE) == ["nearfar-core"]
    assert "pyo3" not in manifest


# The kernels compute: no interpreter, no files, no clock, no environment but the pool's variable, no printing.
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
            # Strings are stripped, so that `.expect("…")` reads `.expect()`, and Progress has a method of that name.
            found = re.findall(r"\.unwrap\(\)|\.expect\(\)|\bpanic!|\bunreachable!", rust_code(path))
            wrong += [f"{path.relative_to(CHECKOUT)}: {name}" for name in found]
    assert wrong == []


def test_bindings_hold_no_arithmetic() -> None:
    """A loop with arithmetic in it is a kernel, and kernels live in the core."""
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


def python_imports(path: Path) -> Iterator[str]:
    """First names after `nearfar.` that a module imports anywhere, type checking included."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            if node.module == "nearfar":
                yield from (alias.name for alias in node.names)
            elif node.module.startswith("nearfar."):
                yield node.module.split(".")[1]
        elif isinstance(node, ast.ImportFrom) and node.level > 0:
            yield f"{'.' * node.level} (relative)"
        elif isinstance(node, ast.Import):
            yield from (alias.name.split(".")[1] for alias in node.names if alias.name.startswith("nearfar."))


def test_python_modules_use_only_what_they_may() -> None:
    wrong = []
    for path in sorted(PACKAGE.rglob("*.py")):
        stage = stage_of(path, PACKAGE)
        if stage in ("__init__", "cli"):
            continue
        assert stage in PYTHON_STAGES, f"{path.name} is a new module: say above what it may use"
        may = PYTHON_STAGES[stage] | (POLICIES if stage not in POLICIES else set()) | {stage}
        wrong += [f"{path.relative_to(PACKAGE)} uses {name}" for name in python_imports(path) if name not in may]
    assert wrong == []


def test_python_stages_depend_one_way() -> None:
    order = list(PYTHON_STAGES)
    later = {name: set(order[i + 1 :]) for i, name in enumerate(order)}
    assert {(name, used) for name in order for used in PYTHON_STAGES[name] & later[name]} == set()


def test_the_command_line_uses_only_the_public_face() -> None:
    allowed = POLICIES - {"_core"} | {"cli", "datasets"}
    for path in sorted(PACKAGE.glob("cli/*.py")):
        assert set(python_imports(path)) <= allowed, path


def tracked() -> list[Path]:
    """Files under version control, or about to be."""
    need("git")
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=CHECKOUT, capture_output=True, text=True, check=True)
    return [path for line in listed.stdout.splitlines() if (path := CHECKOUT / line).is_file()]


SOURCES = {".rs", ".py", ".pyi", ".sh", ".md", ".wgsl", ".ts", ".js", ".toml"}


def test_files_are_short(record_property: Callable[[str, object], None]) -> None:
    lengths = {
        path.relative_to(CHECKOUT).as_posix(): path.read_text(encoding="utf-8").count("\n")
        for path in tracked()
        if path.suffix in SOURCES
    }
    long = {name: length for name, length in lengths.items() if length > THINK}
    record_property("files to think about", sorted(long.items()))
    assert {name: length for name, length in long.items() if length > SPLIT} == {}


def test_nothing_in_the_tree_is_unfinished_or_tied_to_a_machine() -> None:
    # Written in two pieces, so that this file does not find itself.
    words = [a + b for a, b in (("TO", "DO"), ("FIX", "ME"), ("XX", "X"), ("raise Not", "ImplementedError"))]
    words += [a + b for a, b in (("/ho", "me/"), ("/Us", "ers/"), ("/wo", "rk/"))]
    pattern = re.compile("|".join(rf"(?<![\w.~]){re.escape(word)}" for word in words))
    wrong = []
    for path in tracked():
        if path.suffix in SOURCES or path.name in {"Makefile", "run"}:
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                if pattern.search(line):
                    wrong.append(f"{path.relative_to(CHECKOUT)}:{number}: {line.strip()}")
    assert wrong == []


# public names --------------------------------------------------------------------------------------------------------
def public() -> Iterator[tuple[str, Any]]:
    """Everything that `nearfar.__all__` offers, and the public methods of its classes."""
    for name in nf.__all__:
        value = getattr(nf, name)
        yield name, value
        if inspect.isclass(value):
            for member, attribute in vars(value).items():
                if not member.startswith("_") and (
                    callable(attribute) or isinstance(attribute, classmethod | property)
                ):
                    yield f"{name}.{member}", getattr(value, member)


def test_all_names_exist_once_and_in_order() -> None:
    assert len(set(nf.__all__)) == len(nf.__all__)
    assert [name for name in nf.__all__ if not hasattr(nf, name)] == []


@pytest.mark.parametrize(("name", "value"), [item for item in public() if item[0] != "__version__"])
def test_public_names_are_documented(name: str, value: Any) -> None:
    text = inspect.getdoc(value)
    assert text, name
    # Functions state each argument; methods and named constructors may say it in a sentence or two.
    if isinstance(value, types.FunctionType) and "." not in name:
        arguments = list(inspect.signature(value).parameters)
        assert "\nParameters\n" in text, f"{name}: expected a section Parameters"
        section = text.partition("\nParameters\n")[2]
        missing = [a for a in arguments if not re.search(rf"(?<!\w){re.escape(a)}(?!\w)", section)]
        assert missing == [], f"{name}: says nothing of {missing}"


@pytest.mark.parametrize("name", nf.__all__)
def test_readers_find_every_public_function_by_keyword(name: str) -> None:
    """Arguments after the first two or three are keyword-only, so that a call says what its numbers are."""
    value = getattr(nf, name)
    if isinstance(value, types.FunctionType):
        kinds = [p.kind for p in inspect.signature(value).parameters.values()]
        positional = kinds.count(inspect.Parameter.POSITIONAL_OR_KEYWORD)
        assert positional <= 3, f"{name} takes {positional} positional arguments"


def test_every_binding_is_in_the_stub() -> None:
    stub = ast.parse((PACKAGE / "_core.pyi").read_text(encoding="utf-8"))
    named = {node.name for node in stub.body if isinstance(node, ast.FunctionDef | ast.ClassDef)}
    assert {name for name in dir(_core) if not name.startswith("__")} == named
