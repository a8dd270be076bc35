"""Notebook display of reduced scenes: a card, the page's viewer, and an explorer with ipywidgets sliders."""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from nearfar._base import card, check
from nearfar._base.errors import Error
from nearfar._camera.camera import Camera, Fov
from nearfar._partition.load_curve import load_curve
from nearfar._reduce.baking import MapSettings
from nearfar._reduce.data import ReducedData
from nearfar._reduce.drawing import MORPHS
from nearfar._render.frame import Frame
from nearfar._render.showing import View, show as make_view
from nearfar._render.truth import render
from nearfar.metrics._comparison import compare
from nearfar.metrics._discontinuity import discontinuity

MAX_TRIANGLES = 300_000
"""Maximum number of near triangles within the range of the r2 slider, so that a frame does not take seconds."""

FOV_DEG = 90.0
"""Horizontal field of view of the pictures, degrees."""

MAX_R1_SHARE = 0.95
"""Greatest r1, as a share of r2."""


class Explorer:
    """Picture and truth of a reduced scene with sliders; created by `ReducedScene.explore`.

    The attributes are ipywidgets, so that code can set them, too: `x`, `z` and `height` are the user's position in
    metres relative to the centre, `heading` degrees to the right of −z, `r1`, `r2` and `morph`. `picture` and `truth`
    hold PNG files, `figures` HTML, and `widget` contains all of them.
    """

    def __init__(self, reduced: ReducedData, *, size: tuple[int, int], face_size: int) -> None:
        self._size = check.size("size", size)
        self._baking = MapSettings(face_size=face_size, samples=1, channels=("color", "range"), backend="cpu")
        try:
            import ipywidgets as widgets
        except ImportError:
            raise ImportError("explore needs ipywidgets: pip install ipywidgets") from None
        self._is_suspended = False
        self._last_truth: tuple[Camera, Frame] | None = None
        can_bake = reduced._is_whole
        has_range = reduced.env is None or reduced.env.range is not None
        self.reduced: Any = reduced if has_range or not can_bake else reduced._reduce_again(self._baking)
        """The `ReducedScene` with the present radii and morph."""
        r1, r2 = reduced.r1, reduced.r2
        reach = max(r2, _reach(reduced)) if can_bake else r2
        step = _step(reach)

        layout = widgets.Layout(width="98%", max_width="28em")

        def slider(name: str, value: float, low: float, high: float, step: float, **more: Any) -> Any:
            more = {"continuous_update": True, "readout_format": ".4g", **more}
            return widgets.FloatSlider(
                value=value, min=low, max=high, step=step, description=name, layout=layout, **more
            )

        metre = max(r1, 1e-6)
        self.x = slider("x, m", 0.0, -r1, r1, _step(metre), disabled=r1 == 0.0)
        self.z = slider("z, m", 0.0, -r1, r1, _step(metre), disabled=r1 == 0.0)
        self.height = slider("height, m", 0.0, -min(1.5, metre / 2.0), min(3.0, metre), min(0.05, metre / 100.0))
        self.heading = slider("heading, °", 0.0, -180.0, 180.0, 1.0)
        released: dict[str, Any] = {"continuous_update": False, "disabled": not can_bake}
        self.r1 = slider("r₁, m", r1, 0.0, reach, step, **released)
        self.r2 = slider("r₂, m", r2, 0.0, reach, step, **released)
        kinds = MORPHS if reduced._boundary == "r2" else ("none",)
        self.morph = widgets.Dropdown(options=kinds, value=reduced.morph, description="morph", layout=layout)
        self.truth, self.picture = (widgets.Image(format="png", layout={"max_width": "100%"}) for _ in range(2))
        self.figures = widgets.HTML()
        wrap = widgets.Layout(flex_flow="row wrap", width="100%")
        column = widgets.Layout(flex="1 1 20em", max_width="30em", min_width="0")
        titled = [
            widgets.VBox([widgets.HTML(f"<b>{title}</b>"), image], layout=widgets.Layout(max_width="100%"))
            for title, image in (("truth", self.truth), ("reduced", self.picture))
        ]
        self.widget: Any = widgets.VBox(
            [
                widgets.HBox(titled if can_bake else titled[1:], layout=wrap),
                self.figures,
                widgets.HBox(
                    [
                        widgets.VBox([self.x, self.z, self.height, self.heading], layout=column),
                        widgets.VBox([self.r1, self.r2, self.morph], layout=column),
                    ],
                    layout=wrap,
                ),
            ]
        )
        """Widget that contains the pictures, figures and sliders."""
        for control in (self.x, self.z, self.height, self.heading):
            control.observe(self._on_slider_change, "value")
        for control in (self.r1, self.r2):
            control.observe(self._on_radius_change, "value")
        self.morph.observe(self._on_morph_change, "value")
        self._draw()

    @property
    def camera(self) -> Camera:
        """The camera at the user's place, which looks along `heading`."""
        turn = math.radians(self.heading.value)
        eye = np.add(self.reduced.center, (self.x.value, self.height.value, self.z.value))
        forward = (math.sin(turn), 0.0, -math.cos(turn))
        fov = Fov.symmetric(FOV_DEG, self._size[0] / self._size[1])
        return Camera.look_at(eye, eye + forward, fov=fov, size=self._size)

    def _repr_mimebundle_(self, **settings: Any) -> Any:
        # Pages without widgets show the text instead.
        return {**self.widget._repr_mimebundle_(**settings), "text/plain": repr(self)}

    def __repr__(self) -> str:
        return f"Explorer of {self.reduced!r}"

    @contextmanager
    def _suspend_drawing(self) -> Iterator[None]:
        """Prevent drawing while code sets several sliders."""
        self._is_suspended = True
        try:
            yield
        finally:
            self._is_suspended = False

    def _keep_inside(self) -> None:
        """Move the user into the near zone."""
        distance, limit = math.hypot(self.x.value, self.z.value), self.reduced.r1
        with self._suspend_drawing():
            if distance > limit:
                # The factor keeps the user inside despite rounding.
                factor = limit / distance * (1.0 - 1e-12)
                self.x.value, self.z.value = self.x.value * factor, self.z.value * factor
            for control in (self.x, self.z):
                control.min, control.max, control.disabled = -limit, limit, limit == 0.0

    def _on_slider_change(self, change: Any) -> None:
        if not self._is_suspended:
            self._keep_inside()
            self._draw()

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

    def _draw(self) -> None:
        """Render both pictures. Errors appear below them, because notebooks hide errors of callbacks."""
        try:
            rows = self._render_pictures(self.camera)
        except (Error, ValueError, RuntimeError, MemoryError) as error:
            rows = [("not drawn", f"{type(error).__name__}: {error}")]
        self.figures.value = card.table(rows)

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
        comparison = compare(self._truth(camera), frame, center=reduced.center, radius=reduced._boundary_radius)
        edge = comparison.boundary_discontinuity
        return [
            ("SSIM", f"{comparison.ssim:.4f}"),
            ("PSNR", f"{comparison.psnr:.2f} dB"),
            *_discontinuity_rows(comparison.torn),
            ("discontinuity along the boundary", "–" if edge is None else f"{edge:.3f}"),
            *rows,
        ]

    def _truth(self, camera: Camera) -> Frame:
        """Ground truth, which depends on the camera only."""
        if self._last_truth is None or self._last_truth[0] != camera:
            self._last_truth = camera, render(self.reduced.scene, camera, channels=("color",), backend="cpu")
            self.truth.value = card.png(self._last_truth[1].to_image())
        return self._last_truth[1]


def _step(length: float) -> float:
    """Step of a slider with a range of `length`: a power of ten, at most a hundredth of it."""
    return float(10.0 ** (math.floor(math.log10(length)) - 2))


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
