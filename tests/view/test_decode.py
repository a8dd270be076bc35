"""The page's decoding of bundles, in Node, compared with nearfar's own readers."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from trimesh.resolvers import FilePathResolver

import nearfar as nf
from nearfar._base import glb
from nearfar._scene.budget import Budget
from nearfar._scene.gltf.buffers import Buffers
from tests.support import need
from tests.support.bundled_scenes import NAMES, farthest
from tests.support.web_cases import run

pytestmark = pytest.mark.slow

TYPES = {"Float32Array": "<f4", "Uint16Array": "<u2", "Uint32Array": "<u4"}
WIDTHS = {"positions": 3, "normals": 3, "uvs": 2, "colors": 4, "indices": 1, "placements": 12}


@pytest.fixture(scope="module")
def decoded(bundles: dict[str, Path], tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    """Pieces of geometry by bundle and file, written by a unit test. All other unit tests run, too."""
    need("web")
    tests = tmp_path_factory.mktemp("web") / "tests"
    run("node", "build.mjs", "--tests", str(tests))
    run("node", str(tests / "all.mjs"), NEARFAR_BUNDLES=os.pathsep.join(map(str, bundles.values())))
    return {name: pieces_of(bundle) for name, bundle in bundles.items()}


def pieces_of(bundle: Path) -> dict[str, list[dict[str, Any]]]:
    files = json.loads(bundle.with_name(f"{bundle.name}.geometry.json").read_text())
    data = bundle.with_name(f"{bundle.name}.geometry.bin").read_bytes()
    for piece in (piece for pieces in files.values() for piece in pieces):
        for name, width in WIDTHS.items():
            place = piece[name]
            if place is not None:
                rows = np.frombuffer(data, TYPES[place["type"]], place["count"], place["start"])
                piece[name] = rows.reshape(-1, width)
    return dict(files)


def geometry_of(bundle: Path) -> list[tuple[str, bool]]:
    """Names of the GLB files, and whether each has the dynamic objects."""
    manifest = json.loads((bundle / "manifest.json").read_text())
    rings = [(ring["geometry"], False) for ring in manifest["regions"][0]["rings"] if ring["geometry"]]
    return rings + ([(manifest["dynamic"]["geometry"], True)] if manifest["dynamic"] else [])


def center_of(bundle: Path) -> NDArray[np.float64]:
    return np.array(json.loads((bundle / "manifest.json").read_text())["regions"][0]["center"])


@pytest.mark.parametrize("name", NAMES)
def test_triangles_equal_our_loader(bundles: dict[str, Path], decoded: dict[str, Any], name: str) -> None:
    assert set(decoded[name]) == {file for file, _ in geometry_of(bundles[name])}
    for file, pieces in decoded[name].items():
        found = []
        for piece in pieces:
            corners = piece["positions"][piece["indices"][:, 0]].astype(np.float64)
            placements = np.eye(4)[None, :3] if piece["placements"] is None else piece["placements"].reshape(-1, 3, 4)
            placed = np.einsum("nij,vj->nvi", placements[..., :3], corners) + placements[:, None, :, 3]
            found.append(placed.reshape(-1, 3, 3))
        ours = nf.Scene.load(bundles[name] / file)
        expected = ours.triangles() + ours.origin - center_of(bundles[name])
        # Float32 at 9 km, as in our own copies.
        assert farthest(np.concatenate(found), expected) < 2.0**-10


@pytest.mark.parametrize("name", NAMES)
def test_arrays_equal_the_files(bundles: dict[str, Path], decoded: dict[str, Any], name: str) -> None:
    kinds = set()
    for file, is_dynamic in geometry_of(bundles[name]):
        path = bundles[name] / file
        document, end = glb.header(path.read_bytes())
        buffers = Buffers(document, glb.binary(path.read_bytes(), end), FilePathResolver(path), Budget())
        offset = np.array(document["nodes"][0].get("translation", (0.0, 0.0, 0.0))) - center_of(bundles[name])
        expected = expected_pieces(document, is_dynamic)
        assert len(decoded[name][file]) == len(expected)
        for piece, (object_name, primitive) in zip(decoded[name][file], expected, strict=True):
            assert piece["name"] == object_name
            assert piece["material"] == expected_material(document, primitive["material"])
            numbers = {"indices": primitive["indices"], **with_array_names(primitive["attributes"])}
            kinds |= set(numbers)
            assert {key for key in WIDTHS if piece[key] is not None} - {"placements"} == set(numbers)
            for key, number in numbers.items():
                rows = buffers.raw(number)
                if key == "positions" and piece["placements"] is None:
                    rows = (rows + offset).astype(np.float32)
                if key == "normals":
                    unit = buffers.fractions(number, rows).astype(np.float64)
                    unit /= np.linalg.norm(unit, axis=1, keepdims=True)
                    # Decoders of the octahedral filter use the CPU's estimate of 1/√x: rows differ by a step.
                    step = 0.0 if rows.dtype.kind == "f" else 2.0 / np.iinfo(rows.dtype).max
                    np.testing.assert_allclose(piece[key], unit, rtol=0, atol=step + 1e-7)
                else:
                    np.testing.assert_array_equal(piece[key], rows)
    expected_kinds = {"city": {"colors"}, "room": {"uvs"}, "balls": {"uvs", "normals"}}[name.split("-")[0]]
    assert kinds >= expected_kinds | {"positions", "indices"}


def expected_pieces(document: dict[str, Any], is_dynamic: bool) -> list[tuple[str, dict[str, Any]]]:
    """Names and primitives, by mesh: a piece for all static nodes that show it, one for each dynamic node."""
    names: dict[int, list[str]] = {}
    for node in document["nodes"][1:]:
        names.setdefault(node["mesh"], []).append(node.get("name", ""))
    return [
        (object_name, primitive)
        for mesh, own in names.items()
        for primitive in document["meshes"][mesh]["primitives"]
        for object_name in (own if is_dynamic else own[:1])
    ]


def with_array_names(attributes: dict[str, int]) -> dict[str, int]:
    keys = {"POSITION": "positions", "NORMAL": "normals", "TEXCOORD_0": "uvs", "COLOR_0": "colors"}
    return {keys[name]: number for name, number in attributes.items()}


def expected_material(document: dict[str, Any], number: int) -> dict[str, Any]:
    entry = document["materials"][number]
    surface, extensions = entry["pbrMetallicRoughness"], entry.get("extensions", {})

    def image(info: dict[str, int] | None) -> str | None:
        if info is None:
            return None
        texture = document["textures"][info["index"]]
        return "files/" + str(document["images"][texture["extensions"]["EXT_texture_webp"]["source"]]["uri"])

    def sampler(info: dict[str, int] | None) -> list[int]:
        texture = {} if info is None else document["textures"][info["index"]]
        stated = document["samplers"][texture["sampler"]] if "sampler" in texture else {}
        return [stated.get("wrapS", 10497), stated.get("wrapT", 10497), stated.get("magFilter", 9729)]

    strength = extensions.get("KHR_materials_emissive_strength", {}).get("emissiveStrength", 1)
    return {
        "color": surface["baseColorFactor"],
        "image": image(surface.get("baseColorTexture")),
        "imageSampler": sampler(surface.get("baseColorTexture")),
        "cutoff": entry["alphaCutoff"] if entry.get("alphaMode") == "MASK" else None,
        "emission": [strength * part for part in entry["emissiveFactor"]] if "emissiveFactor" in entry else None,
        "glow": image(entry.get("emissiveTexture")),
        "glowSampler": sampler(entry.get("emissiveTexture")),
        "isUnlit": "KHR_materials_unlit" in extensions,
    }


@pytest.mark.parametrize("name", NAMES)
def test_ranges_equal_python_bit_for_bit(bundles: dict[str, Path], decoded: dict[str, Any], name: str) -> None:
    assert decoded[name]
    bundle = nf.stream.open(bundles[name])
    size = bundle.map(1).face_size
    assert bundle.count >= 2
    for ring in range(1, bundle.count + 1):
        codes = np.fromfile(bundles[name].with_name(f"{name}.{ring}.u16"), "<u2").reshape(6, size, size)
        np.testing.assert_array_equal(bundle._layout.scale.ranges(codes), bundle.map(ring).range)
