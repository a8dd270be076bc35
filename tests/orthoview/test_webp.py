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
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from PIL import Image

from nearfar._base import webp
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
    data = _webp.encode(picture)
    np.testing.assert_array_equal(_webp.decode(data, len(picture)), picture)
    # The mask of visible pixels does not affect lossless files.
    assert _webp.encode(picture, filled=np.zeros(picture.shape[:2], bool)) == data


def test_lossy_files_are_close_and_better_qualities_closer() -> None:
    picture = waves(64)
    files = [_webp.encode(picture, quality) for quality in (10, 60, 95)]
    errors = [squared(_webp.decode(data, 64), picture) for data in files]
    assert errors[0] > 2 * errors[2] > 0
    assert errors[2] < 5.0
    assert len(files[0]) < len(files[1]) < len(files[2]) < len(_webp.encode(picture))


def test_unseen_black_does_not_bleed_into_visible_pixels() -> None:
    seen = disc(64)
    picture = np.where(seen[..., None], waves(64), 0).astype(np.uint8)
    plain, filled = _webp.encode(picture, 80), _webp.encode(picture, 80, seen)
    errors = [squared(_webp.decode(data, 64)[seen], picture[seen]) for data in (plain, filled)]
    assert errors[1] < 0.5 * errors[0]
    assert len(filled) < 0.8 * len(plain)


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
        (_webp.encode(waves())[:200], "expected a WebP picture"),
        (_webp.encode(waves(SIZE + 4)), "expected a picture of 32 × 32 pixels, got \\(36, 36\\)"),
    ],
)
def test_other_files_are_refused(data: bytes, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        _webp.decode(data, SIZE)


# Zarr ----------------------------------------------------------------------------------------------------------------
def write(path: Path, picture: NDArray[np.uint8], **settings: Any) -> None:
    """A store with one array, sharded like a tree's, whose cell `PLACE` contains a picture."""
    import zarr
    from zarr.codecs import Crc32cCodec
    from zarr.registry import get_codec_class, register_codec

    from nearfar.orthoview._webp_codec import NAME, WebpCodec

    try:
        get_codec_class(NAME)
    except KeyError:
        register_codec(NAME, WebpCodec)
    shape = picture.shape
    zarr.create_group(str(path)).create_array(
        "color",
        shape=(4, 4, 4, *shape),
        chunks=(1, 1, 1, *shape),
        shards=(2, 2, 2, *shape),
        dtype="u1",
        fill_value=0,
        serializer=WebpCodec(**settings),
        compressors=[Crc32cCodec()],
    )[PLACE] = picture


SETTINGS: list[dict[str, Any]] = [{}, {"level": 90, "lossless": False}]


@pytest.mark.parametrize("settings", SETTINGS)
def test_zarr_python_stores_pictures_as_webp(tmp_path: Path, settings: dict[str, Any]) -> None:
    need("zarr")
    import zarr

    picture = waves()
    write(tmp_path / "store", picture, **settings)
    array = zarr.open_group(str(tmp_path / "store"), mode="r")["color"]
    encoded = _webp.encode(picture, settings.get("level"))
    np.testing.assert_array_equal(array[PLACE], _webp.decode(encoded, SIZE))
    assert (array[PLACE] == picture).all() == (settings == {})
    assert not array[0, 0, 0].any()
    assert not array[1, 2, 2].any()
    document = json.loads((tmp_path / "store" / "color" / "zarr.json").read_text())
    described = {"name": "imagecodecs_webp", "configuration": settings or {"lossless": True}}
    assert document["codecs"][0]["configuration"]["codecs"] == [described, {"name": "crc32c"}]
    shard = tmp_path / "store" / "color" / "c" / "0" / "1" / "1" / "0" / "0" / "0"
    assert encoded in shard.read_bytes()


def test_data_that_is_no_picture_is_refused(tmp_path: Path) -> None:
    need("zarr")
    with pytest.raises(ValueError, match="expected a square picture of 3 × uint8"):
        write(tmp_path / "wide", np.ones((4, 8, 3), np.uint8))
    with pytest.raises(ValueError, match="expected a square picture of 3 × uint8"):
        write(tmp_path / "gray", np.ones((4, 4, 1), np.uint8))
    for level in (None, -1, 101):
        with pytest.raises(ValueError, match="level: expected 0 to 100"):
            write(tmp_path / f"level {level}", waves(), level=level, lossless=False)


def test_damaged_pictures_are_detected(tmp_path: Path) -> None:
    need("zarr")
    import zarr

    write(tmp_path / "store", waves())
    shard = tmp_path / "store" / "color" / "c" / "0" / "1" / "1" / "0" / "0" / "0"
    content = bytearray(shard.read_bytes())
    content[content.index(b"WEBP") + 40] ^= 1
    shard.write_bytes(content)
    with pytest.raises(ValueError, match="checksum"):
        zarr.open_group(str(tmp_path / "store"), mode="r")["color"][PLACE]


READ = """
import sys, warnings
warnings.simplefilter("error")
import zarr
assert "nearfar" not in sys.modules
array = zarr.open_group(sys.argv[1], mode="r")["color"]
print(array[1, 2, 3].tobytes().hex(), type(array.metadata.codecs[0].codecs[0]).__module__)
"""


def add_package(folder: Path, name: str, points: dict[str, str]) -> None:
    """Add a package with these codecs to a folder of packages."""
    about = folder / f"{name}-0.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 0\n")
    lines = "".join(f"{codec} = {place}\n" for codec, place in points.items())
    (about / "entry_points.txt").write_text(f"[zarr.codecs]\n{lines}")


