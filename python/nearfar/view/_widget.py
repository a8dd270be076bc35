"""View in notebooks: the page's viewer as an anywidget widget; importing this module imports anywidget.

Files are sent to the browser in messages, because Python may run on another machine.
"""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from functools import cache, partial
from importlib import resources
from typing import Any, NamedTuple

import anywidget
import traitlets

from nearfar._base import card, check
from nearfar._base.errors import Error
from nearfar._camera.camera import Camera, Fov, orientation_of, viewing_direction
from nearfar._reduce.reduced_scene import ReducedScene
from nearfar.stream._bundle import Bundle
from nearfar.stream._strategies import STRATEGIES
from nearfar.view import _content

ANGLE = 75.0
"""Vertical field of view at the start, degrees, as in the page."""

PIECE_BYTES = 4 << 20
"""Bytes of a file per message; files are divided so that other messages can be sent in between."""

MIN_SIDE, MAX_SIDE = 16, 8192
"""Range of width and height, CSS pixels."""

MAX_PITCH = 1.5
"""Greatest absolute pitch, radians."""

MIN_ANGLE, MAX_ANGLE = 10.0, 150.0
"""Range of the vertical field of view, degrees."""

TOLERANCE = 1e-6
"""Tolerance for the sine of a camera's roll, and for the relative asymmetry of a field of view's tangents."""


class Pose(NamedTuple):
    """Position and direction of the user's eye, and the vertical field of view."""

    position: tuple[float, float, float]
    yaw: float
    """Radians; 0 looks along −z, positive to the left."""
    pitch: float
    """Radians; positive looks up."""
    angle: float
    """Vertical field of view, degrees."""


@cache
def _script() -> str:
    """Return the widget's script: the texts of the scripts that the loader imports, followed by the loader."""
    names = json.loads(_read_built("widget/scripts.json"))
    scripts = [(name.rpartition("/")[2], _read_built(name)) for name in names]
    return f"const SCRIPTS = {json.dumps(scripts)};\n{_read_built('widget/loader.js')}"


def _read_built(name: str) -> str:
    return (resources.files("nearfar.view") / "dist" / name).read_text(encoding="utf-8")


class Widget(anywidget.AnyWidget):  # type: ignore[misc, unused-ignore]
    """A bundle or a reduced scene in a notebook; `nearfar._render.showing.View` documents the attributes."""

    position = traitlets.Tuple(*[traitlets.Float()] * 3).tag(sync=True)
    yaw = traitlets.Float().tag(sync=True)
    pitch = traitlets.Float().tag(sync=True)
    angle = traitlets.Float(ANGLE).tag(sync=True)
    width = traitlets.Int(read_only=True).tag(sync=True)
    height = traitlets.Int(read_only=True).tag(sync=True)
    strategy = traitlets.Unicode(read_only=True).tag(sync=True)
    ring = traitlets.Int(-1, read_only=True).tag(sync=True)
    region = traitlets.Int(0, read_only=True).tag(sync=True)
    radius = traitlets.Float(0.0, read_only=True).tag(sync=True)
    strength = traitlets.Float(0.0, read_only=True).tag(sync=True)
    problem = traitlets.Unicode("", read_only=True).tag(sync=True)

    def __init__(
        self,
        source: Bundle | ReducedScene,
        *,
        center: tuple[float, float, float],
        size: tuple[int, int],
        camera: Camera | None,
        strategy: str,
    ) -> None:
        width, height = check.size("size", size)
        for axis, side in enumerate((width, height)):
            check.integer(f"size[{axis}]", side, MIN_SIDE, MAX_SIDE)
        _check_strategy(source, strategy)
        start = Pose(center, 0.0, 0.0, ANGLE) if camera is None else pose_of(camera)
        self._source = source
        self._files = _files(source)
        self._last_file: tuple[str, bytes] | None = None
        self._esm, self._css = _script(), _read_built("widget/widget.css")
        super().__init__(**start._asdict())
        region = source.number if isinstance(source, Bundle) else 0
        for name, value in {"width": width, "height": height, "strategy": strategy, "region": region}.items():
            self.set_trait(name, value)
        self.on_msg(self._answer)

    @property
    def camera(self) -> Camera:
        """Camera of the picture."""
        return camera_of(Pose(self.position, self.yaw, self.pitch, self.angle), (self.width, self.height))

    @camera.setter
    def camera(self, camera: Camera) -> None:
        pose = pose_of(camera)
        # One message, so that the browser shows no intermediate poses.
        with self.hold_sync():
            for name, value in pose._asdict().items():
                setattr(self, name, value)

    @traitlets.validate("position", "yaw", "pitch", "angle")
    def _check(self, proposal: Mapping[str, Any]) -> Any:
        value = proposal["value"]
        match proposal["trait"].name:
            case "position":
                return check.vector("position", value)
            case "yaw":
                return check.number("yaw", value)
            case "pitch":
                return check.in_range("pitch", value, -MAX_PITCH, MAX_PITCH)
        return check.in_range("angle", value, MIN_ANGLE, MAX_ANGLE)

    def _answer(self, _: Any, request: Any, __: Any) -> None:
        """Send a piece of a file to the browser, or an error message."""
        if not isinstance(request, dict) or request.get("kind") != "read":
            return
        number = request.get("id")
        try:
            content = self._content(request.get("name"))
            start = check.integer("start", request.get("start", 0), 0, len(content))
        except (Error, OSError, ValueError, TypeError) as error:
            self.send({"id": number, "problem": check.one_line(str(error), 300)})
        else:
            self.send({"id": number, "bytes": len(content)}, [content[start : start + PIECE_BYTES]])

    def _content(self, name: Any) -> bytes:
        """Return the content of a file; the last file is cached, because it is sent in pieces."""
        if self._last_file is None or self._last_file[0] != name:
            if not isinstance(name, str) or name not in self._files:
                raise ValueError(f"name: expected a file of the shown scene, got {check.shortened(name)}")
            self._last_file = name, self._files[name]()
        return self._last_file[1]

    def _repr_mimebundle_(self, **settings: Any) -> Any:
        """Return the widget, with an image for viewers without widgets, such as saved notebooks."""
        bundle = super()._repr_mimebundle_(**settings)
        if bundle is None:
            return None
        data, *metadata = bundle
        return ({**data, "image/png": card.png(self._picture())}, *metadata)

    def _picture(self) -> Any:
        """Render an image with the current camera; for a bundle only the map of ring 0, which loads quickly."""
        source = self._source.at(0) if isinstance(self._source, Bundle) else self._source
        return source.render(self.camera, samples=4, channels=("color",)).to_image()

    def __repr__(self) -> str:
        return f"Widget({self._source!r}, position={tuple(self.position)}, yaw={self.yaw:g}, pitch={self.pitch:g})"


