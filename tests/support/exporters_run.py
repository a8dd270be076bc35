"""Exports the models of `exporters_cases`: runs gltfpack, glTF-Transform, Blender, Assimp and trimesh."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import trimesh

from nearfar._base import data as data_files
from tests.support.exporters import SOURCES, Case, plain
from tests.support.reader_cases import EXPORTERS as FOLDER, SECONDS


def _run(*command: str | Path, folder: Path, **environment: str) -> str:
    process = subprocess.run(
        command,
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=SECONDS,
        check=False,
        stdin=subprocess.DEVNULL,
        env=os.environ | environment,
    )
    assert process.returncode == 0, f"{command}: {process.stdout[-2000:]}{process.stderr[-2000:]}"
    return process.stdout


def _copy_pictures(cases: Sequence[Case], folder: Path) -> None:
    """Copy the sources' pictures, which some exporters name but do not copy."""
    for source in {case.source for case in cases}:
        for picture in data_files.require(SOURCES[source]).parent.glob("*.png"):
            shutil.copy(picture, folder)


def _gltfpack(cases: Sequence[Case], folder: Path) -> None:
    program = FOLDER / "node_modules" / "gltfpack" / "cli.js"
    for case in cases:
        _run("node", program, "-i", plain(case.source, folder), "-o", case.file, *case.options, folder=folder)


def _gltf_transform(cases: Sequence[Case], folder: Path) -> None:
    transform([(plain(case.source, folder), folder / case.file, case.options) for case in cases], folder)


def transform(jobs: Sequence[tuple[Path, Path, Any]], folder: Path) -> None:
    """Run steps of glTF-Transform, each a name and options, from a file to another."""
    described = [{"from": str(source), "to": str(file), "steps": steps} for source, file, steps in jobs]
    (folder / "jobs.json").write_text(json.dumps(described))
    _run("node", FOLDER / "transform.mjs", "jobs.json", folder=folder)


def _blender(cases: Sequence[Case], folder: Path) -> None:
    jobs = [
        {"from": str(plain(case.source, folder)), "to": str(folder / case.file), "settings": case.options or {}}
        for case in cases
    ]
    (folder / "jobs.json").write_text(json.dumps(jobs))
    _copy_pictures(cases, folder)
    script = FOLDER / "in_blender.py"
    # Blender uses the modules of the first python3 in PATH; NumPy is installed for the system's.
    path = os.pathsep.join(["/usr/bin", os.environ.get("PATH", "")])
    _run("blender", "-b", "--python-exit-code", "3", "--python", script, "--", "jobs.json", folder=folder, PATH=path)


def _assimp(cases: Sequence[Case], folder: Path) -> None:
    _copy_pictures(cases, folder)
    for case in cases:
        _run("assimp", "export", plain(case.source, folder), case.file, f"-f{case.options}", folder=folder)


def _trimesh(cases: Sequence[Case], folder: Path) -> None:
    for case in cases:
        loaded = trimesh.load_scene(plain(case.source, folder), process=False)
        path = folder / case.file
        path.parent.mkdir(exist_ok=True)
        (loaded.to_mesh() if path.suffix == ".off" else loaded).export(path)


EXPORTERS: dict[str, Callable[[Sequence[Case], Path], None]] = {
    "gltfpack": _gltfpack,
    "glTF-Transform": _gltf_transform,
    "Blender": _blender,
    "Assimp": _assimp,
    "trimesh": _trimesh,
}
"""Functions that write the files of some cases to a folder."""
