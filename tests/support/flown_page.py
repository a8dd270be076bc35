"""The page that flies trees: its figures, and its pictures compared with Python's."""

from __future__ import annotations

import base64
import io
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._scene.srgb import to_srgb
from tests.support.browser import wait_until
from tests.support.page_pictures import camera

Pose = dict[str, Any]

SIZE = (240, 160)
ANGLE = 60.0

FACTS = "() => window.orthoview && ({ ...window.orthoview.facts })"
GRABBED = """async () => {
  const canvas = document.querySelector('canvas');
  // The canvas has its picture until the task ends that has drawn it.
  await window.orthoview.time();
  const time = window.orthoview.time();
  const bitmap = await createImageBitmap(canvas);
  await time;
  const copy = new OffscreenCanvas(bitmap.width, bitmap.height);
  copy.getContext('2d').drawImage(bitmap, 0, 0);
  const content = new Uint8Array(await (await copy.convertToBlob()).arrayBuffer());
  return btoa(Array.from(content, (byte) => String.fromCharCode(byte)).join(''));
}"""
PROBLEMS = "() => [...document.querySelectorAll('#message li')].map((each) => each.textContent)"


def link(pose: Pose) -> str:
    """The part of an address that names a pose."""
    return f"#p={','.join(map(str, pose['position']))}&yaw={pose['yaw']}&pitch={pose['pitch']}"


def facts(page: Any) -> dict[str, Any]:
    """The page's own figures."""
    return dict(page.evaluate(FACTS) or {"isComplete": False})


def open_flight(page: Any, address: str) -> dict[str, Any]:
    """Open the page, and wait until all views have arrived or failed."""
    page.goto(address)
    wait_until(page, lambda: facts(page)["isComplete"])
    return facts(page)


def grabbed(page: Any) -> NDArray[np.uint8]:
    """The picture on the canvas, without overlays."""
    content = base64.b64decode(page.evaluate(GRABBED))
    return np.asarray(Image.open(io.BytesIO(content)).convert("RGB"))


def page_camera(pose: Pose, size: tuple[int, int] = SIZE) -> nf.Camera:
    """The page's camera."""
    return camera(pose["position"], pose["yaw"], pose["pitch"], size, ANGLE)


def rendered(
    tree: nf.orthoview.OrthoTree, pose: Pose, samples: int = 1, *, geometry: bool = False, size: tuple[int, int] = SIZE
) -> nf.Frame:
    """Python's picture."""
    return tree.render(page_camera(pose, size), geometry=geometry, samples=samples, channels=("color", "coverage"))


def likeness(found: NDArray[np.uint8], frame: nf.Frame) -> float:
    """Structural similarity of the mean of the colours."""
    return float(nf.ssim(frame.to_image().mean(axis=-1), found.mean(axis=-1), data_range=255))


def holes(found: NDArray[np.uint8], frame: nf.Frame) -> float:
    """Share of the pixels that Python covers in which the page shows the sky."""
    height = frame.camera.rays()[1][..., 1:2]
    end = np.where(height < 0, [0.24, 0.25, 0.26], [0.16, 0.34, 0.66])
    horizon = np.array([0.66, 0.74, 0.82])
    sky = to_srgb(horizon + (end - horizon) * np.sqrt(np.abs(height))) * 255
    is_sky = np.abs(sky - found).max(axis=-1) < 2
    covered = frame.require("coverage") == 1
    assert covered.all() or is_sky[~covered].mean() > 0.5
    return float(is_sky[covered].mean())


def problems(page: Any) -> list[str]:
    """The page's messages."""
    return list(page.evaluate(PROBLEMS))
