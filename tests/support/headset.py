"""An emulated headset (IWER) around the page: its poses, and the pictures of both eyes."""

from __future__ import annotations

import base64
import json
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._scene.srgb import to_srgb
from tests.support.browser import open_page, wait_for_ring
from tests.support.page_pictures import of_one_face
from tests.support.web_cases import bundled

Vector = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]

EYE_HEIGHT = 1.7
"""Eye height above the floor, metres, of the person that a pose of the page represents."""

OUTWARDS, INWARDS, DOWN, UP = 1.28, 0.87, 1.11, 0.93
"""Tangents of the angles to the sides of an eye's picture, of the size that headsets have."""

HEADSETS = {"quest2": 0.063, "quest3": 0.068}
"""Emulated headsets and eye distances of their users, metres."""


def tangents() -> dict[str, dict[str, float]]:
    """Tangents of both eyes, in the emulator's format."""
    sides = {"down": -DOWN, "up": UP}
    return {
        "left": {"left": -OUTWARDS, "right": INWARDS, **sides},
        "right": {"left": -INWARDS, "right": OUTWARDS, **sides},
    }


class _Gate:
    """Holds requests back until it is opened."""

    def __init__(self) -> None:
        self._held: list[Any] = []
        self._is_open = False

    def take(self, route: Any) -> None:
        """Let a request through, or hold it."""
        if self._is_open:
            route.continue_()
        else:
            self._held.append(route)

    def open(self) -> None:
        """Let all requests through, including later ones."""
        self._is_open = True
        for route in self._held:
            route.continue_()


def _hasten(route: Any) -> None:
    manifest = route.fetch().json()
    manifest["growth"]["speed"] *= 1000
    route.fulfill(json=manifest)


@contextmanager
def worn(
    program: Any, url: str, kind: str, size: tuple[int, int], ring: int, *, layers: bool = False, held: str = ""
) -> Iterator[Any]:
    """The page in a headset, all rings up to one loaded; `size` is that of an eye's picture.

    Files whose names are in `held` are held back until `page.let_go()`; then the morph grows in no time.
    """
    with open_page(program, 2 * size[0], size[1]) as page:
        wanted = {"headset": kind, "eyes": tangents(), "ipd": HEADSETS[kind], "layers": layers}
        page.add_init_script(f"window.wanted = {json.dumps(wanted)};\n{bundled('tests/xr/device.ts')}")
        gate = _Gate()
        page.let_go = gate.open
        if held:
            page.route(f"**/{held}", gate.take)
            page.route("**/manifest.json", _hasten)
        page.goto(url)
        assert wait_for_ring(page, ring) == ""
        enter(page)
        page.wait_for_function("() => window.nearfar.viewer.renderer.xr.isPresenting")
        frames(page, 2)
        yield page


def enter(page: Any) -> None:
    """Enter the headset; on a small page other elements cover the button."""
    page.get_by_role("button", name="Enter VR").dispatch_event("click")


def frames(page: Any, count: int) -> None:
    """Wait until some frames are drawn."""
    page.evaluate("(count) => window.emulated.frames(count)", count)


def rest(page: Any) -> None:
    """Wait until the user has stopped, and no jump is in progress."""
    page.evaluate("() => window.emulated.rest()")


def look(page: Any, position: Vector, turn: Quaternion) -> None:
    """Place the head in the headset's space."""
    page.evaluate(
        "([[x, y, z], [a, b, c, d]]) => { window.emulated.device.position.set(x, y, z);"
        " window.emulated.device.quaternion.set(a, b, c, d); }",
        [position, turn],
    )


def empty_hands(page: Any) -> None:
    """Move the controllers far below, so that they hide nothing."""
    for hand in ("left", "right"):
        point(page, hand, (0.0, -90.0, 0.0), (0.0, 0.0, 0.0, 1.0))
    frames(page, 2)


@dataclass(frozen=True)
class Captured:
    """Both eyes' pictures (H, W, 3), sRGB; what they show, and the positions of eyes that shaders received."""

    left: NDArray[np.uint8]
    right: NDArray[np.uint8]
    shown: dict[str, Any]
    eyes: NDArray[np.float64]


