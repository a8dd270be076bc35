"""Tests of frames: colour codes, lossless files, and errors."""

from __future__ import annotations

import pickle
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PIL import Image

import nearfar as nf
from nearfar import _core
from nearfar._base import exr
from nearfar._camera.camera import Projection
from nearfar._render.channels import CHANNELS
from tests.support import valid

CAMERA = nf.Camera((1, 2, 3), (0.5, 0.5, -0.5, 0.5), fov=nf.Fov(-1, 0.5, -0.3, 0.7), size=(37, 21))


def full(camera: nf.Camera = CAMERA) -> nf.Frame:
    width, height = camera.size
    count = width * height
    noise = np.sin(np.arange(3 * count, dtype=np.float32) ** 2).reshape(height, width, 3)
    distance = np.abs(noise[..., 0]) * 1e5
    distance[0, 0] = np.inf
    position = noise * 1e3
    position[0, 0] = np.nan
    ids = np.arange(count).reshape(height, width) - 1
    return nf.Frame(
        camera,
        (0.1, -2e7, 3.0),
        color=np.abs(noise),
        range=distance.astype(np.float32),
        object_id=ids.astype(np.int32),
        face_id=ids.astype(np.int64) * 12_345_678_901,
        position=position.astype(np.float32),
        normal=noise,
        albedo=np.abs(noise[::-1]).copy(),
        shading_normal=noise[:, ::-1].copy(),
        coverage=np.abs(noise[..., 2]).copy(),
        motion=noise[..., :2].copy(),
    )


def test_images_have_the_nearest_srgb_code() -> None:
    linear = np.linspace(-0.1, 1.2, CAMERA.width * CAMERA.height * 3, dtype=np.float32)
    frame = nf.Frame(CAMERA, color=linear.reshape(CAMERA.height, CAMERA.width, 3))
    x = np.clip(linear.astype(np.float64), 0, 1)
    code = 255 * np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055)
    image = frame.to_image()
    assert image.dtype == np.uint8
    assert image.shape == (CAMERA.height, CAMERA.width, 3)
    # The nearest code, up to float32's rounding of it: 255 · 2⁻²³.
    assert np.abs(image.ravel() - code).max() <= 0.5 + 4e-5


def test_png_files_contain_the_image(tmp_path: Path) -> None:
    frame = full()
    frame.save(tmp_path / "a.png")
    np.testing.assert_array_equal(np.asarray(Image.open(tmp_path / "a.png")), frame.to_image())
    assert [file.name for file in tmp_path.iterdir()] == ["a.png"]


PROJECTIONS: list[Projection] = [nf.Fov(-1, 0.1, -0.2, 0.3), nf.Orthographic(-5, 6, -7, 8), nf.CubeFace(3)]


@pytest.mark.parametrize("projection", PROJECTIONS)
def test_exr_files_load_bit_for_bit(tmp_path: Path, projection: Projection) -> None:
    frame = full(nf.Camera((1e-3, 1 / 3, 1e9), CAMERA.orientation, fov=projection, size=(16, 16)))
    frame.save(tmp_path / "a.EXR")
    back = nf.Frame.load(tmp_path / "a.EXR")
    assert (back.camera, back.origin, back.channels) == (frame.camera, frame.origin, CHANNELS)
    for name in CHANNELS:
        before, after = frame.require(name), back.require(name)
        assert before.dtype == after.dtype
        assert before.tobytes() == after.tobytes(), name


@pytest.mark.parametrize("name", CHANNELS)
def test_each_channel_can_be_saved_alone(tmp_path: Path, name: str) -> None:
    image = full().require(name)
    images: dict[str, Any] = {name: image}
    nf.Frame(CAMERA, (0.0, 0.0, 0.0), **images).save(tmp_path / "a.exr")
    back = nf.Frame.load(tmp_path / "a.exr")
    assert back.channels == (name,)
    np.testing.assert_array_equal(back.require(name), image)


@pytest.mark.parametrize("projection", PROJECTIONS)
def test_the_header_fits_its_schema(tmp_path: Path, projection: Projection) -> None:
    full(nf.Camera((1, 2, 3), fov=projection, size=(8, 8))).save(tmp_path / "a.exr")
    document, _ = exr.read(tmp_path / "a.exr", "frame", 1)
    assert valid(document, "frame")
    assert not valid(document | {"camera": {}}, "frame")


def test_errors_about_missing_channels_suggest_a_remedy(tmp_path: Path) -> None:
    frame = nf.Frame(CAMERA, range=full().range)
    with pytest.raises(ValueError, match=r"no color: render it with channels=\('color', 'range'\)"):
        frame.to_image()
    with pytest.raises(ValueError, match="no color"):
        frame.save(tmp_path / "a.png")
    with pytest.raises(ValueError, match="no images"):
        nf.Frame(CAMERA).save(tmp_path / "a.exr")
    assert not list(tmp_path.iterdir())


