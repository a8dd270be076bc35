"""Samplers of textures: pictures against the rules of OpenGL, written files, and Wavefront's clamping."""

from __future__ import annotations

import base64
import io
import itertools
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._scene.load import wrap_notes
from tests.support.gltf_cases import decode, load
from tests.support.gltf_writer import Writer
from tests.support.gpu_cases import ADAPTERS, adapter
from tests.support.render_cases import noise
from tests.support.render_oracle import linear_from_srgb

REPEAT, MIRROR, CLAMP, NEAREST, LINEAR = 10497, 33648, 33071, 9728, 9729
ALL = list(itertools.product((REPEAT, MIRROR, CLAMP), (REPEAT, MIRROR, CLAMP), (NEAREST, LINEAR)))
TEXTURE: NDArray[np.uint8] = noise(3, 5, 4)
TEXTURE[..., 3] = 255
SIZE = 48
FOV = nf.Fov(-1, 1, -1, 1)
LEAST, SPAN = -1.0, 3.0
"""Texture coordinates of the picture's left and lower side, and their extent: three images by three."""


def texel(number: int, count: int, wrap: int) -> int:
    """Texel of a number that may lie beyond the sides; OpenGL ES 3.0, section 3.8.10."""
    if wrap == REPEAT:
        return number % count
    if wrap == CLAMP:
        return min(max(number, 0), count - 1)
    number = number % (2 * count) - count
    return count - 1 - (number if number >= 0 else -1 - number)


def weights(pixels: NDArray[np.float64], count: int, wrap: int, filter_: int) -> NDArray[np.float64]:
    """Weight of each texel (N, count) at N coordinates."""
    found = np.zeros((len(pixels), count))
    for row, coordinate in enumerate(pixels * count):
        if filter_ == NEAREST:
            found[row, texel(int(np.floor(coordinate)), count, wrap)] = 1.0
            continue
        first = int(np.floor(coordinate - 0.5))
        share = coordinate - 0.5 - first
        found[row, texel(first, count, wrap)] += 1.0 - share
        found[row, texel(first + 1, count, wrap)] += share
    return found


def expected(sampler: tuple[int, int, int]) -> NDArray[np.float64]:
    wrap_s, wrap_t, filter_ = sampler
    across = LEAST + SPAN * (np.arange(SIZE) + 0.5) / SIZE
    # Coordinates of glTF point down, and the picture's upper side has the least one.
    column, row = weights(across, 5, wrap_s, filter_), weights(across, 3, wrap_t, filter_)
    return np.asarray(np.einsum("yr,xc,rck->yxk", row, column, linear_from_srgb(TEXTURE[..., :3])))


def square(materials: list[dict[str, Any]], samplers: list[dict[str, int]]) -> bytes:
    """A GLB of a square that fills the view; texture n has sampler n."""
    writer = Writer(np.random.default_rng(0))
    corners = np.array([[-1, -1, -1], [1, -1, -1], [1, 1, -1], [-1, 1, -1]], np.float32)
    most = LEAST + SPAN
    uvs = np.array([[LEAST, most], [most, most], [most, LEAST], [LEAST, LEAST]], np.float32)
    attributes = {"POSITION": writer.add(corners), "TEXCOORD_0": writer.add(uvs)}
    indices = writer.add(np.array([[0], [1], [2], [0], [2], [3]], np.uint16))
    file = io.BytesIO()
    Image.fromarray(TEXTURE).save(file, "png")
    return writer.glb(
        meshes=[{"primitives": [{"attributes": attributes, "indices": indices, "material": 0}]}],
        nodes=[{"mesh": 0, "name": "square"}],
        scenes=[{"nodes": [0]}],
        materials=materials,
        samplers=samplers,
        textures=[{"source": 0, "sampler": number} for number in range(len(samplers))],
        images=[{"uri": "data:image/png;base64," + base64.b64encode(file.getvalue()).decode()}],
    )


UNLIT: dict[str, Any] = {
    "pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0},
    "extensions": {"KHR_materials_unlit": {}},
    "doubleSided": True,
}
GLOWING: dict[str, Any] = {
    "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1], "baseColorTexture": {"index": 0}, "metallicFactor": 0},
    "emissiveFactor": [1, 1, 1],
    "emissiveTexture": {"index": 1},
    "doubleSided": True,
}


def sampler(codes: tuple[int, int, int]) -> dict[str, int]:
    return {"wrapS": codes[0], "wrapT": codes[1], "magFilter": codes[2], "minFilter": 9985}


def picture(scene: nf.Scene, backend: Any = "cpu", size: int = SIZE) -> NDArray[np.float32]:
    return nf.render(scene, nf.Camera((0, 0, 0), fov=FOV, size=(size, size)), backend=backend).require("color")


def assert_drawn(scene: nf.Scene, codes: tuple[int, int, int], backend: str = "cpu") -> None:
    # The tracer's positions are exact to 2⁻²³ of the distance, 1e-6 texels; colours differ by at most 1 per texel.
    np.testing.assert_allclose(picture(scene, backend), expected(codes), atol=3e-5, err_msg=str(codes))


def test_every_wrap_and_filter_is_drawn(tmp_path: Path) -> None:
    for codes in ALL:
        scene = load(tmp_path, square([UNLIT], [sampler(codes)]))
        assert scene.report.notes == ()
        assert_drawn(scene, codes)


