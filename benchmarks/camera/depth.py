"""Run time against error of ranges from depth buffers, and the error of rounded depth from 0.1 m to 10 km."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, Work, compare, print_limits
from benchmarks.harness.report import start, table

Array = NDArray[np.float32]
FOV = nf.hmd.QUEST_2.left.fov
NEAR = 0.1


def divide(depth: NDArray[Any]) -> NDArray[Any]:
    """Straightforward formula in the type of the buffer."""
    height, width = depth.shape
    x = np.linspace(FOV.left, FOV.right, 2 * width + 1, dtype=depth.dtype)[1::2]
    y = np.linspace(FOV.up, FOV.down, 2 * height + 1, dtype=depth.dtype)[1::2, None]
    return np.asarray(depth.dtype.type(NEAR) / depth * np.sqrt(1 + x * x + y * y))


def unproject(depth: Array) -> Array:
    """General code: every pixel through the inverse of the projection matrix."""
    height, width = depth.shape
    rows = np.zeros((4, 4), np.float32)
    rows[0, 0], rows[0, 2] = 2 / (FOV.right - FOV.left), (FOV.right + FOV.left) / (FOV.right - FOV.left)
    rows[1, 1], rows[1, 2] = 2 / (FOV.up - FOV.down), (FOV.up + FOV.down) / (FOV.up - FOV.down)
    rows[2, 3], rows[3, 2] = NEAR, -1
    x = (np.arange(width, dtype=np.float32) + 0.5) * (2 / width) - 1
    y = 1 - (np.arange(height, dtype=np.float32) + 0.5) * (2 / height)
    clip = np.stack([*np.broadcast_arrays(x, y[:, None], depth), np.ones_like(depth)], axis=-1)
    points = clip @ np.linalg.inv(rows).T
    return np.asarray(np.linalg.norm(points[..., :3] / points[..., 3:], axis=-1))


def exact(depth: Array) -> NDArray[np.longdouble]:
    """The formula in extended precision, whose error is 2⁻¹¹ of float64's."""
    height, width = depth.shape
    sides = [np.longdouble(v) for v in (FOV.left, FOV.right, FOV.up, FOV.down)]
    x = sides[0] + (sides[1] - sides[0]) * (np.arange(width, dtype=np.longdouble) + 0.5) / width
    y = sides[2] + (sides[3] - sides[2]) * (np.arange(height, dtype=np.longdouble) + 0.5) / height
    return np.asarray(np.longdouble(NEAR) / depth * np.sqrt(1 + x * x + (y * y)[:, None]))


def ranges(side: int) -> str:
    depth = (NEAR / np.random.default_rng(0).uniform(0.5, 200, (side, side))).astype(np.float32)
    true = exact(depth)

    def error(result: Array) -> float:
        return float(np.abs(result / true - 1).max())

    cases = [
        Case(OURS, lambda: nf.range_from_depth(depth, FOV, near=NEAR), error),
        Case("NumPy, float32, one expression", lambda: divide(depth), error),
        Case("NumPy, float32, inverse matrix", lambda: unproject(depth), error),
        Case("NumPy, float64, one expression", lambda: divide(depth.astype(np.float64)).astype(np.float32), error),
        Case("copying the buffer", depth.copy),
    ]
    return compare(f"Range from a float32 depth buffer of {side}²", cases, work=Work(bytes=2 * depth.nbytes), repeat=5)


def costs() -> str:
    """Table of bounds of the error in metres of perfectly rounded depth, near plane at 0.1 m and no far plane."""
    distances = [0.1, 1.0, 10.0, 100.0, 1e3, 1e4]
    formats = {"float32, reversed": (True, "float32"), "float32, standard": (False, "float32")}
    formats |= {"24 bits": (True, "uint24"), "16 bits": (True, "uint16")}
    rows = [
        [title, *(nf.range_error(z, near=NEAR, reverse=reverse, depth_format=kind) for z in distances)]
        for title, (reverse, kind) in formats.items()
    ]
    return table("Metres that a range is off by at most", ["depth", *(f"{z:g} m {{:.1e}}" for z in distances)], rows)


def main() -> None:
    start(__doc__)
    print_limits()
    for side in (1024, 2048, 4096):
        print(ranges(side), flush=True)
    print(costs())


if __name__ == "__main__":
    main()
