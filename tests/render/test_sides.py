"""Silhouettes and luma of many views equal `render`'s pictures, to the byte, for every output."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar import _core
from nearfar._metrics.inputs import LUMA
from nearfar._scene.builder import SceneBuilder
from tests.support.lod_cases import ball, checkered, scene, smooth


def cameras(size: tuple[int, int], distance: float = 6.0) -> list[nf.Camera]:
    fov = nf.Fov.symmetric(40, size[0] / size[1])
    ways = [(0.3, 0.2, 1.0), (-1.0, 0.5, 0.1), (0.0, -1.0, 0.2)]
    return [
        nf.Camera.look_at(np.add((3, -2, 1), np.multiply(distance, way)), (3, -2, 1), fov=fov, size=size)
        for way in ways
    ]


def leaves() -> nf.Scene:
    """A ball with holes in its texture, a moved instance, and a moving one."""
    builder = SceneBuilder()
    vertices, faces = ball(12)
    texture = np.full((16, 16, 4), 200, np.uint8)
    texture[::2, ::3, 3] = 0
    material = builder.material((1, 1, 1, 1), texture, cutoff=0.5)
    mesh = builder.mesh(vertices, faces, material=material, uvs=vertices[:, :2])
    builder.instance(mesh, name="holes")
    moved = np.eye(4)
    moved[:3, 3] = 0.8, 0.1, 0.0
    builder.instance(builder.mesh(*ball(6)), moved, name="moved")
    return builder.build().with_dynamic("moved")


SCENES: dict[str, Callable[[], nf.Scene]] = {
    "plain": lambda: scene(12),
    "smooth": lambda: smooth(10),
    "textured": lambda: checkered(12),
    "holes and instances": leaves,
    "crowded": lambda: scene(120),
}


def near(shown: NDArray[np.bool_], reach: int) -> NDArray[np.bool_]:
    """Pixels within a square around a pixel that is set."""
    rows, columns = np.nonzero(shown)
    found = np.zeros(shown.shape, bool)
    for row, column in zip(rows, columns, strict=True):
        found[max(0, row - reach) : row + reach + 1, max(0, column - reach) : column + reach + 1] = True
    return found


@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("samples", [1, 2, 3, 4, 9, 70])
def test_silhouettes_and_luma_equal_render(name: str, samples: int) -> None:
    own, size, reach = SCENES[name](), (53, 37), 3
    views = cameras(size)
    frames = [nf.render(own, view, samples=samples, channels=("color", "range"), backend="cpu") for view in views]
    shown = np.isfinite([frame.require("range") for frame in frames])
    assert 0.05 < shown.mean() < 0.5
    looked = [view._core for view in views]
    np.testing.assert_array_equal(_core.silhouettes(own._core, looked), shown)
    luma = _core.luma_near(own._core, looked, shown, samples=samples, weights=LUMA, reach=reach)
    expected = np.stack([frame.to_image() for frame in frames]) @ np.array(LUMA)
    wanted = np.stack([near(one, reach) for one in shown])
    assert not wanted.all()
    # Sums of three products, whose last digit may differ.
    np.testing.assert_allclose(luma[wanted], expected[wanted], rtol=4e-16, atol=0)
    np.testing.assert_array_equal(luma[~wanted], 0)


def test_empty_lists_and_empty_pictures_are_accepted() -> None:
    own = scene(6)._core
    assert _core.silhouettes(own, []).size == 0
    nothing = np.zeros((3, 8, 8), bool)
    views = [view._core for view in cameras((8, 8))]
    luma = _core.luma_near(own, views, nothing, samples=4, weights=LUMA, reach=5)
    np.testing.assert_array_equal(luma, np.zeros((3, 8, 8)))


def test_pictures_of_several_sizes_are_refused() -> None:
    views = [cameras((8, 8))[0]._core, cameras((8, 9))[0]._core]
    with pytest.raises(ValueError, match=r"cameras: expected 8 × 8 pixels, got 8 × 9"):
        _core.silhouettes(scene(6)._core, views)
    with pytest.raises(ValueError, match=r"shown: expected 64 pixels"):
        _core.luma_near(scene(6)._core, views[:1], np.zeros((1, 8, 7), bool), samples=1, weights=LUMA, reach=1)
