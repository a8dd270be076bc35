"""Tests of colours as WebP: exact if lossless, and equal in Python, Node and a browser."""

from __future__ import annotations

import base64
import io
import json
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from nearfar._base import webp
from nearfar._base.errors import UnusableError
from nearfar.orthoview import _webp
from tests.support import need
from tests.support.reader_cases import SECONDS, answer_of, node

CHECKOUT = Path(__file__).resolve().parents[2]
PLACE = (1, 2, 3)
SIZE = 32


def waves(size: int = SIZE) -> NDArray[np.uint8]:
    """A picture that changes smoothly, as photographs do."""
    place = np.linspace(0, 3, size)
    x, y = np.meshgrid(place, place)
    values = np.stack([np.sin(2 * x + y), np.cos(x - y), np.sin(3 * y)], axis=-1)
    codes: NDArray[np.uint8] = np.rint(127 + 90 * values).astype(np.uint8)
    return codes


def noise(size: int = SIZE) -> NDArray[np.uint8]:
    return np.random.default_rng(2).integers(0, 256, (size, size, 3)).astype(np.uint8)


def disc(size: int = SIZE) -> NDArray[np.bool_]:
    place = np.linspace(-1, 1, size)
    inside: NDArray[np.bool_] = place[:, None] ** 2 + place**2 < 0.6
    return inside


def squared(one: NDArray[np.uint8], other: NDArray[np.uint8]) -> float:
    return float(((one.astype(float) - other) ** 2).mean())


# Files ---------------------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("picture", [waves(), noise(), np.zeros((4, 4, 3), np.uint8)])
def test_lossless_files_keep_every_value(picture: NDArray[np.uint8]) -> None:
    data = _webp.encode(picture[None])
    np.testing.assert_array_equal(_webp.decode(data, len(picture)), picture[None])
    # The mask of visible pixels does not affect lossless files.
    assert _webp.encode(picture[None], filled=np.zeros((1, *picture.shape[:2]), bool)) == data


def test_lossy_files_are_close_and_better_qualities_closer() -> None:
    picture = waves(64)[None]
    files = [_webp.encode(picture, quality) for quality in (10, 60, 95)]
    errors = [squared(_webp.decode(data, 64), picture) for data in files]
    assert errors[0] > 2 * errors[2] > 0
    assert errors[2] < 5.0
    assert len(files[0]) < len(files[1]) < len(files[2]) < len(_webp.encode(picture))


def test_unseen_black_does_not_bleed_into_visible_pixels() -> None:
    """An empty second layer stays black."""
    seen = np.stack([disc(64), np.zeros((64, 64), bool)])
    picture = np.where(seen[..., None], waves(64), 0).astype(np.uint8)
    plain, filled = _webp.encode(picture, 80), _webp.encode(picture, 80, seen)
    errors = [squared(_webp.decode(data, 64, 2)[seen], picture[seen]) for data in (plain, filled)]
    assert errors[1] < 0.5 * errors[0]
    assert len(filled) < 0.8 * len(plain)
    assert _webp.decode(filled, 64, 2)[1, 16:].max() < 4


