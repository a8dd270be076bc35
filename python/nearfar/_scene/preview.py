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

MAX_EXACT_ELEMENTS = 750_000
"""Maximum number of distinct triangles and instances that are all drawn: their trees build within a second."""

POINT_COUNT = 250_000
"""Number of triangles drawn as points for larger scenes, whose trees would take seconds to build and stay in memory."""

SUN = np.array([0.3, 0.9, 0.33])
"""Direction of the light for points."""

VIEW_SAMPLE_COUNT = 20_000
"""Number of sampled triangles that determine the dense part of the scene."""

CAMERA_DIRECTION = np.array([0.45, 0.62, 0.74])
"""Direction from the middle of the scene towards the camera."""

DENSE_SHARE = 0.6
"""Size of the dense part, as a share of the scene's, from which the whole scene is shown."""

MARGIN = 1.1
"""Ratio of the camera's distance to the least distance at which the dense part is in the picture."""


def html(core: _core.Scene, report: Report, bounds: NDArray[np.float64]) -> str:
    """Make the card of a scene."""
    meshes = count(report.meshes, "mesh", "meshes")
    facts = [
        ("triangles", f"{report.triangles:,}"),
        ("objects", f"{report.objects:,} in {count(report.instances, 'instance')} of {meshes}"),
        ("moving", count(report.dynamic, "instance")),
        ("materials", f"{count(report.materials, 'material')}, {count(report.textures, 'drawn texture')}"),
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
    """Draw the dense part of a scene obliquely from above, all of it or a sample; also return a caption."""
    camera = dense_view(core, bounds)
    if element_count(core) > MAX_EXACT_ELEMENTS:
        sample = core.subset_of_triangles(sample_mask(core.triangle_count, POINT_COUNT))
        detail = f"{sample.triangle_count:,} of {core.triangle_count:,} triangles, as points"
        return _points(sample, camera), f"bird's-eye view of the dense part; {detail}"
    shot = Shot(cameras=(camera,), channels=("color",), samples=4)
    color = _core.render_truth(core, camera._core, shot.settings)["color"]
    return _core.encode_srgb(color).reshape(SIZE[1], SIZE[0], 3), "bird's-eye view of the dense part"


def _points(core: _core.Scene, camera: Camera) -> NDArray[np.uint8]:
    """Draw the centre of each triangle as 2 × 2 grey pixels (H, W, 4), which hide gaps between sparse samples."""
    corners = core.triangles().astype(np.float64)
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    cosine = np.abs(normal @ SUN) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    screen_points = camera.project(corners.mean(axis=1) + np.array(core.origin))
    is_in_front = np.isfinite(screen_points).all(axis=1)
    screen_points, shade = screen_points[is_in_front], (60.0 + 170.0 * cosine[is_in_front]).astype(np.uint8)
    far_first = np.argsort(-screen_points[:, 2], kind="stable")
    corner = np.clip(np.floor(screen_points[far_first, :2] - 0.5), -2, 1 << 20).astype(np.int64)
    pixels = (corner[:, None] + np.array([[0, 0], [1, 0], [0, 1], [1, 1]])).reshape(-1, 2)
    shades = np.repeat(shade[far_first], 4)
    inside = ((pixels >= 0) & (pixels < SIZE)).all(axis=1)
    image = np.zeros((SIZE[1], SIZE[0], 4), np.uint8)
    image[pixels[inside, 1], pixels[inside, 0]] = np.column_stack([*[shades[inside]] * 3, np.full(inside.sum(), 255)])
    return image


def element_count(core: _core.Scene) -> int:
    """Number of elements in a scene's trees: triangles of distinct meshes, and instances."""
    _, first = np.unique(core.mesh_ids(), return_index=True)
    return int(np.diff(core.triangle_offsets())[first].sum()) + core.instance_count


def sample_mask(total: int, sample_count: int) -> NDArray[np.bool_]:
    """Sample about `sample_count` of `total` triangles: one at a random place in each interval of equal length.

    Equal spacing would alias with meshes whose faces are in rows.
    """
    interval = max(1, -(-total // max(sample_count, 1)))
    if interval == 1:
        return np.ones(total, bool)
    starts = np.arange(0, total, interval)
    numbers = starts + np.floor(random.uniform(0, 0, starts) * interval).astype(np.int64)
    mask = np.zeros(total, bool)
    mask[numbers[numbers < total]] = True
    return mask


def dense_view(core: _core.Scene, bounds: NDArray[np.float64], size: tuple[int, int] = SIZE) -> Camera:
    """Camera that looks down at the dense part of a scene, which fills the picture."""
    low, high = dense_bounds(core, bounds)
    points = np.clip(_sample(core).reshape(-1, 3) + np.array(core.origin), low, high)
    middle, fov = (low + high) / 2.0, Fov.symmetric(60.0, size[0] / size[1])
    backwards = CAMERA_DIRECTION / np.linalg.norm(CAMERA_DIRECTION)
    right = np.cross([0.0, 1.0, 0.0], backwards)
    right /= np.linalg.norm(right)
    # A point is in the picture if its offset is at most its depth times the tangent of half the field of view.
    depth, eye, distance = (middle - points) @ backwards, middle, 1e-3
    for axis, tangent in ((right, fov.right), (np.cross(backwards, right), fov.up)):
        offset = (points - middle) @ axis
        greatest, least = (offset - tangent * depth).max(), (offset + tangent * depth).min()
        eye = eye + 0.5 * (greatest + least) * axis
        distance = max(distance, 0.5 * (greatest - least) / tangent)
    eye = eye + MARGIN * distance * backwards
    return Camera.look_at(eye, eye - distance * backwards, fov=fov, size=size)


def dense_bounds(core: _core.Scene, bounds: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Bounds of the middle nine tenths of the triangles, or of all if these are not much larger.

    Wide ground and distant hills have few triangles.
    """
    centroids = _sample(core).mean(axis=1)
    low, high = np.percentile(centroids, [5.0, 95.0], axis=0) + np.array(core.origin)
    middle, margin = (low + high) / 2.0, 0.65 * (high - low)
    low, high = np.maximum(middle - margin, bounds[0]), np.minimum(middle + margin, bounds[1])
    is_most = np.linalg.norm(high - low) >= DENSE_SHARE * np.linalg.norm(bounds[1] - bounds[0])
    return (bounds[0], bounds[1]) if is_most else (low, high)


def _sample(core: _core.Scene) -> NDArray[np.float64]:
    """About `VIEW_SAMPLE_COUNT` triangles (N, 3, 3), relative to the scene's origin."""
    return core.subset_of_triangles(sample_mask(core.triangle_count, VIEW_SAMPLE_COUNT)).triangles().astype(np.float64)
