"""Tests of ground truth against brute force in float64 and against known physics."""

from __future__ import annotations

import hashlib
import re
import subprocess
import sys

import numpy as np
import pytest

import nearfar as nf
from nearfar._render.channels import DRAWN
from tests.support import need, printed_by_threads, render_oracle as oracle
from tests.support.render_cases import PROJECTIONS, QUAD, WIDE, build, quad, room
from tests.support.render_oracle import Surface

CAMERAS = [
    nf.Camera((0.3, 0.1, 0.4), (0.05, -0.12, 0.02, np.sqrt(1 - 0.0173)), fov=fov, size=(41, 41)) for fov in PROJECTIONS
]


@pytest.mark.parametrize("camera", CAMERAS, ids=lambda camera: str(camera.fov))
def test_every_channel_agrees_with_brute_force(camera: nf.Camera) -> None:
    surfaces = room()
    frame = nf.render(build(surfaces), camera, channels=DRAWN)
    expected = oracle.cast(surfaces, oracle.view(camera))
    flat = {name: frame.require(name).reshape(41 * 41, *frame.require(name).shape[2:]) for name in DRAWN}
    np.testing.assert_array_equal(flat["object_id"], expected.object_id)
    np.testing.assert_array_equal(flat["face_id"], expected.face_id)
    # Coordinates of 10 m and distances along them are rounded by 5e-7; slanted surfaces amplify it a little.
    np.testing.assert_allclose(flat["range"], expected.range, rtol=2e-6)
    np.testing.assert_allclose(flat["position"], expected.position, atol=1e-5)
    np.testing.assert_allclose(flat["normal"], expected.normal, atol=2e-7)
    # Texture coordinates of 8 are rounded by 5e-7, times 64 texels, times a contrast of 1: 3e-5; levels by log2 of
    # float32 and by steps of 1/65535 add less.
    np.testing.assert_allclose(flat["color"], expected.color, atol=1e-4)


def test_colour_is_the_mean_of_its_samples_and_other_channels_are_unchanged() -> None:
    surfaces, camera = room(), nf.Camera((0, 0, 2), fov=WIDE, size=(30, 20))
    scene = build(surfaces)
    one, many = (nf.render(scene, camera, samples=samples, channels=DRAWN) for samples in (1, 8))
    for name in DRAWN[1:]:
        np.testing.assert_array_equal(one.require(name), many.require(name))
    # Hammersley: the second coordinate of each column is its index with the bits reversed.
    offsets = [((i + 0.5) / 8, (int(f"{i:03b}"[::-1], 2) + 0.5) / 8) for i in range(8)]
    colors = [oracle.cast(surfaces, oracle.view(camera, offset, 8)).color for offset in offsets]
    np.testing.assert_allclose(many.require("color").reshape(-1, 3), np.mean(colors, axis=0), atol=1e-4)
    only = nf.render(scene, camera, samples=8, channels=["color"])
    assert only.channels == ("color",)
    np.testing.assert_array_equal(only.require("color"), many.require("color"))


@pytest.mark.parametrize("channel", DRAWN)
def test_each_channel_alone_is_unchanged(channel: str) -> None:
    scene, camera = build(room()), nf.Camera((0, 0, 2), fov=WIDE, size=(33, 17))
    together, alone = nf.render(scene, camera, channels=DRAWN), nf.render(scene, camera, channels=[channel])
    assert alone.channels == (channel,)
    np.testing.assert_array_equal(alone.require(channel), together.require(channel))


