"""Notebook display of reduced scenes: a card, the page's viewer, and an explorer with ipywidgets sliders."""

from __future__ import annotations

from typing import Any

import numpy as np

from nearfar._base import card, check
from nearfar._camera.camera import Camera
from nearfar._partition.load_curve import load_curve
from nearfar._reduce.baking import MapSettings
from nearfar._reduce.data import ReducedData
from nearfar._reduce.drawing import MORPHS
from nearfar._reduce.user_explorer import UserExplorer, step_of
from nearfar._render.showing import View, show as make_view
from nearfar.metrics._comparison import compare
from nearfar.metrics._discontinuity import discontinuity

MAX_TRIANGLES = 300_000
"""Maximum number of near triangles within the range of the r2 slider, so that a frame does not take seconds."""

MAX_R1_SHARE = 0.95
"""Greatest r1, as a share of r2."""


class Explorer(UserExplorer):
    """Picture and truth of a reduced scene with sliders for the user and the radii; made by `ReducedScene.explore`.

    Besides the attributes of its base, `r1`, `r2` and `morph` are ipywidgets.
    """

    def __init__(self, reduced: ReducedData, *, size: tuple[int, int], face_size: int) -> None:
        can_bake = reduced._is_whole
        super().__init__(
            reduced.center, reduced.r1, size=check.size("size", size), truth=reduced.scene if can_bake else None
        )
        self._baking = MapSettings(face_size=face_size, samples=1, channels=("color", "range"), backend="cpu")
        has_range = reduced.env is None or reduced.env.range is not None
        self.reduced: Any = reduced if has_range or not can_bake else reduced._reduce_again(self._baking)
        """The `ReducedScene` with the present radii and morph."""
        r1, r2 = reduced.r1, reduced.r2
        reach = max(r2, _reach(reduced)) if can_bake else r2
        released: dict[str, Any] = {"continuous_update": False, "disabled": not can_bake}
        self.r1 = self._slider("r₁, m", r1, 0.0, reach, step_of(reach), **released)
        self.r2 = self._slider("r₂, m", r2, 0.0, reach, step_of(reach), **released)
        kinds = MORPHS if reduced._boundary == "r2" else ("none",)
        self.morph = self._widgets.Dropdown(
            options=kinds, value=reduced.morph, description="morph", layout=self.r1.layout
        )
        for control in (self.r1, self.r2):
            control.observe(self._on_radius_change, "value")
        self.morph.observe(self._on_morph_change, "value")
        self._show(self.r1, self.r2, self.morph)

    @property
    def _limit(self) -> float:
        return float(self.reduced.r1)

    def __repr__(self) -> str:
        return f"Explorer of {self.reduced!r}"

    def _on_radius_change(self, change: Any) -> None:
        if self._is_suspended:
            return
        with self._suspend_drawing():
            self.r2.value = max(self.r2.value, self.r2.step)
            if self.r1.value > MAX_R1_SHARE * self.r2.value:
                self.r1.value = MAX_R1_SHARE * self.r2.value
        reduced = self.reduced._reduce_again(self._baking, r1=self.r1.value, r2=self.r2.value)
        self.reduced = reduced.with_morph(self.morph.value)
        self._keep_inside()
        self._draw()

    def _on_morph_change(self, change: Any) -> None:
        self.reduced = self.reduced.with_morph(self.morph.value)
        self._draw()

    def _render_pictures(self, camera: Camera) -> list[tuple[str, str]]:
        reduced = self.reduced
        env = reduced.env
        channels = ("color", "position") if env is None or env.range is not None else ("color",)
        # Bent rays show the exact morph, and are faster than splitting triangles for each position of the user.
        frame = reduced.render(camera, channels=channels, method="exact", backend="cpu")
        self.picture.value = card.png(frame.to_image())
        stats = reduced.stats
        rows = [("triangles", f"{stats['drawn']:,} of {stats['triangles']:,}, {stats['reduction']:,.4g} times fewer")]
        if not reduced._is_whole:
            reason = "not saved: the truth and other radii need the original scene"
            torn = discontinuity(frame) if "position" in channels else np.empty(0)
            return [*rows, *_discontinuity_rows(torn), ("far geometry", reason)]
        comparison = compare(self._render_truth(camera), frame, center=reduced.center, radius=reduced._boundary_radius)
        edge = comparison.boundary_discontinuity
        return [
            ("SSIM", f"{comparison.ssim:.4f}"),
            ("PSNR", f"{comparison.psnr:.2f} dB"),
            *_discontinuity_rows(comparison.torn),
            ("discontinuity along the boundary", "–" if edge is None else f"{edge:.3f}"),
            *rows,
        ]