def test_unseen_pixels_have_the_mean_of_the_smallest_non_empty_block() -> None:
    size = 24
    rng = np.random.default_rng(4)
    picture = rng.integers(0, 256, (size, size, 3)).astype(np.float32)
    seen = rng.random((size, size)) < 0.05
    seen[8:16, 8:16] = False

    def mean(row: int, column: int, side: int) -> NDArray[np.float64] | None:
        """Means of the quarters' means, so that densely visible places do not count more than others."""
        if side == 1:
            return picture[row, column].astype(np.float64) if seen[row, column] else None
        half = side // 2
        quarters = [mean(row + down, column + right, half) for down in (0, half) for right in (0, half)]
        found = [quarter for quarter in quarters if quarter is not None]
        return np.mean(found, axis=0) if found else None

    # 24 pixels are 3 × 3 blocks of 8, beyond which all pixels count.
    tops = [found for row in (0, 8, 16) for column in (0, 8, 16) if (found := mean(row, column, 8)) is not None]
    expected = np.zeros((size, size, 3))
    for row, column in np.ndindex(size, size):
        blocks = (mean(row // side * side, column // side * side, side) for side in (1, 2, 4, 8))
        nearest = next((found for found in blocks if found is not None), None)
        expected[row, column] = np.mean(tops, axis=0) if nearest is None else nearest
    assert len(tops) == 8
    np.testing.assert_allclose(webp.fill_unknown(picture[None], seen[None])[0], expected, rtol=1e-5)


def png() -> bytes:
    file = io.BytesIO()
    Image.fromarray(waves()).save(file, "png")
    return file.getvalue()


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "got something else"),
        (png(), "got something else"),
        (_webp.encode(waves()[None])[:200], "expected a WebP picture"),
        (_webp.encode(waves(SIZE + 4)[None]), "expected a picture of 32 × 32 pixels, got \\(36, 36\\)"),
    ],
)
def test_other_files_are_refused(data: bytes, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        _webp.decode(data, SIZE)


# Zarr ----------------------------------------------------------------------------------------------------------------
REST = np.arange(SIZE**2, dtype=np.uint32).view(np.uint8)
"""Other bytes of a view."""


def view_of(picture: NDArray[np.uint8]) -> NDArray[np.uint8]:
    return np.concatenate([picture.reshape(-1), REST])


def write(path: Path, picture: NDArray[np.uint8], quality: int | None = None) -> None:
    """A store with one array, sharded like a tree's, whose cell `PLACE` contains a view with a picture."""
    import zarr
    from zarr.codecs import Crc32cCodec
    from zarr.registry import register_codec

    from nearfar.orthoview._webp_codec import NAME, WebpViewCodec

    register_codec(NAME, WebpViewCodec)
    view = view_of(picture)
    zarr.create_group(str(path)).create_array(
        "views",
        shape=(4, 4, 4, *view.shape),
        chunks=(1, 1, 1, *view.shape),
        shards=(2, 2, 2, *view.shape),
        dtype="u1",
        fill_value=0,
        serializer=WebpViewCodec(SIZE, 1, quality),
        compressors=[Crc32cCodec()],
    )[PLACE] = view


def expected_view(picture: NDArray[np.uint8], quality: int | None) -> NDArray[np.uint8]:
    return view_of(_webp.decode(_webp.encode(picture[None], quality), SIZE))


def shard_in(path: Path) -> Path:
    return path / "views" / "c" / "0" / "1" / "1" / "0"


@pytest.mark.parametrize("quality", [None, 90])
def test_zarr_python_stores_views_with_webp(tmp_path: Path, quality: int | None) -> None:
    need("zarr")
    import zarr

    write(tmp_path / "store", waves(), quality)
    array = zarr.open_group(str(tmp_path / "store"), mode="r")["views"]
    np.testing.assert_array_equal(array[PLACE], expected_view(waves(), quality))
    assert (array[PLACE] == view_of(waves())).all() == (quality is None)
    assert not array[0, 0, 0].any()
    assert not array[1, 2, 2].any()
    document = json.loads((tmp_path / "store" / "views" / "zarr.json").read_text())
    described = {"name": "nearfar_webp_view", "configuration": {"size": SIZE, "layers": 1, "quality": quality}}
    assert document["codecs"][0]["configuration"]["codecs"] == [described, {"name": "crc32c"}]
    assert _webp.encode(waves()[None], quality) in shard_in(tmp_path / "store").read_bytes()


def test_wrong_data_and_qualities_are_refused() -> None:
    need("zarr")
    from nearfar.orthoview._webp_codec import WebpViewCodec

    for quality in (-1, 101):
        with pytest.raises(ValueError, match="quality: expected 0 to 100"):
            WebpViewCodec(SIZE, 1, quality)
    for chunk in (b"", b"123", bytes([1, 0, 0, 0]), bytes([255] * 8)):
        with pytest.raises(UnusableError, match="its image is longer than the chunk"):
            _webp.split(chunk)


def test_damaged_pictures_are_detected(tmp_path: Path) -> None:
    need("zarr")
    import zarr

    write(tmp_path / "store", waves())
    shard = shard_in(tmp_path / "store")
    content = bytearray(shard.read_bytes())
    content[content.index(b"WEBP") + 40] ^= 1
    shard.write_bytes(content)
    with pytest.raises(ValueError, match="checksum"):
        zarr.open_group(str(tmp_path / "store"), mode="r")["views"][PLACE]


READ = """
import sys, warnings
warnings.simplefilter("error")
import zarr
assert "nearfar" not in sys.modules
array = zarr.open_group(sys.argv[1], mode="r")["views"]
print(array[1, 2, 3].tobytes().hex(), type(array.metadata.codecs[0].codecs[0]).__module__)
"""


def test_plain_zarr_finds_the_codec_where_nearfar_is_installed(tmp_path: Path) -> None:
    need("zarr")
    write(tmp_path / "store", waves())
    about = tmp_path / "packages" / "ours-0.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: ours\nVersion: 0\n")
    with (CHECKOUT / "pyproject.toml").open("rb") as file:
        points = tomllib.load(file)["project"]["entry-points"]["zarr.codecs"]
    lines = "".join(f"{codec} = {place}\n" for codec, place in points.items())
    (about / "entry_points.txt").write_text(f"[zarr.codecs]\n{lines}")
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(about.parent), str(CHECKOUT / "python")])}
    command = [sys.executable, "-c", READ, str(tmp_path / "store")]
    process = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert process.returncode == 0, process.stderr
    view, module = process.stdout.split()
    assert bytes.fromhex(view) == view_of(waves()).tobytes()
    assert module == "nearfar.orthoview._webp_codec"


