"""Simplified surfaces keep textures and their seams, materials, colours and normals."""

from __future__ import annotations

import zipfile
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar import _core
from nearfar._scene.builder import SceneBuilder
from nearfar.lod._simplify import normals as smooth_normals, quadrics
from tests.support import data
from tests.support.simplify_cases import globe, open_edges

Array = NDArray[Any]


def parts(scene: nf.Scene) -> dict[str, Any]:
    return _core.mesh_parts(scene._core.merged())


def checkers(size: int = 256) -> Array:
    """Return a chequerboard whose colours encode position."""
    x, y = np.meshgrid(np.arange(size), np.arange(size))
    dark = ((x // 32 + y // 32) % 2) * 120
    return np.stack([x * 255 // size, y * 255 // size, 255 - dark, np.full_like(x, 255)], axis=2).astype(np.uint8)


def view(scene: nf.Scene, direction: tuple[float, float, float], size: int = 160) -> Array:
    low, high = scene.bounds
    middle, reach = (low + high) / 2, float(np.linalg.norm(high - low))
    eye = middle + reach * 1.1 * np.array(direction) / np.linalg.norm(direction)
    camera = nf.Camera.look_at(eye, middle, fov=nf.Fov.symmetric(55.0), size=(size, size))
    color = nf.render(scene, camera, channels=["color"], samples=4).color
    assert color is not None
    return color


VIEWS = [(1, 0.4, 0.2), (-0.5, 0.3, 1), (0.1, -0.2, -1)]


def likeness(base: nf.Scene, level: nf.Scene) -> float:
    """Return the least similarity over views, of 8-bit pictures."""
    return min(float(nf.ssim(view(base, way).clip(0, 1), view(level, way).clip(0, 1), data_range=1.0)) for way in VIEWS)


def test_textures_keep_their_position(method: Any) -> None:
    scene = globe(texture=checkers())
    levels = nf.lod.simplify(scene, [0.5, 0.2], method=method)
    for level, least in zip(levels[1:], (0.97, 0.9), strict=True):
        assert likeness(scene, level.scene) > least
        arrays = parts(level.scene)
        uvs, points = arrays["uvs"], arrays["positions"].astype(float)
        assert uvs.min() >= 0
        assert uvs.max() <= 1
        # Texture coordinates give a vertex's position on the sphere.
        around, down = 2 * np.pi * uvs[:, 0], np.pi * (1 - uvs[:, 1])
        aim = np.stack([np.sin(down) * np.cos(around), np.cos(down), -np.sin(down) * np.sin(around)], axis=1)
        assert np.linalg.norm(aim - points, axis=1).max() < 0.1
        # No face spans the texture from one side of the seam to the other.
        spans = np.ptp(uvs[arrays["faces"]][:, :, 0], axis=1)
        away = np.abs(points[arrays["faces"]][:, :, 1]).max(axis=1) < 0.9
        assert spans[away].max() < 0.4


def test_materials_stay_apart(method: Any) -> None:
    """Simplifies a sphere in two colours, whose border lies on an edge loop."""
    ball = trimesh.creation.icosphere(4)
    builder = SceneBuilder()
    red, blue = builder.material((1, 0, 0, 1)), builder.material((0, 0, 1, 1))
    faces = ball.faces
    upper = ball.triangles_center[:, 1] > 0
    builder.instance(builder.mesh(ball.vertices, faces, material=np.where(upper, red, blue)), name="ball")
    scene = builder.build()
    for level in nf.lod.simplify(scene, [0.3, 0.1], method=method)[1:]:
        arrays = parts(level.scene)
        middle = arrays["positions"][arrays["faces"]].mean(axis=1)[:, 1]
        assert set(arrays["materials"].tolist()) == {red, blue}
        assert middle[arrays["materials"] == red].min() > -0.1
        assert middle[arrays["materials"] == blue].max() < 0.1
        assert open_edges(level.scene) == 0


def test_vertex_colors_are_carried(method: Any) -> None:
    ball = trimesh.creation.icosphere(4)
    colors = np.column_stack([np.rint((ball.vertices + 1) * 127), np.full(len(ball.vertices), 255)]).astype(np.uint8)
    builder = SceneBuilder()
    builder.instance(builder.mesh(ball.vertices, ball.faces, colors=colors), name="ball")
    for level in nf.lod.simplify(builder.build(), [0.3, 0.1], method=method)[1:]:
        arrays = parts(level.scene)
        expected = (arrays["positions"] + 1) * 127
        assert np.abs(arrays["colors"][:, :3] - expected).max() < 8


def test_normals_are_interpolated_computed_or_omitted(method: Any) -> None:
    """Normals of a unit sphere equal its positions; smooth normals of a box are its faces'."""
    ball = trimesh.creation.icosphere(4)
    builder = SceneBuilder()
    builder.instance(builder.mesh(ball.vertices, ball.faces, normals=ball.vertices), name="ball")
    scene = builder.build()
    for kind in ("keep", "smooth"):
        for level in nf.lod.simplify(scene, [0.3, 0.1], method=method, normals=kind):
            arrays = parts(level.scene)
            assert np.linalg.norm(arrays["normals"], axis=1) == pytest.approx(1, abs=1e-5)
            assert np.abs(arrays["normals"] - arrays["positions"]).max() < 0.08
    assert all(parts(level.scene)["normals"] is None for level in nf.lod.simplify(scene, [0.1], normals="flat"))
    box = trimesh.creation.box().subdivide().subdivide().subdivide()
    assert parts(nf.lod.simplify(box, [0.2], method=method)[1].scene)["normals"] is None
    for level in nf.lod.simplify(box, [0.2, 0.05], method=method, normals="smooth"):
        arrays = parts(level.scene)
        corners = level.scene.triangles().astype(float)
        flat = smooth_normals.unit(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]))
        assert np.abs(arrays["normals"][arrays["faces"]] - flat[:, None]).max() < 1e-3
        assert level.error < 1e-5


def test_smooth_normals_keep_hard_edges() -> None:
    for shape, hard in ((trimesh.creation.box(), True), (trimesh.creation.icosphere(3), False)):
        positions = np.asarray(shape.vertices, np.float32)
        faces = np.asarray(shape.faces, np.uint32)
        corners, normals = smooth_normals.smooth_normals(positions, faces, np.arange(len(positions), dtype=np.uint32))
        found = normals[corners]
        assert np.allclose(np.linalg.norm(found, axis=2), 1, atol=1e-6)
        if hard:
            assert np.allclose(found, shape.face_normals[:, None], atol=1e-6)
        else:
            assert np.abs(found - positions[faces]).max() < 0.02
            assert len(np.unique(corners)) == len(positions)


def test_corners_with_equal_attributes_share_a_vertex() -> None:
    corners = np.array([0, 0, 0, 0, 1, 1], np.uint32)
    values = np.array([[0.0], [5.0], [0.9], [5.5], [np.nan], [1.0]])
    assert quadrics.group_equal_corners(corners, values).tolist() == [0, 1, 0, 1, 4, 5]


@pytest.fixture(scope="module")
def spot(tmp_path_factory: pytest.TempPathFactory) -> nf.Scene:
    folder = tmp_path_factory.mktemp("spot")
    with zipfile.ZipFile(data("objects/spot/spot.zip")) as packed:
        packed.extractall(folder)
    mesh = trimesh.load(folder / "spot/spot_triangulated.obj", process=False)
    picture = Image.open(folder / "spot/spot_texture.png")
    mesh.visual = trimesh.visual.TextureVisuals(mesh.visual.uv, image=picture)
    return nf.Scene.from_trimesh(mesh)


def test_spot_keeps_her_spots(method: Any, spot: nf.Scene) -> None:
    levels = nf.lod.simplify(spot, [0.5, 0.1], method=method)
    for level, least in zip(levels[1:], (0.95, 0.8), strict=True):
        assert abs(level.triangle_count / (levels[0].triangle_count * level.ratio) - 1) < 0.02
        assert open_edges(level.scene) == open_edges(spot)
        assert likeness(spot, level.scene) > least


@pytest.fixture(scope="module")
def helmet() -> nf.Scene:
    return nf.Scene.load(data("objects/gltf/FlightHelmet/FlightHelmet.gltf"))


def test_the_helmet_keeps_its_materials(method: Any, helmet: nf.Scene) -> None:
    levels = nf.lod.simplify(helmet, [0.1], method=method)
    assert levels[1].scene.report.textures == helmet.report.textures
    assert set(parts(levels[1].scene)["materials"].tolist()) == set(parts(helmet)["materials"].tolist())
    assert abs(levels[1].triangle_count / levels[0].triangle_count - 0.1) < 0.005 or levels[1].note
    assert levels[1].error < 0.02 * levels.radius * 2
