"""Texture coordinates of glTF files: the drawn set, and those kept for maps that are not drawn."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene import coordinates
from tests.support import data
from tests.support.gltf_cases import decode, encode, gltf, load

TRANSFORM = "KHR_texture_transform"
FOV = nf.Fov(-1.2, 0.9, -1.1, 1.0)
SETS = np.random.default_rng(7).random((3, 4, 2)).astype(np.float32)
NUMBERS = st.floats(-4, 4, width=32)
TRANSFORMS = st.fixed_dictionaries(
    {}, optional={"offset": st.lists(NUMBERS, min_size=2, max_size=2), "rotation": NUMBERS,
                  "scale": st.lists(NUMBERS, min_size=2, max_size=2)},
)  # fmt: skip


def info(number: int = 0, index: int = 0, **transform: Any) -> dict[str, Any]:
    """A reference to a texture."""
    extension = {"extensions": {TRANSFORM: transform}} if transform else {}
    return {"index": index} | ({"texCoord": number} if number else {}) | extension


def base(**stated: Any) -> dict[str, Any]:
    return {"pbrMetallicRoughness": {"baseColorTexture": info(**stated)}}


def content(materials: list[dict[str, Any]], sets: list[list[int]] | None = None, **changes: Any) -> bytes:
    """Squares with one to three sets of texture coordinates; `sets` lists those of each square."""
    document, binary = decode(gltf(materials))
    start = len(binary)
    document["bufferViews"].append({"buffer": 0, "byteOffset": start, "byteLength": SETS.nbytes})
    document["buffers"][0]["byteLength"] = start + SETS.nbytes
    view = len(document["bufferViews"]) - 1
    first = len(document["accessors"])
    for number in range(3):
        place = {"bufferView": view, "byteOffset": 32 * number}
        document["accessors"].append(place | {"componentType": 5126, "count": 4, "type": "VEC2"})
    for square, mesh in enumerate(document["meshes"]):
        chosen = [0, 1, 2] if sets is None else sets[square]
        names = {f"TEXCOORD_{place}": first + number for place, number in enumerate(chosen)}
        mesh["primitives"][0]["attributes"] = {"POSITION": 0} | names
    return encode(document | changes, binary + SETS.tobytes())


def first_square(scene: nf.Scene) -> NDArray[Any]:
    """Texture coordinates (4, 2) of the first square's corners in file order, v pointing down."""
    parts = nf._core.mesh_parts(scene._core.merged())
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    places = parts["positions"][:, :2] - parts["positions"][:, :2].min(axis=0)
    rows = [int(np.argmin(np.abs(places - corner).sum(axis=1))) for corner in corners]
    return np.asarray(parts["uvs"][rows]) * [1, -1] + [0, 1]


def picture_of(scene: nf.Scene, view: nf.Camera) -> NDArray[np.float32]:
    color = nf.render(scene, view, samples=16).color
    assert color is not None
    return color


def transform_uv(uv: Any, transform: dict[str, Any]) -> tuple[float, float]:
    """A point scaled, then rotated counter-clockwise in an image whose v points down, then moved."""
    u, v = (float(x) * s for x, s in zip(uv, transform.get("scale", (1, 1)), strict=True))
    turn = complex(u, -v) * complex(math.cos(angle := transform.get("rotation", 0)), math.sin(angle))
    offset = transform.get("offset", (0, 0))
    return turn.real + offset[0], -turn.imag + offset[1]


@given(TRANSFORMS, st.lists(NUMBERS, min_size=2, max_size=2))
def test_points_are_transformed_as_the_extension_defines(transform: dict[str, Any], uv: list[float]) -> None:
    found = coordinates.from_texture_info(info(**transform)).to_scene(np.array([uv], np.float32))
    u, v = transform_uv(uv, transform)
    # One rounding to float32 of numbers up to 4 · 4 · √2 + 4 + 1.
    np.testing.assert_allclose(found, np.array([[u, 1 - v]]), rtol=0, atol=2**-19)


def test_the_example_of_the_extension_shows_the_lower_left_quarter() -> None:
    """The image is "rotated clockwise 90°": its lower left corner goes to the upper left one of the square."""
    example = coordinates.from_texture_info(info(offset=[0, 1], rotation=1.57079632679, scale=[0.5, 0.5]))
    corners = np.array([[0, 0], [1, 0], [1, 1], [0, 1]], np.float32)
    found = example.to_scene(corners) * [1, -1] + [0, 1]
    np.testing.assert_allclose(found, np.array([[0, 1], [0, 0.5], [0.5, 0.5], [0.5, 1]]), atol=1e-7)


