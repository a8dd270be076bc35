"""Tests of the wheel: small, complete, installs into an empty environment, imports without optional packages."""

from __future__ import annotations

import email
import importlib.metadata
import os
import re
import stat
import subprocess
import sys
import tarfile
import tomllib
import venv
import zipfile
from pathlib import Path

import pytest
import trimesh
from packaging.requirements import Requirement

import nearfar as nf
from tests.support import need

CHECKOUT = Path(__file__).resolve().parents[2]
BACKEND = CHECKOUT / "scripts" / "nearfar_build.py"

IMPORT_BACKEND = f"import sys; sys.path.insert(0, {str(BACKEND.parent)!r}); import nearfar_build as b"

# Maximum size of the wheel in bytes.
LARGEST_WHEEL = 12_000_000

HEAVY = ("trimesh", "PIL", "typer", "rich", "matplotlib", "scipy", "cv2", "jsonschema", "networkx")
"""Packages that `import nearfar` must not load: each takes tens of milliseconds that most scripts do not need."""


def run(*command: str | Path, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command, env=os.environ | environment, cwd=CHECKOUT, capture_output=True, text=True, timeout=900, check=False
    )


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Wheel built from the tree with the environment's maturin; the release build exists, so this only packs."""
    need("release")
    folder = tmp_path_factory.mktemp("wheel")
    # pyo3 is built for the interpreter that this names; another name would rebuild everything.
    process = run(
        *(sys.executable, "-m", "pip", "wheel", "--no-deps", "--no-build-isolation", "--no-index"),
        *("--wheel-dir", folder, CHECKOUT),
        PYO3_PYTHON=sys.executable,
    )
    assert process.returncode == 0, process.stdout + process.stderr
    (path,) = folder.glob("*.whl")
    return path


