"""Pictures over time: `Steady` fades from one to the next, so that changes of the cut do not pop; motion blur."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import SupportsFloat, SupportsIndex

import numpy as np

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame
from nearfar._render.ranged import Ranged, motion_of, ranged


class Steady:
    """Fades each picture of a sequence into the next one, surface by surface.

    For each pixel of the new picture, the previous picture is looked up at the place where the pixel's surface was. The
    pixel *agrees* if the new camera would show the surface found there at most Δt/τ pixels, and at most half a pixel,
    from the pixel; Δt is the time between the pictures. Then it is the same surface, or one that has disappeared from
    the new picture and fades out. Pixels that agree are blended with the previous colour, whose weight is e^(−Δt/τ).
    All other pixels, mostly disoccluded ones, are unchanged. ValueError and TypeError for values out of range.

    Parameters
    ----------
    seconds
        τ in seconds where the picture does not move: the time in which a difference decays to 1/e.
    moving
        τ where the picture moves by a tenth of a pixel or more; between 0 and a tenth τ is interpolated. Interpolation
        between pixels of the previous picture blurs, so this time should be short.
    least
        Least share of pixels that must agree, 0 to 1. With fewer, as after a jump to another place, the new picture is
        returned unchanged.
    """

    def __init__(
        self, *, seconds: SupportsFloat = 0.5, moving: SupportsFloat = 0.05, least: SupportsFloat = 0.25
    ) -> None:
        self._times = check.positive("seconds", seconds), check.positive("moving", moving)
        self._least = check.in_range("least", least, 0.0, 1.0)
        self.restart()

    def restart(self) -> None:
        """Forget the previous picture; for a change of world."""
        self._past: tuple[float, Ranged] | None = None

    def next(self, frame: Frame, time: SupportsFloat) -> Frame:
        """Return the next picture with blended colours; its other images are unchanged.

        `agreed` in `stats` is the share of pixels that agree with the previous picture; 0 for the first one.
        ValueError for a frame without colour or range, or a time that is not later; TypeError for a value that is not a
        frame or not a number.

        Parameters
        ----------
        frame
            The picture, with colour and range, by a camera of any projection and size. The channel "motion", which must
            be relative to the previous picture, allows for moving objects: it locates each surface in the previous
            picture, where a surface counts only at the same distance, within 2 %. Without it only the camera may move.
        time
            Its time in seconds, later than that of the previous picture.
        """
        picture, moment = ranged("frame", frame), check.number("time", time)
        motion = motion_of("frame", frame) if "motion" in frame.channels else None
        color, agreed = picture[1], 0.0
        if self._past is not None:
            earlier, past = self._past
            if moment <= earlier:
                raise ValueError(f"time: expected more than {earlier:g}, that of the picture before, got {moment:g}")
            still, moving = ((moment - earlier) / seconds for seconds in self._times)
            mixed, agrees = _core.blend_past(past, picture, fade=(still, moving), motion=motion)
            agreed = float(agrees.mean())
            color = mixed if agreed >= self._least else color
        # Copies: the caller owns the arrays of a frame and may write into them.
        self._past = moment, (picture[0], color.copy() if color is picture[1] else color, picture[2].copy())
        return replace(frame, color=color, stats={**frame.stats, "agreed": agreed})


MAX_POSES = 64


def motion_blur(frame: Frame, before: Camera, *, shutter: SupportsFloat = 0.5, poses: SupportsIndex = 8) -> Frame:
    """Average a picture over the poses that its camera had while the shutter was open.

    The picture is warped to each pose: each pixel moves to the place where the pose shows its surface, and the nearest
    surface wins. Then each pixel is the mean of the linear colours of the poses that show something there. Only the
    camera's motion is considered: moving objects are blurred like static ones. Images other than colours are unchanged,
    and so are colours if the camera did not move. ValueError for a frame without colour or range, or numbers out of
    range; TypeError for a value that is not a frame or not a camera.

    Parameters
    ----------
    frame
        The picture, with colour and range, by a camera of any projection.
    before
        Camera of the previous picture; its position and orientation are used. In between, the camera moves along a
        straight line and turns at a constant rate.
    shutter
        Time for which the shutter is open before the picture, as a share, 0 to 1, of the interval between the two
        pictures.
    poses
        Number of poses, 1 to 64.
    """
    picture, earlier = ranged("frame", frame), check.instance("before", before, Camera)
    open_time = check.in_range("shutter", shutter, 0.0, 1.0)
    count = check.integer("poses", poses, 1, MAX_POSES)
    cameras = [pose_between(frame.camera, earlier, open_time * (n + 0.5) / count) for n in range(count)]
    color = _core.blur_motion(picture, [camera._core for camera in cameras])
    return replace(frame, color=color)


def pose_between(camera: Camera, other: Camera, weight: float) -> Camera:
    """Interpolate between the poses of two cameras: linear positions, slerp of orientations (Shoemake 1985)."""
    x, y, z = ((1 - weight) * np.array(camera.position) + weight * np.array(other.position)).tolist()
    start, end = np.array(camera.orientation), np.array(other.orientation)
    cosine = float(start @ end)
    if cosine < 0.0:
        end, cosine = -end, -cosine
    angle = math.acos(min(cosine, 1.0))
    if angle < 1e-6:
        mixed = (1 - weight) * start + weight * end
    else:
        mixed = (math.sin((1 - weight) * angle) * start + math.sin(weight * angle) * end) / math.sin(angle)
    i, j, k, w = (mixed / np.linalg.norm(mixed)).tolist()
    return replace(camera, position=(x, y, z), orientation=(i, j, k, w))