@pytest.mark.parametrize(
    ("stated", "number"),
    [({}, 0), ({"number": 1}, 1), ({"number": 2}, 2), ({"texCoord": 2}, 2), ({"number": 1, "texCoord": 0}, 0)],
)
@pytest.mark.parametrize("transform", [{}, {"offset": [0.25, -3], "rotation": 0.7, "scale": [2, -0.5]}])
def test_the_base_colour_uses_its_set_and_transform(
    tmp_path: Path, stated: dict[str, Any], number: int, transform: dict[str, Any]
) -> None:
    scene = load(tmp_path, content([base(**stated, **transform)]))
    assert scene.report.textures == 1
    expected = [transform_uv(uv, transform) for uv in SETS[number]]
    np.testing.assert_allclose(first_square(scene), expected, atol=1e-6)
    assert not any("ignored" in note or "coordinates" in note for note in scene.report.notes)


def test_squares_that_share_a_material_use_their_own_sets(tmp_path: Path) -> None:
    """The second square has different coordinates at the same position, and the third one none there."""
    document, binary = decode(content([base(number=1)] * 3, [[0, 1], [0, 2], [0]]))
    for mesh in document["meshes"]:
        mesh["primitives"][0]["material"] = 0
    scene = load(tmp_path, encode(document, binary))
    for square, number in ((0, 1), (1, 2)):
        np.testing.assert_allclose(first_square(scene.subset(objects=[f"square{square}"])), SETS[number], atol=1e-6)
    assert scene.report.materials == 2  # With a texture and without.


def test_small_integer_coordinates_are_transformed_exactly(tmp_path: Path) -> None:
    """gltfpack writes unnormalised integers, which a scale of 1 / 4095 makes fractions."""
    document, binary = decode(content([base(scale=[1 / 4095] * 2)]))
    rows = np.array([[0, 4095], [1, 2], [77, 3000], [4095, 0]], np.uint16)
    place = document["bufferViews"][-1]["byteOffset"]
    binary = binary[:place] + rows.tobytes() + binary[place + rows.nbytes :]
    document["accessors"][3] |= {"componentType": 5123}
    scene = load(tmp_path, encode(document, binary))
    np.testing.assert_allclose(first_square(scene), rows / 4095, atol=1e-7)


@given(TRANSFORMS, TRANSFORMS, st.lists(NUMBERS, min_size=2, max_size=2))
def test_maps_keep_their_position_on_the_shape(one: dict[str, Any], other: dict[str, Any], uv: list[float]) -> None:
    """The transform stated for a map leads from the base colour's coordinates to its own; or nothing is stated."""
    shown_first, own = coordinates.from_texture_info(info(**one)), coordinates.from_texture_info(info(**other))
    stated = coordinates.relative(info(**other), shown_first)
    linear = shown_first.matrix[:, :2]
    if stated is None:
        # Only transforms that shear, and those of a shape whose coordinates are collinear, cannot be stated.
        if np.linalg.cond(linear) < 1e10:
            first, second = (own.matrix[:, :2] @ np.linalg.inv(linear)).T
            assert abs(first @ second) > 1e-10 * np.hypot(*first) * np.hypot(*second)
        return
    start = shown_first.matrix @ [*uv, 1]
    end = own.matrix @ [*uv, 1]
    size = max(1, np.abs(coordinates.from_texture_info(info(**stated)).matrix).max())
    np.testing.assert_allclose(transform_uv(start, stated), end, atol=1e-6 * size)


@pytest.mark.parametrize(
    "transform",
    [
        {"scale": [2, 2], "rotation": 1, "offset": [3, 4]},
        {"scale": [0.5, -3], "offset": [1, 0]},
        {"scale": [-1, 1], "rotation": math.pi / 2},
    ],
)
def test_rotations_and_scales_can_be_stated(transform: dict[str, Any]) -> None:
    assert coordinates.relative(info(), coordinates.from_texture_info(info(**transform))) is not None
    assert coordinates.relative(info(**transform), coordinates.from_texture_info(info(**transform))) == {}
    assert coordinates.relative(info(**transform), coordinates.from_texture_info(info())) == transform


def test_shears_and_degenerate_coordinates_cannot_be_stated() -> None:
    turned = coordinates.from_texture_info(info(rotation=0.5, scale=[1, 3]))
    assert coordinates.relative(info(rotation=0.1), turned) is None
    assert coordinates.relative(info(), coordinates.from_texture_info(info(scale=[0, 1]))) is None
    assert coordinates.relative(info(number=1), coordinates.from_texture_info(info())) is None


