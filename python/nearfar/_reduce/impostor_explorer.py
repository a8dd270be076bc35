"""Notebook explorer of impostors: the picture beside the truth, with sliders for the user."""

from __future__ import annotations

from typing import Any

from nearfar._base import card
from nearfar._camera.camera import Camera
from nearfar._reduce.user_explorer import Point, UserExplorer
from nearfar._render.renderable import Renderable
from nearfar._render.truth import render
from nearfar._scene.scene import Scene
from nearfar.metrics._pixel_errors import psnr
from nearfar.metrics._similarity import ssim


class ImpostorExplorer(UserExplorer):
    """Picture and truth of impostors with sliders for the user; made by `Impostors.explore`."""

    def __init__(
        self, impostors: Renderable, *, center: Point, reach: float, truth: Scene | None, size: tuple[int, int]
    ) -> None:
        super().__init__(center, reach, size=size, truth=truth)
        self.impostors = impostors
        self._reach = reach
        self._show()

    @property
    def _limit(self) -> float:
        return self._reach

    def _render_pictures(self, camera: Camera) -> list[tuple[str, str]]:
        frame = render(self.impostors, camera, channels=("color",), backend="cpu")
        self.picture.value = card.png(frame.to_image())
        rows: list[tuple[str, Any]] = [("triangles", f"{self.impostors.triangle_count:,}")]
        if self._truth_scene is None:
            return [("far geometry", "not saved: the truth needs the original scene"), *rows]
        truth = self._render_truth(camera)
        return [("SSIM", f"{float(ssim(truth, frame)):.4f}"), ("PSNR", f"{psnr(truth, frame):.2f} dB"), *rows]

    def __repr__(self) -> str:
        return f"ImpostorExplorer of {self.impostors!r}"
