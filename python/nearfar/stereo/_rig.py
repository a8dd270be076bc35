"""The `HybridRig` class: two eyes that share one picture beyond a plane, and the rendering of their pictures."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar._base import check, progress
from nearfar._base.settings import gather, split
from nearfar._camera.camera import quaternion
from nearfar._render.renderable import Renderable
from nearfar._render.renderer import Renderer
from nearfar._render.settings import RenderSettings
from nearfar._scene.scene import Scene
from nearfar.hmd._hmd import EYES, Hmd
from nearfar.hmd._stereo import StereoFrame
from nearfar.stereo._geometry import RigGeometry
from nearfar.stereo._moments import moment_before
from nearfar.stereo._passes import check_near, render
from nearfar.stereo._settings import HybridOptions, HybridSettings


@dataclass(frozen=True, kw_only=True)
class HybridRig(RigGeometry):
    """Two eyes, and a third camera behind them whose picture both share beyond the mono plane.

    The plane lies `mono_plane` metres ahead of the plane of the eyes, in head axes, regardless of the eyes'
    orientation. Each eye draws nearer geometry, the third camera farther geometry; its picture is mapped to each eye by
    the homography of the plane. The picture thus has no seam at the plane, and the error of a point beyond it is
    (a s − p)(z − m)/((z + s) m) in tangents: a is the true tangent of the point for the eye at p, z its depth, m the
    plane, s the `center_offset`.

    ValueError and TypeError for eyes that are not beside each other, that look farther than 90° from the head's forward
    axis, or whose views do not overlap on the plane; for a plane behind an eye, or a zone that ends before it begins.
    Source: Fink, Hensel, Markov-Vetter, Weber, Staadt, Stamminger (2019): Hybrid mono-stereo rendering in virtual
    reality, Eq. 5 and 8. The paper maps the near plane of the third camera instead of m, which leaves a seam of 0.2
    pixels at 8 m.

    Parameters
    ----------
    left, right
        The eyes: field of view, position and orientation on the head.
    mono_plane
        Distance m of the plane from the plane of the eyes, metres; or a pair (m₁, m₂) for a zone: eyes draw up to m₂,
        and beyond m₁ points move smoothly from their own places to their places in the shared picture, so that straight
        lines become parabolas without a kink. Both pictures meet on the plane m with 1/m = (1/m₁ + 1/m₂)/2. Zones are
        drawn for scenes only, on the CPU.
    size
        Width and height of an eye's picture, pixels.
    hmd
        The headset, whose lens distorts the pictures; None for no headset.
    """

    @classmethod
    def of(cls, hmd: Hmd, *, mono_plane: float | tuple[float, float], size: tuple[int, int] | None = None) -> HybridRig:
        """Return the rig of a headset; `size` in pixels is its `render_size` by default."""
        check.instance("hmd", hmd, Hmd, "an Hmd")
        pixels = hmd.render_size if size is None else size
        return cls(left=hmd.left, right=hmd.right, mono_plane=mono_plane, size=pixels, hmd=hmd)

    def render(
        self,
        source: Renderable,
        position: ArrayLike,
        orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        at: Mapping[str, ArrayLike] | None = None,
        before: tuple[ArrayLike, ArrayLike] | None = None,
        before_at: Mapping[str, ArrayLike] | None = None,
        settings: RenderSettings | None = None,
        hybrid: HybridSettings | None = None,
        **keywords: Unpack[HybridOptions],
    ) -> StereoFrame:
        """Render near geometry for each eye, and geometry beyond the plane once for both.

        A surface that crosses the plane is drawn by all three cameras. For scenes, if nothing lies before the plane,
        only the shared picture is drawn; if nothing lies beyond it, the result is plain stereo. ValueError and
        TypeError for arguments out of range, a plane nearer than `near`, a zone or "resolved" with a source other than
        a scene, and a zone on a graphics adapter; DeviceError as in `render`. Source: Fink et al. (2019).

        Parameters
        ----------
        source
            Scene, reduced scene or other renderable. All pictures of a reduced scene are morphed for the point between
            the eyes, and its map is looked up by the third camera.
        position
            World position (3,) of the head, metres.
        orientation
            Unit quaternion (x, y, z, w) that rotates head axes to world axes; by default the head looks along −z.
        at
            Poses of dynamic objects, as `Scene.at` takes them.
        before, before_at
            For the channel "motion": position and orientation of the head in an earlier frame, and poses of dynamic
            objects then, by default the source's own. Pixels of the shared picture move by its own motion, mapped to
            the eye (Eq. 9).
        settings
            Samples, channels, backend and levels, as `nearfar.RenderSettings`; depths replace its limits. Samples of an
            eye without a surface of its own show the shared picture, so that edges before the plane are as smooth as in
            `render`. There channels other than colour and coverage come from the nearest pixel of the shared picture.
            Levels of detail are chosen once for both eyes, by the larger of the two sizes.
        hybrid
            Culling, look-up of the shared picture and depths, as `HybridSettings`.
        keywords
            Fields of `settings` and `hybrid`, which they replace.

        Returns
        -------
        StereoFrame
            `left`, `right` and `center`. `stats` contains `pixels`: numbers of pixels of each eye with a surface of its
            own, and of drawn and discarded pixels of the third camera; for scenes `instances` and `triangles`: numbers
            that each of the three views may show, at the drawn levels of detail; and `seconds`, the wall time of each
            stage. A selector with a budget counts objects as often as `draws` says, and objects of a reduced scene
            three times: `left.lod.selection.spent` has the triangles counted once and as drawn.
        """
        render_keywords, hybrid_keywords = split(HybridSettings, keywords)
        renderer = Renderer(source, gather(RenderSettings, settings, render_keywords))
        earlier = moment_before(source, before, before_at)
        if earlier is None and "motion" in renderer.channels:
            raise ValueError("channels: expected motion with the head's pose in an earlier frame, `before`")
        frame, _ = render(
            self,
            renderer,
            (position, orientation),
            at=at,
            hybrid=gather(HybridSettings, hybrid, hybrid_keywords, argument="hybrid"),
            before=earlier,
        )
        return frame

    def draws(
        self,
        centers: ArrayLike,
        radii: ArrayLike,
        position: ArrayLike,
        orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        near: float = 0.1,
        far: float = math.inf,
    ) -> NDArray[np.uint8]:
        """Count the pictures that may draw each of N objects: 0 to 3 (N,), for `draws` of `nearfar.lod.select`.

        An object before the plane is drawn for each eye that sees it, one beyond the plane by the third camera, one
        across it by all three. The test is conservative: the box around an object's sphere counts. ValueError and
        TypeError for arguments out of range.

        Parameters
        ----------
        centers
            Centres of the objects' bounding spheres (N, 3), world metres.
        radii
            Radii (N,) or one for all, metres, at least 0.
        position, orientation
            Pose of the head, as in `render`.
        near, far
            Depths from the plane of the eyes between which surfaces are drawn, metres.
        """
        depths = HybridSettings(near=near, far=far)
        check_near(self, depths.near)
        sphere_centers, sphere_radii = check.spheres(centers, radii)
        for name, values in (("centers", sphere_centers), ("radii", sphere_radii)):
            if flaw := check.not_finite(name, values):
                raise flaw
        if sphere_radii.size and sphere_radii.min() < 0.0:
            raise ValueError(f"radii: expected numbers of at least 0, got {sphere_radii.min()}")
        head = check.vector("position", position), quaternion(orientation), (depths.near, depths.far)
        extents = sphere_radii[:, None]
        return self._core.draws(np.stack([sphere_centers - extents, sphere_centers + extents], axis=1), head)

    def triangles(
        self,
        scene: Scene,
        position: ArrayLike,
        orientation: ArrayLike = (0.0, 0.0, 0.0, 1.0),
        *,
        near: float = 0.1,
        far: float = math.inf,
    ) -> dict[str, int]:
        """Count the triangles that each camera draws, and those of plain stereo, without drawing.

        If `left`, `right` and `center` together exceed `plain`, the plane is so far away that three pictures cost more
        geometry than two. Each counts the triangles of the scene, in its present pose, that intersect the space that
        the camera draws. `thrice` counts triangles that cross the plane, so that all three cameras draw them, and
        `plain` the triangles of both eyes without a plane. ValueError and TypeError for arguments out of range, which
        are as in `render`.
        """
        check.instance("scene", scene, Scene)
        depths = HybridSettings(near=near, far=far)
        check_near(self, depths.near)
        head = check.vector("position", position), quaternion(orientation), (depths.near, depths.far)
        with progress.bar("counting") as report:
            views, thrice, plain = self._core.triangles(scene._core, head, report)
        return dict(zip((*EYES, "center"), views, strict=True)) | {"thrice": thrice, "plain": sum(plain)}
