"""Both eyes of the page's immersive mode, in emulated headsets, beside the pictures of `nearfar.render`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.srgb import to_srgb
from nearfar.view._server import Server
from tests.support import need
from tests.support.browser import started
from tests.support.headset import (
    HEADSETS,
    Captured,
    Quaternion,
    Vector,
    about,
    camera,
    capture,
    empty_hands,
    floor_under,
    folder_of,
    look,
    times,
    worn,
)

pytestmark = pytest.mark.slow

SIZE = (240, 240)
CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0, 63.0)
START: Vector = (3.4, 1.7, -2.3)
YAW = 0.6
HEADS: tuple[tuple[Vector, Quaternion], ...] = (
    ((0.0, 1.6, 0.0), (0.0, 0.0, 0.0, 1.0)),
    ((0.3, 1.35, -0.25), times(about((0, 1, 0), 2.0), about((1, 0, 0), -0.3))),
    ((-0.4, 1.8, 0.2), times(about((0, 1, 0), -1.3), about((0, 0, 1), 0.25))),
)
FIRST: Vector = (0.0, 1.6, 0.0)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("headset") / "bundle"
    scene = nf.datasets.city(blocks=3, detail=1)
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    return nf.stream.export(scene, folder, center=CENTER, radii=RADII, **settings)


@pytest.fixture(scope="module")
def server(bundle: nf.stream.Bundle) -> Iterator[str]:
    with Server(folder_of(bundle)) as running:
        yield running.url


@pytest.fixture(scope="module")
def chromium() -> Iterator[Any]:
    need("browser")
    need("web")
    with started() as program:
        yield program


def address(server: str, query: str) -> str:
    place = ",".join(map(str, START))
    return f"{server}?aa=0&{query}#p={place}&yaw={YAW}&pitch=-0.2"


def of_one_face(faces: Any) -> Any:
    """Pixels whose eight neighbours show the same face."""
    same = np.ones(faces.shape, bool)
    for rows in (-1, 0, 1):
        for columns in (-1, 0, 1):
            same &= np.roll(faces, (rows, columns), (0, 1)) == faces
    same[[0, -1]] = same[:, [0, -1]] = False
    return same


def expected(
    bundle: nf.stream.Bundle, picture: dict[str, Any], seen: nf.Camera
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """nearfar's picture in codes, and the pixels that are compared."""
    frame = bundle.at(**picture).render(seen, channels=("color", "face_id"))
    codes = to_srgb(np.clip(frame.require("color"), 0, 1)) * 255
    return np.asarray(codes, np.float64), of_one_face(frame.require("face_id"))


def share_alike(found: NDArray[np.uint8], codes: NDArray[np.float64], inner: NDArray[np.bool_]) -> float:
    off = np.abs(np.rint(codes) - found).max(axis=-1)
    return float((off[inner] <= 2).mean())


def eyes_of(head: tuple[Vector, Quaternion], kind: str) -> dict[str, nf.Camera]:
    floor = floor_under(START, YAW, FIRST)
    return {side: camera(floor, *head, side, HEADSETS[kind], SIZE) for side in ("left", "right")}


@pytest.mark.parametrize("kind", HEADSETS)
@pytest.mark.parametrize("ring", [2, 3])
def test_each_eye_is_shown_the_picture_of_its_own_position(
    chromium: Any, server: str, bundle: nf.stream.Bundle, kind: str, ring: int
) -> None:
    with worn(chromium, address(server, f"rings={ring}&strategy=clovrd"), kind, SIZE, ring) as page:
        empty_hands(page)
        for head in HEADS:
            look(page, *head)
            found: Captured = capture(page, f"shown.ring === {ring}")
            assert found.shown["grown"] == {"radius": RADII[ring - 1], "strength": 1}
            picture = {"ring": ring, "radius": RADII[ring - 1], "strength": 1.0}
            cameras = eyes_of(head, kind)
            for side, pixels in (("left", found.left), ("right", found.right)):
                codes, inner = expected(bundle, picture, cameras[side])
                assert inner.mean() > 0.4
                assert share_alike(pixels, codes, inner) >= 0.99
            # Shaders were told both eyes' positions from the centre, and no other one.
            places = np.array([np.subtract(cameras[side].position, CENTER) for side in ("left", "right")])
            assert found.eyes.shape == (2, 3)
            assert np.abs(found.eyes[np.argsort(found.eyes[:, 0])] - places[np.argsort(places[:, 0])]).max() < 1e-5
        assert page.printed == []