def capture(page: Any, condition: str) -> Captured:
    """The first frame whose state `shown` meets a condition in JavaScript."""
    answer = page.evaluate(f"() => window.emulated.capture((shown) => {condition})")
    width, height = answer["width"], answer["height"]
    pixels = np.frombuffer(base64.b64decode(answer["pixels"]), np.uint8).reshape(height, width, 4)
    assert (pixels[..., 3] == 255).all(), "the picture lets what is below it shine through"
    both = pixels[::-1, :, :3]
    return Captured(both[:, : width // 2], both[:, width // 2 :], answer["shown"], np.array(answer["eyes"]))


def about(axis: Vector, angle: float) -> Quaternion:
    """The quaternion (x, y, z, w) of a rotation about an axis, radians."""
    x, y, z = (float(value) * np.sin(angle / 2) for value in axis)
    return x, y, z, float(np.cos(angle / 2))


def times(first: Quaternion, second: Quaternion) -> Quaternion:
    """The rotation `second`, then `first`."""
    (ax, ay, az, aw), (bx, by, bz, bw) = first, second
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def rotated(turn: Quaternion, vector: Vector) -> NDArray[np.float64]:
    """A vector after a rotation."""
    x, y, z, _ = times(times(turn, (*vector, 0.0)), (-turn[0], -turn[1], -turn[2], turn[3]))
    return np.array([x, y, z])


@dataclass(frozen=True)
class Floor:
    """World position of the origin of the headset's space, and its rotation about the vertical axis."""

    position: NDArray[np.float64]
    yaw: float

    def eye(self, head: Vector, turn: Quaternion, aside: float) -> tuple[NDArray[np.float64], Quaternion]:
        """Position and orientation, in the world, of an eye that is some metres to the right of the head."""
        base = about((0, 1, 0), self.yaw)
        local = np.array(head) + rotated(turn, (aside, 0, 0))
        return self.position + rotated(base, tuple(local)), times(base, turn)


def floor_under(place: Vector, yaw: float, head: Vector) -> Floor:
    """The floor on which a head that looks along −z of its space stands at the page's position."""
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
    return Path(bundle._reader.location)


def floor_of(page: Any, center: Vector) -> Floor:
    """The floor chosen by the page for its user, if it shows the region of a centre."""
    x, y, z, yaw = page.evaluate(
        "() => { const { rig } = window.nearfar.viewer; return [...rig.position.toArray(), rig.rotation.y]; }"
    )
    return Floor(np.array([x, y, z]) + center, yaw)


def push(page: Any, hand: str, right: float, down: float, *, pressed: bool = False) -> None:
    """Push a controller's stick."""
    page.evaluate(
        "([hand, x, y, pressed]) => { const one = window.emulated.device.controllers[hand];"
        " one.updateAxes('thumbstick', x, y); one.updateButtonValue('thumbstick', pressed ? 1 : 0); }",
        [hand, right, down, pressed],
    )


def point(page: Any, hand: str, position: Vector, turn: Quaternion, kind: str = "controllers") -> None:
    """Place a controller, or one of the `hands`, in the headset's space."""
    page.evaluate(
        "([kind, hand, [x, y, z], [a, b, c, d]]) => { const one = window.emulated.device[kind][hand];"
        " one.position.set(x, y, z); one.quaternion.set(a, b, c, d); }",
        [kind, hand, position, turn],
    )


def squeeze(page: Any, hand: str, value: float, kind: str = "controllers") -> None:
    """Pull a controller's trigger, or pinch with one of the `hands`; 0 releases."""
    page.evaluate(
        "([kind, hand, value]) => { const one = window.emulated.device[kind][hand];"
        " if (kind === 'hands') one.updatePinchValue(value); else one.updateButtonValue('trigger', value); }",
        [kind, hand, value],
    )


SPEED, GRAVITY = 7.5, 9.81
"""Speed and acceleration of thrown arcs, metres per second and per second²."""


def thrown(floor: Floor, position: Vector, turn: Quaternion) -> NDArray[np.float64]:
    """The point of the floor, in the world, where an object thrown by a hand lands."""
    ahead = rotated(turn, (0, 0, -1)) * SPEED
    seconds = (ahead[1] + np.sqrt(ahead[1] ** 2 + 2 * GRAVITY * position[1])) / GRAVITY
    local = np.array(position) + ahead * seconds
    return floor.position + rotated(about((0, 1, 0), floor.yaw), (local[0], 0.0, local[2]))


def eyes(floor: Floor, head: tuple[Vector, Quaternion], ipd: float, size: tuple[int, int]) -> dict[str, nf.Camera]:
    """nearfar's cameras of both eyes."""
    return {side: camera(floor, *head, side, ipd, size) for side in ("left", "right")}


def expected(
    bundle: nf.stream.Bundle, picture: dict[str, Any], seen: nf.Camera
) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """nearfar's picture in codes, and the pixels that are compared."""
    frame = bundle.at(**picture).render(seen, channels=("color", "face_id"))
    codes = to_srgb(np.clip(frame.require("color"), 0, 1)) * 255
    return np.asarray(codes, np.float64), of_one_face(frame.require("face_id"))


def share_alike(found: NDArray[np.uint8], codes: NDArray[np.float64], inner: NDArray[np.bool_]) -> float:
    """The share of pixels that are within 2 of 255."""
    off = np.abs(np.rint(codes) - found).max(axis=-1)
    return float((off[inner] <= 2).mean())


def share_equal(
    bundle: nf.stream.Bundle, picture: dict[str, Any], found: Captured, cameras: dict[str, nf.Camera]
) -> float:
    """The lesser share of both eyes' pixels that equal nearfar's."""
    return min(
        share_alike(pixels, *expected(bundle, picture, cameras[side]))
        for side, pixels in (("left", found.left), ("right", found.right))
    )