@pytest.fixture(scope="module")
def installed(wheel: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Python of an environment with only the wheel and its required packages.

    The requirements are linked from this environment, so that no package index is contacted.
    """
    folder = tmp_path_factory.mktemp("empty")
    venv.create(folder, with_pip=False, symlinks=os.name != "nt")
    python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
    where = run(python, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").stdout.strip()
    process = run(
        *(sys.executable, "-m", "pip", "--python", python, "install", "--no-deps", "--no-index"),
        *("--no-compile", "--no-warn-script-location", wheel),
    )
    assert process.returncode == 0, process.stdout + process.stderr
    for top in _requirements(wheel):
        (Path(where) / top.name).symlink_to(top)
    return python


def _requirements(wheel: Path) -> set[Path]:
    """Top-level files and folders of all direct and indirect requirements of the wheel without extras."""
    with zipfile.ZipFile(wheel) as archive:
        (name,) = (name for name in archive.namelist() if name.endswith(".dist-info/METADATA"))
        metadata = email.message_from_bytes(archive.read(name))
    waiting: list[str] = metadata.get_all("Requires-Dist") or []
    seen: set[str] = set()
    tops: set[Path] = set()
    while waiting:
        requirement = Requirement(waiting.pop())
        if requirement.name in seen or (requirement.marker and not requirement.marker.evaluate({"extra": ""})):
            continue
        seen.add(requirement.name)
        distribution = importlib.metadata.distribution(requirement.name)
        waiting += distribution.requires or []
        for file in distribution.files or []:
            if ".." not in file.parts:
                tops.add(Path(str(distribution.locate_file(file.parts[0]))))
    return tops


def test_the_wheel_is_small_and_complete(wheel: Path) -> None:
    assert wheel.stat().st_size <= LARGEST_WHEEL
    assert re.fullmatch(rf"nearfar-{re.escape(nf.__version__)}-cp311-abi3-\w+\.whl", wheel.name)
    with zipfile.ZipFile(wheel) as archive:
        names = set(archive.namelist())
    tracked = {
        path.relative_to(CHECKOUT / "python").as_posix()
        for path in (CHECKOUT / "python" / "nearfar").rglob("*")
        if path.is_file() and "__pycache__" not in path.parts
    }
    assert {name for name in names if name.startswith("nearfar/")} == tracked
    extensions = [name for name in names if name.endswith((".so", ".pyd", ".dylib"))]
    assert len(extensions) == 1
    assert any(name.endswith("licenses/LICENSE-MIT") for name in names)
    assert any(name.endswith("licenses/LICENSE-APACHE") for name in names)


def test_the_wheel_works_in_an_empty_environment(installed: Path, tmp_path: Path) -> None:
    trimesh.Scene([trimesh.creation.box()]).export(tmp_path / "box.glb")
    code = (
        "import nearfar as nf\n"
        "assert 'empty' in nf.__file__, nf.__file__\n"
        "scene = nf.Scene.load('box.glb')\n"
        "view = nf.Camera((0, 0, 3), fov=nf.Fov.symmetric(60), size=(8, 8))\n"
        "nf.render(scene, view).save('box.png')\n"
        "print(scene.triangle_count)"
    )
    process = subprocess.run([installed, "-I", "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=600)
    assert (process.returncode, process.stdout.strip()) == (0, "12"), process.stderr
    process = subprocess.run(
        [installed.with_name("nearfar"), "--help"], cwd=tmp_path, capture_output=True, text=True, timeout=600
    )
    assert process.returncode == 0, process.stderr
    assert "render" in process.stdout


def test_importing_loads_nothing_heavy(installed: Path, tmp_path: Path) -> None:
    code = (
        "import sys, nearfar as nf; opened = sorted(n for n in sys.modules if n.startswith('nearfar.'))\n"
        "print(*opened)\n"
        "import nearfar.lod, nearfar.gpu, nearfar.datasets; [getattr(nf, name) for name in nf.__all__]\n"
        "print(*sorted({name.partition('.')[0] for name in sys.modules}))"
    )
    process = subprocess.run([installed, "-I", "-c", code], cwd=tmp_path, capture_output=True, text=True, timeout=600)
    opened, loaded = process.stdout.splitlines()
    # The package's name tells one protocol which stage serves it.
    assert opened.split() == ["nearfar._render", "nearfar._render.showing"], "each stage is imported on first use"
    assert not set(HEAVY) & set(loaded.split())


def test_the_source_distribution_is_complete(tmp_path: Path) -> None:
    process = run(sys.executable, "-c", f"{IMPORT_BACKEND}; b.build_sdist({str(tmp_path)!r})")
    assert process.returncode == 0, process.stdout + process.stderr
    (path,) = tmp_path.glob("nearfar-*.tar.gz")
    with tarfile.open(path) as archive:
        names = {name.partition("/")[2] for name in archive.getnames()}
    wanted = {"pyproject.toml", "Cargo.toml", "Cargo.lock", "README.md", "LICENSE-MIT", "LICENSE-APACHE"}
    wanted |= {
        "scripts/nearfar_build.py",
        "rust/core/src/lib.rs",
        "rust/py/src/lib.rs",
        "rust/serve/src/lib.rs",
        "python/nearfar/__init__.py",
    }
    gpu = CHECKOUT / "rust" / "gpu" / "src"
    wanted |= {path.relative_to(CHECKOUT).as_posix() for path in gpu.rglob("*") if path.suffix in {".rs", ".wgsl"}}
    assert wanted <= names
    assert not any(name.endswith(".so") for name in names)


def test_versions_agree_everywhere() -> None:
    cargo = tomllib.loads((CHECKOUT / "Cargo.toml").read_text(encoding="utf-8"))
    assert cargo["workspace"]["package"]["version"] == nf.__version__
    changes = (CHECKOUT / "CHANGELOG.md").read_text(encoding="utf-8")
    assert re.search(rf"^## {re.escape(nf.__version__)}\b", changes, re.MULTILINE)


@pytest.mark.parametrize(
    ("output", "words"),
    [
        (None, "needs cargo, which is not on the PATH; install Rust 1.89 or newer from https://rustup.rs"),
        ("cargo 1.70.0 (old)", "needs cargo 1.89, but found 1.70; install Rust 1.89 or newer"),
        ("nonsense", "but `cargo --version` says 'nonsense'; install Rust 1.89 or newer"),
    ],
)
def test_a_build_without_a_suitable_cargo_fails_with_one_sentence(
    output: str | None, words: str, tmp_path: Path
) -> None:
    need("fork")  # The stand-in for cargo is a shell script.
    if output is not None:
        script = tmp_path / "cargo"
        script.write_text(f"#!/bin/sh\necho '{output}'\n")
        script.chmod(script.stat().st_mode | stat.S_IEXEC)
    path = os.pathsep.join([str(tmp_path), "/nonexistent"])
    for command in ([sys.executable, BACKEND], [sys.executable, "-c", f"{IMPORT_BACKEND}; b.build_wheel('.')"]):
        process = run(*command, PATH=path if output is None else os.pathsep.join([str(tmp_path), "/bin"]))
        assert process.returncode == 1
        assert process.stderr.count("\n") == 1
        assert words in process.stderr


def test_command_line_scripts_are_executable() -> None:
    for name in (".ci/run", "scripts/system-packages.sh", "scripts/dev-build.sh"):
        assert os.access(CHECKOUT / name, os.X_OK), name
