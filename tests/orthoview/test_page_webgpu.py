"""The page that flies trees, drawn by WebGPU: compared with Python's pictures and with WebGL."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import need
from tests.support.browser import FRAMES, WEBGPU, open_page, started, wait_until
from tests.support.flown_page import (
    SIZE,
    Pose,
    facts,
    grabbed,
    holes,
    likeness,
    link,
    open_flight,
    page_camera,
    problems,
    rendered,
)

pytestmark = pytest.mark.slow

STREET: Pose = {"position": [20.0, 3.0, 22.0], "yaw": 0.7, "pitch": 0.0}
NEAR: Pose = {"position": [3.0, 14.0, 34.0], "yaw": 0.5, "pitch": -0.2}
FACADE: Pose = {"position": [0.0, 3.0, 9.0], "yaw": 0.2, "pitch": -0.1}
FAR_FACADE: Pose = {"position": [10.0, 20.0, 190.0], "yaw": 0.05, "pitch": -0.1}
WALL: Pose = {"position": [20.0, 2.0, -20.0], "yaw": 1.6, "pitch": 0.0}

WITHOUT = "Object.defineProperty(navigator, 'gpu', { value: undefined })"
REFUSED = """
Object.defineProperty(GPUAdapterInfo.prototype, 'isFallbackAdapter', { get: () => false });
GPUAdapter.prototype.requestDevice = () => Promise.reject(new Error('no room'));
"""
"""Provides an adapter that counts as hardware and no device."""
FEW = "Object.defineProperty(GPUSupportedLimits.prototype, 'maxBufferSize', { get: () => 1 << 20 })"
"""Sets pages of 1 MB."""
SMALL = "Object.defineProperty(GPUSupportedLimits.prototype, 'maxStorageBufferBindingSize', { get: () => 96000 })"
"""Draws pictures in bands of up to 100 rows."""


@pytest.fixture(scope="module")
def with_webgpu() -> Iterator[Any]:
    """A browser with WebGPU."""
    need("browser")
    with started(flags=WEBGPU) as program:
        yield program


def draw(program: Any, address: str, script: str = "") -> tuple[dict[str, Any], Any]:
    """The page's figures, and its picture by WebGPU."""
    with open_page(program, *SIZE) as page:
        page.add_init_script(f"{FRAMES}; {script}")
        open_flight(page, address)
        found = grabbed(page)
        wait_until(page, lambda: facts(page)["drawnSplats"] is not None)
        told = facts(page)
        assert page.printed == []
    assert (told["standIns"], told["holes"]) == (0, 0)
    return told, found


@pytest.mark.parametrize(("pose", "least", "samples"), [(WALL, 0.9, 1), (STREET, 0.9, 4)])
def test_pictures_are_those_of_render(
    with_webgpu: Any, city: nf.orthoview.OrthoTree, pose: Pose, least: float, samples: int
) -> None:
    with Server.of_bundle(city.path) as server:
        address = f"{server.url}?graphics=webgpu&geometry=0&samples={samples}{link(pose)}"
        told, found = draw(with_webgpu, address)
    frame = rendered(city, pose, samples)
    assert told["views"] == frame.stats["views"]
    assert likeness(found, frame) > least
    assert holes(found, frame) < 0.001
    assert 0 < told["drawnSplats"] <= told["splats"]


def test_geometry_is_drawn_before_and_behind_splats(with_webgpu: Any, city: nf.orthoview.OrthoTree) -> None:
    """As a whole, and band by band."""
    with Server.of_bundle(city.path) as server:
        address = f"{server.url}?graphics=webgpu&samples=4{link(NEAR)}"
        (told, found), (banded, again) = (draw(with_webgpu, address, script) for script in ("", SMALL))
    frame = rendered(city, NEAR, 4, geometry=True)
    assert told["triangles"] > 0
    assert told["views"] == frame.stats["views"]
    assert likeness(found, frame) > 0.99
    assert holes(found, frame) < 0.001
    assert banded["calls"] > told["calls"]
    assert told["drawnSplats"] <= banded["drawnSplats"]
    # Corners of triangles are snapped differently within a pixel.
    assert (np.abs(found.astype(int) - again).max(axis=-1) > 2).mean() < 3e-3