def _check_strategy(source: Bundle | ReducedScene, strategy: str) -> None:
    """Raise ValueError for a strategy that needs files which the content does not have."""
    by_footprint = check.choice("strategy", strategy, STRATEGIES).startswith("vis")
    if by_footprint and not (isinstance(source, Bundle) and source._region["by_footprint"] is not None):
        raise ValueError(f"strategy: expected 'clovr' or 'clovrd' without export(by_footprint=True), got {strategy!r}")


def _files(source: Bundle | ReducedScene) -> dict[str, _content.Read]:
    if isinstance(source, Bundle):
        # `Bundle.read` caches: a cell may remove the folder before the browser requests files.
        return _content.of_bundle(source, source.read)
    return {name: partial(bytes, content) for name, content in _content.files_of(source).items()}


def pose_of(camera: Camera) -> Pose:
    """Convert a camera to a pose; ValueError or TypeError if the page cannot represent it."""
    fov = check.instance("camera", camera, Camera).fov
    if not isinstance(fov, Fov):
        raise TypeError(f"camera: expected a perspective camera (nearfar.Fov), got {type(fov).__name__}")
    if abs(fov.left + fov.right) > TOLERANCE * fov.right or abs(fov.down + fov.up) > TOLERANCE * fov.up:
        raise ValueError("camera: expected the same field of view to both sides, up and down, got others")
    x, y, z, w = camera.orientation
    ahead = viewing_direction(camera.orientation)
    right_y = 2 * (x * y + w * z)
    if abs(right_y) > TOLERANCE:
        raise ValueError(f"camera: expected one without roll, got {math.degrees(math.asin(right_y)):.3g} degrees")
    pitch = math.atan2(ahead[1], math.hypot(ahead[0], ahead[2]))
    if abs(pitch) > MAX_PITCH:
        raise ValueError(f"camera: expected a pitch of at most ±{MAX_PITCH} radians, got {pitch:.4g}")
    angle = math.degrees(2.0 * math.atan(fov.up))
    check.in_range("camera: vertical field of view", angle, MIN_ANGLE, MAX_ANGLE)
    return Pose(camera.position, math.atan2(-ahead[0], -ahead[2]), pitch, angle)


def camera_of(pose: Pose, size: tuple[int, int]) -> Camera:
    """Convert a pose to a camera with an image size in pixels."""
    up = math.tan(math.radians(0.5 * pose.angle))
    right = up * size[0] / size[1]
    return Camera(pose.position, orientation_of(pose.yaw, pose.pitch), fov=Fov(-right, right, -up, up), size=size)
