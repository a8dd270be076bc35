"""Tessellation for the growth of a cylinder morph: triangles, and the greatest error as a share of the tolerance.

After a ring has arrived, the outer radius R of the morph, or for ring 1 its strength, grows (docs/stream.md).
"""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.report import start, table
from benchmarks.harness.timing import best
from benchmarks.tessellate.tessellate import CENTER, PIXEL, morph_errors
from tests.support.tessellate_cases import VIEW, ground

NEAR, REACH, TOLERANCE = 0.7, 1.0, 4.0
"""r₁ as a share of R = r₂; greatest distance of users from the centre, metres; tolerance in pixels of `VIEW`."""
GROWTHS = {"10 m, all strengths": (10.0, 10.0, 0.0), "10 to 14 m": (10.0, 14.0, 1.0), "22 to 32 m": (22.0, 32.0, 1.0)}
"""Least and greatest R to which the morph grows, metres; least strength."""
EXEMPT = 2.6 * REACH
"""Distance from the axis within which no error bound holds while the strength is below 1, metres."""

Array = NDArray[Any]


def sheet(*corners: tuple[float, float, float]) -> trimesh.Trimesh:
    return trimesh.Trimesh(CENTER + corners, [[0, 1, 2], [0, 2, 3]], process=False)


def surfaces() -> dict[str, trimesh.Trimesh]:
    walls = {
        f"wall {x:g} m off, {height:g} m high": sheet((x, -2, -40), (x, -2, 40), (x, height, 40), (x, height, -40))
        for x, height in ((4.0, 30.0), (9.0, 30.0), (20.0, 300.0))
    }
    roof = sheet((-40, 4, -40), (40, 4, -40), (40, 12, 40), (-40, 12, 40))
    return {"ground, 200 m wide": ground(100.0), **walls, "roof 4 to 12 m above the eye": roof}


def greatest_error(triangles: Array, growth: tuple[float, float, float]) -> float:
    """Greatest error in pixels at ten points of each triangle, for 40 users, most of them at `REACH`, and several R."""
    least, greatest, weakest = growth
    random = np.random.default_rng(1)
    weights = np.concatenate([(1 - np.eye(3)) / 2, np.full((1, 3), 1 / 3), random.dirichlet(np.ones(3), 6)])
    error = 0.0
    for number in range(40):
        aim = random.normal(size=3) * [1, random.random(), 1]
        user = CENTER + REACH * random.random() ** 0.1 * aim / np.linalg.norm(aim)
        radius = least + (greatest - least) * (number % 8) / 7
        strength = 1.0 if weakest == 1.0 or number % 3 == 0 else random.random()
        settings: dict[str, Any] = {"user": user, "center": CENTER, "kind": "cylinder", "strength": strength}
        settings |= {"r1": NEAR * radius, "r2": radius}
        error = max(error, float(morph_errors(triangles, weights, settings).max()))
    return error / PIXEL


def rows_of(growth: tuple[float, float, float]) -> list[list[object]]:
    least, greatest, weakest = growth
    rows: list[list[object]] = []
    for name, mesh in surfaces().items():
        settings: dict[str, Any] = {"center": CENTER, "r1": NEAR * greatest, "r2": greatest, "user_region": REACH}
        settings |= {"kind": "cylinder", "radius": least, "strength": weakest}
        job = partial(nf.tessellate, mesh, **settings, tolerance_px=TOLERANCE, camera=VIEW)
        triangles = np.asarray(job().triangles)
        rho = np.hypot(*np.moveaxis((triangles - CENTER)[..., [0, 2]], -1, 0))
        has_bound = (rho > EXEMPT).all(axis=1) | (weakest >= 1.0)
        error = greatest_error(triangles[has_bound], growth)
        rows.append([name, len(triangles), error, error / TOLERANCE, best(job, repeat=1).wall])
    return rows


def main() -> None:
    start(__doc__)
    header = "surface | triangles {:,} | greatest error, px {:.2f} | of the bound {:.2f} | s {:.2f}"
    for name, growth in GROWTHS.items():
        title = f"Two triangles split for R of {name}, users within {REACH:g} m, to {TOLERANCE:g} px"
        print(table(title, header, rows_of(growth)))


if __name__ == "__main__":
    main()
