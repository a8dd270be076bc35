"""Renders what both eyes of a headset see, as one shot of a renderable."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal, Unpack, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import card, check, files
from nearfar._base.pickling import WithStats
from nearfar._base.settings import gather
from nearfar._lens.warp import Filter
from nearfar._render.frame import Frame
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderKeywords, RenderSettings
from nearfar.hmd._hmd import EYES, Hmd

User = Literal["eyes", "middle"]
"""Name of a user that `render_eyes` describes."""
USERS: tuple[User, ...] = get_args(User)

# For each eye, weights of its red, green and blue (columns) in the anaglyph's red, green and blue (rows).
_ANAGLYPH = np.array([
    [[0.4561, 0.500484, 0.176381], [-0.0400822, -0.0378246, -0.0157589], [-0.0152161, -0.0205971, -0.00546856]],
    [[-0.0434706, -0.0879388, -0.00155529], [0.378476, 0.73364, -0.0184503], [-0.0721527, -0.112961, 1.2264]],
])  # fmt: skip


@dataclass(frozen=True, eq=False)
class StereoFrame(WithStats):
    """The frames of both eyes of a headset, as `render_eyes` and `nearfar.stereo.HybridRig.render` return them.

    ValueError and TypeError for frames of different sizes, and other things than frames and a headset.
    """

    hmd: Hmd | None
    """The headset; None for a rig that was made of two eyes."""
    left: Frame
    """The left eye's picture, before the lens warp."""
    right: Frame
    """The right eye's picture."""
    center: Frame | None = None
    """The picture that both eyes share beyond the mono plane; black where no eye looks it up. None for plain stereo."""
    stats: Mapping[str, Any] = field(default_factory=dict, repr=False)
    """Counts of a hybrid picture, read-only; see `nearfar.stereo.HybridRig.render`. Empty for plain stereo."""

    def __post_init__(self) -> None:
        if self.hmd is not None:
            check.instance("hmd", self.hmd, Hmd, "an Hmd")
        if self.center is not None:
            check.instance("center", self.center, Frame)
        self._freeze_stats()
        for eye in EYES:
            check.instance(eye, getattr(self, eye), Frame)
        if self.left.camera.size != self.right.camera.size:
            sizes = f"{self.left.camera.size} and {self.right.camera.size}"
            raise ValueError(f"right: expected a frame of the left one's size, got {sizes}")

    @property
    def side_by_side(self) -> NDArray[np.uint8]:
        """Colours of the left and of the right eye side by side, sRGB (H, 2 W, 3) uint8; ValueError without colour."""
        return np.concatenate([self.left.to_image(), self.right.to_image()], axis=1)

    @property
    def anaglyph(self) -> NDArray[np.uint8]:
        """Both colours in one picture for red–cyan glasses, sRGB (H, W, 3) uint8; ValueError without colour.

        Source: Dubois (2001), A projection method to generate anaglyph stereo images, least squares in linear light.
        """
        left, right = (frame.require("color").astype(np.float64) for frame in (self.left, self.right))
        mixed = np.clip(left @ _ANAGLYPH[0].T + right @ _ANAGLYPH[1].T, 0.0, 1.0).astype(np.float32)
        return _core.encode_srgb(mixed).reshape(mixed.shape)

    def warped(
        self, *, size: tuple[int, int] | None = None, filter: Filter = "linear"  # noqa: A002
    ) -> tuple[NDArray[np.uint8], NDArray[np.uint8]]:  # fmt: skip
        """Warp both pictures so that the distortion of the headset's lens cancels out, as the panel shows them.

        Each is warped about the axis of its eye's lens. Both have r = 1 at the same tangent, `Hmd.lens_radius` or
        `Hmd.tan_half_angle`. `size` is (width, height) in pixels of each picture, such as `Hmd.panel_size`, by default
        the size of the frames; `filter` is "linear" or "cubic", in linear light, as in `RadialLens.warp`. The pictures
        are sRGB (H, W, 3) uint8, black where the lens shows no part of the frame. ValueError for a headset without a
        lens (see `Hmd.with_lens`), and frames without colour.
        """
        hmd = self.hmd
        if hmd is None:
            raise ValueError("hmd: expected a headset with a lens, got the picture of a rig without a headset")
        lens = hmd.lens
        if lens is None:
            raise ValueError(f"hmd: expected a lens, {hmd.name} has none; hmd.with_lens() adds a generic one")
        radius = hmd.tan_half_angle if hmd.lens_radius is None else hmd.lens_radius

        def picture(frame: Frame) -> NDArray[np.uint8]:
            # The cubic filter overshoots at edges.
            linear = np.clip(lens.warp(frame, True, lens_radius=radius, size=size, filter=filter), 0.0, 1.0)
            return _core.encode_srgb(linear).reshape(linear.shape)

        return picture(self.left), picture(self.right)

    @card.repr_html
    def _repr_html_(self) -> str:
        """Both pictures side by side for notebooks, with headset and size below."""
        width, height = self.left.camera.size
        owner = "a rig" if self.hmd is None else self.hmd.name
        caption = f"left and right eye of {owner}, {width} × {height} pixels each"
        return card.page("StereoFrame", (), card.picture(self.side_by_side, "left and right eye", caption))

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write `side_by_side` as a PNG, atomically.

        ValueError for a name that does not end in .png and frames without colour; OSError if it cannot be written.
        `left.save` and `right.save` write the frames, also as EXR.
        """
        files.write_png(check.path("path", path, ".png"), self.side_by_side)


def render_eyes(
    source: Renderable,
    hmd: Hmd,
    position: ArrayLike,
    *,
    orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
    size: tuple[int, int] | None = None,
    scale: float | None = None,
    at: Mapping[str, ArrayLike] | None = None,
    user: User | ArrayLike = "eyes",
    settings: RenderSettings | None = None,
    **keywords: Unpack[RenderKeywords],
) -> StereoFrame:
    """Render a scene, a reduced scene or another `Renderable` for both eyes of a headset.

    The frames equal those of `render` for `hmd.camera("left", …)` and "right". ValueError and TypeError for arguments
    out of range, and for both `size` and `scale`; DeviceError as in `render`.

    Parameters
    ----------
    source
        The scene, reduced scene, or other renderable.
    hmd
        The headset: positions and fields of view of its eyes.
    position
        World position (3,) of the head, metres.
    orientation
        Unit quaternion (x, y, z, w) that turns head axes into world axes; by default the head looks along −z.
        `Camera.look_at(…).orientation` turns it to a target.
    size
        Width and height in pixels of each eye's picture; by default `hmd.render_size`.
    scale
        Factor on width and height of `hmd.render_size` instead of `size`, above 0: 0.5 renders a quarter of the pixels.
    at
        Poses of dynamic objects, as `Scene.at` takes them.
    user
        The eye U for which a reduced scene is morphed. "eyes": each eye is its own user, so that neither picture breaks
        at r1 or r2, and the disparity of geometry falls to 0, the disparity of the map, at r2. "middle": the point
        between the eyes is the user for both, so that both eyes see the same morphed geometry; the pictures break at r2
        by half the eyes' distance / r2 radians. A world position (3,) in metres is used for both eyes. Scenes do not
        depend on it.
    settings
        Samples, channels, limits, backend and levels, as `RenderSettings`. Levels are chosen once, for both eyes; a
        budget of triangles counts each object twice.
    keywords
        Fields of `settings`, which they replace.
    """
    check.instance("hmd", hmd, Hmd, "an Hmd such as nearfar.hmd.QUEST_2")
    pixels = _size(hmd, size, scale)
    renderer = Renderer(source, gather(RenderSettings, settings, keywords))
    cameras = [hmd.camera(eye, position, orientation, size=pixels) for eye in EYES]
    shot = renderer.shot(cameras, _user(user, [camera.position for camera in cameras]))
    left, right = renderer.frames(shot, at, renderer.device())
    return StereoFrame(hmd, left, right)


def _size(hmd: Hmd, size: tuple[int, int] | None, scale: float | None) -> tuple[int, int]:
    if scale is None:
        return hmd.render_size if size is None else size
    if size is not None:
        raise ValueError(f"scale: expected None with a size, got {check.value_or_type(scale)}")
    factor = check.positive("scale", scale)
    width, height = (max(1, round(min(side * factor, check.MAX_SIZE + 1))) for side in hmd.render_size)
    return check.size("scale", (width, height))


def _user(user: Any, eyes: list[tuple[float, float, float]]) -> ArrayLike | None:
    """Return the position of the user for both eyes; None makes each eye its own user."""
    if not isinstance(user, str):
        return check.vector("user", user)
    middle = np.mean(eyes, axis=0)
    return middle if check.choice("user", user, USERS) == "middle" else None