@pytest.mark.parametrize("normal", [(0, 1, 0), (1, 0, 0), (0, 0, -1), (0.6, 0.0, 0.8), (-0.48, 0.6, 0.64)])
def test_a_white_plane_shows_the_light_that_falls_on_it(normal: tuple[float, float, float]) -> None:
    n = np.array(normal)
    side = np.cross(n, (0.2, 0.3, 0.9))
    side /= np.linalg.norm(side)
    plane = Surface(quad((0, 0, 0), 100 * side, 100 * np.cross(n, side)), QUAD, (1, 1, 1, 1))
    scene = build([plane])
    for side_of_viewer in (1.0, -1.0):
        camera = nf.Camera.look_at(3 * side_of_viewer * n, (0, 0, 0), up=side, fov=nf.Fov.symmetric(60), size=(9, 9))
        frame = nf.render(scene, camera, samples=4)
        light = oracle.irradiance(side_of_viewer * n[None])[0]
        assert (light < 1).all()
        # One normalisation, a product and a sum of four in float32.
        np.testing.assert_allclose(frame.require("color"), np.broadcast_to(light, (9, 9, 3)), atol=5e-7)
        # Corners 100 m away are rounded by 4e-6 along each axis.
        assert frame.require("range")[4, 4] == pytest.approx(3.0, abs=2e-5)


def test_a_distant_checkerboard_has_the_mean_light() -> None:
    # Black and white squares: half of the light, not half of the code (which would be 0.21 of it).
    board = np.kron([[0, 255], [255, 0]], np.ones((4, 4))).astype(np.uint8)
    texture = np.dstack([board, board, board, np.full((8, 8), 255, np.uint8)])
    uvs = 1000.0 * np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    plane = Surface(quad((0, 0, -50), (50, 0, 0), (0, 50, 0)), QUAD, (1, 1, 1, 1), None, uvs, texture)
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(60), size=(16, 16))
    color = nf.render(build([plane]), camera).require("color")
    light = oracle.irradiance(np.array([[0.0, 0.0, 1.0]]))[0]
    # The coarsest level contains the mean in steps of 1/65535.
    np.testing.assert_allclose(color, np.broadcast_to(0.5 * light, (16, 16, 3)), atol=1 / 65535)


def test_textures_are_the_right_way_up() -> None:
    texture = np.zeros((2, 2, 4), np.uint8)
    texture[0, 0] = (255, 0, 0, 255)
    texture[1, 1] = (0, 0, 255, 255)
    uvs = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    picture = Surface(quad((0, 0, -1), (1, 0, 0), (0, 1, 0)), QUAD, (1, 1, 1, 1), None, uvs, texture)
    # Four pixels, each on the centre of a texel.
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(2, 2))
    color = nf.render(build([picture]), camera).require("color")
    light = oracle.irradiance(np.array([[0.0, 0.0, 1.0]]))[0]
    expected = np.array([[light * (1, 0, 0), np.zeros(3)], [np.zeros(3), light * (0, 0, 1)]])
    # Neighbouring texels contribute by the rounding of the texture coordinate.
    np.testing.assert_allclose(color, expected, atol=1e-6)


def test_cut_out_holes_show_surfaces_behind() -> None:
    texture = np.full((4, 4, 4), 255, np.uint8)
    texture[:2, :, 3] = 0
    uvs = np.array([[0.0, 0], [1, 0], [1, 1], [0, 1]])
    behind = Surface(quad((0, 0, -2), (9, 0, 0), (0, 9, 0)), QUAD)
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(16, 16))
    for cutoff, rows in ((0.5, 8), (None, 16)):
        leaf = Surface(quad((0, 0, -1), (1, 0, 0), (0, 1, 0)), QUAD, (1, 1, 1, 1), cutoff, uvs, texture)
        ids = nf.render(build([leaf, behind]), camera, channels=["object_id"]).require("object_id")
        assert (ids[16 - rows :] == 0).all()
        assert (ids[: 16 - rows] == 1).all()
    faint = Surface(quad((0, 0, -1), (1, 0, 0), (0, 1, 0)), QUAD, (1, 1, 1, 0.3), 0.5)
    assert (nf.render(build([faint, behind]), camera).require("object_id") == 1).all()


def test_six_faces_make_one_picture() -> None:
    surfaces = room()
    scene, center = build(surfaces), (0.5, 0.25, -0.125)
    for face in range(6):
        camera = nf.Camera(center, fov=nf.CubeFace(face), size=(12, 12))
        frame = nf.render(scene, camera, channels=("range", "position"))
        reached = np.array(center) + frame.require("range")[..., None] * camera.rays()[1]
        # Distances of 10 m in float32.
        np.testing.assert_allclose(frame.require("position"), reached, atol=1e-5)


