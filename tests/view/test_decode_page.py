"""The page's worker in headless Chromium: its pictures compared with Pillow's, its maps with Python's."""

from __future__ import annotations

import base64
import json
import shutil
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._scene.srgb import to_linear
from nearfar.stream import _map_files as codec
from tests.support import need
from tests.support.bundled_scenes import NAMES
from tests.support.reader_cases import answer_of
from tests.support.web_cases import run

pytestmark = pytest.mark.slow

PAGE = Path(__file__).parent / "decoder"
LINEAR = to_linear(np.arange(256) / 255.0).astype(np.float32)


@pytest.fixture(scope="module")
def answer(bundles: dict[str, Path], tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    need("web")
    need("browser")
    pages = tmp_path_factory.mktemp("pages")
    for path in PAGE.iterdir():
        shutil.copy(path, pages)
    settings = ("--bundle", "--format=esm", "--log-level=warning")
    run("npx", "esbuild", "src/decode/worker.ts", *settings, f"--outfile={pages / 'worker.js'}")
    return answer_of("page.mjs", {"bundles": NAMES}, tmp_path_factory.mktemp("browser"), bundles, pages=pages)


def array(text: str, kind: str) -> NDArray[Any]:
    return np.frombuffer(base64.b64decode(text), kind)


def manifest_of(bundle: Path) -> dict[str, Any]:
    manifest: dict[str, Any] = json.loads((bundle / "manifest.json").read_text())
    return manifest


@pytest.mark.parametrize("name", NAMES)
def test_maps_equal_python_bit_for_bit(bundles: dict[str, Path], answer: dict[str, Any], name: str) -> None:
    bundle = nf.stream.open(bundles[name])
    size = manifest_of(bundles[name])["map"]["face_size"]
    maps = answer[name]["whole"]
    assert len(maps) == bundle.count + 1
    for ring, found in enumerate(maps):
        colors = array(found["color"], "u1").reshape(6, size, size, 4)
        expected = bundle.map(ring)
        # Linear values of codes are distinct, so these are Pillow's codes.
        np.testing.assert_array_equal(LINEAR[colors[..., :3]], expected.color)
        assert (colors[..., 3] == 255).all()
        if ring == 0:
            assert found["codes"] is None
        else:
            codes = array(found["codes"], "<u2").reshape(6, size, size)
            np.testing.assert_array_equal(bundle._layout.scale.ranges(codes), expected.range)


@pytest.mark.parametrize("name", NAMES)
def test_changed_tiles_turn_an_older_map_into_the_next(
    bundles: dict[str, Path], answer: dict[str, Any], name: str
) -> None:
    manifest = manifest_of(bundles[name])
    size, tile = manifest["map"]["face_size"], manifest["map"]["tile"]
    whole = [
        (array(found["color"], "u1").reshape(6, size, size, 4), array(found["codes"] or "", "<u2"))
        for found in answer[name]["whole"]
    ]
    assert answer[name]["changes"]
    for change in answer[name]["changes"]:
        since, ring = change["since"], change["ring"]
        tiles = array(change["tiles"], "<i4").astype(np.int64)
        assert (np.diff(tiles) > 0).all()
        colors, codes = whole[since][0].copy(), whole[since][1].reshape(6, size, size).copy()
        codec.put_tiles(colors, tiles, array(change["color"], "u1").reshape(-1, tile, tile, 4))
        codec.put_tiles(codes, tiles, array(change["codes"], "<u2").reshape(-1, tile, tile))
        np.testing.assert_array_equal(colors, whole[ring][0])
        np.testing.assert_array_equal(codes.ravel(), whole[ring][1])


@pytest.mark.parametrize("name", NAMES)
def test_textures_equal_pillow_byte_for_byte(bundles: dict[str, Path], answer: dict[str, Any], name: str) -> None:
    manifest = manifest_of(bundles[name])
    rings = [*manifest["regions"][0]["rings"], *([manifest["dynamic"]] if manifest["dynamic"] else [])]
    listed = {part for ring in rings for part in ring["parts"] if part.endswith(".webp")}
    found = answer[name]["images"]
    assert set(found) == listed
    assert bool(listed) == (name.split("-")[0] in ("room", "balls"))
    for file, image in found.items():
        with Image.open(bundles[name] / file) as opened:
            expected = np.asarray(opened.convert("RGBA"))
        texels = array(image["texels"], "u1").reshape(image["height"], image["width"], 4)
        # Fully transparent texels may have any colour.
        np.testing.assert_array_equal(texels[..., 3], expected[..., 3])
        seen = expected[..., 3] > 0
        np.testing.assert_array_equal(texels[seen], expected[seen])


@pytest.mark.parametrize("name", NAMES)
def test_damage_is_reported_and_the_worker_continues(answer: dict[str, Any], name: str) -> None:
    errors = answer[name]["errors"]
    assert errors["hash"].startswith("files/")
    assert "expected SHA-256" in errors["hash"]
    assert "bytes, as the manifest lists it" in errors["size"]
    assert "expected a WebP picture" in errors["picture"]
    assert "expected a GLB" in errors["glb"]
    assert "before the first map" in errors["order"]
