"""Sliders for a user's position and heading, with the user's picture beside the truth, for notebooks."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np

from nearfar._base import card
from nearfar._base.errors import Error
from nearfar._camera.camera import Camera, Fov
from nearfar._render.frame import Frame
from nearfar._render.truth import render
from nearfar._scene.scene import Scene

FOV_DEG = 90.0
"""Horizontal field of view of the pictures, degrees."""

Point = tuple[float, float, float]


class UserExplorer(ABC):
    """Picture and truth for a user who is moved by sliders; the base of both explorers.

    The attributes are ipywidgets, so that code can set them, too: `x`, `z` and `height` are the user's position in
    metres relative to the centre, `heading` degrees to the right of −z. `picture` and `truth` hold PNG files, `figures`
    HTML, and `widget` contains all of them.
    """

    def __init__(self, center: Point, limit: float, *, size: tuple[int, int], truth: Scene | None) -> None:
        try:
            import ipywidgets as widgets
        except ImportError:
            raise ImportError("explore needs ipywidgets: pip install ipywidgets") from None
        self._widgets: Any = widgets
        self._center, self._size, self._truth_scene = center, size, truth
        self._is_suspended = False
        self._last_truth: tuple[Camera, Frame] | None = None
        metre = max(limit, 1e-6)
        self.x = self._slider("x, m", 0.0, -limit, limit, step_of(metre), disabled=limit == 0.0)
        self.z = self._slider("z, m", 0.0, -limit, limit, step_of(metre), disabled=limit == 0.0)
        self.height = self._slider("height, m", 0.0, -min(1.5, metre / 2.0), min(3.0, metre), min(0.05, metre / 100.0))
        self.heading = self._slider("heading, °", 0.0, -180.0, 180.0, 1.0)
        self.truth, self.picture = (widgets.Image(format="png", layout={"max_width": "100%"}) for _ in range(2))
        self.figures = widgets.HTML()
        self.widget: Any = None
        """Widget that contains the pictures, figures and sliders."""

    def _slider(self, name: str, value: float, low: float, high: float, step: float, **more: Any) -> Any:
        layout = self._widgets.Layout(width="98%", max_width="28em")
        settings = {"continuous_update": True, "readout_format": ".4g", **more}
        return self._widgets.FloatSlider(
            value=value, min=low, max=high, step=step, description=name, layout=layout, **settings
        )

    def _show(self, *controls: Any) -> None:
        """Arrange all widgets, with further controls, and draw the first pictures."""
        widgets = self._widgets
        wrap = widgets.Layout(flex_flow="row wrap", width="100%")
        column = widgets.Layout(flex="1 1 20em", max_width="30em", min_width="0")
        titled = [
            widgets.VBox([widgets.HTML(f"<b>{title}</b>"), image], layout=widgets.Layout(max_width="100%"))
            for title, image in (("truth", self.truth), ("reduced", self.picture))
        ]
        user = [self.x, self.z, self.height, self.heading]
        columns = [widgets.VBox(part, layout=column) for part in (user, controls) if part]
        pictures = widgets.HBox(titled if self._truth_scene is not None else titled[1:], layout=wrap)
        self.widget = widgets.VBox([pictures, self.figures, widgets.HBox(columns, layout=wrap)])
        for control in user:
            control.observe(self._on_slider_change, "value")
        self._draw()

    @property
    @abstractmethod
    def _limit(self) -> float:
        """Greatest horizontal distance of the user from the centre, metres."""

    @abstractmethod
    def _render_pictures(self, camera: Camera) -> list[tuple[str, str]]:
        """Render the picture, and the truth if there is one; return labels and values of figures."""

    @property
    def camera(self) -> Camera:
        """The camera at the user's place, which looks along `heading`."""
        turn = math.radians(self.heading.value)
        eye = np.add(self._center, (self.x.value, self.height.value, self.z.value))
        forward = (math.sin(turn), 0.0, -math.cos(turn))
        fov = Fov.symmetric(FOV_DEG, self._size[0] / self._size[1])
        return Camera.look_at(eye, eye + forward, fov=fov, size=self._size)

    def _repr_mimebundle_(self, **settings: Any) -> Any:
        # Pages without widgets show the text instead.
        return {**self.widget._repr_mimebundle_(**settings), "text/plain": repr(self)}

    @contextmanager
    def _suspend_drawing(self) -> Iterator[None]:
        """Prevent drawing while code sets several sliders."""
        self._is_suspended = True
        try:
            yield
        finally:
            self._is_suspended = False

    def _keep_inside(self) -> None:
        """Move the user to within the limit."""
        distance, limit = math.hypot(self.x.value, self.z.value), self._limit
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

    def _draw(self) -> None:
        """Render both pictures. Errors appear below them, because notebooks hide errors of callbacks."""
        try:
            rows = self._render_pictures(self.camera)
        except (Error, ValueError, RuntimeError, MemoryError) as error:
            rows = [("not drawn", f"{type(error).__name__}: {error}")]
        self.figures.value = card.table(rows)

    def _render_truth(self, camera: Camera) -> Frame:
        """Render the ground truth, which depends on the camera only."""
        assert self._truth_scene is not None
        if self._last_truth is None or self._last_truth[0] != camera:
            self._last_truth = camera, render(self._truth_scene, camera, channels=("color",), backend="cpu")
            self.truth.value = card.png(self._last_truth[1].to_image())
        return self._last_truth[1]


def step_of(length: float) -> float:
    """Return the step of a slider with a range of `length`: a power of ten, at most a hundredth of it."""
    return float(10.0 ** (math.floor(math.log10(length)) - 2))
