"""Kernels on graphics adapters, exported by `nearfar._core`; there is no such module at run time."""

from collections.abc import Sequence
from typing import Any, final

from numpy.typing import NDArray

from nearfar._core import _F32, Camera, Reduced, Scene, _Point, _Report

# gpu ----------------------------------------------------------------------------------------------------------------
def gpu_adapters() -> list[tuple[str, str, str, str, str, int, int]]: ...
def gpu_is_hardware(wanted: str | None = None) -> bool: ...
def gpu_close() -> None: ...
def gpu_forked() -> None: ...

@final
class GpuDevice:
    def __new__(cls, wanted: str | None = None) -> GpuDevice: ...
    @property
    def label(self) -> str: ...
    @property
    def kind(self) -> str: ...
    def counters(self) -> tuple[int, int, int, int]: ...
    def pass_seconds(self) -> list[float] | None: ...
    def check_whole(self, camera: Camera, channels: list[str]) -> None: ...
    def allow_two_views(self, allowed: bool) -> bool: ...
    def allow_long_atomics(self, allowed: bool) -> bool: ...
    @property
    def uses_long_atomics(self) -> bool: ...
    def lose(self) -> None: ...
    def truth(
        self, scene: Scene, cameras: Sequence[Camera], settings: dict[str, Any], *, report: _Report = None
    ) -> list[GpuJob]: ...
    def bake(
        self,
        scene: Scene,
        *,
        center: _Point,
        radius: float,
        size: int,
        samples: int,
        range: bool,  # noqa: A002
        object_id: bool,
        report: _Report = None,
    ) -> dict[str, NDArray[Any]]: ...
    def reduced(
        self,
        reduced: Reduced,
        scene: Scene,
        camera: Camera,
        settings: dict[str, Any],
        *,
        user: _Point | None,
        radius: float | None,
        strength: float,
        method: str,
        mapped: bool,
        tolerance_px: float,
        conventional_dynamic: str,
        report: _Report = None,
    ) -> GpuJob: ...

@final
class GpuJob:
    def finish(self, report: _Report = None) -> dict[str, Any]: ...

# gpu_compute --------------------------------------------------------------------------------------------------------
@final
class GpuFrame:
    @property
    def label(self) -> str: ...
    def read(self, report: _Report = None) -> dict[str, Any]: ...

def gpu_keep(job: GpuJob, report: _Report = None) -> GpuFrame: ...
def gpu_similarity(
    reference: GpuFrame, test: GpuFrame, *, window: str, size: int, sigma: float, full: bool
) -> tuple[float, _F32 | None]: ...
def gpu_discontinuity(
    frame: GpuFrame, *, camera: Camera, epsilon: float, min_distance: float, report: _Report = None
) -> _F32: ...
def gpu_morph(
    device: GpuDevice,
    points: _F32,
    shown: _F32,
    *,
    user: _Point,
    center: _Point,
    r1: float,
    r2: float,
    kind: str,
    strength: float,
) -> None: ...
def gpu_cube_lookup(
    device: GpuDevice,
    maps: tuple[_F32, _F32],
    directions: _F32,
    filter: str,  # noqa: A002
) -> None: ...