def test_invalid_paths_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"\.png or \.exr, got '.*a\.jpg'"):
        full().save(tmp_path / "a.jpg")
    with pytest.raises(ValueError, match=r"\.png or \.exr"):
        full().save(tmp_path / "png")
    for name in ("a.png", "a.exr"):
        with pytest.raises(OSError, match="nowhere"):
            full().save(tmp_path / "nowhere" / name)


def test_shapes_must_fit_the_camera() -> None:
    with pytest.raises(ValueError, match=r"range: expected shape \(21, 37\)"):
        nf.Frame(CAMERA, range=np.zeros((37, 21), np.float32))
    with pytest.raises(ValueError, match=r"color: expected shape \(21, 37, 3\)"):
        nf.Frame(CAMERA, color=np.zeros((21, 37), np.float32))


def test_files_that_are_no_frames_are_refused(tmp_path: Path) -> None:
    good, bad = tmp_path / "good.exr", tmp_path / "bad.exr"
    full().save(good)
    data = good.read_bytes()
    for wrong in (b"", b"no image", data[: len(data) // 2], data[:8]):
        bad.write_bytes(wrong)
        with pytest.raises(nf.FormatError, match=r"bad\.exr"):
            nf.Frame.load(bad)
    bad.write_bytes(_core.encode_exr([("frame", {"R": np.zeros((2, 2), np.float32)}, {})]).data)
    with pytest.raises(nf.FormatError, match=r"bad\.exr: expected a nearfar\.frame"):
        nf.Frame.load(bad)
    document, parts = exr.read(good, "frame", 1)
    exr.write(bad, parts, document | {"version": 2})
    with pytest.raises(nf.FormatError, match="version 2"):
        nf.Frame.load(bad)
    exr.write(bad, parts, document | {"camera": {}})
    with pytest.raises(nf.FormatError, match=r"bad\.exr: damaged frame"):
        nf.Frame.load(bad)
    with pytest.raises(FileNotFoundError):
        nf.Frame.load(tmp_path / "absent.exr")


def test_exr_parts_of_all_types_load_in_order(tmp_path: Path) -> None:
    images: dict[str, np.ndarray] = {
        "half": np.linspace(0, 7, 12, dtype=np.float16).reshape(3, 4),
        "float": np.array([[np.inf, -0.0, 1e-45, np.finfo(np.float32).max]] * 3, np.float32),
        "unsigned": np.array([[0, 1, 2**31, 2**32 - 1]] * 3, np.uint32),
    }
    parts = dict.fromkeys(("pz", "nx", "only"), images)
    exr.write(tmp_path / "a.exr", parts, {"format": "nearfar.test", "version": 1, "center": [1, 2, 3]})
    document, back = exr.read(tmp_path / "a.exr", "test", 1)
    assert document["center"] == [1, 2, 3]
    assert list(back) == list(parts)
    for channels in back.values():
        for name, image in images.items():
            assert channels[name].dtype == image.dtype
            assert channels[name].tobytes() == image.tobytes()


def test_images_that_openexr_cannot_hold_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "a.exr"
    with pytest.raises(TypeError, match="float16, float32 or uint32 for 'a'"):
        exr.write(path, {"p": {"a": np.zeros((2, 2))}}, {})
    with pytest.raises(ValueError, match="'b' differs in shape"):
        exr.write(path, {"p": {"a": np.zeros((2, 2), np.float32), "b": np.zeros((2, 3), np.float32)}}, {})
    with pytest.raises(ValueError, match="at least one image"):
        exr.write(path, {"p": {}}, {})
    with pytest.raises(ValueError, match="ASCII"):
        exr.write(path, {"пример": {"a": np.zeros((2, 2), np.float32)}}, {})
    assert not list(tmp_path.iterdir())


def test_counts_of_a_frame_are_read_only_and_pickled(tmp_path: Path) -> None:
    counts = {"frame_triangles": 5}
    frame = nf.Frame(CAMERA, color=np.zeros((21, 37, 3), np.float32), stats=counts)
    counts["frame_triangles"] = 6
    with pytest.raises(TypeError):
        frame.stats["frame_triangles"] = 7  # type: ignore[index]
    again = pickle.loads(pickle.dumps(frame))
    assert frame.stats == again.stats == {"frame_triangles": 5}
    with pytest.raises(TypeError):
        again.stats["frame_triangles"] = 7
    frame.save(tmp_path / "a.exr")
    assert nf.Frame.load(tmp_path / "a.exr").stats == {}
