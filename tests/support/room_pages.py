"""Pages in a room, on clocks that the test steps, and the positions of points in their pictures."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

import nearfar as nf
from tests.support.browser import wait_until
from tests.support.page_pictures import ANGLE
from tests.support.stepped_page import SteppedPage

SEEN = """() => {
  const { room } = window.nearfar;
  const plain = ({ head, right, pointer }) => ({ head, right, pointer });
  return {
    own: room.body && plain(room.body),
    state: room.connection.state,
    seen: room.seen.map(({ number, name, body }) => ({ number, name, ...plain(body) })),
  };
}"""

HEAR = """([user, body]) => {
  const { presence } = window.nearfar.room;
  presence.hear({ kind: 'joined', user, group: 0, name: '' }, 0);
  const pose = { ...body, sequence: 1, clock: 0n, isAcknowledged: false, stops: true };
  presence.hear({ kind: 'pose', user, pose }, performance.now() / 1000);
}"""
"""A resting user joins."""

AIMS = 60
"""Milliseconds after which a page updates the hit of its pointer."""


class RoomPage:
    """A page that has joined a room, at a given pose."""

    def __init__(self, page: Any, pose: dict[str, Any]) -> None:
        wait_until(page, lambda: page.evaluate("() => Boolean(window.nearfar?.room)"))
        self.page, self.pose, self._stepped = page, pose, SteppedPage(page)
        self._stepped.load(pose, 0.1)

    def step(self) -> dict[str, Any]:
        """Draw a frame; returns the page's state of itself and others."""
        self.page.evaluate("(pose) => window.nearfar.room.frame(pose)", self.pose)
        self._stepped.frame(self.pose, 0.02)
        return dict(self.page.evaluate(SEEN))

    def picture(self) -> NDArray[np.int16]:
        """Draw a frame; returns its pixels (H, W, 3), sRGB."""
        self.page.evaluate("(pose) => window.nearfar.room.frame(pose)", self.pose)
        return self._stepped.picture(self.pose, 0.02)[1].astype(np.int16)

    def point_at(self, column: int, row: int) -> dict[str, Any]:
        """Hold the key to point at the centre of a pixel; returns the page's state then."""
        self.page.mouse.move(column + 0.5, row + 0.5)
        self.page.keyboard.down("e")
        self.page.wait_for_timeout(AIMS)
        return self.step()

    def pixel_of(self, points: ArrayLike, center: ArrayLike, radii: tuple[float, float]) -> NDArray[np.float64]:
        """Columns and rows (N, 2) at which the picture shows points of the world, with fractions."""
        user = np.asarray(self.pose["position"], np.float64)
        shown = nf.morph(np.atleast_2d(points), user=user, center=center, r1=radii[0], r2=radii[1]) - user
        yaw, pitch = self.pose["yaw"], self.pose["pitch"]
        right = np.array([np.cos(yaw), 0, -np.sin(yaw)])
        up = np.array([np.sin(yaw) * np.sin(pitch), np.cos(pitch), np.cos(yaw) * np.sin(pitch)])
        ahead = np.cross(up, right)
        size = self.page.viewport_size
        half = 0.5 * size["height"]
        scale = half / np.tan(np.radians(ANGLE) / 2) / (shown @ ahead)
        return np.stack([0.5 * size["width"] + scale * (shown @ right), half - scale * (shown @ up)], axis=1)


def ends(body: dict[str, Any]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Both ends of a pointer from the right hand."""
    begin = np.array(body["right"]["position"])
    *imaginary, real = np.array(body["right"]["rotation"])
    ahead = np.array([0.0, 0.0, -1.0])
    cross = 2 * np.cross(imaginary, ahead)
    return begin, begin + body["pointer"]["length"] * (ahead + real * cross + np.cross(imaginary, cross))


def has_changed(mask: NDArray[np.bool_], at: ArrayLike, reach: float) -> bool:
    """Whether a pixel within some pixels of a place has changed."""
    rows, columns = np.nonzero(mask)
    column, row = np.asarray(at)
    return bool((np.hypot(columns + 0.5 - column, rows + 0.5 - row) <= reach).any())


def reach_beyond(mask: NDArray[np.bool_], before: ArrayLike, end: ArrayLike) -> float:
    """Pixels by which a change extends beyond an end, on the line that leads there from a place before it."""
    way = np.subtract(end, before)
    rows, columns = np.nonzero(mask)
    beyond = np.stack([columns + 0.5, rows + 0.5], axis=1) - np.asarray(end)
    return float((beyond @ (way / max(float(np.linalg.norm(way)), 1e-9))).max())
