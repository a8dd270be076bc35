"""Support for all tests: skipping of tests with missing parts, data files, and common checks."""

from __future__ import annotations

import functools
import importlib.util
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from benchmarks.harness.link import no_link
from nearfar._base import data as data_files
from tests.support.reader_cases import no_blender, no_browser, no_exporters, no_node, no_web
from tests.support.thread_counts import printed_by_threads as printed_by_threads


def _module(name: str) -> Callable[[], str]:
    return lambda: "" if importlib.util.find_spec(name) else f"the Python package {name} is not installed"


def _data_folder() -> str:
    return "" if data_files.root() else "there is no data folder (NEARFAR_DATA, or shared/data above the checkout)"


def _pyrender() -> str:
    """An import is not sufficient: an off-screen context needs EGL or OSMesa from the system."""
    if not importlib.util.find_spec("pyrender"):
        return "the Python package pyrender is not installed"
    platforms = [os.environ["PYOPENGL_PLATFORM"]] if "PYOPENGL_PLATFORM" in os.environ else ["egl", "osmesa"]
    code = "import pyrender; pyrender.OffscreenRenderer(8, 8).delete()"
    for platform in platforms:
        environment = os.environ | {"PYOPENGL_PLATFORM": platform}
        process = subprocess.run([sys.executable, "-c", code], env=environment, capture_output=True, timeout=120)
        if process.returncode == 0:
            os.environ["PYOPENGL_PLATFORM"] = platform
            return ""
    return f"pyrender finds no off-screen OpenGL ({', '.join(platforms)}); see scripts/system-packages.sh"


def _adapter(name: str) -> Callable[[], str]:
    def look() -> str:
        found = [adapter for adapter in nf.gpu.adapters() if name in ("any", adapter.backend) and adapter.usable]
        return "" if found else f"there is no graphics adapter behind {name}; see scripts/system-packages.sh"

    return look


def _tokyo() -> str:
    """The whole city is built by a tool in the data folder."""
    root = data_files.root()
    return (
        "" if root and (root.parent / "tools" / "tokyo.py").is_file() else "there is no tools/tokyo.py beside the data"
    )


def _git() -> str:
    """A source archive has no list of files, and git refuses a checkout of another user."""
    command = ["git", "-C", str(Path(__file__).parent), "ls-files", "--error-unmatch", Path(__file__).name]
    try:
        process = subprocess.run(command, capture_output=True, check=False)
    except FileNotFoundError:
        return "git is not installed"
    return "" if process.returncode == 0 else "this is no git checkout"


def _release() -> str:
    """Without a release build, making a wheel would compile everything within a test."""
    folder = Path(os.environ.get("CARGO_TARGET_DIR", Path(__file__).resolve().parents[2] / "target")) / "release"
    return "" if any(folder.glob("*_core.*")) else "there is no release build; `make setup` makes one"


PARTS: dict[str, Callable[[], str]] = {
    "adapter": _adapter("any"),
    "aiohttp": _module("aiohttp"),
    "anywidget": _module("anywidget"),
    "assimp": lambda: "" if shutil.which("assimp") else "Assimp is not installed; see scripts/system-packages.sh",
    "blender": no_blender,
    "browser": no_browser,
    "data": _data_folder,
    "DracoPy": _module("DracoPy"),
    "distributed": _module("distributed"),
    "opengl_basisu": _module("opengl_basisu"),
    "fast_simplification": _module("fast_simplification"),
    "embreex": _module("embreex"),
    "exporters": no_exporters,
    "fsspec": _module("fsspec"),
    "fork": lambda: "" if hasattr(os, "fork") else "this system cannot fork",
    "git": _git,
    "gl": _adapter("gl"),
    "glslang": lambda: (
        "" if shutil.which("glslangValidator") else "glslang is not installed; see scripts/system-packages.sh"
    ),
    "ipywidgets": _module("ipywidgets"),
    "jupyterlab": _module("jupyterlab"),
    "link": no_link,
    "linux": lambda: "" if sys.platform == "linux" else "only Linux tells and limits a process's memory",
    "matplotlib": _module("matplotlib"),
    "miniball": _module("miniball"),
    "OpenEXR": _module("OpenEXR"),
    "node": no_node,
    "zarr": _module("zarr"),
    "web": no_web,
    "notebook": lambda: _module("nbclient")() or _module("ipykernel")() or _module("ipywidgets")(),
    "pycvvdp": _module("pycvvdp"),
    "pyproj": _module("pyproj"),
    "pyrender": _pyrender,
    "release": _release,
    "skimage": _module("skimage"),
    "tokyo": _tokyo,
    "vulkan": _adapter("vulkan"),
}
"""Parts that a system may lack, each with a function that returns why it is missing, or "" if it is present."""


OF_SLOW_TESTS = {"browser", "exporters", "node"}
"""Parts that `make test` does not install; `make test-slow` runs tests that need them."""

marks: set[str] = set()
"""Names of the marks of the running test, set by conftest.py."""


@functools.cache
def missing(part: str) -> str:
    """Return why a part is missing, or "" if it is present. Each part is checked once."""
    return PARTS[part]()


def required() -> set[str]:
    """Parts that must be present: the comma-separated names in `NEARFAR_REQUIRE`."""
    names = {name.strip() for name in os.environ.get("NEARFAR_REQUIRE", "").split(",")}
    return names - {""}


def need(part: str) -> None:
    """Skip the test, module or fixture if a part is missing; fail it if `NEARFAR_REQUIRE` names the part."""
    if part in OF_SLOW_TESTS and marks.isdisjoint({"slow", "stress"}):
        pytest.fail(f"tests that need {part} are slow: expected the mark", pytrace=False)
    reason = missing(part)
    if reason and part in required():
        pytest.fail(f"NEARFAR_REQUIRE names {part}, but {reason}", pytrace=False)
    if reason:
        pytest.skip(f"{part}: {reason}", allow_module_level=True)


PEAK = """
def peak():
    with open("/proc/self/status") as status:
        return 1024 * int(next(line for line in status if line.startswith("VmHWM")).split()[1])
"""
"""Code for programs on Linux: peak memory in bytes. `getrusage` includes the parent's memory at the start."""


SCHEMAS = Path(nf.__file__).parent / "schemas"


def load_schema(name: str) -> Any:
    """Load the JSON Schema of a format, such as "report"."""
    return json.loads((SCHEMAS / f"{name}.schema.json").read_text(encoding="utf-8"))


def valid(document: dict[str, Any], name: str) -> bool:
    """Whether a document fits the schema of a format."""
    return bool(validator(name).is_valid(document))


@functools.cache
def validator(name: str) -> Any:
    """Validator of the schema of a format, which may refer to other schemas."""
    import jsonschema  # Its grammar of addresses takes a second, which other processes do not wait for.
    from referencing import Registry, Resource

    contents = [json.loads(path.read_text(encoding="utf-8")) for path in SCHEMAS.glob("*.schema.json")]
    registry: Registry[Any] = Registry().with_resources((c["$id"], Resource.from_contents(c)) for c in contents)
    return jsonschema.Draft202012Validator(load_schema(name), registry=registry)


def data(relative: str) -> Path:
    """Path of a file below the data folder; skips or fails as `need("data")` does."""
    need("data")
    return data_files.require(relative)
