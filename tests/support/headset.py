"""An emulated headset (IWER) around the page: its poses, and the pictures of both eyes."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from tests.support.browser import opened, wait_for_ring
from tests.support.web_cases import WEB, run

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

EYE_HEIGHT = 1.7
"""Metres from the floor to the eyes of somebody for whom a pose of the page stands."""

OUTWARDS, INWARDS, DOWN, UP = 1.28, 0.87, 1.11, 0.93
"""Tangents of the angles to the sides of an eye's picture, of the size that headsets have."""

HEADSETS = {"quest2": 0.063, "quest3": 0.068}
"""Emulated headsets and metres between their users' eyes."""


@cache
def script() -> str:
    """The emulator with its controls, bundled."""
    out = WEB / "build" / "xr" / "device.js"
    run("npx", "esbuild", "tests/xr/device.ts", "--bundle", "--format=iife", "--log-level=warning", f"--outfile={out}")
    return out.read_text()


def tangents() -> dict[str, dict[str, float]]:
    """Those of both eyes, as the emulator takes them."""
    sides = {"down": -DOWN, "up": UP}
    return {
        "left": {"left": -OUTWARDS, "right": INWARDS, **sides},
        "right": {"left": -INWARDS, "right": OUTWARDS, **sides},
    }


@contextmanager
def worn(program: Any, url: str, kind: str, size: tuple[int, int], ring: int) -> Iterator[Any]:
    """The page in a headset, all rings up to one loaded; `size` is that of an eye's picture."""
    with opened(program, 2 * size[0], size[1]) as page:
        wanted = {"headset": kind, "eyes": tangents(), "ipd": HEADSETS[kind]}
        page.add_init_script(f"window.wanted = {json.dumps(wanted)};\n{script()}")
        page.goto(url)
        assert wait_for_ring(page, ring) == ""
        page.get_by_role("button", name="Enter VR").click()
        page.wait_for_function("() => window.nearfar.viewer.renderer.xr.isPresenting")
        frames(page, 2)
        yield page


def frames(page: Any, count: int) -> None:
    """Wait until some frames are drawn."""
    page.evaluate("(count) => window.emulated.frames(count)", count)


def look(page: Any, position: Vector, turn: Quaternion) -> None:
    """Put the head somewhere in the headset's space."""
    page.evaluate(
        "([[x, y, z], [a, b, c, d]]) => { window.emulated.device.position.set(x, y, z);"
        " window.emulated.device.quaternion.set(a, b, c, d); }",
        [position, turn],
    )


def empty_hands(page: Any) -> None:
    """Put the controllers away, so that they hide nothing."""
    page.evaluate(
        "() => { for (const one of Object.values(window.emulated.device.controllers)) one.connected = false; }"
    )
    frames(page, 2)


@dataclass(frozen=True)
class Captured:
    """Both eyes' pictures (H, W, 3), sRGB; what they show, and the positions of eyes that shaders were told."""

    left: NDArray[np.uint8]
    right: NDArray[np.uint8]
    shown: dict[str, Any]
    eyes: NDArray[np.float64]


def capture(page: Any, condition: str) -> Captured:
    """The first frame whose state `shown` fulfils a condition in JavaScript."""
    answer = page.evaluate(f"() => window.emulated.capture((shown) => {condition})")
    width, height = answer["width"], answer["height"]
    pixels = np.frombuffer(base64.b64decode(answer["pixels"]), np.uint8).reshape(height, width, 4)
    assert (pixels[..., 3] == 255).all(), "the picture lets what is below it shine through"
    both = pixels[::-1, :, :3]
    return Captured(both[:, : width // 2], both[:, width // 2 :], answer["shown"], np.array(answer["eyes"]))


def about(axis: Vector, angle: float) -> Quaternion:
    """The quaternion (x, y, z, w) of a turn about an axis, radians."""
    x, y, z = (float(value) * np.sin(angle / 2) for value in axis)
    return x, y, z, float(np.cos(angle / 2))


def times(first: Quaternion, second: Quaternion) -> Quaternion:
    """The turn `second`, then `first`."""
    (ax, ay, az, aw), (bx, by, bz, bw) = first, second
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def rotated(turn: Quaternion, vector: Vector) -> NDArray[np.float64]:
    """A vector after a turn."""
    x, y, z, _ = times(times(turn, (*vector, 0.0)), (-turn[0], -turn[1], -turn[2], turn[3]))
    return np.array([x, y, z])


@dataclass(frozen=True)
class Floor:
    """Where the origin of the headset's space is in the world, and its turn about the vertical axis."""

    position: NDArray[np.float64]
    yaw: float

    def eye(self, head: Vector, turn: Quaternion, aside: float) -> tuple[NDArray[np.float64], Quaternion]:
        """Position and turn, in the world, of an eye that is some metres to the right of the head."""
        base = about((0, 1, 0), self.yaw)
        local = np.array(head) + rotated(turn, (aside, 0, 0))
        return self.position + rotated(base, tuple(local)), times(base, turn)


def floor_under(place: Vector, yaw: float, head: Vector) -> Floor:
    """The floor on which a head that looks along −z of its space stands where the page was."""
    shift = rotated(about((0, 1, 0), yaw), (head[0], 0, head[2]))
    return Floor(np.array(place) - shift - (0, EYE_HEIGHT, 0), yaw)


def camera(floor: Floor, head: Vector, turn: Quaternion, side: str, ipd: float, size: tuple[int, int]) -> nf.Camera:
    """nearfar's camera of an eye."""
    place, orientation = floor.eye(head, turn, -ipd / 2 if side == "left" else ipd / 2)
    edges = tangents()[side]
    fov = nf.Fov(edges["left"], edges["right"], edges["down"], edges["up"])
    return nf.Camera(tuple(place.tolist()), orientation, fov=fov, size=size)


def folder_of(bundle: nf.stream.Bundle) -> Path:
    """The folder of a bundle."""
    return Path(bundle._reader.place)
