"""Support for tests of graphics adapters: adapters, views, and comparison of pictures."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._render import backend as backends
from nearfar._render.backend import Backend
from nearfar._scene.builder import SceneBuilder
from tests.support import need
from tests.support.render_cases import QUAD, noise, quad

ADAPTERS = ("vulkan", "gl")

RENDERED = (
    *("color", "range", "object_id", "face_id", "position"),
    *("normal", "albedo", "shading_normal", "coverage"),
)


@contextmanager
def adapter(name: str) -> Iterator[None]:
    """Select an adapter within a block; skips or fails as `need` does."""
    need(name)
    before = backends._selected
    nf.gpu.select(name)
    try:
        yield
    finally:
        nf.gpu.select(before)


@contextmanager
def backend_of(name: str) -> Iterator[Backend]:
    """Yield the `backend` that renders on the CPU ("cpu"), or on an adapter, which is selected within the block."""
    if name == "cpu":
        yield "cpu"
    else:
        with adapter(name):
            yield "gpu"


def view(eye: Any, target: Any, size: tuple[int, int] = (240, 160), fov: float = 80.0) -> nf.Camera:
    return nf.Camera.look_at(tuple(eye), tuple(target), fov=nf.Fov.symmetric(fov, size[0] / size[1]), size=size)


def edges(ids: NDArray[Any]) -> NDArray[np.bool_]:
    """Pixels with another face among their eight neighbours."""
    height, width = ids.shape
    around = np.pad(ids, 1, mode="edge")
    parts = [around[r : r + height, c : c + width] != ids for r in range(3) for c in range(3)]
    return np.asarray(np.any(parts, axis=0))


def agree(cpu: nf.Frame, gpu: nf.Frame, *, same: float = 0.999) -> NDArray[np.bool_]:
    """Compare frames of both back ends with all images; returns where they show the same face.

    Faces may differ where an edge passes a pixel's centre by 1/256 of a pixel or less, the precision of rasterisers;
    and where two faces have equal depth to six digits, because rounding decides which of them is nearer.
    Where they agree, ranges agree to 1e-5: both are within 5e-6 of float64 at the greatest slants in these views; those
    of parallel rays have the error of coordinates of some metres. Colour is compared in sRGB codes: the levels of
    textures follow from base-2 logarithms, which adapters may round in the fourth digit.
    """
    there, here = cpu.require("face_id"), gpu.require("face_id")
    equal = there == here
    assert equal.mean() >= same, f"{(~equal).sum()} of {equal.size} faces differ"
    far, near = cpu.require("range"), gpu.require("range")
    hits = np.isfinite(far) & np.isfinite(near)
    coplanar = np.zeros_like(equal)
    coplanar[hits] = np.abs(far[hits] - near[hits]) <= 1e-6 * far[hits]
    assert not (~equal & ~edges(there) & ~coplanar).any(), np.argwhere(~equal & ~edges(there) & ~coplanar)
    np.testing.assert_array_equal(np.isfinite(far)[equal], np.isfinite(near)[equal])
    hits &= equal
    np.testing.assert_allclose(near[hits], far[hits], rtol=1e-5, atol=3e-6 if cpu.camera._core.is_parallel else 0.0)
    np.testing.assert_array_equal(gpu.require("object_id")[equal], cpu.require("object_id")[equal])
    np.testing.assert_allclose(gpu.require("normal")[hits], cpu.require("normal")[hits], atol=1e-3)
    reach = 1e-5 * far[hits] + 1e-6 * np.abs(cpu.require("position")[hits]).max(initial=0.0)
    assert (np.abs(gpu.require("position")[hits] - cpu.require("position")[hits]).max(-1, initial=0.0) <= reach).all()
    if cpu.albedo is not None:
        check_materials(cpu, gpu, hits)
    codes = codes_apart(cpu, gpu)[equal]
    assert np.percentile(codes, 99.9) <= 2, np.percentile(codes, [50, 99, 99.9, 100])
    return np.asarray(equal)


def check_materials(cpu: nf.Frame, gpu: nf.Frame, hits: NDArray[np.bool_]) -> None:
    """Compare albedo, whose texture levels may differ as for colour, shading normals and coverage."""
    codes = np.abs(srgb(cpu.require("albedo")[hits]) - srgb(gpu.require("albedo")[hits]))
    assert not codes.size or np.percentile(codes, 99.9) <= 2, np.percentile(codes, [50, 99, 99.9, 100])
    np.testing.assert_allclose(gpu.require("shading_normal")[hits], cpu.require("shading_normal")[hits], atol=2e-3)
    missed = ~(np.isfinite(cpu.require("range")) | np.isfinite(gpu.require("range")))
    for frame in (cpu, gpu):
        assert np.isnan(frame.require("albedo")[missed]).all()
        assert np.isnan(frame.require("shading_normal")[missed]).all()

    whole = ~edges(cpu.require("face_id")) & ~edges(gpu.require("face_id"))
    np.testing.assert_allclose(cpu.require("coverage")[whole], gpu.require("coverage")[whole], atol=1e-6)


def srgb(linear: NDArray[Any]) -> NDArray[np.float64]:
    """Codes 0 … 255 of linear values, not rounded."""
    x = np.clip(linear.astype(np.float64), 0.0, 1.0)
    return np.asarray(255.0 * np.where(x <= 0.0031308, 12.92 * x, 1.055 * x ** (1 / 2.4) - 0.055))


def both(scene: nf.Scene, camera: nf.Camera, **settings: Any) -> tuple[nf.Frame, nf.Frame]:
    """Render the same picture on the CPU and on the selected adapter."""
    settings = {"channels": RENDERED} | settings
    cpu, gpu = (nf.render(scene, camera, backend=backend, **settings) for backend in ("cpu", "gpu"))
    return cpu, gpu


def codes_apart(reference: nf.Frame, test: nf.Frame) -> NDArray[np.int64]:
    """Greatest difference of a pixel's three sRGB codes."""
    return np.asarray(np.abs(reference.to_image().astype(int) - test.to_image().astype(int)).max(axis=-1))


