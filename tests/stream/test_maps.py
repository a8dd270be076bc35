"""Maps of rings: each shows the objects of later rings, and is traced only where it differs from the previous one."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._render.bake import bake

CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0, 63.0)
SIZE = 48


def ranges(env: nf.EnvMap) -> NDArray[Any]:
    assert env.range is not None
    return env.range


@pytest.fixture(scope="module")
def rings() -> nf.stream.Rings:
    return nf.stream.assign(nf.datasets.city(blocks=3, detail=1), center=CENTER, radii=RADII)


@pytest.mark.parametrize("samples", [1, 4])
def test_each_map_shows_the_objects_of_later_rings(rings: nf.stream.Rings, samples: int) -> None:
    maps = nf.stream.bake_maps(rings, face_size=SIZE, samples=samples, object_id=True)
    for ring in range(rings.count + 1):
        later = [name for number in range(ring + 1, rings.count + 2) for name in rings.objects(number)]
        settings: dict[str, Any] = {"size": SIZE, "samples": samples, "half": False, "device": None}
        whole, _ = bake(rings.scene.subset(objects=later), CENTER, 0.0, channels=("range", "object_id"), **settings)
        found = maps.map(ring)
        np.testing.assert_array_equal(found.range, whole.range)
        np.testing.assert_array_equal(found.object_id, whole.object_id)
        # Equal up to rounding: textures of parts may lie elsewhere, but their texels are the same.
        np.testing.assert_allclose(found.color, whole.color, atol=2e-6)
        assert found.center == CENTER


def test_only_texels_that_change_are_traced_again(rings: nf.stream.Rings) -> None:
    maps = nf.stream.bake_maps(rings, face_size=SIZE, samples=1)
    before = maps.map(0)
    for ring in range(1, rings.count + 1):
        after = maps.map(ring)
        differs = np.ravel(ranges(after) != ranges(before))
        texels = maps.changes[ring - 1]["texels"]
        assert set(np.flatnonzero(differs)) == set(texels.tolist()), "ranges grow where an object leaves"
        assert (ranges(after) >= ranges(before)).all()
        before = after
    changed = sum(len(change["texels"]) for change in maps.changes)
    assert maps.rays == 6 * SIZE**2 + changed < 3 * 6 * SIZE**2


def test_changed_tiles_contain_all_changed_texels(rings: nf.stream.Rings) -> None:
    maps = nf.stream.bake_maps(rings, face_size=100)
    for ring in range(1, rings.count + 1):
        tiles = maps.changed_tiles(ring)
        assert tiles.shape == (6, 2, 2)
        changed = np.zeros(6 * 100 * 100, bool)
        changed[maps.changes[ring - 1]["texels"]] = True
        faces = changed.reshape(6, 100, 100)
        expected = [
            [[faces[f, 64 * y : 64 * y + 64, 64 * x : 64 * x + 64].any() for x in (0, 1)] for y in (0, 1)]
            for f in range(6)
        ]
        np.testing.assert_array_equal(tiles, expected)


def test_a_ring_without_objects_changes_nothing() -> None:
    corners = np.array([[-5, -5, -80], [5, -5, -80], [5, 5, -80]], np.float32)
    far = nf.Scene.from_arrays(corners, [[0, 1, 2]], face_object=[0])
    rings = nf.stream.assign(far, center=(0, 0, 0), radii=(10.0, 20.0, 100.0))
    maps = nf.stream.bake_maps(rings, face_size=16)
    assert [len(change["texels"]) for change in maps.changes[:2]] == [0, 0]
    assert len(maps.changes[2]["texels"]) > 0
    assert np.isinf(ranges(maps.map(3))).all()
    np.testing.assert_array_equal(maps.map(2).color, maps.map(0).color)
