"""Damages files and documents, and loads files; those that claim too much in a separate process."""

from __future__ import annotations

import copy
import random
from collections.abc import Callable
from pathlib import Path
from typing import Any

import nearfar as nf
from tests.attack import mutate
from tests.support import PEAK
from tests.support.gltf_cases import load
from tests.support.thread_counts import output_of


def load_damaged(folder: Path, data: bytes, count: int, wrap: Callable[[bytes], bytes]) -> list[nf.Scene]:
    """Damage data many times, load GLBs that contain it, and return the scenes; errors must name the file."""
    scenes = []
    for seed in range(count):
        try:
            scenes.append(load(folder, wrap(mutate.damaged(data, random.Random(seed)))))
        except nf.SceneError as error:
            assert str(error).startswith(f"{folder / 'a.glb'}: ")  # noqa: PT017
    return scenes


def replace_value(document: Any, value: Any, *path: Any) -> Any:
    """A copy of a document with the value at a path replaced; `...` removes it."""
    document = copy.deepcopy(document)
    node = document
    for key in path[:-1]:
        node = node[key]
    if value is ...:
        del node[path[-1]]
    else:
        node[path[-1]] = value
    return document


def refusals(path: Path, *limits: int | None) -> tuple[list[str], int]:
    """Return the errors under limits of bytes, None for the default, and the bytes by which the memory grew."""
    code = f"""{PEAK}
import nearfar as nf
open("/proc/self/clear_refs", "w").write("5")
start = peak()
for most in {limits}:
    try: nf.Scene.load({str(path)!r}, max_bytes=most)
    except nf.SceneError as error: print(error)
print(peak() - start)
"""
    *messages, more = output_of(code).splitlines()
    return messages, int(more)
