"""Other programs read bundles: glTF's validator, trimesh, meshoptimizer, three.js, 3d-tiles-renderer and Pillow."""

from __future__ import annotations

import base64
import io
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray
from PIL import Image
from scipy.spatial.transform import Rotation
from trimesh.resolvers import FilePathResolver

import nearfar as nf
from nearfar._base import glb
from nearfar._scene.budget import Budget
from nearfar._scene.gltf.buffers import Buffers
from nearfar._scene.srgb import to_srgb
from tests.support import need, valid
from tests.support.bundled_scenes import NAMES, SCENES, bundled_scenes, export_all, farthest
from tests.support.reader_cases import in_browser, node

pytestmark = pytest.mark.slow

VIEWS: dict[str, dict[str, Any]] = {
    "city": {"eye": (9.0, 30.0, 40.0), "target": (0.0, 5.0, -20.0)},
    "room": {"eye": (1.8, 2.2, 1.9), "target": (-1.0, 0.6, -1.0)},
    "balls": {"eye": (3.0, 5.0, 15.0), "target": (0.0, 0.5, 0.0)},
}
SIZE, ANGLE = (320, 200), 60.0


@pytest.fixture(scope="module")
def scenes() -> dict[str, nf.Scene]:
    return bundled_scenes()


@pytest.fixture(scope="module")
def bundles(scenes: dict[str, nf.Scene], tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    return export_all(scenes, tmp_path_factory.mktemp("bundles"))


@pytest.fixture(scope="module")
def page(bundles: dict[str, Path], tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    need("browser")
    views = {name: VIEWS[name.split("-")[0]] | {"size": SIZE, "angle": ANGLE} for name in NAMES}
    return in_browser(bundles, views, tmp_path_factory.mktemp("browser"))


def glbs(bundle: Path) -> list[Path]:
    return sorted((bundle / "files").glob("*.glb"))


def manifest_of(bundle: Path) -> dict[str, Any]:
    manifest: dict[str, Any] = json.loads((bundle / "manifest.json").read_text())
    return manifest


# geometry ------------------------------------------------------------------------------------------------------------
def test_the_gltf_validator_finds_no_errors_in_bundles(bundles: dict[str, Path]) -> None:
    need("node")
    paths = [path for bundle in bundles.values() for path in glbs(bundle)]
    reports = node("validate.mjs", paths)
    assert len(reports) == len(paths)
    remarks = set()
    for path, report in reports.items():
        found = [message for message in report["messages"] if message["severity"] < 2]
        assert not found, f"{path}: {found[:3]}"
        assert not report["truncated"]
        remarks |= {message["code"] for message in report["messages"]}
    # It knows neither extension, so it reports data that only they use as unused, and notes every URI in a GLB.
    assert remarks <= {"UNSUPPORTED_EXTENSION", "UNUSED_OBJECT", "URI_GLB"}


def test_the_validator_detects_errors(bundles: dict[str, Path], tmp_path: Path) -> None:
    need("node")
    data = glbs(bundles["balls-plain"])[0].read_bytes()
    path = tmp_path / "damaged.glb"
    path.write_bytes(data.replace(b'"componentType":5126', b'"componentType":5122', 1))
    assert node("validate.mjs", [path])[str(path)]["numErrors"] > 0


def test_meshoptimizers_decoder_returns_our_bytes(bundles: dict[str, Path]) -> None:
    need("node")
    paths = [path for name, bundle in bundles.items() if name.endswith("packed") for path in glbs(bundle)]
    decoded = node("decode.mjs", paths)
    filters = set()
    for path in paths:
        document, end = glb.header(path.read_bytes())
        binary = glb.binary(path.read_bytes(), end)
        buffers = Buffers(document, binary, FilePathResolver(path), Budget())
        streams = {
            number: view["extensions"]["EXT_meshopt_compression"]
            for number, view in enumerate(document.get("bufferViews", []))
            if "EXT_meshopt_compression" in view.get("extensions", {})
        }
        for (number, stream), text in zip(streams.items(), decoded[str(path)], strict=True):
            blobs = (buffers.blob(number), base64.b64decode(text))
            ours, theirs = (np.frombuffer(blob, np.int8).astype(np.int16) for blob in blobs)
            # Decoders of the octahedral filter use the CPU's estimate of 1/√x: normals differ by a step.
            steps = 1 if stream.get("filter") == "OCTAHEDRAL" else 0
            np.testing.assert_allclose(ours, theirs, rtol=0, atol=steps)
        filters |= {(stream["mode"], stream.get("filter")) for stream in streams.values()}
    expected = {("ATTRIBUTES", None), ("ATTRIBUTES", "EXPONENTIAL"), ("ATTRIBUTES", "OCTAHEDRAL"), ("TRIANGLES", None)}
    assert filters == expected


def test_trimesh_loads_plain_files(bundles: dict[str, Path]) -> None:
    for path in [path for name, bundle in bundles.items() if name.endswith("plain") for path in glbs(bundle)]:
        found = np.concatenate([mesh.triangles for mesh in trimesh.load_scene(path, process=False).dump()])
        ours = nf.Scene.load(path)
        expected = ours.triangles() + ours.origin
        # Our copies are placed in float32: half a step of it at 9 km.
        assert farthest(found, expected) < 2.0**-10


@pytest.mark.parametrize("name", NAMES)
def test_three_js_loads_every_file(bundles: dict[str, Path], page: dict[str, Any], name: str) -> None:
    files = page[name]["files"]
    assert set(files) == {f"files/{path.name}" for path in glbs(bundles[name])}
    for uri, found in files.items():
        ours = nf.Scene.load(bundles[name] / uri)
        assert found["triangles"] == ours.triangle_count
        np.testing.assert_allclose(found["bounds"], ours.bounds, atol=2.0**-10)
    dynamic = manifest_of(bundles[name])["dynamic"]
    if dynamic is not None:
        assert {row["object"] for row in dynamic["instances"]} <= set(files[dynamic["geometry"]]["names"])
    images = sum(found["images"] for found in files.values())
    assert (images > 0) == (name.split("-")[0] in ("room", "balls"))


# tilesets ------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", NAMES)
def test_3d_tiles_renderer_shows_all_tiles(bundles: dict[str, Path], page: dict[str, Any], name: str) -> None:
    found = page[name]
    tileset = json.loads((bundles[name] / "tileset.json").read_text())
    by_uri = {tile["content"]["uri"]: tile["extras"] for tile in tileset["root"]["children"]}
    assert found["errors"] == []
    assert sorted(found["visible"]) == sorted(by_uri)
    assert {tile["uri"]: tile["extras"] for tile in found["tiles"]} == by_uri
    for tile in found["tiles"]:
        # The viewer has rotated the content: z is up.
        middle, half = np.array(tile["box"][:3]), np.diag(np.reshape(tile["box"][3:], (3, 3)))
        least, most = np.array(tile["bounds"])
        assert (least > middle - half).all()
        assert (most < middle + half).all()


@pytest.mark.parametrize("name", NAMES)
def test_the_tileset_has_the_pixels_of_the_near_geometry(
    scenes: dict[str, nf.Scene], page: dict[str, Any], name: str
) -> None:
    kind = name.split("-")[0]
    rings = nf.stream.assign(scenes[kind], **SCENES[kind])
    near = scenes[kind].subset(objects=[name for ring in range(rings.count + 1) for name in rings.objects(ring)])
    camera = camera_of(VIEWS[kind])
    frame = nf.render(near, camera, samples=1, channels=("range", "albedo", "shading_normal"))
    expected = np.isfinite(frame.require("range"))
    lit, color, normal = (picture_of(page[name]["pictures"][shown]) for shown in ("lit", "color", "normal"))
    covered = color[..., 3] > 127
    assert 0.1 < expected.mean() < 0.999, "a view that tells"
    # Pixels on silhouettes may differ.
    assert (covered != expected).mean() < 0.002
    both = covered & expected
    # Images are filtered differently, and a step of colour may fall on either side of a pixel's centre.
    differences = np.abs(color[..., :3] - 255.0 * to_srgb(frame.require("albedo")))[both].max(axis=1)
    assert np.median(differences) < 1
    assert (differences > 32).mean() < 0.01
    assert lit[both][:, :3].mean() > 0.5 * color[both][:, :3].mean()
    # Normals towards the camera, in its axes.
    turned = frame.require("shading_normal") @ rotation_of(camera)
    cosines = np.einsum("ni,ni->n", normal[both][:, :3] / 127.5 - 1, turned[both])
    assert np.median(cosines) > np.cos(np.radians(1))
    assert (cosines < 0.9).mean() < 0.005


def camera_of(view: dict[str, Any]) -> nf.Camera:
    aspect = SIZE[0] / SIZE[1]
    across = np.degrees(2 * np.arctan(np.tan(np.radians(ANGLE) / 2) * aspect))
    return nf.Camera.look_at(view["eye"], view["target"], fov=nf.Fov.symmetric(float(across), aspect), size=SIZE)


def rotation_of(camera: nf.Camera) -> NDArray[np.float64]:
    """(3, 3) matrix whose columns are the camera's axes."""
    return np.asarray(Rotation.from_quat(camera.orientation).as_matrix())


def picture_of(url: str) -> NDArray[np.float64]:
    data = base64.b64decode(url.removeprefix("data:image/png;base64,"))
    return np.array(Image.open(io.BytesIO(data)).convert("RGBA"), np.float64)


# pictures and documents ----------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", NAMES)
def test_pillow_loads_every_image(bundles: dict[str, Path], name: str) -> None:
    manifest = manifest_of(bundles[name])
    size, tile, across = (manifest["map"][key] for key in ("face_size", "tile", "across"))
    first, *later = [ring["map"] for ring in manifest["regions"][0]["rings"]]
    sizes = dict.fromkeys(first["color"], (size, size))
    sizes |= {
        found["color"]: (across * tile, -(-len(found["tiles"]) // across) * tile) for found in later if found["color"]
    }
    images = [file for file in manifest["files"] if file.endswith(".webp")]
    assert set(sizes) <= set(images)
    for file in images:
        with Image.open(bundles[name] / file) as image:
            image.load()
            assert image.format == "WEBP"
            assert image.mode in ("RGB", "RGBA")
            assert image.size == sizes.get(file, image.size)


@pytest.mark.parametrize("name", NAMES)
def test_documents_fit_their_schemas(bundles: dict[str, Path], name: str) -> None:
    assert valid(manifest_of(bundles[name]), "bundle")
    assert valid(json.loads((bundles[name] / "tileset.json").read_text()), "tileset")
