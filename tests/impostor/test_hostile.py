"""Impostors of odd scenes and from odd places, and what is left behind when a bake or a save ends early."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
import pytest

import nearfar as nf
from benchmarks.impostor.bound import errors
from benchmarks.impostor.texels import Texels
from nearfar import _core
from nearfar._base import files
from tests.support.impostor_cases import CENTER, SETTINGS, bake, view, yard
from tests.support.reduce_cases import box

COARSE: dict[str, Any] = {"reach": 2.0, "r2": 12.0, "face_size": 64, "centers": 3}
FAR_AWAY = (4_000_000.0, 1000.0, -4_500_000.0)
SAMPLE_ERROR_PX = 0.23
"""Error beside silhouettes for any bound: samples lie on a plane up to 5·10⁻⁴ of its inverse depth. The place is off by
as much of its distance, which a user 4 m from the layer's centre sees from 10 m at an angle of at most 2·10⁻⁴."""
UNIT_BOX = box((-1.0, -1.0, -1.0), (1.0, 1.0, 1.0))


def room() -> nf.Scene:
    """A closed room whose walls are beyond r₂: no sky."""
    corners, faces = UNIT_BOX
    return nf.Scene.from_arrays(corners * [30.0, 20.0, 40.0], faces)


def sealed() -> nf.Scene:
    """A far wall outside a closed near room: nothing far is seen."""
    corners, faces = UNIT_BOX
    wall = np.array([[-20, -20, -60], [20, -20, -60], [20, 20, -60], [-20, 20, -60]], float)
    vertices = np.concatenate([corners * 8.0, wall])
    return nf.Scene.from_arrays(vertices, np.concatenate([faces, np.array([[0, 1, 2], [0, 2, 3]]) + len(corners)]))


def foliage() -> nf.Scene:
    """Cards with round holes before a wall."""
    build = nf.SceneBuilder()
    y, x = np.mgrid[:32, :32]
    leaf = np.full((32, 32, 4), (40, 160, 60, 255), np.uint8)
    leaf[np.hypot(x % 16 - 7.5, y % 16 - 7.5) < 5.0, 3] = 0
    material = build.material(texture=leaf, cutoff=0.5)
    uvs = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], float)
    for number in range(4):
        card = np.add([[-9, -6, 0], [9, -6, 0], [9, 6, 0], [-9, 6, 0]], (3.0 * number - 5.0, 0.0, -18.0 - 3.0 * number))
        build.instance(build.mesh(card, [[0, 1, 2], [0, 2, 3]], material=material, uvs=uvs), name=f"card_{number}")
    wall = np.array([[-60, -40, -50], [60, -40, -50], [60, 40, -50], [-60, 40, -50]], float)
    build.instance(build.mesh(wall, [[0, 1, 2], [0, 2, 3]], material=build.material((0.9, 0.4, 0.1, 1.0))), name="wall")
    return build.build()


def mirrored() -> nf.Scene:
    """Instances of one box, half of them with a mirroring transform."""
    build = nf.SceneBuilder()
    mesh = build.mesh(*box((0.0, -2.0, 0.0), (4.0, 5.0, 6.0)))
    for number in range(8):
        place = np.diag([(-1.0) ** number, 1.0, 1.0, 1.0])
        place[:3, 3] = 25.0 * np.cos(0.8 * number), 0.0, 25.0 * np.sin(0.8 * number)
        build.instance(mesh, place, name=f"box_{number}")
    return build.build()


def broken() -> nf.Scene:
    """A wall, the same wall again in the same place, triangles without area, and a needle 2 km long."""
    wall = np.array([[-20, -9, -30], [20, -9, -30], [20, 9, -30], [-20, 9, -30]], float)
    flat = np.array([[-5, 0, -20], [-5, 0, -20], [-5, 0, -20], [0, 0, -25], [1, 1, -25], [2, 2, -25]], float)
    needle = np.array([[15, 0, -20], [2000, 0, -20], [15, 1e-6, -20]], float)
    faces = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7], [8, 9, 10], [11, 12, 13], [14, 15, 16], [8, 8, 0]]
    return nf.Scene.from_arrays(np.concatenate([wall, wall, flat, needle]), faces)


CASES: dict[str, tuple[Callable[[], nf.Scene], dict[str, Any]]] = {
    "no sky": (room, {}),
    "nothing seen": (sealed, {}),
    "foliage": (foliage, {}),
    "mirrored": (mirrored, {}),
    "broken triangles": (broken, {}),
    "centre in a wall": (yard, {"center": (7.1, 1.5, -5.0)}),
    "below the ground": (yard, {"center": (3.0, -1.0, -2.0)}),
    "far above": (yard, {"center": (3.0, 500.0, -2.0)}),
    "odd face": (yard, {"center": CENTER, "face_size": 67}),
    "tiny reach": (yard, {"center": CENTER, "reach": 0.001}),
    "least reach and radius": (yard, {"center": CENTER, "reach": 1e-30, "r2": 2e-30}),
    "reach almost r2": (yard, {"center": CENTER, "reach": 11.999}),
    "huge error": (yard, {"center": CENTER, "error_px": 100.0}),
    "no error": (yard, {"center": CENTER, "error_px": 1e-9}),
}


