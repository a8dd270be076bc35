"""An operation that takes seconds if nothing stops it, as a script.

It runs in an empty folder of its own. Ctrl-C ends it within half a second.
"""

from __future__ import annotations

import textwrap
from dataclasses import dataclass


@dataclass(frozen=True)
class LongOperation:
    """Statements that make what is needed, and statements that take seconds."""

    name: str
    make: str
    work: str
    gigabytes: float = 2.0
    """Memory that it takes at most."""
    needs: str = ""
    """Part that the system must have; see `tests.support.need`."""


def code(operation: LongOperation) -> str:
    """A script that prints "ready" before it works, and then "interrupted", or "finished" if no signal came."""
    work = textwrap.indent(operation.work, 8 * " ")
    end = f'    print("ready", flush=True)\n    try:\n{work}\n        print("finished", flush=True)\n'
    end += '    except KeyboardInterrupt:\n        print("interrupted", flush=True)\n'
    return f'{_BEGIN}\nif __name__ == "__main__":\n{textwrap.indent(operation.make or "pass", 4 * " ")}\n{end}'


_BEGIN = """
import pathlib, numpy as np, nearfar as nf
draw = np.random.default_rng(0)

def triangle():
    return nf.Scene.from_arrays([[-9, -9, -5], [9, -9, -5], [0, 9, -5]], [[0, 1, 2]])

def soup(count):
    points = draw.uniform(-100, 100, (count, 1, 3)) + draw.normal(0, 0.1, (count, 3, 3))
    return nf.Scene.from_arrays(points.reshape(-1, 3), np.arange(3 * count).reshape(-1, 3))

def sheet(side):
    u, v = np.meshgrid(np.arange(side), np.arange(side))
    points = np.stack([u / side, np.sin(u / 40) * np.cos(v / 40) / 20, v / side], -1).reshape(-1, 3)
    first = (u[:-1, :-1] + side * v[:-1, :-1]).ravel()
    faces = np.stack([first, first + 1, first + side, first + 1, first + side + 1, first + side], -1).reshape(-1, 3)
    return points, faces

def camera(width, height=None):
    return nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(width, height or width))

def units(count):
    directions = draw.standard_normal((count, 3), np.float32)
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    return directions

def frame(side, **images):
    return nf.Frame(camera(side), **images)

zones = {"center": (0, 0, 0), "r1": 10.0, "r2": 30.0}
lens = nf.RadialLens((0.22, 0.24))
"""
