"""Files of impostors: rounding, structure, near geometry in nearfar's light, and other programs that show them."""

from __future__ import annotations

import base64
import io
import itertools
import json
import os
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image
from scipy.spatial import KDTree

import nearfar as nf
from nearfar._base import glb
from nearfar._impostor import packing
from nearfar._impostor.bake import Region
from nearfar._impostor.file import EncodedFile, Geometry, Textures, encode
from nearfar._impostor.quads import Quads
from tests.support import need
from tests.support.impostor_cases import CENTER, SETTINGS, view, yard
from tests.support.reader_cases import FOLDER, SECONDS, answer_of, node

KINDS: list[tuple[Geometry, Textures]] = [
    ("meshopt", "webp"),
    ("meshopt", "png"),
    ("plain", "webp"),
    ("plain", "png"),
]
USERS = [((0.0, 0.0, 0.0), 0.0), ((-1.2, 0.3, 1.5), 2.0)]
"""Places about O, and directions."""


def quads_of(impostors: nf.Impostors) -> Quads:
    assert impostors._quads is not None
    return impostors._quads


def light(impostors: nf.Impostors, textures: Textures, geometry: Geometry) -> EncodedFile:
    return encode(impostors._quads, impostors._region, near=impostors.near, textures=textures, geometry=geometry)


def load(data: bytes, folder: Path) -> nf.Scene:
    path = folder / "loaded.glb"
    path.write_bytes(data)
    return nf.Scene.load(path)


def ordered(triangles: NDArray[np.float32]) -> NDArray[np.float32]:
    """Triangles in an order that depends on their corners only, each from its least corner on."""
    rows = triangles.reshape(-1, 3, 3)
    first = (rows.astype(np.float64) @ np.sqrt([2.0, 3.0, 5.0])).argmin(axis=1)
    turned = np.take_along_axis(rows, ((first[:, None] + np.arange(3)) % 3)[..., None], axis=1).reshape(-1, 9)
    return turned[np.lexsort(turned.T)]


def psnr(shown: nf.Scene | nf.Impostors, loaded: nf.Scene) -> float:
    """Least PSNR of pictures of a file for two users, against what it was written from."""
    found = []
    for user, turn in USERS:
        pairs = [(shown, view(np.add(CENTER, user), turn)), (loaded, view(np.array(user), turn))]
        ours, theirs = (nf.render(scene, camera, samples=4).require("color") for scene, camera in pairs)
        found.append(nf.psnr(ours, theirs, data_range=1.0))
    return min(found)


# rounding ------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("error_px", [0.5, 2.0, 8.0])
def test_no_user_sees_rounded_quads_off_by_more_than_is_reported(impostors: nf.Impostors, error_px: float) -> None:
    quads, reach = quads_of(impostors), impostors.reach
    packed = packing.pack(quads, reach, error_px)
    shown = np.ldexp(packed.steps, packed.exponents[:, None])
    uvs = np.ldexp(packed.uv_steps, packed.uv_exponents[:, None])
    size = np.array(quads.atlas.shape[1::-1])
    exact = np.column_stack([quads.uvs[:, 0], 1.0 - quads.uvs[:, 1]])
    # Narrow strips are less than a texel wide, so places in the texture do not identify all vertices.
    key = np.concatenate([exact * size, 20.0 * quads.vertices], axis=1)
    _, rows = KDTree(key).query(np.concatenate([uvs * size, 20.0 * shown], axis=1))
    assert len(np.unique(rows)) == len(quads.vertices) == len(shown), "each vertex is kept once: quads stay watertight"
    assert np.isclose(np.abs((uvs - exact[rows]) * size).max(), packed.uv_error)
    assert packed.uv_error <= packing.UV_ERROR_TEXELS
    points = quads.vertices[rows].astype(np.float64)
    draw = np.random.default_rng(3)
    users = draw.normal(size=(2000, 3))
    users *= reach / np.linalg.norm(users, axis=1, keepdims=True)
    # The worst place for each point is on the sphere: nearest to it, or beside the line of its error.
    toward = reach * points / np.linalg.norm(points, axis=1, keepdims=True)
    angles = np.concatenate([_angles(points, shown, place) for place in (*users[:200], toward)])
    worst = np.degrees(angles.max()) * 20.0
    assert 0.5 * packed.error_px < worst <= packed.error_px * (1.0 + 1e-9)
    assert packed.error_px <= min(error_px / 8.0, 0.25)