def read_by_others(folder: Path, store: Path) -> list[str]:
    """Output of a program that knows only zarr, with our package and those of a folder installed."""
    with (CHECKOUT / "pyproject.toml").open("rb") as file:
        add_package(folder, "ours", tomllib.load(file)["project"]["entry-points"]["zarr.codecs"])
    environment = os.environ | {"PYTHONPATH": os.pathsep.join([str(folder), str(CHECKOUT / "python")])}
    command = [sys.executable, "-c", READ, str(store)]
    process = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert process.returncode == 0, process.stderr
    return process.stdout.split()


def test_plain_zarr_finds_the_codec_where_nearfar_is_installed(tmp_path: Path) -> None:
    need("zarr")
    write(tmp_path / "store", waves())
    picture, module = read_by_others(tmp_path / "packages", tmp_path / "store")
    assert bytes.fromhex(picture) == waves().tobytes()
    assert module == "nearfar.orthoview._webp_codec"


STAND_IN = """
import numpy as np
from zarr.abc.codec import ArrayBytesCodec

class Webp(ArrayBytesCodec):
    is_fixed_size = False

    @classmethod
    def from_dict(cls, data):
        assert data == {"name": "imagecodecs_webp", "configuration": {"lossless": True}}
        return cls()

    def compute_encoded_size(self, length, spec):
        assert False

    async def _decode_single(self, chunk, spec):
        return spec.prototype.nd_buffer.from_numpy_array(np.full(spec.shape, 7, "u1"))
"""


def test_the_codec_of_imagecodecs_has_priority_without_a_warning(tmp_path: Path) -> None:
    need("zarr")
    write(tmp_path / "store", waves())
    packages = tmp_path / "packages"
    (packages / "imagecodecs").mkdir(parents=True)
    (packages / "imagecodecs" / "__init__.py").write_text("")
    (packages / "imagecodecs" / "zarr.py").write_text(STAND_IN)
    add_package(packages, "theirs", {"imagecodecs_webp": "imagecodecs.zarr:Webp"})
    picture, module = read_by_others(packages, tmp_path / "store")
    assert set(bytes.fromhex(picture)) == {7}
    assert module == "imagecodecs.zarr"


# zarrita -------------------------------------------------------------------------------------------------------------
@pytest.mark.slow
@pytest.mark.parametrize("settings", SETTINGS)
def test_zarrita_decodes_the_same_in_node(tmp_path: Path, settings: dict[str, Any]) -> None:
    need("zarr")
    need("node")
    write(tmp_path / "store", waves(), **settings)
    answer = node("orthoviews.mjs", [tmp_path / "store", "color", "1,2,3", "color", "0,0,0"])
    first, missing = (base64.b64decode(read["bytes"]) for read in answer["read"])
    assert first == _webp.decode(_webp.encode(waves(), settings.get("level")), SIZE).tobytes()
    assert missing == bytes(3 * SIZE * SIZE)


SHOW = """
import * as zarr from 'zarrita';

const group = await zarr.open.v3(new zarr.FetchStore(`${location.origin}/bundles/store`), { kind: 'group' });
const array = await zarr.open.v3(group.resolve('color'), { kind: 'array' });
const { data, shape } = await zarr.get(array, [1, 2, 3, null, null, null]);
await answer({ data: Array.from(data), shape });
"""


@pytest.mark.slow
def test_the_pages_browser_code_decodes_the_same(tmp_path: Path) -> None:
    need("zarr")
    need("browser")
    page = (CHECKOUT / "docs" / "orthoview.md").read_text(encoding="utf-8")
    (lines,) = (block for block in re.findall(r"```js\n(.*?)```", page, re.DOTALL) if "imagecodecs_webp" in block)
    write(tmp_path / "store", noise())
    for name in ("code", "profile"):
        (tmp_path / name).mkdir()
    (tmp_path / "code" / "read.mjs").write_text(lines + SHOW)
    folders = {"code": tmp_path / "code", "store": tmp_path / "store"}
    found = answer_of("bundles/code/read.mjs", {}, tmp_path / "profile", folders)
    assert found["shape"] == [SIZE, SIZE, 3]
    np.testing.assert_array_equal(np.array(found["data"]).reshape(SIZE, SIZE, 3), noise())
