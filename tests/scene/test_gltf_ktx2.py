"""Textures in KTX 2: Basis Universal and plain pixels are drawn; others are errors, before memory is allocated."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._scene.gltf import ktx2 as reader
from tests.support import data, need
from tests.support.gltf_cases import decode, load, picture
from tests.support.ktx2_cases import EXTENSION, glb, ktx2
from tests.support.refused import load_damaged, refusals

FILES = "wild/glTF-Transform/packages/extensions/test/in"
KOTA = "wild/cesium-native/CesiumImage/test/data/ktx2"
FOV = nf.Fov(-1.2, 0.9, -1.1, 1.0)
DICE = np.random.default_rng(5)


def only_texture(scene: nf.Scene) -> NDArray[Any]:
    """The scene's only texture."""
    (texture,) = nf._core.scene_parts(scene._core)["textures"]
    return np.asarray(texture)


def gamma(light: NDArray[Any]) -> NDArray[Any]:
    return np.where(light <= 0.0031308, 12.92 * light, 1.055 * np.maximum(light, 1e-9) ** (1 / 2.4) - 0.055)


@pytest.mark.parametrize(
    ("kind", "type_", "channels"),
    [
        (23, "u1", "RGB"), (29, "u1", "RGB"), (30, "u1", "BGR"), (37, "u1", "RGBA"), (43, "u1", "RGBA"),
        (50, "u1", "BGRA"), (84, "u2", "RGB"), (91, "u2", "RGBA"), (90, "f2", "RGB"), (97, "f2", "RGBA"),
        (106, "f4", "RGB"), (109, "f4", "RGBA"),
    ],
)  # fmt: skip
@pytest.mark.parametrize("packed", [False, True])
def test_plain_pixels_are_read(tmp_path: Path, kind: int, type_: str, channels: str, packed: bool) -> None:
    shape = (5, 7, len(channels))
    levels = DICE.random(shape)
    pixels = levels.astype(type_) if type_[0] == "f" else (levels * np.iinfo(type_).max).astype(type_)
    texels = only_texture(load(tmp_path, glb(ktx2(pixels, kind, packed=packed))))
    expected = levels if type_[0] != "f" else np.where(np.array([c == "A" for c in channels]), levels, gamma(levels))
    for place, channel in enumerate(channels):
        np.testing.assert_allclose(texels[..., "RGBA".index(channel)], 255 * expected[..., place], atol=1.01)
    if "A" not in channels:
        assert (texels[..., 3] == 255).all()


def test_row_0_may_be_the_bottom(tmp_path: Path) -> None:
    pixels = DICE.integers(0, 256, (3, 4, 4), np.uint8)
    found = only_texture(load(tmp_path, glb(ktx2(pixels, 43, notes=b"\x12\0\0\0KTXorientation\0ru\0\0"))))
    np.testing.assert_array_equal(found, pixels[::-1])


@pytest.mark.parametrize("name", ["kota-onelevel", "kota-mipmaps", "kota-automipmap"])
def test_basis_pictures_resemble_their_source(tmp_path: Path, name: str) -> None:
    need("opengl_basisu")
    texels = only_texture(load(tmp_path, glb(data(f"{KOTA}/{name}.ktx2").read_bytes())))
    with Image.open(data(f"{KOTA}/kota.jpg")) as image:
        source = np.asarray(image.convert("RGB"), np.float64)
    assert texels.shape == (*source.shape[:2], 4)
    # The codec is lossy, like JPEG: 27 dB, and 8 dB for a picture upside down.
    assert 10 * np.log10(255**2 / np.square(texels[..., :3] - source).mean()) > 27


@pytest.mark.parametrize(("name", "color"), [("etc1s", (186, 150, 0)), ("uastc", (186, 150, 0))])
def test_both_codecs_are_read(tmp_path: Path, name: str, color: tuple[int, int, int]) -> None:
    need("opengl_basisu")
    texels = only_texture(load(tmp_path, glb(data(f"{FILES}/2d_{name}.ktx2").read_bytes())))
    assert texels.shape == (40, 40, 4)
    np.testing.assert_allclose(np.median(texels, axis=(0, 1)), [*color, 255], atol=6)


@pytest.mark.parametrize("name", ["rgb8", "rgba8", "rgba16_linear", "rgba32_linear"])
def test_real_plain_pixels_are_green(tmp_path: Path, name: str) -> None:
    texels = only_texture(load(tmp_path, glb(data(f"{FILES}/2d_{name}.ktx2").read_bytes())))
    # All were made from one green, either linear or sRGB.
    np.testing.assert_allclose(np.median(texels, axis=(0, 1)), [78, 178, 75, 255], atol=6)


@pytest.mark.parametrize(("name", "words"), [("bc1", "BC"), ("bc7", "BC"), ("astc4x4", "ASTC")])
def test_other_compressions_are_named(tmp_path: Path, name: str, words: str) -> None:
    with pytest.raises(nf.SceneError, match=rf"a\.glb: its texture 0, a KTX 2 image, has {words}"):
        load(tmp_path, glb(data(f"{FILES}/2d_{name}.ktx2").read_bytes()))


