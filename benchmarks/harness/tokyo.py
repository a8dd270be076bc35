"""Loads the whole of Tokyo as arrays, which a tool beside the data folder makes once for nearfar's cache."""

from __future__ import annotations

import importlib.util
import warnings
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import cache, data


def load_arrays() -> tuple[NDArray[np.float32], NDArray[np.uint32]] | None:
    """Load vertices and faces of 29.8 million triangles, or None without the tool. The first call takes a minute."""
    stored = _load_or_make()
    return None if stored is None else (stored["vertices"], stored["faces"])


def with_buildings() -> tuple[NDArray[np.float32], NDArray[np.uint32], NDArray[np.int32]] | None:
    """Load the same arrays and the building of each face."""
    stored = _load_or_make()
    return None if stored is None else (stored["vertices"], stored["faces"], stored["building"])


def scene_of_buildings() -> nf.Scene | None:
    """Make a scene with an object for each building; None without the tool."""
    arrays = with_buildings()
    return None if arrays is None else nf.Scene.from_arrays(arrays[0], arrays[1], face_object=arrays[2])


def _load_or_make() -> Any:
    root = data.root()
    tool = None if root is None else root.parent / "tools" / "tokyo.py"
    if tool is None or not tool.is_file():
        return None
    return np.load(cache.get_or_make(cache.key("benchmark tokyo", 2), ".npz", lambda path: _make(tool, path)))


def _make(tool: Path, path: Path) -> None:
    spec = importlib.util.spec_from_file_location("tokyo", tool)
    if spec is None or spec.loader is None:
        raise ImportError(f"{tool}: expected a Python module")
    module: Any = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    # The tool is not part of nearfar, whose tests turn warnings into errors.
    with warnings.catch_warnings(action="ignore"):
        vertices, faces, building = module.mesh()
    with path.open("wb") as file:
        np.savez(file, vertices=vertices, faces=faces, building=building)
