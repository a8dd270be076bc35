"""Textures and levels in a bundle are as fine as visible to users, and no finer."""

from __future__ import annotations

import io
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar import _core
from nearfar._base import glb
from nearfar._scene.srgb import to_linear, to_srgb
from nearfar.stream._detail import Detail, least_distances
from tests.support import leveled_cases

CENTER = (0.0, 1.7, 0.0)
SETTINGS: dict[str, Any] = {"center": CENTER, "radii": (10.0, 40.0), "face_size": 64, "samples": 1}
TEXELS = 256
"""Texels along a side of the panels' texture; panels are 4 m wide."""


def noise(side: int = TEXELS, *, seed: int = 3) -> NDArray[np.uint8]:
    """A picture with detail of all sizes, opaque."""
    rng, total = np.random.default_rng(seed), np.zeros((side, side, 3))
    for level in range(int(math.log2(side)) + 1):
        coarse = rng.random((2**level, 2**level, 3))
        total += coarse.repeat(side >> level, axis=0).repeat(side >> level, axis=1)
    scaled = (255 * (total - total.min()) / np.ptp(total)).astype(np.uint8)
    return np.dstack([scaled, np.full((side, side), 255, np.uint8)])


def panel(builder: nf.SceneBuilder, name: str, material: int, at: tuple[float, float], scale: float = 1.0) -> None:
    """An upright square of 4 m that faces the centre from x, z."""
    corners = np.array([(-2, 0, 0), (2, 0, 0), (2, 4, 0), (-2, 4, 0)], np.float32)
    uvs = np.array([(0, 0), (1, 0), (1, 1), (0, 1)], np.float32)
    mesh = builder.mesh(corners, np.array([(0, 1, 2), (0, 2, 3)], np.uint32), material=material, uvs=uvs)
    matrix = np.diag([scale, scale, scale, 1.0])
    matrix[:3, 3] = (at[0], 0.0, at[1])
    builder.instance(mesh, matrix, name=name)


def gallery(*panels: tuple[str, tuple[float, float]], dynamic: tuple[str, ...] = ()) -> nf.Scene:
    """Panels of one texture on dark ground."""
    builder = nf.SceneBuilder()
    painted = builder.material((1, 1, 1, 1), texture=noise())
    ground = np.array([(-60, 0, -60), (60, 0, -60), (60, 0, 60), (-60, 0, 60)], np.float32)
    dark = builder.material((0.1, 0.1, 0.1, 1.0))
    faces = np.array([(0, 2, 1), (0, 3, 2)], np.uint32)
    builder.instance(builder.mesh(ground, faces, material=dark), name="ground")
    for name, at in panels:
        panel(builder, name, painted, at)
    return builder.build(dynamic=dynamic)


def sizes(bundle: nf.stream.Bundle, folder: Path) -> list[tuple[int, int]]:
    """Sizes of the textures that the bundle's GLBs refer to."""
    names = {image["uri"] for name in bundle.files if name.endswith(".glb") for image in images_of(folder / name)}
    return sorted(Image.open(io.BytesIO((folder / "files" / name).read_bytes())).size for name in names)


def images_of(path: Path) -> list[dict[str, Any]]:
    listed: list[dict[str, Any]] = glb.header(path.read_bytes())[0].get("images", [])
    return listed


def by_hand(distance: float, pixels_per_degree: float, *, reach: float = 1.0, first: float = 10.0) -> int:
    """Texels of a panel's side for its distance: halved while two texels are at most a pixel."""
    seen = (distance - reach) / (1 + reach / (0.3 * max(distance, first)))
    pixel = math.radians(1 / pixels_per_degree) * seen
    side = TEXELS
    while side > 1 and 4.0 / (side / 2) <= pixel:
        side //= 2
    return side


@pytest.mark.parametrize(
    ("distance", "pixels_per_degree"), [(3.0, 25.0), (9.5, 25.0), (30.0, 25.0), (30.0, 10.0), (39.0, 2.0), (0.5, 1.0)]
)
def test_a_texture_has_the_size_that_pixels_need(tmp_path: Path, distance: float, pixels_per_degree: float) -> None:
    scene = gallery(("panel", (0.0, -distance)))
    bundle = nf.stream.export(scene, tmp_path / "b", **SETTINGS, pixels_per_degree=pixels_per_degree)
    side = by_hand(distance, pixels_per_degree)
    assert sizes(bundle, tmp_path / "b") == [(side, side)]
    bundle.verify()
    assert bundle.at(2).triangle_count


