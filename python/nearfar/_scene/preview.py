"""A scene's card for notebooks: counts, extent, notes, and a small picture of bounded cost."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import card, random
from nearfar._camera.camera import Camera, Fov
from nearfar._camera.shot import Shot
from nearfar._scene.report import Report, count

SIZE = (320, 200)
"""Width and height of the picture in pixels."""

WHOLE = 750_000
"""Most distinct triangles and instances to draw exactly: their trees take less than a second to build."""

SAMPLE = 250_000
"""Number of triangles drawn as points for larger scenes, whose trees would take seconds and stay in memory."""

SUN = np.array([0.3, 0.9, 0.33])
"""Direction of the light for points."""

MEASURED = 20_000
"""Number of sampled triangles that determine where the scene is dense."""

TOWARDS = np.array([0.45, 0.5, 0.74])
"""Unit direction from the middle of the scene towards the camera."""


def html(core: _core.Scene, report: Report, bounds: NDArray[np.float64]) -> str:
    """Make the card of a scene."""
    facts = [
        ("triangles", f"{report.triangles:,}"),
        (
            "objects",
            f"{report.objects:,} in {count(report.instances, 'instance')} of {count(report.meshes, 'mesh', 'meshes')}",
        ),
        ("moving", count(report.dynamic, "instance")),
        ("materials", f"{count(report.materials, 'material')}, {count(report.textures, 'texture')}"),
    ]
    if report.degenerate_faces:
        facts.append(("without an area", count(report.degenerate_faces, "face")))
    if report.dropped_faces:
        facts.append(("dropped", count(report.dropped_faces, "unusable face")))
    notes = [*report.notes, *filter(None, [report.unit_note])]
    if not np.isfinite(bounds).all():
        return card.page("Scene", facts, notes=notes)
    facts.append(("extent", " × ".join(map(card.length, bounds[1] - bounds[0])) + " m"))
    facts += [(name, card.point(corner)) for name, corner in zip(("from", "to"), bounds, strict=True)]
    pixels, caption = picture(core, bounds)
    return card.page("Scene", facts, card.picture(pixels, "bird's-eye view of the scene", caption), notes=notes)


def picture(core: _core.Scene, bounds: NDArray[np.float64]) -> tuple[NDArray[np.uint8], str]:
    """Draw the dense part of a scene from above and beside, exactly or by samples; return a caption, too."""
    camera = view(core, bounds)
    if cost(core) > WHOLE:
        sample = core.subset_of_triangles(every(core.triangle_count, SAMPLE))
        share = f"{sample.triangle_count:,} of {core.triangle_count:,} triangles, as points"
        return _points(sample, camera), f"bird's-eye view of the dense part; {share}"
    shot = Shot(cameras=(camera,), channels=("color",), samples=4)
    color = _core.render_truth(core, camera._core, shot.settings)["color"]
    return _core.encode_srgb(color).reshape(SIZE[1], SIZE[0], 3), "bird's-eye view of the dense part"


def _points(core: _core.Scene, camera: Camera) -> NDArray[np.uint8]:
    """Draw the centre of each triangle as 2 × 2 grey pixels (H, W, 4), which hide gaps between sparse samples."""
    corners = core.triangles().astype(np.float64)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lit = np.abs(normal @ SUN) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    placed = camera.project(corners.mean(axis=1) + np.array(core.origin))
    ahead = np.isfinite(placed).all(axis=1)
    placed, shade = placed[ahead], (60.0 + 170.0 * lit[ahead]).astype(np.uint8)
    far_first = np.argsort(-placed[:, 2], kind="stable")
    corner = np.clip(np.floor(placed[far_first, :2] - 0.5), -2, 1 << 20).astype(np.int64)
    pixels = (corner[:, None] + np.array([[0, 0], [1, 0], [0, 1], [1, 1]])).reshape(-1, 2)
    shades = np.repeat(shade[far_first], 4)
    inside = ((pixels >= 0) & (pixels < SIZE)).all(axis=1)
    picture = np.zeros((SIZE[1], SIZE[0], 4), np.uint8)
    picture[pixels[inside, 1], pixels[inside, 0]] = np.column_stack([*[shades[inside]] * 3, np.full(inside.sum(), 255)])
    return picture


def cost(core: _core.Scene) -> int:
    """Number of elements in a scene's trees: triangles of distinct meshes, and instances."""
    _, first = np.unique(core.mesh_ids(), return_index=True)
    return int(np.diff(core.triangle_offsets())[first].sum()) + core.instance_count


def every(total: int, wanted: int) -> NDArray[np.bool_]:
    """Sample about `wanted` of `total` triangles: one at a random place in each interval of equal length.

    Equal spacing would alias with meshes whose faces are in rows.
    """
    stretch = max(1, -(-total // max(wanted, 1)))
    if stretch == 1:
        return np.ones(total, bool)
    starts = np.arange(0, total, stretch)
    numbers = starts + np.floor(random.uniform(0, 0, starts) * stretch).astype(np.int64)
    chosen = np.zeros(total, bool)
    chosen[numbers[numbers < total]] = True
    return chosen


def view(core: _core.Scene, bounds: NDArray[np.float64]) -> Camera:
    """Camera that sees the middle nine tenths of the triangles: ground and distant hills are wide and hold few."""
    sample = core.subset_of_triangles(every(core.triangle_count, MEASURED)).triangles().mean(axis=1, dtype=np.float64)
    low, high = np.percentile(sample, [5.0, 95.0], axis=0) + np.array(core.origin)
    middle, grown = (low + high) / 2.0, 0.65 * (high - low)
    low, high = np.maximum(middle - grown, bounds[0]), np.minimum(middle + grown, bounds[1])
    middle, radius = (low + high) / 2.0, max(float(np.linalg.norm(high - low)) / 2.0, 1e-3)
    return Camera.look_at(
        middle + 2.2 * radius * TOWARDS, middle, fov=Fov.symmetric(60.0, SIZE[0] / SIZE[1]), size=SIZE
    )