@pytest.mark.parametrize("name", CASES)
def test_odd_scenes_keep_the_bound_and_have_no_nan(name: str, tmp_path: Path) -> None:
    make, changes = CASES[name]
    scene, options = make(), {"center": (0.0, 0.0, 0.0), **COARSE, **changes}
    baked = bake(scene, **options)
    quads, path = baked._quads, tmp_path / "far.glb"
    if quads is None:
        assert name == "nothing seen"
    else:
        assert np.isfinite(quads.vertices).all()
        assert ((quads.uvs >= 0.0) & (quads.uvs <= 1.0)).all()
        corners = quads.vertices[quads.faces].astype(np.float64)
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        assert (np.linalg.norm(normals, axis=1) > 0.0).all()
        assert (quads.texels > 0).all()
        baked.save_glb(path, part="far", textures="png")
        found = errors(Texels(scene, baked), path, count=2 * 10**4, users=2)
        # Positions are float32, which a bound near 0 does not allow for.
        plane, limit = found.plane[~found.is_grown], baked.settings.error_px * (1.0 + 1e-4) + 1e-3
        assert plane.max(initial=0.0) <= max(limit, SAMPLE_ERROR_PX)
        assert (plane > limit).sum() <= 0.001 * len(plane)
        assert (~found.is_grown).mean() > 0.3
    reach = options["reach"]
    for side in ((0.0, 0.0, 0.0), (0.0, 0.99, 0.0), (0.7, 0.1, -0.7), (0.0, 3.0, 0.0)):
        camera = view(np.add(options["center"], reach * np.array(side)), 0.4, (64, 36))
        truth, frame = (nf.render(shown, camera, channels=("color", "range")) for shown in (scene, baked))
        assert np.isfinite(frame.require("color")).all()
        assert not np.isnan(frame.require("range")).any()
        if name == "nothing seen":
            np.testing.assert_array_equal(frame.require("range"), truth.require("range"))


@pytest.mark.parametrize("name", ["foliage", "mirrored", "broken triangles"])
def test_odd_scenes_look_like_the_truth(name: str) -> None:
    scene = CASES[name][0]()
    baked = bake(scene, center=(0.0, 0.0, 0.0), **{**COARSE, "face_size": 256})
    camera = view(np.array([1.2, 0.4, -0.9]), 0.2)
    truth, frame = (nf.render(shown, camera, samples=4, channels=("color",)) for shown in (scene, baked))
    color = truth.require("color")
    blank = np.broadcast_to(color.mean(axis=(0, 1)), color.shape)
    assert nf.psnr(truth, frame) > max(27.0, 6.0 + nf.psnr(color, blank, data_range=1.0))


def test_millimetres_are_kept_6000_km_from_the_origin(tmp_path: Path) -> None:
    corners, faces = UNIT_BOX
    size, center = np.array([30.0, 20.0, 40.0]), np.add(FAR_AWAY, (0.123, 1.7, -0.456))
    scene = nf.Scene.from_arrays(corners * size + FAR_AWAY, faces)
    baked = bake(scene, center=center, **COARSE, error_px=1e-3)
    assert baked.far is not None
    baked.save_glb(tmp_path / "far.glb", part="far")
    file = nf.Scene.load(tmp_path / "far.glb")
    for shown, offset in ((baked.far, np.subtract(0.0, FAR_AWAY)), (file, np.subtract(center, FAR_AWAY))):
        points = shown.triangles().reshape(-1, 3) + (shown.origin + offset)
        # Every corner of a quad lies on the plane of a wall, at most a texel past its end.
        assert np.abs(np.abs(points) - size).min(axis=1).max() < 1e-3


@pytest.mark.parametrize("action", [KeyboardInterrupt, LookupError])
def test_a_bake_ends_at_once_when_it_is_interrupted(scene: nf.Scene, action: type[BaseException]) -> None:
    calls = []

    def report(done: int, total: int) -> None:
        calls.append((done, total))
        raise action("enough")

    place = {"center": CENTER, "reach": 2.0, "r2": 12.0, "height": 0.5}
    options = {**place, "size": 256, "angle": 0.002, "centers": 16, "missing": 0.0}
    with pytest.raises(action, match="enough"):
        _core.bake_impostors(scene._core, options, report=report)
    assert len(calls) == 1
    # The scene is as it was, and bakes again.
    assert nf.reduce(scene, far="impostors", center=CENTER, **COARSE).triangle_count > 0


def test_a_full_disk_leaves_the_older_file(
    impostors: nf.Impostors, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "far.glb"
    path.write_bytes(b"older")

    def write_half(aside: Path, data: bytes) -> NoReturn:
        aside.write_bytes(data[: len(data) // 2])
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(files, "write", write_half)
    with pytest.raises(OSError, match="No space left"):
        impostors.save_glb(path, part="far")
    assert [entry.name for entry in tmp_path.iterdir()] == ["far.glb"]
    assert path.read_bytes() == b"older"


def test_radii_that_leave_no_region_or_no_far_part_say_so(scene: nf.Scene) -> None:
    with pytest.raises(ValueError, match="reach: expected less than r2 = 12 m, got 12"):
        nf.reduce(scene, far="impostors", **{**SETTINGS, "reach": 12.0})
    beyond = nf.reduce(scene, far="impostors", **{**SETTINGS, "r2": 1e6})
    assert beyond.far is None
    assert "no static triangle beyond 1e+06 m is seen" in repr(beyond)