def _angles(points: NDArray[np.float64], shown: NDArray[np.float64], user: NDArray[np.float64]) -> NDArray[np.float64]:
    first, second = points - user, shown - user
    cross = np.linalg.norm(np.cross(first, second), axis=1)
    return np.asarray(np.arctan2(cross, np.einsum("ni,ni->n", first, second)))


def test_triangles_sectors_and_masks_are_kept(impostors: nf.Impostors) -> None:
    quads = quads_of(impostors)
    packed = packing.pack(quads, impostors.reach, impostors.settings.error_px)
    counts = np.zeros(2, int)
    for sector in packed.sectors:
        points = np.ldexp(packed.steps, packed.exponents[:, None])[sector.vertices]
        for is_masked, faces in sector.parts:
            counts[int(is_masked)] += len(faces)
            middles = points[faces].mean(axis=1)
            azimuth = np.degrees(np.arctan2(middles[:, 2], middles[:, 0]))
            # Triangles of a quad that straddles the border of two sectors may lie in the next one.
            assert np.ptp(np.unwrap(azimuth, period=360.0)) < 360.0 / packing.SECTORS + 30.0
    masked = int(quads.masked[quads.owners].sum())
    assert counts.tolist() == [len(quads.faces) - masked, masked]


def test_corners_that_users_may_touch_have_a_finite_step() -> None:
    points = np.array([[0.5, 0.0, 0.0], [9.0, 0.0, 0.0]])
    assert packing._exponents(points, np.array([0, 0]), 1, 1.0, 0.25).tolist() == [-19]
    assert packing.seen_error(points, points, 1.0) == 0.0
    assert packing.seen_error(points, points + 1e-6, 1.0) == pytest.approx(90.0 * 20.0)


# structure -----------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize(("geometry", "textures"), KINDS)
def test_a_far_file_is_plain_gltf(impostors: nf.Impostors, geometry: Geometry, textures: Textures) -> None:
    encoded = encode(impostors._quads, impostors._region, textures=textures, geometry=geometry)
    assert encoded == encode(impostors._quads, impostors._region, textures=textures, geometry=geometry)
    document, end = glb.header(encoded.data)
    region = document["scenes"][0]["extras"]["nearfar"]
    expected = {
        "center": list(CENTER),
        "origin": list(CENTER),
        "reach": 2.0,
        "r2": 12.0,
        "error_px": 2.0,
        "rounding_px": encoded.error_px,
    }
    assert region == expected
    assert not any({"matrix", "translation", "rotation", "scale"} & set(entry) for entry in document["nodes"])
    primitives = [primitive for mesh in document["meshes"] for primitive in mesh["primitives"]]
    assert len(document["meshes"]) <= 6
    assert len(primitives) == encoded.draw_calls <= 12
    assert {primitive["material"] for primitive in primitives} == {0, 1}
    assert [material.get("alphaMode") for material in document["materials"]] == [None, "MASK"]
    assert all("KHR_materials_unlit" in material["extensions"] for material in document["materials"])
    # three.js makes mipmaps unless the filter has none, and they would mix neighbours in the texture.
    assert document["samplers"] == [{"wrapS": 33071, "wrapT": 33071, "magFilter": 9729, "minFilter": 9729}]
    required = {"webp": ["EXT_texture_webp"], "png": []}[textures]
    required = [*(["EXT_meshopt_compression"] if geometry == "meshopt" else []), *required]
    assert document.get("extensionsRequired", []) == required
    assert document["extensionsUsed"] == sorted([*required, "KHR_materials_unlit"])
    view_entry = document["bufferViews"][document["images"][0]["bufferView"]]
    start = view_entry["byteOffset"]
    with Image.open(io.BytesIO(glb.binary(encoded.data, end)[start : start + view_entry["byteLength"]])) as picture:
        assert picture.format == textures.upper()
        np.testing.assert_array_equal(np.asarray(picture)[..., 3], quads_of(impostors).atlas[..., 3])


