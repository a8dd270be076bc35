"""Bundles: their content equals the reduction, and they are written completely or not at all."""

from __future__ import annotations

import functools
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar._reduce.drawing import Method
from tests.support import valid
from tests.support.bundle_cases import content

CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0, 63.0)
SIZE = 128
VIEW = nf.Camera.look_at((3.6, 1.5, -1.4), (30, 3, -20), fov=nf.Fov.symmetric(90, 1.6), size=(160, 100))
SETTINGS: dict[str, Any] = {
    "center": CENTER,
    "radii": RADII,
    "face_size": SIZE,
    "samples": 1,
    "quality": None,
    "step": 2.0**-14,
}


@pytest.fixture(scope="module")
def folder(city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("bundles") / "city"
    nf.stream.export(city, path, **SETTINGS)
    return path


@pytest.fixture(scope="module")
def bundle(folder: Path) -> nf.stream.Bundle:
    return nf.stream.open(folder)


@functools.cache
def reduced(city: nf.Scene, ring: int, **changes: Any) -> nf.ReducedScene:
    """The same state without files: whole objects within the ring's radius in front of the map of the others."""
    radius = RADII[max(ring, 1) - 1]
    given = {"center": CENTER, "r1": 0.7 * radius, "r2": radius, "unit": "object", "morph": "cylinder", **changes}
    return nf.reduce(city, channels=("color", "range"), face_size=SIZE, samples=1, **given)


@pytest.mark.parametrize(
    ("ring", "radius", "method"),
    [
        *((1, 0.0, "vertex"), (1, 6.0, "exact"), (1, 10.0, "vertex"), (2, 10.0, "exact")),
        *((2, 22.0, "vertex"), (3, 40.0, "vertex"), (3, 63.0, "exact")),
    ],
)
def test_a_client_shows_the_reduction(
    city: nf.Scene, bundle: nf.stream.Bundle, ring: int, radius: float, method: Method
) -> None:
    channels = ("color", "range")
    shown = bundle.at(ring, radius).render(VIEW, channels=channels, samples=1, method=method)
    expected = reduced(city, ring).render(VIEW, radius=radius, channels=channels, samples=1, method=method)
    # Lossless colour, so that pixels differ only where the rounded range decides which surface is in front.
    differs = np.abs(shown.to_image().astype(int) - expected.to_image()).max(axis=-1) > 1
    assert differs.mean() < 1e-3
    # Twice the error of stored ranges; moved vertices depend on how triangles are split, which rounding changes.
    limit = 2.0**-10 if method == "exact" else 2.0**-9
    alike = np.isclose(shown.require("range"), expected.require("range"), rtol=limit)
    assert alike.mean() > 0.999


def test_ring_0_is_the_map_of_everything(city: nf.Scene, bundle: nf.stream.Bundle) -> None:
    first = bundle.at(0)
    frame = first.render(VIEW, samples=1)
    # Without a radius of the morph everything is shown from the centre.
    moved = nf.Camera(CENTER, VIEW.orientation, fov=VIEW.fov, size=VIEW.size)
    still = city.subset(objects=[name for name in city.object_names if name not in city.poses])
    truth = nf.render(still, moved, samples=16)
    assert nf.psnr(truth, nf.render(first, moved)) > 20.0
    assert (frame.require("color") == nf.render(first, VIEW, samples=1).require("color")).all()
    assert bundle.map(0).range is None
    assert bundle.map(1).range is not None


def test_maps_equal_the_bake(city: nf.Scene, bundle: nf.stream.Bundle) -> None:
    maps = nf.stream.bake_maps(nf.stream.assign(city, center=CENTER, radii=RADII), face_size=SIZE, samples=1)
    for ring in range(4):
        found, baked = bundle.map(ring), maps.map(ring)
        assert np.abs(found.color - baked.color).max() < 0.5 / 255 * 2.3  # Half a step of sRGB at its steepest.
        if ring:
            assert found.range is not None
            assert baked.range is not None
            np.testing.assert_allclose(found.range, baked.range, rtol=2.0**-10.9)


def test_moving_objects_can_be_posed(city: nf.Scene, bundle: nf.stream.Bundle) -> None:
    name = next(iter(city.poses))
    assert set(bundle.at(2).poses) >= set(city.poses)
    pose = np.eye(4)
    pose[:3, 3] = (8.0, 0.5, -6.0)
    shown = bundle.at(2).at({name: pose}).render(VIEW, samples=1)
    expected = reduced(city, 2).at({name: pose}).render(VIEW, samples=1)
    assert (np.abs(shown.to_image().astype(int) - expected.to_image()).max(axis=-1) > 1).mean() < 1e-3
    assert np.any(shown.color != bundle.at(2).render(VIEW, samples=1).color)


def test_bytes_do_not_depend_on_the_run(city: nf.Scene, folder: Path, tmp_path: Path) -> None:
    nf.stream.export(city, tmp_path / "again", **SETTINGS)
    assert content(tmp_path / "again") == content(folder)


def test_the_manifest_lists_every_file(folder: Path, bundle: nf.stream.Bundle) -> None:
    manifest = json.loads((folder / "manifest.json").read_text())
    assert valid(manifest, "bundle")
    assert set(manifest["files"]) == {f"files/{path.name}" for path in (folder / "files").iterdir()}
    assert bundle.nbytes == sum(path.stat().st_size for path in (folder / "files").iterdir())
    rows = bundle.summary()
    dynamic = manifest["files"][manifest["dynamic"]["geometry"]]["bytes"]
    assert [row["dynamic"] for row in rows] == [dynamic, 0, 0, 0], "all pictures show what moves"
    kinds = ("dynamic", "geometry", "color", "range")
    assert sum(row[kind] for row in rows for kind in kinds) == bundle.nbytes
    assert rows[0]["geometry"] == rows[0]["range"] == 0
    assert f"{manifest['dynamic']['triangles']:,} triangles, {dynamic:,} bytes" in bundle._repr_html_()
    bundle.verify()


def test_a_scene_far_from_the_origin_has_the_same_pictures(tmp_path: Path) -> None:
    # Beyond 32,768 m the scene has a separate origin.
    place = np.array([500_000.0, 20.0, -300_000.0])
    trees = nf.datasets.forest(trees=60, detail=0)
    arrays = trees.triangles().reshape(-1, 3).astype(np.float64)
    faces = np.arange(len(arrays), dtype=np.uint32).reshape(-1, 3)
    near, far = nf.Scene.from_arrays(arrays, faces), nf.Scene.from_arrays(arrays + place, faces)
    assert far.origin.any()
    frames: list[Any] = []
    for scene, offset in ((near, np.zeros(3)), (far, place)):
        path = tmp_path / str(len(frames))
        center = np.add((0.0, 1.7, 0.0), offset)
        bundle = nf.stream.export(scene, path, **{**SETTINGS, "center": center, "radii": [30.0], "face_size": 64})
        view = nf.Camera.look_at(
            np.add(center, (0.5, 0, 0.2)), np.add(center, (9, 1, -9)), fov=VIEW.fov, size=VIEW.size
        )
        frames.append(nf.stream.open(path).at(1).render(view, samples=1).to_image().astype(int))
        assert bundle.radii == (30.0,)
    # Positions relative to other origins round differently by millimetres.
    assert (np.abs(frames[0] - frames[1]).max(axis=-1) > 8).mean() < 0.02


def test_scenes_without_moving_or_near_objects_are_bundles(tmp_path: Path) -> None:
    wall = nf.Scene.from_arrays([[-20, -20, -80], [20, -20, -80], [20, 20, -80]], [[0, 1, 2]])
    given = {**SETTINGS, "center": (0, 0, 0), "radii": [10.0, 20.0, 100.0], "face_size": 128}
    bundle = nf.stream.export(wall, tmp_path / "wall", **given)
    view = nf.Camera.look_at((0, 0, 0), (0, 0, -1), fov=nf.Fov.symmetric(40, 1), size=(32, 32))
    first, *others = (bundle.at(ring).render(view, samples=1).require("color") for ring in range(4))
    for other in others:
        assert (np.abs(other - first).max(axis=-1) > 0.01).mean() < 0.1
    assert np.ptp(first) > 0.1
    assert [row["triangles"] for row in bundle.summary()] == [0, 0, 0, 1]


def test_plain_geometry_is_loaded_by_other_readers(city: nf.Scene, folder: Path, tmp_path: Path) -> None:
    plain = nf.stream.export(city, tmp_path / "plain", **SETTINGS, compression=None)
    packed = nf.stream.open(folder)
    for ring in range(1, 4):
        sizes = [bundle.summary()[ring]["geometry"] for bundle in (plain, packed)]
        # For a few triangles the descriptions of extensions are larger than what they save.
        assert sizes[1] < sizes[0] or plain.summary()[ring]["triangles"] < 200
        pictures = [bundle.at(ring).render(VIEW, samples=1).to_image().astype(int) for bundle in (plain, packed)]
        assert (np.abs(pictures[0] - pictures[1]).max(axis=-1) > 1).mean() < 1e-3
    manifest = json.loads((tmp_path / "plain" / "manifest.json").read_text())
    for ring, row in zip(manifest["regions"][0]["rings"][1:], plain.summary()[1:], strict=True):
        loaded = trimesh.load_scene(tmp_path / "plain" / ring["geometry"])
        assert sum(len(mesh.faces) for mesh in loaded.dump()) == row["triangles"]
        assert ring["error"] <= 2.0**-10  # float32 of coordinates up to 16 km.


def test_a_bundle_says_what_its_files_approximate(bundle: nf.stream.Bundle, city: nf.Scene, tmp_path: Path) -> None:
    assert bundle.losses[0] == "colours are 8-bit sRGB"
    assert bundle.losses[1] == "ranges of maps have a relative error of at most 0.00049"
    assert bundle.losses[2].startswith("positions are rounded by at most ")
    lossy = nf.stream.ExportSettings(face_size=64, samples=1, pixels_per_degree=None)
    other = nf.stream.export(city, tmp_path / "b", center=CENTER, radii=RADII, settings=lossy)
    assert other.losses[0] == "colours are lossy WebP images"
    assert len(other.losses) == 3
