"""Kernels for hybrid mono-stereo rendering, exported by `nearfar._core`; there is no such module at run time."""

from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from nearfar._core import _F32, _F64, Camera, Scene, _Point, _Report

# stereo -------------------------------------------------------------------------------------------------------------
_Quaternion = tuple[float, float, float, float]
_View = tuple[tuple[float, float, float, float], _Point, _Quaternion]

@final
class HybridRig:
    def __new__(cls, left: _View, right: _View, planes: tuple[float, float], size: tuple[int, int]) -> HybridRig: ...
    def jittered(self, jitter: tuple[float, float]) -> HybridRig: ...
    @property
    def center_fov(self) -> list[float]: ...
    @property
    def center_size(self) -> tuple[int, int]: ...
    @property
    def mono(self) -> float: ...
    @property
    def setback(self) -> float: ...
    @property
    def middle(self) -> list[float]: ...
    @property
    def overlap(self) -> float: ...
    def homography(self, eye: str) -> list[list[float]]: ...
    def displayed_tangents(self, eye: str, at: tuple[float, float], depth: float) -> list[float]: ...
    def max_error(self, depth: float, axis: str) -> float: ...
    def error_field(self, eye: str, depth: float) -> _F64: ...
    def contents(
        self, scene: Scene, position: _Point, orientation: _Quaternion, depths: tuple[float, float], traced: bool
    ) -> tuple[NDArray[np.uint8], bool, bool]: ...
    def triangles(
        self,
        scene: Scene,
        position: _Point,
        orientation: _Quaternion,
        depths: tuple[float, float],
        report: _Report | None = None,
    ) -> tuple[list[int], int, list[int]]: ...
    def render_zone(
        self,
        eye: str,
        scene: Scene,
        camera: Camera,
        settings: dict[str, Any],
        position: _Point,
        orientation: _Quaternion,
        depths: tuple[float, float],
        report: _Report | None = None,
    ) -> dict[str, NDArray[Any]]: ...
    def needed(self, left: _F32, right: _F32, samples: int) -> NDArray[np.bool_]: ...
    def assemble(self, eye: str, coverage: _F32, center: _F32, color: _F32) -> None: ...
    def resolve(
        self,
        eye: str,
        coverage: _F32,
        scene: Scene,
        camera: Camera,
        settings: dict[str, Any],
        center: tuple[_F32, NDArray[np.int64]],
        color: _F32,
    ) -> None: ...
    def nearest(self, eye: str, coverage: _F32) -> NDArray[np.uint32]: ...