def check_ids(reference: NDArray[Any], test: NDArray[Any], share: float = 0.999) -> None:
    """Check that numbers agree except for a share of pixels, and that every exception is at an edge of a picture."""
    differ = reference != test
    assert differ.mean() <= 1 - share, f"{differ.sum()} of {differ.size} differ"
    assert not (differ & ~edges(reference) & ~edges(test)).any()


def check_range(reference: nf.Frame, test: nf.Frame, *, tolerance: float = 1e-5, worst: float = 1e-4) -> None:
    """Check ranges where both show one face: all but a thousandth agree to `tolerance`, all to `worst`, relatively.

    The exceptions are large faces seen at a slant and slivers, where float32 has no more digits on either back end.
    """
    same = (reference.face_id == test.face_id) & (reference.require("face_id") >= 0)
    expected, got = reference.require("range")[same], test.require("range")[same]
    apart = np.abs(got - expected) / expected
    if apart.size:
        assert np.percentile(apart, 99.9) <= tolerance
        assert apart.max() <= worst, f"{apart.max()} at {np.argmax(apart)} of {apart.size}"


def check_color(reference: nf.Frame, test: nf.Frame, codes: int = 2, percentile: float = 99.9) -> None:
    """Check that all but a share of pixels have indistinguishable colours."""
    assert np.percentile(codes_apart(reference, test), percentile) <= codes


def crowd(dynamic: tuple[str, ...] = ()) -> nf.Scene:
    """A mesh placed many times, sometimes mirrored, above a ground."""
    builder = SceneBuilder()
    texture = noise(16, 16, 4, seed=5)
    material = builder.material((1, 0.8, 0.6, 1), texture)
    corners = np.array([[0, 0, 0], [1, 0, 0.2], [0.1, 1.5, 0], [0.2, 0.3, 0.9]], np.float32)
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]
    shape = builder.mesh(corners, faces, material=material, uvs=corners[:, :2] * 2)
    places = np.tile(np.eye(4), (25, 1, 1))
    for number, place in enumerate(places):
        angle = 0.7 * number
        place[:3, :3] = [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
        place[:3, :3] *= 1.0 + 0.02 * number
        place[:3, 3] = (2.0 * (number % 5) - 4, -1.0, -2.0 * (number // 5) - 3)
        if number % 3 == 0:
            place[:3, 0] *= -1.0
    builder.place_many(shape, places, "one")
    builder.instance(
        builder.mesh(quad((0, -1, -8), (9, 0, 0), (0, 0, -9)), QUAD, material=builder.material()), name="g"
    )
    return builder.build(dynamic)


SETUP = """
import nearfar as nf, numpy as np
scene = nf.Scene.from_arrays(np.eye(3) - [0.3, 0.3, 2.0], [[0, 1, 2]])
camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(60), size=(16, 16))
"""


def program(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """Run a program in a separate process, without this process's selection."""
    kept = {
        name: value for name, value in os.environ.items() if not name.startswith(("XDG_RUNTIME", "NEARFAR_ADAPTER"))
    }
    kept |= {"PYTHONPATH": os.pathsep.join(sys.path)} | environment
    return subprocess.run([sys.executable, "-c", SETUP + code], env=kept, capture_output=True, text=True, timeout=120)