def test_each_quad_has_a_border_for_the_filter(impostors: nf.Impostors) -> None:
    """A look-up at a quad's edge, rounded, takes texels up to half a texel and the rounding outside: its border."""
    quads = quads_of(impostors)
    assert 0.5 + packing.UV_ERROR_TEXELS < 1.0
    for left, top, right, bottom in quads.rectangles.tolist():
        inside = quads.atlas[top:bottom, left:right]
        around = np.pad(inside, ((1, 1), (1, 1), (0, 0)), mode="edge")
        np.testing.assert_array_equal(quads.atlas[top - 1 : bottom + 1, left - 1 : right + 1], around)


def test_bad_files_are_refused(impostors: nf.Impostors, tmp_path: Path) -> None:
    unknown: Any = "jpeg"
    with pytest.raises(ValueError, match="textures: expected"):
        impostors.save_glb(tmp_path / "far.glb", textures=unknown)
    with pytest.raises(ValueError, match="geometry: expected"):
        impostors.save_glb(tmp_path / "far.glb", geometry=unknown)
    assert encode(None, impostors._region).data == b""
    with pytest.raises(ValueError, match="path: expected"):
        impostors.save_glb(tmp_path / "far.obj")
    with pytest.raises(OSError, match="missing"):
        impostors.save_glb(tmp_path / "missing" / "far.glb")
    assert list(tmp_path.iterdir()) == []


# pictures by nearfar -------------------------------------------------------------------------------------------------
def test_files_look_like_the_far_part(impostors: nf.Impostors, tmp_path: Path) -> None:
    far = impostors.far
    assert far is not None
    packed, plain = (
        load(encode(impostors._quads, impostors._region, geometry=kind[0], textures=kind[1]).data, tmp_path)
        for kind in (KINDS[0], KINDS[3])
    )
    np.testing.assert_array_equal(ordered(packed.triangles()), ordered(plain.triangles()))
    assert psnr(far, plain) > 44.0
    assert psnr(far, packed) > 34.0, "WebP loses colour"
    impostors.save_glb(tmp_path / "far.glb")
    assert nf.Scene.load(tmp_path / "far.glb").triangle_count == impostors.triangle_count


def test_a_plain_file_is_read_by_trimesh(impostors: nf.Impostors, tmp_path: Path) -> None:
    path = tmp_path / "far.glb"
    path.write_bytes(encode(impostors._quads, impostors._region, geometry="plain", textures="png").data)
    found = np.concatenate([mesh.triangles for mesh in trimesh.load_scene(path, process=False).dump()])
    np.testing.assert_array_equal(ordered(found.astype(np.float32)), ordered(nf.Scene.load(path).triangles()))


def test_a_light_file_looks_like_near_and_far(impostors: nf.Impostors, tmp_path: Path) -> None:
    encoded = light(impostors, "png", "meshopt")
    assert encoded.lost == ()
    assert encoded.near_error <= 2.0**-12
    loaded = load(encoded.data, tmp_path)
    assert loaded.triangle_count == impostors.scene.triangle_count
    assert "car" in loaded.object_names
    assert psnr(impostors, loaded) > 42.0


