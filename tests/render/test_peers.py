"""Tests of ground truth against pyrender, one picture of each real scene: depth, and unlit base colour."""

from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar._scene import serialize
from nearfar._scene.names import Names
from tests.support import data, need
from tests.support.render_oracle import irradiance, rotate

SIZE = (480, 360)


@dataclass
class Case:
    """A scene, a view of it, and pyrender's near and far plane, metres."""

    file: str
    eye: tuple[float, float, float]
    target: tuple[float, float, float]
    near: float
    far: float
    textured: bool = False


CASES = {
    "tokyo": Case("city/tokyo23/tokyo_core_lod1.glb", (300, 260, 700), (0, 30, 0), 100.0, 4000.0),
    "garage": Case("interior/garage/garage.gltf", (1.5, 1.6, 2.5), (-1, 1, -2), 0.1, 20.0),
    "helmet": Case(
        "objects/gltf/FlightHelmet/FlightHelmet.gltf", (0.3, 0.5, 0.9), (0, 0.35, 0), 0.1, 5.0, textured=True
    ),
}


@dataclass
class Pictures:
    """Pictures of one view: nearfar's, pyrender's, and the pixels where both show the interior of a triangle."""

    frame: nf.Frame
    depth: np.ndarray
    color: np.ndarray
    inside: np.ndarray
    textured: bool


@pytest.fixture(scope="module", params=[pytest.param("tokyo", marks=pytest.mark.slow), "garage", "helmet"])
def pictures(request: pytest.FixtureRequest) -> Pictures:
    need("pyrender")
    case = CASES[request.param]
    path = data(case.file)
    camera = nf.Camera.look_at(case.eye, case.target, fov=nf.Fov.symmetric(60, SIZE[0] / SIZE[1]), size=SIZE)
    frame = nf.render(flat(nf.Scene.load(path)), camera, channels=("color", "range", "face_id", "normal"))
    color, depth = rasterised(trimesh.load_scene(path, process=False), camera, case)
    return Pictures(frame, depth, color, inside_of_faces(frame.require("face_id")), case.textured)


def flat(scene: nf.Scene) -> nf.Scene:
    """The scene without vertex normals: colours are divided by the light on the normal in the channel `normal`."""
    parts = serialize.parts_of(scene._core)
    for mesh in parts["meshes"]:
        mesh["normals"] = None
    return nf.Scene(serialize.core_of_parts(parts), Names(scene.object_names))


def inside_of_faces(faces: np.ndarray) -> np.ndarray:
    """Pixels whose eight neighbours show the same triangle, so that a shift by half a pixel changes nothing."""
    same = np.zeros(faces.shape, bool)
    same[1:-1, 1:-1] = faces[1:-1, 1:-1] >= 0
    for dy in (-1, 0, 1):
        for dx in (-1, 0, 1):
            same &= np.roll(faces, (dy, dx), (0, 1)) == faces
    return same


def rasterised(source: Any, camera: nf.Camera, case: Case) -> tuple[np.ndarray, np.ndarray]:
    """Base colours (H, W, 3) uint8 as pyrender stores them, and depth along the viewing axis, 0 for nothing."""
    with warnings.catch_warnings(), pytest.MonkeyPatch.context() as patch:
        warnings.simplefilter("ignore")
        patch.setattr(np, "infty", np.inf, raising=False)  # pyrender 0.1.45 was written for NumPy 1.
        import pyrender
        from pyrender import renderer as internals

        # Multisampling stores the depth of a point other than the pixel's centre.
        storage = internals.glRenderbufferStorageMultisample
        patch.setattr(internals, "glRenderbufferStorageMultisample", lambda kind, _, *rest: storage(kind, 0, *rest))
        scene = pyrender.Scene(bg_color=(0.0, 0.0, 0.0, 0.0))
        for mesh in meshes(source, pyrender):
            scene.add(mesh)
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = rotate(camera.orientation, np.eye(3)).T, camera.position
        assert isinstance(camera.fov, nf.Fov)
        view = pyrender.PerspectiveCamera(2 * np.arctan(camera.fov.up), case.near, case.far, SIZE[0] / SIZE[1])
        scene.add(view, pose=pose)
        renderer = pyrender.OffscreenRenderer(*SIZE)
        try:
            flags = pyrender.RenderFlags.FLAT | pyrender.RenderFlags.SKIP_CULL_FACES
            color, depth = renderer.render(scene, flags)
        finally:
            renderer.delete()
    return np.asarray(color), np.asarray(depth)


def meshes(source: Any, pyrender: Any) -> list[Any]:
    """One mesh per geometry; a city without materials is merged into one, because thousands take a minute."""
    if len(source.geometry) > 1000:
        whole = source.to_mesh()
        corners = np.asarray(whole.vertices)[np.asarray(whole.faces)].reshape(-1, 3)
        white = pyrender.MetallicRoughnessMaterial(baseColorFactor=(0.8, 0.8, 0.8, 1.0))
        return [pyrender.Mesh([pyrender.Primitive(positions=corners.astype(np.float32), material=white)])]
    placed = []
    for node in source.graph.nodes_geometry:
        transform, name = source.graph[node]
        geometry = source.geometry[name].copy()
        geometry.apply_transform(transform)
        placed.append(pyrender.Mesh.from_trimesh(geometry, smooth=True))
    return placed


def test_depth_equals_pyrender(pictures: Pictures) -> None:
    frame, depth, inside = pictures.frame, pictures.depth, pictures.inside
    assert inside.mean() > 0.02
    axis = rotate(frame.camera.orientation, np.array([0.0, 0.0, -1.0]))
    ours = frame.require("range") * (frame.camera.rays()[1] @ axis)
    # A 24-bit depth buffer with far/near of 200 resolves 200 · 2⁻²⁴ of the distance at its far end; pyrender's matrices
    # in float32 add as much.
    np.testing.assert_allclose(ours[inside], depth[inside], rtol=3e-5)
    # If only one of both shows a surface, the pixel is at an edge.
    differs = (depth > 0) != np.isfinite(ours)
    assert differs.mean() < 1e-3


def test_base_colours_equal_pyrender(pictures: Pictures) -> None:
    frame, inside = pictures.frame, pictures.inside
    albedo = frame.require("color")[inside] / irradiance(frame.require("normal")[inside].astype(np.float64))
    theirs = pictures.color[inside] / 255.0
    if not pictures.textured:
        # Without lights pyrender stores factors unchanged: one rounding to 8 bits.
        np.testing.assert_allclose(albedo, theirs, atol=0.51 / 255)
        return
    # Textures keep their codes, but are filtered as codes, not as light, and at another level: a code in most pixels,
    # more at the texture's edges. The lenses are blended there, and opaque here by convention.
    codes = np.where(albedo <= 0.0031308, 12.92 * albedo, 1.055 * albedo ** (1 / 2.4) - 0.055)
    error = np.abs(codes - theirs)
    assert np.median(error) < 1 / 255
    assert np.percentile(error, 95) < 8 / 255
