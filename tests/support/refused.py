"""Damages files and documents, and loads files; those that claim too much in a separate process."""

from __future__ import annotations

import copy
import os
import random
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import nearfar as nf
from tests.attack import mutate
from tests.support import PEAK
from tests.support.gltf_cases import load


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


def refused_twice(path: Path) -> tuple[str, str, int]:
    """Return the errors under the default limit of bytes and under one of 2⁵⁰, and the bytes by which memory grew."""
    code = f"{PEAK}\nimport sys, nearfar as nf\nstart = peak()\nfor most in (None, 1 << 50):\n"
    code += "    try: nf.Scene.load(sys.argv[1], max_bytes=most)\n"
    code += "    except nf.SceneError as error: print(error)\nprint(peak() - start)"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", code, str(path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=True, env=environment)
    first, second, more = done.stdout.splitlines()
    return first, second, int(more)