def test_none_keeps_textures_at_full_size(tmp_path: Path) -> None:
    bundle = nf.stream.export(gallery(("far", (0, -30))), tmp_path / "b", **SETTINGS, pixels_per_degree=None)
    assert sizes(bundle, tmp_path / "b") == [(TEXELS, TEXELS)]


def test_the_nearest_object_of_all_regions_decides(tmp_path: Path) -> None:
    scene = gallery(("far", (0.0, -30.0)), ("farther", (3.0, -36.0)))
    centers = [CENTER, (0.0, 1.7, -10.0)]
    given = {**SETTINGS, "center": centers, "pixels_per_degree": 5.0}
    bundle = nf.stream.export(scene, tmp_path / "b", **given)
    # Users come half of the way to the other centre.
    assert sizes(bundle, tmp_path / "b") == [(by_hand(20.0, 5.0, reach=5.0),) * 2]
    assert by_hand(20.0, 5.0, reach=5.0) > by_hand(30.0, 5.0, reach=5.0)
    # On a grid of 8 m the centres stay, but users are up to 8/√2 m farther from them.
    spread = nf.stream.export(scene, tmp_path / "grid", **{**given, "center": [CENTER, (0, 1.7, -8)], "grid": 8.0})
    assert sizes(spread, tmp_path / "grid") == [(by_hand(22.0, 5.0, reach=4 + 8 / math.sqrt(2)),) * 2]


def test_moving_objects_keep_their_textures(tmp_path: Path) -> None:
    scene = gallery(("still", (0, -30)), ("mover", (5, -30)), dynamic=("mover",))
    bundle = nf.stream.export(scene, tmp_path / "b", **SETTINGS, pixels_per_degree=2.0)
    assert sizes(bundle, tmp_path / "b") == [(TEXELS, TEXELS)]


