"""Run time against error of the morph: 10 million float32 points, beside NumPy, numba and the copy limit."""

from __future__ import annotations

import importlib
import importlib.util
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from _measure import best, machine, table

COUNT = 10_000_000
USER, CENTER, R1, R2 = (3.0, 1.0, 2.0), (0.0, 1.7, 0.0), 30.0, 50.0

Job = Callable[[NDArray[Any]], NDArray[Any]]


def numpy_morph(points: NDArray[Any], real: Any = np.float32) -> NDArray[Any]:
    """Eq. 1–3 as written, in one precision throughout."""
    p, u, o = (np.asarray(x, real) for x in (points, USER, CENTER))
    from_o, from_u = p - o, p - u
    rho = np.sqrt(from_o[:, 0] ** 2 + from_o[:, 2] ** 2)
    w = np.clip((real(R2) - rho) / real(R2 - R1), real(0), real(1))[:, None]
    a, b = np.sqrt((from_u**2).sum(1))[:, None], np.sqrt((from_o**2).sum(1))[:, None]
    d = w * from_u / a + (real(1) - w) * from_o / b
    d /= np.sqrt((d**2).sum(1))[:, None]
    shown: NDArray[Any] = u + (w * a + (real(1) - w) * b) * d
    return shown


def numba_morph() -> Job:
    numba = importlib.import_module("numba")
    (ux, uy, uz), (ox, oy, oz) = (tuple(map(np.float32, x)) for x in (USER, CENTER))
    r1, r2, one, zero = (np.float32(x) for x in (R1, R2, 1, 0))

    def body(points: Any, shown: Any) -> None:
        for i in numba.prange(len(points)):
            x, y, z = points[i, 0], points[i, 1], points[i, 2]
            bx, by, bz = x - ox, y - oy, z - oz
            ax, ay, az = x - ux, y - uy, z - uz
            w = min(max((r2 - np.sqrt(bx * bx + bz * bz)) / (r2 - r1), zero), one)
            a, b = np.sqrt(ax * ax + ay * ay + az * az), np.sqrt(bx * bx + by * by + bz * bz)
            wa, wb = w / a, (one - w) / b
            dx, dy, dz = wa * ax + wb * bx, wa * ay + wb * by, wa * az + wb * bz
            t = (w * a + (one - w) * b) / np.sqrt(dx * dx + dy * dy + dz * dz)
            shown[i, 0], shown[i, 1], shown[i, 2] = ux + t * dx, uy + t * dy, uz + t * dz

    kernel = numba.njit(parallel=True, fastmath=True)(body)

    def morph(points: NDArray[Any]) -> NDArray[Any]:
        shown = np.empty_like(points)
        kernel(points, shown)
        return shown

    return morph


def ours(r1: float = R1, r2: float = R2, kind: str = "blend") -> Job:
    return lambda points: nf.morph(points, user=USER, center=CENTER, r1=r1, r2=r2, kind=kind)


def error(job: Job, points: NDArray[Any]) -> str:
    """Greatest distance in metres from Eq. 1–3 in extended precision."""
    few = points[:100_000]
    return f"{np.abs(job(few) - numpy_morph(few, np.longdouble)).max():.1e}"


def main() -> None:
    random = np.random.default_rng(0)
    points = (random.random((COUNT, 3), np.float32) - np.float32(0.5)) * np.float32(150)
    points[:, 1] += np.float32(40)
    peers: list[tuple[str, Job, int]] = [("nearfar", ours(), 7), ("NumPy", numpy_morph, 2)]
    if importlib.util.find_spec("numba"):
        peers.append(("numba, parallel, fast-math", numba_morph(), 5))
    copy = best(points.copy, repeat=7)
    rows = [["np.copy (one thread)", f"{copy.wall * 1e3:.1f}", f"{copy.cpu * 1e3:.1f}", "1.0", "0"]]
    cases = [(name, job, repeat, error(job, points)) for name, job, repeat in peers]
    cases += [
        ("nearfar, all inside r1", ours(200, 300), 7, "0"),
        ("nearfar, all beyond r2", ours(0.1, 0.2), 7, "0 (rounded once)"),
        ("nearfar, cylinder", ours(kind="cylinder"), 5, "-"),
    ]
    for name, job, repeat, distance in cases:
        timing = best(lambda job=job: job(points), repeat=repeat)  # type: ignore[misc]
        ratio = f"{timing.wall / copy.wall:.1f}"
        rows.append([name, f"{timing.wall * 1e3:.1f}", f"{timing.cpu * 1e3:.1f}", ratio, distance])
    double = points[: COUNT // 4].astype(np.float64)
    timing = best(lambda: ours()(double))
    rows.append(["nearfar, float64 (per 10⁷)", f"{timing.wall * 4e3:.1f}", f"{timing.cpu * 4e3:.1f}", "-", "-"])
    print(machine())
    header = ["", "wall ms", "CPU ms", "wall / copy", "greatest error, m"]
    print(table(f"Morph of {COUNT:,} float32 points, r1 = 30 m, r2 = 50 m, scattered over 150 m", header, rows))


if __name__ == "__main__":
    main()