@pytest.mark.slow
def test_files_are_about_the_centre_also_6000_km_from_the_origin(tmp_path: Path) -> None:
    away = np.array((6e6, 1e3, -4e6))
    moved = nf.reduce(yard(tuple(away)), far="impostors", **{**SETTINGS, "center": CENTER + away, "face_size": 128})
    encoded = light(moved, "png", "meshopt")
    assert glb.header(encoded.data)[0]["scenes"][0]["extras"]["nearfar"]["center"] == list(CENTER + away)
    scene = load(encoded.data, tmp_path)
    assert scene.origin.tolist() == [0.0, 0.0, 0.0]
    np.testing.assert_allclose(scene.bounds, moved.scene.bounds - (CENTER + away), atol=0.02)
    camera = view(CENTER + away)
    ours, theirs = nf.render(moved, camera, samples=4), nf.render(scene, view(np.zeros(3)), samples=4)
    assert nf.psnr(ours.require("color"), theirs.require("color"), data_range=1.0) > 42.0


def test_near_geometry_has_the_light_of_nearfar(tmp_path: Path) -> None:
    build = nf.SceneBuilder()
    ball = trimesh.creation.icosphere(subdivisions=3)
    texels = np.random.default_rng(2).integers(0, 256, (8, 8, 4), np.uint8)
    square = np.array([[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 2.0, 0.0], [-1.0, 2.0, 0.0]])
    sides, uvs = [[0, 1, 2], [0, 2, 3]], np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]])
    painted = np.random.default_rng(1).integers(0, 256, (len(ball.vertices), 4), np.uint8)
    colors = {"plain": (0.8, 0.5, 0.2, 1.0), "dark": (0.02, 0.05, 0.1, 1.0)}
    numbers = {name: build.material(color) for name, color in colors.items()}
    textured, cut = build.material(texture=texels), build.material(texture=texels, cutoff=0.5)
    smooth = build.mesh(ball.vertices, ball.faces, normals=ball.vertex_normals, material=numbers["plain"])
    flat = build.mesh(ball.vertices, ball.faces, colors=painted, material=numbers["dark"])
    wall, fence = (build.mesh(square, sides, uvs=uvs, material=number) for number in (textured, cut))
    backwards = build.mesh(square, np.array(sides)[:, ::-1], uvs=uvs, material=numbers["plain"])
    for number, mesh in enumerate((smooth, smooth, flat, wall, fence, backwards)):
        place = np.diag([-1.0 if number == 1 else 1.0, 1.0 + 0.2 * number, 1.0, 1.0])
        place[:3, 3] = 5.0 * np.sin(number), 0.0, -5.0 * np.cos(number)
        build.instance(mesh, place, name=f"part_{number}")
    scene = build.build(dynamic=["part_2"])
    region = Region((0.0, 0.0, 0.0), reach=1.0, r2=10.0, error_px=2.0)
    loaded = load(encode(None, region, near=scene, textures="png").data, tmp_path)
    assert loaded.triangle_count == scene.triangle_count
    for turn in np.arange(6.0):
        camera = view(np.zeros(3), turn)
        ours, theirs = (nf.render(shown, camera).to_image().astype(int) for shown in (scene, loaded))
        off = np.abs(ours - theirs).max(axis=-1)
        assert (off > 2).mean() < 0.003, f"{turn}: silhouettes, and corners of smooth faces"


# other programs ------------------------------------------------------------------------------------------------------
SIZE, ANGLE = (480, 270), 30.0
"""Size and vertical angle of pictures in which texels are larger than pixels, as in a headset."""
SHOWN = [((0.0, 0.0, 0.0), (0.3, 0.1, -10.0)), ((-1.2, 0.3, 1.5), (8.0, -0.5, 4.0))]
"""Eyes and targets about O."""


def views() -> list[dict[str, Any]]:
    return [{"eye": eye, "target": target, "size": SIZE, "angle": ANGLE} for eye, target in SHOWN]


@pytest.fixture(scope="module")
def fine(scene: nf.Scene) -> nf.Impostors:
    """Impostors whose texels are as wide as two pixels."""
    return nf.reduce(scene, far="impostors", **{**SETTINGS, "face_size": 512})


