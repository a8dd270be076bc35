"""Bundles with split large triangles: moved vertices show what bent rays show."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import glb
from nearfar.stream import _detail
from nearfar.stream._growth import Growth
from nearfar.stream._manifest import NEAR_SHARE
from tests.support import leveled_cases

CENTER = np.array([0.0, 1.7, 0.0])
RADII = (8.0, 12.0, 20.0)
PIXEL = math.radians(1.0 / 8.0)
SPLIT_PX = 2.0
SETTINGS: dict[str, Any] = {
    "center": CENTER, "radii": RADII, "face_size": 64, "samples": 1, "pixels_per_degree": math.radians(1.0) / PIXEL
}  # fmt: skip


def meshed(builder: nf.SceneBuilder, solid: trimesh.Trimesh) -> Any:
    return builder.mesh(np.asarray(solid.vertices, np.float32), np.asarray(solid.faces, np.uint32))


@pytest.fixture(scope="module")
def street() -> nf.Scene:
    """Ground of two triangles, a wall for each ring, and posts of one mesh, the last of which lies beyond the rings."""
    builder = nf.SceneBuilder()
    ground = trimesh.Trimesh([(-40, 0, -40), (40, 0, -40), (40, 0, 40), (-40, 0, 40)], [(0, 2, 1), (0, 3, 2)])
    walls = {f"wall {x:g}": trimesh.creation.box(bounds=[(x, 0, -20), (x + 1, 15, 20)]) for x in (5.0, 9.0, 14.0)}
    for name, solid in {"ground": ground, **walls}.items():
        builder.instance(meshed(builder, solid), name=name)
    post = trimesh.creation.box((0.02, 0.02, 0.02))
    mesh = meshed(builder, post)
    for number, z in enumerate((4.0, 6.0, 9.0, 30.0)):
        matrix = np.eye(4)
        matrix[:3, 3] = (-3.0, 1.0, z)
        builder.instance(mesh, matrix, name=f"post {number}")
    return builder.build()


def users(count: int, rng: np.random.Generator) -> NDArray[np.float64]:
    aims = rng.normal(size=(count, 3))
    return np.asarray(CENTER + Growth.reach * aims / np.linalg.norm(aims, axis=1, keepdims=True))


def greatest_error(bundle: nf.stream.Bundle, ring: int, *, seed: int = 0) -> float:
    """Pixels between the interpolated morph of corners and the morph of points, at stages of a ring's growth."""
    rng = np.random.default_rng(seed)
    triangles = np.asarray(bundle.at(ring).scene.triangles(), np.float64)
    if ring == 1:
        # Next to the axis there is no bound below full strength.
        rho = np.hypot(*np.moveaxis((triangles - CENTER)[..., [0, 2]], -1, 0))
        triangles = triangles[(rho > 2.6 * Growth.reach).all(axis=1)]
    weights = np.concatenate([rng.dirichlet(np.ones(3), 3), (1 - np.eye(3)) / 2, np.full((1, 3), 1 / 3)])
    points = np.einsum("wk,tkc->twc", weights, triangles).reshape(-1, 3)
    least = RADII[max(ring - 2, 0)]
    worst = 0.0
    for number, user in enumerate(users(6, rng)):
        radius = least + (RADII[ring - 1] - least) * rng.random()
        strength = rng.random() if ring == 1 and number else 1.0
        settings: dict[str, Any] = {"user": user, "center": CENTER, "kind": "cylinder", "strength": strength}
        corners, exact = (
            nf.morph(where, r1=NEAR_SHARE * radius, r2=radius, **settings) - user
            for where in (triangles.reshape(-1, 3), points)
        )
        mixed = np.einsum("wk,tkc->twc", weights, corners.reshape(triangles.shape)).reshape(-1, 3)
        angles = np.arctan2(np.linalg.norm(np.cross(mixed, exact), axis=1), (mixed * exact).sum(axis=1))
        worst = max(worst, float(angles.max()))
    return worst / PIXEL