# zarrita -------------------------------------------------------------------------------------------------------------
@pytest.mark.slow
@pytest.mark.parametrize("quality", [None, 90])
def test_zarrita_decodes_the_same_in_node(tmp_path: Path, quality: int | None) -> None:
    need("zarr")
    need("node")
    write(tmp_path / "store", waves(), quality)
    answer = node("orthoviews.mjs", [tmp_path / "store", "views", "1,2,3", "views", "0,0,0"])
    first, missing = (base64.b64decode(read["bytes"]) for read in answer["read"])
    assert first == expected_view(waves(), quality).tobytes()
    assert missing == bytes(7 * SIZE * SIZE)


SHOW = """
import * as zarr from 'zarrita';

const group = await zarr.open.v3(new zarr.FetchStore(`${location.origin}/bundles/store`), { kind: 'group' });
const array = await zarr.open.v3(group.resolve('views'), { kind: 'array' });
const { data, shape } = await zarr.get(array, [1, 2, 3, null]);
await answer({ data: Array.from(data), shape });
"""


@pytest.mark.slow
def test_the_pages_browser_code_decodes_the_same(tmp_path: Path) -> None:
    need("zarr")
    need("browser")
    page = (CHECKOUT / "docs" / "orthoview.md").read_text(encoding="utf-8")
    (lines,) = (block for block in re.findall(r"```js\n(.*?)```", page, re.DOTALL) if "nearfar_webp_view" in block)
    write(tmp_path / "store", noise())
    for name in ("code", "profile"):
        (tmp_path / name).mkdir()
    (tmp_path / "code" / "read.mjs").write_text(lines + SHOW)
    folders = {"code": tmp_path / "code", "store": tmp_path / "store"}
    found = answer_of("bundles/code/read.mjs", {}, tmp_path / "profile", folders)
    assert found["shape"] == [7 * SIZE * SIZE]
    np.testing.assert_array_equal(np.array(found["data"]), view_of(noise()))