def test_pictures_equal_webgl(with_webgpu: Any, city: nf.orthoview.OrthoTree) -> None:
    """WebGL draws if WebGPU fails."""
    pictures = []
    with Server.of_bundle(city.path) as server:
        for query, script in (("", REFUSED), ("graphics=webgpu&", "")):
            with open_page(with_webgpu, *SIZE) as page:
                page.add_init_script(f"{FRAMES}; {script}")
                told = open_flight(page, f"{server.url}?{query}{link(NEAR)}")
                pictures.append(grabbed(page).astype(int))
                assert problems(page) == []
                assert any("WebGPU fails, so WebGL draws" in line for line in page.printed) == (not query)
            assert told["graphics"] == ("webgpu" if query else "webgl")
            assert (told["drawnSplats"] is None) == (not query)
    off = np.abs(pictures[0] - pictures[1]).max(axis=-1)
    # Where edges of splats pass through a sample.
    assert (off > 2).mean() < 0.01


@pytest.mark.parametrize("pose", [FACADE, FAR_FACADE])
def test_textures_and_their_levels_are_drawn(with_webgpu: Any, textured: nf.orthoview.OrthoTree, pose: Pose) -> None:
    with Server.of_bundle(textured.path) as server:
        told, found = draw(with_webgpu, f"{server.url}?graphics=webgpu&error=0.2{link(pose)}")
    assert told["triangles"] > 0
    assert told["views"] == 0
    frame = textured.render(page_camera(pose), error_px=0.2, channels=("color", "coverage"))
    off = np.abs(frame.to_image().astype(int) - found).max(axis=-1)
    assert (off <= 3).mean() > 0.97


def test_hidden_parts_are_culled(with_webgpu: Any, tmp_path: Path) -> None:
    """A wall in front of blocks that are all hidden."""
    boxes = trimesh.Scene()
    boxes.add_geometry(trimesh.creation.box((60.0, 60.0, 1.0)), node_name="wall")
    for n in range(36):
        block = trimesh.creation.box((6.0, 6.0, 3.0))
        block.apply_translation((8.0 * (n % 6) - 20.0, 8.0 * (n // 6) - 20.0, -30.0 - n % 7))
        boxes.add_geometry(block, node_name=f"block {n}")
    need("zarr")
    tree = nf.orthoview.build(
        nf.Scene.from_trimesh(boxes), tmp_path / "wall.zarr", cell=32, size=64, directions=5, geometry=False
    )
    pose: Pose = {"position": [0.0, 0.0, 45.0], "yaw": 0.0, "pitch": 0.0}
    with Server.of_bundle(tree.path) as server:
        told, found = draw(with_webgpu, f"{server.url}?graphics=webgpu&error=2{link(pose)}")
    frame = tree.render(page_camera(pose), geometry=False, error_px=2, channels=("color", "coverage"))
    assert likeness(found, frame) > 0.99
    assert told["splats"] == frame.stats["splats_in_picture"]
    assert told["drawnSplats"] < 0.85 * told["splats"]


def test_parts_of_thousands_of_splats_are_drawn_from_several_pages(with_webgpu: Any, tmp_path: Path) -> None:
    """Views whose parts have 64 × 64 splats, in pages that hold few of them."""
    need("zarr")
    box = np.array([[-30.0, -9.0, -30.0], [29.0, 50.0, 29.0]])
    world = nf.datasets.city(blocks=1, detail=0)
    tree = nf.orthoview.build(world, tmp_path / "fine.zarr", cell=60, aabb=box, size=256, directions=5, geometry=False)
    pose: Pose = {"position": [0.0, 12.0, 45.0], "yaw": 0.0, "pitch": 0.0}
    with Server.of_bundle(tree.path) as server:
        address = f"{server.url}?graphics=webgpu{link(pose)}"
        (told, found), (whole, _) = (draw(with_webgpu, address, script) for script in (FEW, ""))
    assert told["calls"] > whole["calls"]
    frame = rendered(tree, pose)
    assert told["views"] == frame.stats["views"]
    assert likeness(found, frame) > 0.95
    assert holes(found, frame) < 0.001


def test_missing_requested_graphics_are_reported(with_webgpu: Any, city: nf.orthoview.OrthoTree) -> None:
    with Server.of_bundle(city.path) as server, open_page(with_webgpu, *SIZE) as page:
        page.add_init_script(WITHOUT)
        page.goto(f"{server.url}?graphics=webgpu{link(STREET)}")
        wait_until(page, lambda: page.locator("#message h1").count())
        assert "no WebGPU" in page.locator("#message").inner_text()