def test_objects_beyond_the_rings_need_no_texels(tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    materials = [builder.material((1, 1, 1, 1), texture=noise(seed=seed)) for seed in (1, 2)]
    panel(builder, "near", materials[0], (0, -3))
    panel(builder, "beyond", materials[1], (0, -50))
    scene = builder.build()
    rings = nf.stream.assign(scene, center=CENTER, radii=SETTINGS["radii"])
    assert Detail.from_options(None, None, 25.0, 1.0).halvings([rings]).tolist() == [0, 32]
    bundle = nf.stream.export(scene, tmp_path / "b", **SETTINGS)
    assert sizes(bundle, tmp_path / "b") == [(TEXELS, TEXELS)]


def test_densities_are_the_greatest_singular_values() -> None:
    scene = nf.datasets.room()
    distances = np.random.default_rng(1).uniform(0.5, 20, len(scene.object_names) + 1)
    found = _core.texels_per_radian(scene._core, distances)
    np.testing.assert_allclose(found, one_by_one(scene, distances), rtol=1e-9)
    assert np.isfinite(found).any()


def one_by_one(scene: nf.Scene, distances: NDArray[np.float64]) -> NDArray[np.float64]:
    """Least texels per radian of each texture, by the singular values of all faces in the scene."""
    parts = _core.scene_parts(scene._core)
    least = np.full(len(parts["textures"]), np.inf)
    for mesh, placement, own in zip(parts["meshes"], parts["placements"], parts["objects"], strict=True):
        arrays = _core.mesh_parts(mesh)
        if arrays["uvs"] is None:
            continue
        for face, material, object_ in zip(arrays["faces"], arrays["materials"], arrays["objects"], strict=True):
            texture = -1 if material < 0 else parts["material_textures"][material]
            if texture < 0:
                continue
            height, width = parts["textures"][texture].shape[:2]
            corners = arrays["positions"][face].astype(np.float64) @ placement[:, :3].T
            edges = (corners[1:] - corners[0]).T
            texels = ((arrays["uvs"][face[1:]].astype(np.float64) - arrays["uvs"][face[0]]) * (width, height)).T
            if np.linalg.matrix_rank(edges) < 2:
                continue
            # The pseudo-inverse maps points of the plane to multiples of the edges.
            density = np.linalg.svd(texels @ np.linalg.pinv(edges), compute_uv=False)[0]
            seen = density * distances[own if own >= 0 else object_]
            least[texture] = min(least[texture], seen)
    return least


@pytest.mark.parametrize("cutout", [False, True])
def test_halved_textures_are_means_of_squares_in_linear_light(cutout: bool) -> None:
    texels = np.random.default_rng(4).integers(0, 256, (24, 40, 4), np.uint8)
    texels[:8, :8, 3] = 0
    halved = _core.halved_texture(texels, times=3, cutout=cutout)
    weight = texels[..., 3] / 255 + 1 / 1024 if cutout else np.ones(texels.shape[:2])
    squares = (to_linear(texels[..., :3] / 255.0) * weight[..., None]).reshape(3, 8, 5, 8, 3).sum(axis=(1, 3))
    total = weight.reshape(3, 8, 5, 8).sum(axis=(1, 3))
    expected = to_srgb(squares / total[..., None]) * 255
    # Half a code, and the error of float32 sums, which is far below one.
    assert np.abs(halved[..., :3] - expected).max() < 0.51
    alpha = texels[..., 3].reshape(3, 8, 5, 8).mean(axis=(1, 3)) if cutout else np.full((3, 5), 255)
    assert np.abs(halved[..., 3] - alpha).max() < 0.51


def test_no_point_appears_larger_than_at_its_least_distance() -> None:
    rng, reach, radii = np.random.default_rng(5), 1.0, (10.0, 40.0)
    count = 20_000
    rho, turn = rng.uniform(2.0, 40.0, count), rng.uniform(0, 2 * np.pi, count)
    points = np.stack([rho * np.cos(turn), rng.uniform(-1, 5, count), rho * np.sin(turn)], axis=1)
    step = rng.normal(size=(count, 3))
    step *= 1e-5 / np.linalg.norm(step, axis=1, keepdims=True)
    seen = (rho - reach) / (1 + reach / (0.3 * np.maximum(rho, radii[0])))
    worst = 0.0
    for radius in np.linspace(*radii, 7):
        for _ in range(5):
            user = np.array(CENTER) + reach * np.append(unit(rng.normal(size=2)), 0)[[0, 2, 1]]
            shown = [
                unit(nf.morph(p, user=user, center=CENTER, r1=0.7 * radius, r2=radius, kind="cylinder") - user)
                for p in (points, points + step)
            ]
            angle = np.linalg.norm(shown[1] - shown[0], axis=1)
            worst = max(worst, (angle * seen / 1e-5).max())
    # Points are morphed from ρ = 7 m, where the blend of two unit directions is shorter than 1 by less than 3e-3.
    assert 0.8 < worst < 1.003


def unit(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.asarray(vectors / np.linalg.norm(vectors, axis=-1, keepdims=True))


def test_least_distances_of_all_kinds_of_objects() -> None:
    scene = gallery(("near", (0, -3)), ("far", (0, -30)), ("beyond", (0, -50)), ("mover", (9, 9)), dynamic=("mover",))
    rings = nf.stream.assign(scene, center=CENTER, radii=SETTINGS["radii"])
    found = dict(zip(scene.object_names, least_distances(rings, 1.0), strict=False))
    assert (found["ground"], found["mover"], found["beyond"]) == (0.0, 0.0, np.inf)
    assert found["near"] == pytest.approx(2.0 / (1 + 1 / 3.0), rel=1e-6)
    assert found["far"] == pytest.approx(29.0 / (1 + 1 / 9.0), rel=1e-6)
    assert least_distances(rings, 1.0)[-1] == np.inf


def test_pictures_hardly_change_and_bytes_fall(tmp_path: Path) -> None:
    """A client of 25 pixels a degree, as near as users come: reduced textures look like full ones, even of noise."""
    builder, painted, distance = nf.SceneBuilder(), noise(512), 30.0
    panel(builder, "panel", builder.material((1, 1, 1, 1), texture=painted), (0.0, -distance))
    scene = builder.build()
    whole, cut = (
        nf.stream.export(scene, tmp_path / name, **SETTINGS, quality=None, pixels_per_degree=value)
        for name, value in (("whole", None), ("cut", 25.0))
    )
    assert cut.nbytes < 0.3 * whole.nbytes
    degrees = 2 * math.degrees(math.atan(2.0 / (distance - 1)))
    size = round(25 * degrees)
    view = nf.Camera.look_at((0, 2, -1), (0, 2, -distance), fov=nf.Fov.symmetric(degrees), size=(size, size))
    # One sample uses the texture's own coarser level, and the reduced texture is such a level.
    for samples, least in ((1, 65.0), (16, 45.0)):
        pictures = [bundle.at(2, 10.0).render(view, samples=samples) for bundle in (whole, cut)]
        assert nf.psnr(*pictures) > least
        assert nf.ssim(*pictures) > 0.99


def balls(*distances: float) -> nf.Scene:
    """A model with levels of 1,280 to 20 triangles, placed ahead of the centre."""
    model = leveled_cases.model_of((3, 2, 1, 0), texture=leveled_cases.checkers())
    transforms = np.tile(np.eye(4), (len(distances), 1, 1))
    transforms[:, :3, 3] = [(0.0, 1.7, -distance) for distance in distances]
    return nf.lod.place([model], [0] * len(distances), transforms)


def test_objects_have_the_levels_of_the_nearest_user(tmp_path: Path) -> None:
    scene, distances = balls(1.5, 8.0, 16.0, 36.0), np.array([1.5, 8.0, 16.0, 36.0])
    leveled = leveled_cases.leveled(scene)
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(64, 64))
    ahead = [(0.0, 0.0, 1.0 - distance) for distance in distances]
    expected = nf.lod.select(leveled.models, leveled.model_index, ahead, leveled.radii, camera=camera, mode="depth")
    counts = np.array([1280, 320, 80, 20])
    assert expected.level[0] == 0
    assert expected.level[-1] > 0
    bundle = nf.stream.export(scene, tmp_path / "b", **SETTINGS, lod="depth")
    assert sum(row["triangles"] for row in bundle.summary()) == counts[expected.level].sum()
    whole = nf.stream.export(scene, tmp_path / "whole", **SETTINGS)
    assert sum(row["triangles"] for row in whole.summary()) == 4 * 1280
    assert bundle.map(0).color.tolist() == whole.map(0).color.tolist()


def test_levels_are_chosen_for_each_region(tmp_path: Path) -> None:
    scene = balls(20.0)
    centers = [CENTER, (0.0, 1.7, -18.9)]
    bundle = nf.stream.export(scene, tmp_path / "b", **{**SETTINGS, "center": centers}, lod=nf.lod.Selector())
    triangles = [sum(row["triangles"] for row in bundle.region(number).summary()) for number in range(2)]
    assert triangles[1] == 1280
    assert triangles[0] < 1280


def test_levels_can_be_specified(tmp_path: Path) -> None:
    scene = balls(5.0, 20.0)
    for lod in ([1, 3], lambda *objects, camera: np.array([1, 3]), {"ball0": 1, "ball1": 3}):
        if isinstance(lod, dict):
            lod = dict(zip(leveled_cases.leveled(scene).names, (1, 3), strict=True))
        bundle = nf.stream.export(scene, tmp_path / "b", **SETTINGS, lod=lod)
        assert sum(row["triangles"] for row in bundle.summary()) == 320 + 20


def test_moving_objects_stay_at_level_0(tmp_path: Path) -> None:
    scene = balls(20.0, 30.0)
    names = leveled_cases.leveled(scene).names
    scene = scene.with_dynamic([names[1]])
    bundle = nf.stream.export(scene, tmp_path / "b", **SETTINGS, lod=[3, 3])
    assert sum(row["triangles"] for row in bundle.summary()) == 20
    assert bundle.at(1).poses.keys() == {names[1]}
    document = bundle._manifest["dynamic"]
    assert document["triangles"] == 1280


def test_wrong_arguments_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="lod: expected a scene whose objects have levels"):
        nf.stream.export(gallery(), tmp_path / "b", **SETTINGS, lod="depth")
    with pytest.raises(ValueError, match="lod: mode: expected"):
        nf.stream.export(balls(5.0), tmp_path / "b", **SETTINGS, lod="sideways")