@pytest.mark.parametrize("kind", ADAPTERS)
def test_graphics_adapters_draw_every_wrap_and_filter(kind: str, tmp_path: Path) -> None:
    with adapter(kind):
        for codes in ALL:
            assert_drawn(load(tmp_path, square([UNLIT], [sampler(codes)])), codes, "gpu")


def test_the_emission_has_its_own_sampler(tmp_path: Path) -> None:
    codes = (MIRROR, CLAMP, NEAREST)
    scene = load(tmp_path, square([GLOWING], [{}, sampler(codes)]))
    assert scene.report.textures == 2
    assert_drawn(scene, codes)


def test_a_clamped_image_that_is_small_in_the_picture_continues_its_sides(tmp_path: Path) -> None:
    """In a picture of three pixels the corners show only the continuation, even in coarser levels."""
    color = linear_from_srgb(TEXTURE[..., :3])
    scene = load(tmp_path, square([UNLIT], [sampler((CLAMP, CLAMP, LINEAR))]))
    seen = picture(scene, size=3)
    mean = color.mean((0, 1))
    # Level log2(5) of 2: the blend of the coarsest level, which is the mean, and a level of 2 × 1 texels.
    assert np.abs(seen[1, 1] - mean).max() < 0.1
    clamped, repeated = seen[0, 0], picture(load(tmp_path, square([UNLIT], [{}])), size=3)[0, 0]
    assert np.abs(repeated - mean).max() < 0.1
    halves = np.array(
        [color[:, :2].sum((0, 1)) + color[:, 2].sum(0) / 2, color[:, 3:].sum((0, 1)) + color[:, 2].sum(0) / 2]
    )
    side = halves[0] / 7.5
    assert np.abs(clamped - side).max() < np.abs(side - mean).max()


@pytest.mark.parametrize("material", [UNLIT, GLOWING], ids=["unlit", "glowing"])
def test_written_files_have_the_samplers(tmp_path: Path, material: dict[str, Any]) -> None:
    stated = [sampler((CLAMP, MIRROR, NEAREST)), sampler((MIRROR, REPEAT, LINEAR))]
    scene = load(tmp_path, square([material], stated))
    codes = nf._core.scene_parts(scene._core)["texture_samplers"].tolist()
    reduced = nf.reduce(scene, center=(0, 0, 0), r1=5, r2=9, face_size=4)
    reduced.save(tmp_path / "reduced")
    back = nf.ReducedScene.load(tmp_path / "reduced").scene
    nf.stream.export(scene, tmp_path / "bundle", center=(0, 0, 0), radii=(5.0,), face_size=64)
    files = [tmp_path / "reduced/near.glb", *(tmp_path / "bundle").glob("files/*.glb")]
    assert len(files) == 2
    np.testing.assert_array_equal(picture(back), picture(scene))
    assert nf._core.scene_parts(back._core)["texture_samplers"].tolist() == codes
    for file in files:
        document = decode(file)[0]
        infos = [document["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]]
        infos += [document["materials"][0]["emissiveTexture"]] if material is GLOWING else []
        textures = [document["textures"][info["index"]] for info in infos]
        found = [document["samplers"][texture["sampler"]] for texture in textures]
        assert [[entry["wrapS"], entry["wrapT"], entry["magFilter"]] for entry in found] == codes
    # A scene's own files keep all entries of the sampler.
    assert decode(files[0])[0]["samplers"] == stated[: len(codes)]


def test_wavefront_clamps(tmp_path: Path) -> None:
    Image.fromarray(TEXTURE).save(tmp_path / "t.png")
    most = LEAST + SPAN
    (tmp_path / "a.obj").write_text(
        f"mtllib a.mtl\nusemtl m\nv -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\n"
        f"vt {LEAST} {LEAST}\nvt {most} {LEAST}\nvt {most} {most}\nvt {LEAST} {most}\nf 1/1 2/2 3/3 4/4\n"
    )
    for statement, wrap in (("t.png", REPEAT), ("-clamp off t.png", REPEAT), ("-clamp on t.png", CLAMP)):
        (tmp_path / "a.mtl").write_text(f"newmtl m\nKd 0 0 0\nKe 1 1 1\nmap_Ke {statement}\n")
        scene = nf.Scene.load(tmp_path / "a.obj")
        assert not any("clamp" in note for note in scene.report.notes)
        assert_drawn(scene, (wrap, wrap, LINEAR))
        (tmp_path / "a.mtl").write_text(f"newmtl m\nKd 1 1 1\nmap_Kd {statement}\n")
        scene = nf.Scene.load(tmp_path / "a.obj")
        nf.lod.export(scene, tmp_path / "a.glb", view=FOV)
        for written in (scene, nf.Scene.load(tmp_path / "a.glb")):
            assert nf._core.scene_parts(written._core)["texture_samplers"].tolist() == [[wrap, wrap, LINEAR]]


def test_other_wrap_modes_of_collada_are_counted() -> None:
    def sampler(*modes: str) -> str:
        wraps = "".join(f"<wrap_{axis}>{mode}</wrap_{axis}>" for axis, mode in zip("st", modes, strict=False))
        return f"<newparam><sampler2D><source>image</source>{wraps}</sampler2D></newparam>"

    document = "".join(sampler(*modes) for modes in ((), ("WRAP", "WRAP"), ("WRAP", "CLAMP"), ("MIRROR", "BORDER")))
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as members:
        members.writestr("scene.dae", document)
    expected = ["2 textures with clamped or mirrored sides repeated"]
    assert wrap_notes(document.encode()) == wrap_notes(archive.getvalue()) == expected
    assert wrap_notes(sampler("WRAP").encode()) == []