@pytest.fixture(scope="module")
def bundles(street: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> tuple[nf.stream.Bundle, nf.stream.Bundle]:
    """Unsplit and split bundles."""
    folder = tmp_path_factory.mktemp("split")
    whole = nf.stream.export(street, folder / "whole", **SETTINGS)
    return whole, nf.stream.export(street, folder / "split", split_px=SPLIT_PX, **SETTINGS)


@pytest.mark.slow
@pytest.mark.parametrize("ring", [1, 2, 3])
def test_morphed_triangles_agree_with_morphed_points(
    bundles: tuple[nf.stream.Bundle, nf.stream.Bundle], ring: int
) -> None:
    whole, split = bundles
    assert greatest_error(whole, ring) > 5 * SPLIT_PX
    assert 0.02 * SPLIT_PX < greatest_error(split, ring) <= SPLIT_PX


def test_split_rings_keep_their_objects_and_shared_meshes(bundles: tuple[nf.stream.Bundle, nf.stream.Bundle]) -> None:
    whole, split = (bundle.summary() for bundle in bundles)
    for before, after in zip(whole[1:], split[1:], strict=True):
        assert after["objects"] == before["objects"]
        assert after["triangles"] > before["triangles"]
    area = [float(np.linalg.norm(_normals(bundle), axis=1).sum()) for bundle in bundles]
    assert area[1] == pytest.approx(area[0], rel=1e-3)
    # The posts are too small to be split: ring 1 places one mesh twice.
    assert [placements(bundle, 1) for bundle in bundles] == [[2], [2]]


def placements(bundle: nf.stream.Bundle, ring: int) -> list[int]:
    """Number of placements of each mesh that a ring's file places several times."""
    document = glb.header(bundle.read(bundle._region["rings"][ring]["geometry"]))[0]
    placed = [node["extensions"]["EXT_mesh_gpu_instancing"] for node in document["nodes"] if "extensions" in node]
    return [document["accessors"][next(iter(node["attributes"].values()))]["count"] for node in placed]


def _normals(bundle: nf.stream.Bundle) -> NDArray[np.float64]:
    a, b, c = np.moveaxis(np.asarray(bundle.at(3).scene.triangles(), np.float64), 1, 0)
    return np.asarray(np.cross(b - a, c - a))


@pytest.mark.parametrize(("ring", "radius"), [(1, 8.0), (2, 10.0), (3, 12.0), (3, 20.0)])
def test_vertex_pictures_are_within_the_error_of_bent_rays(
    bundles: tuple[nf.stream.Bundle, nf.stream.Bundle], ring: int, radius: float
) -> None:
    whole, split = bundles
    (user,) = users(1, np.random.default_rng(ring))
    assert displaced(split, ring, radius, user, method="exact") <= 0.25
    assert displaced(split, ring, radius, user, method="vertex", tolerance_px=np.inf) <= SPLIT_PX
    assert displaced(whole, ring, radius, user, method="vertex", tolerance_px=np.inf) > 2 * SPLIT_PX


def displaced(bundle: nf.stream.Bundle, ring: int, radius: float, user: NDArray[np.float64], **how: Any) -> float:
    """Greatest angle, in pixels of the client, between a picture's pixels and the same points by bent rays."""
    view = nf.Camera.look_at(user, np.add(user, (1.0, -0.2, 0.3)), fov=nf.Fov.symmetric(90, 16 / 9), size=(96, 54))
    frame = bundle.at(ring, radius).render(view, channels=("position", "face_id"), **how)
    near = frame.require("face_id") >= 0
    points = frame.require("position")[near].astype(np.float64)
    assert near.sum() > 1000
    settings: dict[str, Any] = {"user": user, "center": CENTER, "kind": "cylinder"}
    shown = nf.morph(points, r1=NEAR_SHARE * radius, r2=radius, **settings) - user
    rays = view.rays()[1][near]
    angles = np.arctan2(np.linalg.norm(np.cross(shown, rays), axis=1), (shown * rays).sum(axis=1))
    return float(angles.max()) / PIXEL


def test_levels_are_split_on_export(tmp_path: Path) -> None:
    model = leveled_cases.model_of((1, 0))
    place = np.diag([4.0, 4.0, 4.0, 1.0])
    place[:3, 3] = (9.0, 1.7, 0.0)
    scene = nf.lod.place([model], [0], place[None])
    split, whole = (
        sum(row["triangles"] for row in nf.stream.export(scene, tmp_path / "b", **SETTINGS, **more).summary())
        for more in (dict[str, Any](lod=[1], split_px=SPLIT_PX), dict[str, Any](lod=[1]))
    )
    assert whole == 20
    assert split > 10 * whole


def test_bytes_do_not_change(
    street: nf.Scene, bundles: tuple[nf.stream.Bundle, nf.stream.Bundle], tmp_path: Path
) -> None:
    again = nf.stream.export(street, tmp_path / "again", split_px=SPLIT_PX, **SETTINGS)
    assert again.files == bundles[1].files
    assert again.files != bundles[0].files


@pytest.mark.parametrize(
    ("changed", "named"),
    [
        ({"split_px": 1.0, "radii": (2.5, 9.0)}, "radii: expected a first radius of at least 2.874 m with split_px"),
        (
            {"split_px": 1.0, "center": [(0.0, 1.7, 0.0), (12.0, 1.7, 0.0)]},
            "radii: expected a first radius of at least 17.241 m with split_px",
        ),
    ],
)
def test_splits_without_a_bound_are_refused_before_work_begins(
    street: nf.Scene, tmp_path: Path, changed: dict[str, Any], named: str
) -> None:
    with pytest.raises(ValueError, match=f"^{named}"):
        nf.stream.export(street, tmp_path / "none", **{**SETTINGS, **changed})
    assert not (tmp_path / "none").exists()


def test_too_many_triangles_are_refused_before_allocation(
    street: nf.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(_detail, "MAX_ADDED_TRIANGLES", 500)
    with pytest.raises(ValueError, match=r"^split_px: too small for ring 1 .* more than 500 triangles to the rings"):
        nf.stream.export(street, tmp_path / "none", split_px=SPLIT_PX, **SETTINGS)
    assert not (tmp_path / "none").exists()


def test_the_manifest_records_the_split(bundles: tuple[nf.stream.Bundle, nf.stream.Bundle]) -> None:
    assert [bundle.split_px for bundle in bundles] == [None, SPLIT_PX]
    assert [bundle.pixels_per_degree for bundle in bundles] == pytest.approx([8.0, 8.0])
    assert ["split to 2 px" in repr(bundle) for bundle in bundles] == [False, True]
