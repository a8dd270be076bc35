"""Error bound of impostors: up to a million texels of each case against the scene points that they were baked from.

Users at random places of the region, and those farthest from each line of sight, see both points; the columns are
pixels of 1/20 degree. The drawn point is where a quad's triangle has the texel's coordinates, in float64 from float32
vertices; the file's positions replace these vertices in the last column.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

import nearfar as nf
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.impostor.quality import Case, bake, cases
from benchmarks.impostor.texels import Floats, Texels, angle
from nearfar._impostor.bake import PIXELS_PER_DEGREE

PIXELS = np.degrees(1.0) * PIXELS_PER_DEGREE
"""Pixels of a radian."""

_CHUNK = 50_000


@dataclass(frozen=True)
class Errors:
    """Errors (N,) of texels in pixels, as the worst of their users sees them."""

    plane: Floats
    """The quad's plane against the scene point: what the bound limits."""
    texture: Floats
    """The drawn point against the plane's point: interpolation of texture coordinates."""
    columns: Floats
    """The same in texels, the greater of both directions."""
    file: Floats
    """Positions of the file against those of the quads."""
    whole: Floats
    """The drawn point with the file's positions against the scene point."""
    is_grown: NDArray[np.bool_]
    """Texels no sample of which is within the bound: the mask grew there over what lies before the plane."""


def errors(texels: Texels, path: Path, count: int, seed: int = 0, users: int = 16) -> Errors:
    """Measure random texels; each is seen by `users` random users and by 16 far from its line of sight."""
    draw = np.random.default_rng(seed)
    shown = texels.shown_texels()
    chosen = np.sort(draw.permutation(len(shown))[:count])
    vertices = texels.quads.vertices.astype(np.float64)
    file = nf.Scene.load(path)
    stored = file.triangles().reshape(-1, 3) + file.origin
    moved = stored[cKDTree(stored).query(vertices)[1]]
    parts = [
        _errors(texels, shown[part], vertices, moved, draw, users)
        for part in np.array_split(chosen, len(chosen) // _CHUNK + 1)
    ]
    return Errors(*(np.concatenate(arrays) for arrays in zip(*parts, strict=True)))


def _errors(
    texels: Texels, places: NDArray[np.int64], vertices: Floats, moved: Floats, draw: np.random.Generator, users: int
) -> tuple[Any, ...]:
    quad = texels.quads.owners[texels.triangles(places + 0.5)[0]].astype(np.int64)
    corner = texels.quads.rectangles[quad, :2]
    local, points = texels.scene_points(quad, places - corner)
    triangles, weights = texels.triangles(corner + local)
    eyes = texels.worst_users(points.plane, points.plane - texels.faces.center[quad], draw, users)
    corners = texels.quads.faces[triangles]
    drawn, filed = ((weights[..., None] * rows[corners]).sum(axis=1) for rows in (vertices, moved))
    plane = PIXELS * points.errors(points.plane, eyes)

    def between(a: Floats, b: Floats) -> Floats:
        return np.asarray(PIXELS * angle(a[:, None] - eyes, b[:, None] - eyes).max(axis=1), np.float64)

    off = np.abs(texels.faces.places(quad, drawn, texels.size) - local).max(axis=1)
    # A plane in front of all surfaces is no grown mask, whatever its error. Positions are float32.
    is_grown = points.is_behind & ~(plane <= texels.impostors.settings.error_px * (1.0 + 1e-6) + 1e-4)
    return (
        plane,
        between(points.plane, drawn),
        off,
        between(drawn, filed),
        PIXELS * points.errors(filed, eyes),
        is_grown,
    )


def row(case: Case, count: int, folder: Path) -> list[Any]:
    """Bake, save and measure a case."""
    impostors = bake(case.scene, case.center, case.r2, nf.ImpostorSettings(**case.settings))
    path = folder / "far.glb"
    impostors.save_glb(path, part="far", textures="png")
    found = errors(Texels(case.scene, impostors), path, count)
    kept = ~found.is_grown
    above = 100.0 * float((found.plane[kept] > impostors.settings.error_px).mean())
    spread = [np.quantile(values[kept], (0.99, 1.0)).tolist() for values in (found.plane, found.texture, found.whole)]
    shares = (len(kept), 100.0 * (1.0 - float(kept.mean())), impostors.settings.error_px)
    plane, texture, whole = spread
    return [case.label, *shares, *plane, above, *texture, found.columns[kept].max(), found.file[kept].max(), *whole]


HEADER = (
    "case | texels {:,} | grown, % {:.1f} | ε, px {:.3g} | planes, px: 99 % {:.2f} | greatest {:.4f} |"
    " above ε, % {:.4f} | texture coordinates, px: 99 % {:.2f} | greatest {:.2f} | in texels {:.3f} |"
    " positions of the file, px {:.4f} | sum, px: 99 % {:.2f} | greatest {:.2f}"
)


def main() -> None:
    arguments = start(__doc__, "--quick", texels=(1_000_000, "greatest number of texels of a case"))
    count = min(arguments.texels, 20_000) if arguments.quick else arguments.texels
    with folder_or_temporary() as folder:
        rows = []
        for case in cases((240, 136), 4, arguments.quick):
            if case.far_triangles is not None:
                continue
            rows.append(row(case, count, folder))
            print(*rows[-1], flush=True)
    print(table("Texels of impostors against the scene points that they were baked from", HEADER, rows))


if __name__ == "__main__":
    main()
