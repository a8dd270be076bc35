"""The steps of an export are a line: few functions take the scene, all by one name.

Functions are counted while two exports run with all options: those of `nearfar.stream` that are called with a `Scene`
as an argument other than `self`. Functions of other stages, such as `bake`, and what holds a scene, such as `Rings`, do
not count.
"""

from __future__ import annotations

import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from types import FrameType
from typing import Any

import numpy as np

import nearfar as nf
from tests.support import leveled_cases

FOLDER = Path(nf.stream.__file__).parent
MAX_FUNCTIONS = 15

Taken = dict[tuple[str, str, int], set[str]]
"""Names of the parameters that were scenes, by file, name and line of the function."""


@contextmanager
def scenes_taken() -> Iterator[Taken]:
    """Record the functions of all threads that are called with a scene."""
    taken: Taken = {}

    def look(frame: FrameType, event: str, _: Any) -> None:
        code = frame.f_code
        if event == "call" and Path(code.co_filename).parent == FOLDER:
            names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
            found = {name for name in names if name != "self" and isinstance(frame.f_locals.get(name), nf.Scene)}
            if found:
                taken[Path(code.co_filename).name, code.co_name, code.co_firstlineno] = found

    threading.setprofile(look)
    sys.setprofile(look)
    try:
        yield taken
    finally:
        sys.setprofile(None)
        threading.setprofile(None)


def test_few_functions_of_an_export_take_the_scene_all_by_one_name(tmp_path: Path) -> None:
    places = np.tile(np.eye(4), (4, 1, 1))
    places[:, :3, 3] = [(0.0, 1.7, -distance) for distance in (3.0, 8.0, 16.0, 30.0)]
    scene = nf.lod.place([leveled_cases.model_of((3, 2, 1, 0))], [0] * 4, places)
    scene = scene.with_dynamic([scene.object_names[1]])
    options: dict[str, Any] = {"center": [(0.0, 1.7, 0.0), (4.0, 1.7, 0.0)], "face_size": 64, "samples": 1}
    with scenes_taken() as taken:
        nf.stream.export(scene, tmp_path / "chosen", **options, by_footprint=True)
        given: dict[str, Any] = {"radii": (12.0, 20.0), "lod": "depth", "split_px": 50.0}
        nf.stream.export(scene, tmp_path / "given", **options, grid=1.0, **given)
    assert {name for _, name, _ in taken} > {"export", "object_radii", "scene_facts"}
    assert set().union(*taken.values()) == {"scene"}
    assert len(taken) <= MAX_FUNCTIONS, sorted(taken)