def test_written_files_keep_the_position_of_each_map(tmp_path: Path) -> None:
    one, other = {"scale": [2, 2], "rotation": 0.3, "offset": [0.5, 0]}, {"scale": [4, 4], "rotation": -0.4}
    material = base(number=1, **one) | {
        "name": "wall",
        "normalTexture": info(1, 1, **other),
        "occlusionTexture": info(1, 2, **one),
        "emissiveTexture": info(2, 3),
        "emissiveFactor": [1.0, 1.0, 1.0],
    }
    material["pbrMetallicRoughness"]["metallicRoughnessTexture"] = info(2, 3)
    scene = load(tmp_path, content([material]))
    for lost in ("a map", "emission"):
        assert f"1 material with {lost} on other texture coordinates drawn and saved without it" in scene.report.notes
    nf.lod.export(scene, tmp_path / "written.glb", view=FOV)
    document, _ = decode(tmp_path / "written.glb")
    (written,) = document["materials"]
    assert "extensions" not in written["pbrMetallicRoughness"]["baseColorTexture"]
    assert "extensions" not in written["occlusionTexture"]
    assert "emissiveTexture" not in written
    assert "metallicRoughnessTexture" not in written["pbrMetallicRoughness"]
    stated = written["normalTexture"]["extensions"][TRANSFORM]
    assert document["extensionsUsed"] == [TRANSFORM]
    for uv in SETS[1]:
        np.testing.assert_allclose(transform_uv(transform_uv(uv, one), stated), transform_uv(uv, other), atol=1e-6)
    again = nf.Scene.load(tmp_path / "written.glb")
    np.testing.assert_allclose(first_square(again), [transform_uv(uv, one) for uv in SETS[1]], atol=1e-6)


def test_without_a_base_colour_emission_or_the_first_map_supplies_coordinates(tmp_path: Path) -> None:
    moves: dict[str, Any] = {"scale": [2, 3], "offset": [1, 1]}
    glow = {"emissiveTexture": info(1, **moves), "normalTexture": info(1, 1, **moves), "emissiveFactor": [1.0] * 3}
    scene = load(tmp_path, content([glow]))
    np.testing.assert_allclose(first_square(scene), [transform_uv(uv, moves) for uv in SETS[1]], atol=1e-6)
    bumps = {"normalTexture": info(2, 1, **moves)}
    scene = load(tmp_path, content([bumps]))
    np.testing.assert_allclose(first_square(scene), SETS[2], atol=1e-6)
    nf.lod.export(scene, tmp_path / "written.glb", view=FOV)
    (written,) = decode(tmp_path / "written.glb")[0]["materials"]
    assert written["normalTexture"]["extensions"] == {TRANSFORM: moves}


@pytest.mark.parametrize(
    "transform",
    [
        {"offset": "abc"}, {"offset": [1]}, {"offset": [1, None]}, {"rotation": [1]}, {"rotation": True},
        {"scale": {}}, {"scale": [10**400, 1]}, {"texCoord": -1}, {"texCoord": 1.5}, {"rotation": float("nan")},
    ],
)  # fmt: skip
def test_entries_of_wrong_types_count_as_absent(tmp_path: Path, transform: dict[str, Any]) -> None:
    scene = load(tmp_path, content([base(**transform)]))
    np.testing.assert_allclose(first_square(scene), SETS[0], atol=1e-6)


@pytest.mark.parametrize("scale", [1e30, 1e300])
def test_huge_scales_are_drawn_without_an_error(tmp_path: Path, scale: float) -> None:
    scene = load(tmp_path, content([base(scale=[scale, scale])]))
    view = nf.Camera.look_at((0.5, 0.5, 1.2), (0.5, 0.5, 0), fov=FOV, size=(8, 8))
    assert np.isfinite(picture_of(scene, view)).all()


def test_compressed_ducks_look_like_the_plain_one() -> None:
    """Coordinates have 12 and 15 bits, and a transform; 3 and 6 bits would move edges by whole pixels."""
    folder = "wild/cesium-native/CesiumGltfReader/test/data/DucksMeshopt"
    view = nf.Camera.look_at((2.2, 1.6, 2.2), (0.1, 0.8, 0), fov=nf.Fov.symmetric(50, 1), size=(160, 160))
    plain = picture_of(nf.Scene.load(data(f"{folder}/Duck.glb")), view)
    for bits in (12, 15):
        packed = nf.Scene.load(data(f"{folder}/Duck-vp-{bits}-vt-{bits}-vn-{bits}.glb"))
        found = picture_of(packed, view)
        # The texture of the duck has hard edges around its eyes: few pixels may differ by more.
        assert np.quantile(np.abs(found - plain), 0.99) < 0.02
        assert np.abs(found - plain).mean() < 0.002