def _reach(reduced: ReducedData) -> float:
    """Return the upper end of the r2 slider in metres: four times r2, or less to limit the number of triangles."""
    budget = max(MAX_TRIANGLES, reduced.stats["nsf"])
    return min(4.0 * reduced.r2, float(load_curve(reduced.scene, center=reduced.center).radius(budget)))


def _discontinuity_rows(torn: Any) -> list[tuple[str, str]]:
    values = torn[~np.isnan(torn)]
    return [("discontinuity, mean", f"{values.mean():.3f}" if values.size else "–")]


class NotebookMixin(ReducedData):
    """Display of a reduced scene; the base of `ReducedScene`."""

    @card.repr_html
    def _repr_html_(self) -> str:
        stats = self.stats
        moving = stats["nsf"] - stats["near"] - stats["intermediate"]
        facts = [
            ("drawn", f"{stats['drawn']:,} of {stats['triangles']:,} triangles, {stats['reduction']:,.4g} times fewer"),
            ("near", f"{stats['near']:,}"),
            ("intermediate", f"{stats['intermediate']:,}"),
            *([("moving", f"{moving:,}")] if moving else []),
            ("r₁, r₂", f"{self.r1:g} m, {self.r2:g} m"),
            *([("chosen", self.reason)] if self.reason else []),
            ("morph", self.morph),
            ("centre", card.point(self.center)),
            ("copies of near geometry", f"{stats['near_bytes'] / 1e6:,.1f} MB"),
        ]
        if self.env is None:
            return card.page("ReducedScene", facts, notes=["Nothing lies beyond the near part, so there is no map."])
        facts.append(("map", f"6 × {self.env.face_size}² texels, {stats['map_bytes'] / 1e6:,.1f} MB"))
        _, pixels = self.env._preview()
        caption = "the map: what the centre sees beyond the near part, −z in the middle"
        return card.page("ReducedScene", facts, card.picture(pixels, "environment map", caption))

    def explore(self, *, size: tuple[int, int] = (400, 250), face_size: int = 256) -> Explorer:
        """Show the picture beside the truth in a notebook, with sliders for the user and the radii.

        The explorer's sliders are attributes, and its `reduced` is the reduced scene of the present radii. A notebook
        shows the explorer if it is the last value of a cell. The user stays within the near zone, ρ ≤ r1. ImportError
        if ipywidgets is not installed; ValueError and TypeError for arguments out of range.

        Parameters
        ----------
        size
            Width and height of both pictures in pixels, 16 to 2048.
        face_size
            Number of texels across the faces of maps that the explorer bakes, 1 to 1024. It bakes at the start if the
            map lacks range, which discontinuity needs, and whenever a radius slider is released.
        """
        for name, value in zip(("size[0]", "size[1]"), check.size("size", size), strict=True):
            check.integer(name, value, 16, 2048)
        return Explorer(self, size=size, face_size=check.integer("face_size", face_size, 1, 1024))

    def show(
        self, *, size: tuple[int, int] = (640, 400), camera: Camera | None = None, strategy: str = "clovr"
    ) -> View:
        """Show the reduced scene in a notebook: the page's viewer, in which the user walks and looks around.

        Files are sent to the browser as notebook messages, so that Python may run on another machine. Returns a widget,
        which a notebook shows if it is the last value of a cell. Its `camera` can be read and set, as can `position`,
        `yaw`, `pitch` (radians) and `angle` (degrees); `ring`, `region`, `radius`, `strength` and `problem` can be
        read. Places without widgets, such as saved notebooks, show a picture. ImportError if anywidget is not
        installed; ValueError and TypeError for arguments out of range, such as a camera with roll, or a scene without a
        morph.

        Parameters
        ----------
        size
            Width and height in pixels of the browser, 16 to 8192; smaller if a cell is narrower.
        camera
            Initial view of the user; by default at the centre, looking along −z, with a vertical field of view of 75°.
        strategy
            "clovr": the near part fades in, and the morph grows by its strength. "clovrd": it is shown at once.
        """
        return make_view(self, center=self.center, size=size, camera=camera, strategy=strategy)