def test_misses_show_the_sky() -> None:
    scene = build([Surface(quad((0, 0, 5), (1, 0, 0), (0, 1, 0)), QUAD)])
    camera = nf.Camera((0, 0, 0), fov=WIDE, size=(9, 7))
    frame = nf.render(scene, camera, channels=DRAWN)
    expected = oracle.background(camera.rays()[1].reshape(-1, 3)).reshape(7, 9, 3)
    # Directions and colours below 1 in float32: five roundings of 6e-8.
    np.testing.assert_allclose(frame.require("color"), expected, atol=3e-7)
    assert np.isposinf(frame.require("range")).all()
    for name in ("object_id", "face_id"):
        assert (frame.require(name) == -1).all()
    for name in ("position", "normal"):
        assert np.isnan(frame.require(name)).all()


def test_an_empty_scene_shows_sky() -> None:
    scene = nf.Scene.from_arrays(np.empty((0, 3)), np.empty((0, 3), int))
    frame = nf.render(scene, nf.Camera((0, 0, 0), fov=WIDE, size=(3, 2)), samples=3, channels=DRAWN)
    assert np.isposinf(frame.require("range")).all()
    assert np.isfinite(frame.require("color")).all()


def test_far_from_the_origin_pictures_keep_their_precision() -> None:
    surfaces = room()
    near = nf.render(build(surfaces), nf.Camera((0, 0, 2), fov=WIDE, size=(24, 16)), channels=("range", "position"))
    offset = np.array([1e7, -2e6, 3e7])
    vertices = np.concatenate([surface.vertices for surface in surfaces]) + offset
    counts = np.cumsum([0, *(len(surface.vertices) for surface in surfaces)])
    faces = np.concatenate([surface.faces + first for surface, first in zip(surfaces, counts, strict=False)])
    owners = np.repeat(np.arange(len(surfaces)), [len(surface.faces) for surface in surfaces])
    scene = nf.Scene.from_arrays(vertices, faces, owners)
    eye = offset + np.array([0, 0, 2])
    frame = nf.render(
        scene, nf.Camera(tuple(eye), fov=WIDE, size=(24, 16)), channels=("range", "position", "object_id")
    )
    solid = frame.require("object_id") != 3  # The cut-out one is whole here.
    same = solid & (nf.render(build(surfaces), nf.Camera((0, 0, 2), fov=WIDE, size=(24, 16))).require("object_id") != 3)
    # The origin is in whole metres, so that local coordinates of 10 m lose only a float32 rounding.
    np.testing.assert_allclose(frame.require("range")[same], near.require("range")[same], rtol=3e-6)
    world = np.array(frame.origin) + frame.require("position")
    np.testing.assert_allclose(world[same] - offset, near.require("position")[same], atol=2e-5)


def test_a_camera_in_a_wall_or_outside_everything_works() -> None:
    scene = build(room())
    in_wall = nf.Camera((8.0, 0, 0), fov=WIDE, size=(32, 24))
    outside = nf.Camera.look_at((500, 400, 300), (0, 0, 0), fov=nf.Fov.symmetric(5), size=(32, 24))
    for camera in (in_wall, outside):
        frame = nf.render(scene, camera, samples=2, channels=DRAWN)
        assert np.isfinite(frame.require("color")).all()
        assert (frame.require("color") <= 1).all()
    assert nf.render(scene, outside).require("range").min() == pytest.approx(707 - 10, abs=10)


@pytest.mark.parametrize("far", [1.1e30, 1e39, 1e300])
def test_positions_beyond_float32_are_refused(far: float) -> None:
    scene = build(room())
    camera = nf.Camera((far, 0, 0), fov=WIDE, size=(4, 4))
    reduced = nf.reduce(scene, center=(0, 0, 0), r1=1, r2=2, face_size=4)
    with pytest.raises(ValueError, match="position: expected a place within 1e30 m"):
        nf.render(scene, camera)
    with pytest.raises(ValueError, match="position: expected a place within 1e30 m"):
        reduced.render(camera)
    with pytest.raises(ValueError, match="center: expected a place within 1e30 m"):
        nf.reduce(scene, center=(far, 0, 0), r1=1, r2=2, face_size=4)
    # At the greatest allowed distance only sky is visible.
    edge = nf.render(scene, nf.Camera((1e30, 0, 0), fov=WIDE, size=(4, 4)))
    assert np.isinf(edge.require("range")).all()