def test_written_files_contain_all_textures(tmp_path: Path) -> None:
    """The base colour is stored as PNG, like all base colours, and other maps unchanged."""
    pixels, other = DICE.integers(0, 256, (2, 6, 4, 3), np.uint8)
    surface = {"metallicFactor": 0, "baseColorTexture": {"index": 0}}
    material = {"pbrMetallicRoughness": surface, "normalTexture": {"index": 1}}
    bumps = ktx2(other, 23)
    scene = load(tmp_path, glb(ktx2(pixels, 29), bumps, materials=[material]))
    np.testing.assert_array_equal(only_texture(scene)[..., :3], pixels)
    assert not any("texture" in note or "map saved" in note for note in scene.report.notes)
    nf.lod.export(scene, tmp_path / "written.glb", view=FOV)
    document, binary = decode(tmp_path / "written.glb")
    assert {image["mimeType"] for image in document["images"]} == {"image/png", "image/ktx2"}
    assert document["extensionsRequired"] == [EXTENSION]
    assert bumps in binary
    again = nf.Scene.load(tmp_path / "written.glb")
    np.testing.assert_array_equal(only_texture(again), only_texture(scene))


def test_plain_alternatives_need_no_decoder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A plain picture is present besides the packed one, and the packed maps are not drawn."""
    monkeypatch.setattr(reader, "find_spec", lambda name: None)
    packed = data(f"{FILES}/2d_etc1s.ktx2").read_bytes()
    plain = [{"source": 1, "extensions": {EXTENSION: {"source": 0}}}]
    scene = load(tmp_path, glb(packed, picture(0, "png"), textures=plain))
    assert only_texture(scene).shape == (8, 6, 4)
    bumps = [{"normalTexture": {"index": 0}, "pbrMetallicRoughness": {"metallicFactor": 0}}]
    assert load(tmp_path, glb(packed, materials=bumps)).triangle_count == 2


@pytest.mark.parametrize("name", ["etc1s", "uastc"])
def test_without_the_package_the_install_command_is_named(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str
) -> None:
    monkeypatch.setattr(reader, "find_spec", lambda name: None)
    with pytest.raises(nf.SceneError, match=r'a\.glb: its texture 0.*Basis.*pip install "nearfar\[formats\]"'):
        load(tmp_path, glb(data(f"{FILES}/2d_{name}.ktx2").read_bytes()))


SMALL = np.zeros((4, 4, 4), np.uint8)
PLAIN = "not a single two-dimensional image"


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"width": 0}, PLAIN), ({"height": 0}, PLAIN), ({"depth": 1}, PLAIN), ({"layers": 1}, PLAIN),
        ({"faces": 6}, PLAIN), ({"faces": 0}, PLAIN), ({"levels": 33}, "too many"), ({"levels": 7}, "level|cut off"),
        ({"width": 2**32 - 1, "height": 2**32 - 1}, "at most 134,217,728 are read"),
        ({"width": 2**13, "height": 2**13}, "unpacks to more than"),
        ({"width": 5}, "has a level of 64 bytes for 5 × 4 texels"),
        ({"start": 2**63}, "is cut off"), ({"length": 2**63}, "is cut off"), ({"length": 63}, "has a level of 63"),
        ({"kind": 0}, "has colour model 1 "), ({"kind": 9}, "Vulkan's format 9"), ({"scheme": 2}, "by Zstandard"),
        ({"scheme": 3}, "cannot be unpacked"), ({"scheme": 3, "unpacked": 2**60}, "unpacks to more than"),
        ({"scheme": 77}, "Zstandard|not read"),
    ],
)  # fmt: skip
def test_inconsistent_headers_are_errors(tmp_path: Path, changes: dict[str, Any], words: str) -> None:
    with pytest.raises(nf.SceneError, match=rf"a\.glb: .*({words})"):
        load(tmp_path, glb(ktx2(SMALL, 43, **changes)))


def test_zeros_that_expand_greatly_are_errors(tmp_path: Path) -> None:
    """64 MiB that zlib compresses to 64 kB."""
    bomb = ktx2(np.zeros((1, 1 << 26, 1), np.uint8), 43, packed=True, width=4, height=4, unpacked=64)
    with pytest.raises(nf.SceneError, match=r"a\.glb: .*has a level of 65 bytes for 4 × 4 texels"):
        load(tmp_path, glb(bomb))


@pytest.mark.parametrize("name", ["etc1s", "uastc", "rgba8"])
def test_truncated_ktx_2_files_are_errors(tmp_path: Path, name: str) -> None:
    need("opengl_basisu")
    content = data(f"{FILES}/2d_{name}.ktx2").read_bytes()
    for length in range(12, len(content), max(1, len(content) // 40)):
        # In some files bytes follow the largest level.
        try:
            assert only_texture(load(tmp_path, glb(content[:length]))).shape == (40, 40, 4)
        except nf.SceneError as error:
            assert "a.glb: its texture 0, a KTX 2 image, " in str(error)  # noqa: PT017
        else:
            assert length > len(content) - 32


@pytest.mark.parametrize("name", ["etc1s", "uastc"])
def test_damaged_files_are_errors_or_other_pictures(tmp_path: Path, name: str) -> None:
    need("opengl_basisu")
    content = data(f"{FILES}/2d_{name}.ktx2").read_bytes()
    scenes = load_damaged(tmp_path, content[12:], 80, lambda damaged: glb(content[:12] + damaged))
    assert 0 < len(scenes) < 80


def test_impossible_sizes_take_no_memory(tmp_path: Path) -> None:
    """Basis Universal data that claims more than its bytes, refused by the default limit and a larger one."""
    need("linux")
    need("opengl_basisu")
    content = bytearray(data(f"{FILES}/2d_uastc.ktx2").read_bytes())
    struct.pack_into("<2I", content, 20, 11_000, 11_000)
    (tmp_path / "a.glb").write_bytes(glb(bytes(content)))
    (first, second), more = refusals(tmp_path / "a.glb", None, 1 << 50)
    assert "a.glb: it unpacks to more than 268,435,456 bytes" in first
    assert "has a level of another size than its 11000 × 11000 texels" in second
    assert more < 200e6