def check_pictures(fine: nf.Impostors, pictures: list[NDArray[np.uint8]], most: float) -> None:
    """Compare pictures of a light file, RGBA, with nearfar's; few pixels, at silhouettes, may differ."""
    aspect = SIZE[0] / SIZE[1]
    across = np.degrees(2.0 * np.arctan(np.tan(np.radians(ANGLE) / 2.0) * aspect))
    fov = nf.Fov.symmetric(float(across), aspect)
    for (eye, target), picture in zip(SHOWN, pictures, strict=True):
        camera = nf.Camera.look_at(np.add(CENTER, eye), np.add(CENTER, target), fov=fov, size=SIZE)
        frame = nf.render(fine, camera, channels=("color", "range"))
        expected, covered = np.isfinite(frame.require("range")), picture[..., 3] > 127
        assert 0.3 < expected.mean() < 1.0, "a view with sky"
        assert (covered != expected).mean() < most
        off = np.abs(frame.to_image().astype(int) - picture[..., :3]).max(axis=-1)[covered & expected]
        assert np.median(off) <= 2
        assert (off > 24).mean() < most


@pytest.mark.slow
def test_three_js_shows_the_picture(fine: nf.Impostors, tmp_path: Path) -> None:
    need("browser")
    files, profile = tmp_path / "files", tmp_path / "profile"
    files.mkdir()
    profile.mkdir()
    (files / "light.glb").write_bytes(light(fine, "webp", "meshopt").data)
    found = answer_of("impostors.mjs", {"files": ["files/light.glb"], "views": views()}, profile, {"files": files})
    (shown,) = found.values()
    assert shown["triangles"] == fine.scene.triangle_count
    assert shown["filters"] == [{"linear": True, "mipmaps": False}], "mipmaps would mix neighbours in the texture"
    assert shown["center"] == list(CENTER)
    urls = [picture["picture"].removeprefix("data:image/png;base64,") for picture in shown["pictures"]]
    check_pictures(fine, [np.array(Image.open(io.BytesIO(base64.b64decode(url)))) for url in urls], 0.01)


@pytest.mark.slow
def test_blender_shows_the_picture(fine: nf.Impostors, tmp_path: Path) -> None:
    need("blender")
    (tmp_path / "light.glb").write_bytes(light(fine, "png", "plain").data)
    jobs = [{**entry, "to": str(tmp_path / f"{number}.png")} for number, entry in enumerate(views())]
    (tmp_path / "job.json").write_text(json.dumps({"file": str(tmp_path / "light.glb"), "views": jobs}))
    command = ["blender", "-b", "--python-exit-code", "3", "--python", str(FOLDER / "in_blender.py"), "--", "job.json"]
    # Blender uses the modules of the first python3 in PATH; NumPy is installed for the system's.
    path = os.pathsep.join(["/usr/bin", os.environ.get("PATH", "")])
    process = subprocess.run(
        command, cwd=tmp_path, env=os.environ | {"PATH": path}, capture_output=True, timeout=SECONDS
    )
    assert process.returncode == 0, process.stderr[-2000:]
    check_pictures(fine, [np.array(Image.open(job["to"])) for job in jobs], 0.01)


@pytest.mark.slow
def test_the_gltf_validator_finds_no_errors(impostors: nf.Impostors, tmp_path: Path) -> None:
    need("node")
    paths = []
    for (geometry, textures), near in itertools.product(KINDS, (None, impostors.near)):
        encoded = encode(impostors._quads, impostors._region, near=near, geometry=geometry, textures=textures)
        paths.append(tmp_path / f"{geometry}_{textures}_{near is None}.glb")
        paths[-1].write_bytes(encoded.data)
    for report in node("validate.mjs", paths).values():
        messages = [message for message in report["messages"] if message["severity"] < 2]
        assert not messages, messages[:3]
        assert {message["code"] for message in report["messages"]} <= {
            "UNSUPPORTED_EXTENSION",
            "IMAGE_NPOT_DIMENSIONS",
            "UNUSED_OBJECT",
        }