def test_images_that_exceed_memory_are_refused() -> None:
    need("linux")
    code = """
import resource
import nearfar as nf
scene = nf.Scene.from_arrays([[0, 0, -1], [1, 0, -1], [0, 1, -1]], [[0, 1, 2]])
camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(65536, 65536))
nf.render(scene, nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(4, 4)))  # Creates the threads.
resource.setrlimit(resource.RLIMIT_AS, (8 << 30, 8 << 30))
for call in (
    lambda: nf.render(scene, camera),
    lambda: camera.rays(),
    lambda: nf.reduce(scene, center=(0, 0, 0), r1=0.1, r2=0.5, face_size=16384),
):
    try:
        call()
    except MemoryError as error:
        print(error)
"""
    process = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=600, check=True)
    refused = r"the result needs \d+ bytes, which the system does not have\n"
    # The system may have memory that the process must not use.
    early = r"camera: a picture of 65536 × 65536 pixels takes 85.9 GB of memory, and .* GB are free\n"
    assert re.fullmatch(f"({early}|{refused})({refused}){{2}}", process.stdout)


def test_degenerate_triangles_are_invisible() -> None:
    vertices = np.array([[0, 0, -1], [1, 0, -1], [2, 0, -1], [0, 0, -1], [0, 0, -1]], np.float32)
    scene = nf.Scene.from_arrays(vertices, np.array([[0, 1, 2], [0, 3, 4]]))
    frame = nf.render(scene, nf.Camera((0, 0, 0), fov=WIDE, size=(9, 9)), channels=DRAWN)
    assert np.isfinite(frame.require("color")).all()
    seen = frame.require("object_id") >= 0
    assert np.isfinite(frame.require("normal")[seen]).all()


def test_odd_sizes_are_complete() -> None:
    scene = build(room())
    whole = nf.render(scene, nf.Camera((0, 0, 2), fov=nf.Fov(-1, 1, -1, 1), size=(40, 40)), channels=["range"])
    for width, height in ((1, 1), (8, 1), (7, 40), (40, 9), (17, 23)):
        # The same pixels in a window from the top left corner.
        fov = nf.Fov(-1, -1 + width / 20, 1 - height / 20, 1)
        part = nf.render(scene, nf.Camera((0, 0, 2), fov=fov, size=(width, height)), channels=["range"])
        # Bounds in float64 are rounded once.
        np.testing.assert_allclose(part.require("range"), whole.require("range")[:height, :width], rtol=1e-5)


def digest() -> str:
    """Hash of all images of the first camera."""
    frame = nf.render(build(room()), CAMERAS[0], samples=3, channels=DRAWN)
    return hashlib.sha256(b"".join(frame.require(name).tobytes() for name in DRAWN)).hexdigest()


@pytest.mark.slow
def test_bytes_do_not_depend_on_the_number_of_threads() -> None:
    assert printed_by_threads("from tests.render import test_truth; print(test_truth.digest())") == {digest() + "\n"}


def test_arguments_are_checked(monkeypatch: pytest.MonkeyPatch) -> None:
    scene, camera = build(room()), nf.Camera((0, 0, 0), fov=WIDE, size=(2, 2))
    with pytest.raises(TypeError, match="got the string 'range'"):
        nf.render(scene, camera, channels="range")
    with pytest.raises(ValueError, match="at least one"):
        nf.render(scene, camera, channels=[])
    monkeypatch.setenv("NEARFAR_ADAPTER", "none of this name")
    with pytest.raises(nf.DeviceError, match="no graphics adapter 'none of this name'"):
        nf.render(scene, camera, backend="gpu")
