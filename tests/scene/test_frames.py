"""Coordinates on the Earth's ellipsoid, compared with PROJ's."""

from __future__ import annotations

import numpy as np
import pyproj
import pytest
from numpy.typing import NDArray

from nearfar._scene.frames import earth_centred, earth_to_local, geodetic, local_to_earth

_TO_EARTH = pyproj.Transformer.from_crs("EPSG:4979", "EPSG:4978", always_xy=True)


def places() -> NDArray[np.float64]:
    """Longitudes and latitudes in radians and heights in metres, including poles, the equator and the date line."""
    random = np.random.default_rng(5)
    rows = random.uniform((-np.pi, -np.pi / 2, -11_000), (np.pi, np.pi / 2, 400_000), (1000, 3))
    corners = [(x, y, h) for x in (-np.pi, 0, np.pi) for y in (-np.pi / 2, 0, np.pi / 2) for h in (-5e6, 0, 3.6e7)]
    return np.concatenate([rows, np.array(corners)])


def test_earth_centred_coordinates_equal_proj() -> None:
    rows = places()
    expected = np.stack(_TO_EARTH.transform(*np.degrees(rows[:, :2]).T, rows[:, 2]), axis=-1)
    np.testing.assert_allclose(earth_centred(rows), expected, rtol=0, atol=1e-7)


def test_geodetic_coordinates_are_inverted() -> None:
    rows = places()
    back = geodetic(earth_centred(rows))
    np.testing.assert_allclose(back[:, 1:], rows[:, 1:], rtol=0, atol=1e-7)
    np.testing.assert_allclose(earth_centred(back), earth_centred(rows), rtol=0, atol=1e-7)


@pytest.mark.parametrize(
    "place", [(139.7671, 35.6812, 40.0), (-74.01, 40.7, 0.0), (0.0, 90.0, 5.0), (180.0, -30.0, 0.0)]
)
def test_a_local_frame_points_east_up_and_south(place: tuple[float, float, float]) -> None:
    longitude, latitude, height = np.radians(place[0]), np.radians(place[1]), place[2]
    forth, back = local_to_earth(longitude, latitude, height), earth_to_local(longitude, latitude, height)
    np.testing.assert_allclose(forth[:3, :3] @ forth[:3, :3].T, np.eye(3), atol=1e-15)
    assert np.linalg.det(forth[:3, :3]) == pytest.approx(1)
    np.testing.assert_allclose(back @ forth, np.eye(4), atol=1e-8)
    other = (longitude + 1e-3, latitude - 2e-4, height + 9)
    local = pyproj.Transformer.from_pipeline(
        "+proj=pipeline +step +proj=cart +ellps=WGS84 +step +proj=topocentric +ellps=WGS84 "
        f"+lon_0={place[0]} +lat_0={place[1]} +h_0={height}"
    )
    x, y, z = (back @ [*earth_centred(np.array(other)), 1])[:3]
    np.testing.assert_allclose((x, -z, y), local.transform(*other, radians=True), rtol=0, atol=1e-6)
