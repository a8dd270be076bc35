"""Motion blur: a picture averaged over the poses between two cameras."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import SupportsFloat, SupportsIndex

import numpy as np

from nearfar import _core
from nearfar._base import check
from nearfar._camera.camera import Camera
from nearfar._render.frame import Frame
from nearfar._render.ranged import ranged

MAX_POSES = 64


def motion_blur(frame: Frame, before: Camera, *, shutter: SupportsFloat = 0.5, poses: SupportsIndex = 8) -> Frame:
    """Average a picture over the poses that its camera had while the shutter was open.

    Each pixel is warped forward to where each pose shows its surface, and the nearest surface counts; then the linear
    colours of the poses are averaged, at each pixel over the poses that show something there. Only the camera's motion
    is considered: moving objects are blurred like static ones.

    Parameters
    ----------
    frame
        The picture, with colour and range, by a camera of any projection.
    before
        Camera of the previous picture; its position and orientation are used. In between the eye moves straight and
        turns evenly.
    shutter
        Time for which the shutter is open before the picture, in intervals between two pictures, 0 to 1.
    poses
        Number of poses, 1 to 64.

    Returns
    -------
    Frame
        The picture with averaged colours; its other images are unchanged, and so are colours if the camera did not
        move.

    Raises
    ------
    ValueError
        A frame without colour or range, or numbers out of range.
    TypeError
        A value that is not a frame or not a camera.
    """
    picture, earlier = ranged("frame", frame), check.instance("before", before, Camera)
    open_time = check.in_range("shutter", shutter, 0.0, 1.0)
    count = check.integer("poses", poses, 1, MAX_POSES)
    cameras = [pose_between(frame.camera, earlier, open_time * (n + 0.5) / count) for n in range(count)]
    color = _core.blur_motion(picture, [camera._core for camera in cameras])
    return replace(frame, color=color)


def pose_between(camera: Camera, other: Camera, weight: float) -> Camera:
    """Interpolate between the poses of two cameras: a straight line, and an even turn (Shoemake 1985)."""
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
