"""Run time against error of the morph of 10 million float32 points, compared with NumPy, numba and a copy."""

from __future__ import annotations

import functools
import importlib
import importlib.util
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, Work, compare, print_limits
from benchmarks.harness.report import start

COUNT = 10_000_000
USER, CENTER, R1, R2 = (3.0, 1.0, 2.0), (0.0, 1.7, 0.0), 30.0, 50.0


def numpy_morph(points: NDArray[Any], real: Any = np.float32) -> NDArray[Any]:
    """Eq. 1–3 as published, in one precision throughout."""
    p, u, o = (np.asarray(x, real) for x in (points, USER, CENTER))
    from_o, from_u = p - o, p - u
    rho = np.sqrt(from_o[:, 0] ** 2 + from_o[:, 2] ** 2)
    w = np.clip((real(R2) - rho) / real(R2 - R1), real(0), real(1))[:, None]
    a, b = np.sqrt((from_u**2).sum(1))[:, None], np.sqrt((from_o**2).sum(1))[:, None]
    d = w * from_u / a + (real(1) - w) * from_o / b
    d /= np.sqrt((d**2).sum(1))[:, None]
    return np.asarray(u + (w * a + (real(1) - w) * b) * d)


def numba_morph() -> Callable[..., NDArray[Any]]:
    numba = importlib.import_module("numba")
    (ux, uy, uz), (ox, oy, oz) = (tuple(map(np.float32, x)) for x in (USER, CENTER))
    r1, r2, unit, zero = (np.float32(x) for x in (R1, R2, 1, 0))

    def body(points: Any, morphed: Any) -> None:
        for i in numba.prange(len(points)):
            x, y, z = points[i, 0], points[i, 1], points[i, 2]
            bx, by, bz = x - ox, y - oy, z - oz
            ax, ay, az = x - ux, y - uy, z - uz
            w = min(max((r2 - np.sqrt(bx * bx + bz * bz)) / (r2 - r1), zero), unit)
            a, b = np.sqrt(ax * ax + ay * ay + az * az), np.sqrt(bx * bx + by * by + bz * bz)
            wa, wb = w / a, (unit - w) / b
            dx, dy, dz = wa * ax + wb * bx, wa * ay + wb * by, wa * az + wb * bz
            t = (w * a + (unit - w) * b) / np.sqrt(dx * dx + dy * dy + dz * dz)
            morphed[i, 0], morphed[i, 1], morphed[i, 2] = ux + t * dx, uy + t * dy, uz + t * dz

    kernel = numba.njit(parallel=True, fastmath=True)(body)

    def morph(points: NDArray[Any], morphed: NDArray[Any] | None = None) -> NDArray[Any]:
        morphed = np.empty_like(points) if morphed is None else morphed
        kernel(points, morphed)
        return morphed

    return morph


def ours(points: NDArray[Any], kind: str = "blend", out: Any = None) -> NDArray[Any]:
    return nf.morph(points, user=USER, center=CENTER, r1=R1, r2=R2, kind=kind, out=out)


def error(shown: NDArray[Any], points: NDArray[Any]) -> float:
    """Greatest distance in metres from Eq. 1–3 in extended precision, of the first points."""
    first_rows = slice(100_000)
    return float(np.abs(shown[first_rows] - numpy_morph(points[first_rows], np.longdouble)).max())


def main() -> None:
    random = np.random.default_rng(0)
    points = (random.random((COUNT, 3), np.float32) - np.float32(0.5)) * np.float32(150)
    points[:, 1] += np.float32(40)
    output, peer_output = np.empty_like(points), np.empty_like(points)
    error_of = functools.partial(error, points=points)
    cases = [
        Case(OURS, lambda: ours(points), error_of),
        Case(f"{OURS}, out=", lambda: ours(points, out=output), error_of),
        Case(f"{OURS}, cylinder", lambda: ours(points, kind="cylinder")),
        Case("NumPy", lambda: numpy_morph(points), error_of),
        Case("np.copy (one thread)", points.copy),
    ]
    if importlib.util.find_spec("numba"):
        numba = numba_morph()
        cases += [Case("numba, parallel, fast-math", lambda: numba(points), error_of)]
        cases += [Case("numba, into an array at hand", lambda: numba(points, peer_output), error_of)]
    start(__doc__)
    print_limits()
    title = "Morph of 10⁷ float32 points scattered over 150 m, r1 = 30 m, r2 = 50 m"
    print(compare(title, cases, work=Work(bytes=2 * points.nbytes), unit="m"))
    double = points[: COUNT // 4].astype(np.float64)
    job = [Case(f"{OURS}, float64", lambda: ours(double))]
    print(compare("Morph of 2.5 · 10⁶ float64 points", job, work=Work(bytes=2 * double.nbytes)))


if __name__ == "__main__":
    main()
