"""Kernels for orthoviews, exported by `nearfar._core`; there is no such module at run time."""

from collections.abc import Mapping, Sequence
from typing import Any, final

from nearfar._core import _F32, _U8, _U16, _U32, Camera, GpuDevice, Scene, _Bools, _Point, _Report

_Direction = tuple[int, int, int]
_Format = tuple[int, int, int]

# orthoview ----------------------------------------------------------------------------------------------------------
@final
class OrthoViews:
    @staticmethod
    def of_cell(
        scene: Scene,
        cell: tuple[Sequence[float], float],
        directions: Sequence[_Direction],
        view_format: _Format,
        *,
        way: str | None = None,
        behind: bool = False,
        report: _Report = None,
    ) -> OrthoViews: ...
    @staticmethod
    def from_arrays(
        directions: Sequence[_Direction], view_format: _Format, colors: _U8, depths: _U16, normals: _U16
    ) -> OrthoViews: ...
    @staticmethod
    def with_behind(first: OrthoViews, second: OrthoViews) -> OrthoViews: ...
    def second_layer(self) -> OrthoViews | None: ...
    def keep_behind(self, keep: Sequence[bool]) -> OrthoViews: ...
    def unseen(self) -> list[float]: ...
    def colors(self) -> _U8: ...
    def depths(self) -> _U16: ...
    def normals(self) -> _U16: ...
    def vectors(self) -> _F32: ...
    @property
    def steps(self) -> int: ...
    def empty(self) -> list[bool]: ...
    def connected(self, bounds: _Point) -> _U8: ...

@final
class OrthoParent:
    def __new__(
        cls, directions: Sequence[_Direction], view_format: _Format, *, behind: bool = False
    ) -> OrthoParent: ...
    def add(self, octant: Sequence[int], child: OrthoViews) -> None: ...
    def finish(self) -> OrthoViews: ...

def orthoview_axes(direction: _Direction) -> tuple[list[list[float]], list[float]]: ...
def orthoview_steps(view_format: _Format) -> int: ...
def orthoview_surfels(bits: _U8) -> _Bools: ...

# splats -------------------------------------------------------------------------------------------------------------
@final
class OrthoSplats:
    def __new__(
        cls, views: OrthoViews, number: int, connected: _U8, cell: tuple[Sequence[float], float]
    ) -> OrthoSplats: ...
    def outside_cylinder(self, center: Sequence[float], radius: float) -> OrthoSplats: ...
    def crop_to_box(self, low: Sequence[float], high: Sequence[float]) -> OrthoSplats: ...
    @property
    def count(self) -> int: ...
    @property
    def bytes(self) -> int: ...
    @property
    def compressed_bytes(self) -> int: ...

_View = tuple[Sequence[OrthoSplats], int, Sequence[int], int, bool]

def blend_orthoviews(views: Sequence[_View], rule: OrthoRule) -> list[list[OrthoSplats]]: ...
def expected_orthoviews(views: Sequence[_View], rule: OrthoRule) -> float: ...
def splat_orthoviews(
    views: Sequence[OrthoSplats],
    camera: Camera,
    settings: Mapping[str, Any],
    *,
    origin: _Point,
    grid: int,
    before: dict[str, Any] | None = None,
    report: _Report = None,
    device: GpuDevice | None = None,
) -> dict[str, Any]: ...
def gpu_keep_orthoviews(device: GpuDevice, views: Sequence[OrthoSplats]) -> None: ...
def gpu_orthoview_bytes(device: GpuDevice) -> int: ...

# steady pictures ----------------------------------------------------------------------------------------------------
_Picture = tuple[Camera, _F32, _F32]

def blend_past(
    past: _Picture, now: _Picture, *, fade: tuple[float, float], motion: _F32 | None = None
) -> tuple[_F32, _Bools]: ...
def blur_motion(picture: _Picture, poses: Sequence[Camera]) -> _F32: ...

# cuts ---------------------------------------------------------------------------------------------------------------
@final
class OrthoRule:
    def __new__(
        cls,
        camera: Camera,
        *,
        pitch: float,
        error: float,
        band: float | None = None,
        gaze: tuple[Sequence[float], float, float] | None = None,
    ) -> OrthoRule: ...

@final
class OrthoCells:
    def __new__(cls, origin: Sequence[float], side: float, levels: int, subtree: int) -> OrthoCells: ...
    def add(self, tier: int, place: Sequence[int], levels: Sequence[_U32]) -> None: ...
    @property
    def subtree_count(self) -> int: ...
    def cut(
        self,
        camera: Camera,
        rule: OrthoRule,
        *,
        directions: Sequence[_Direction],
        views: int,
        geometry: bool,
        around: bool,
        lift_deg: float = 0.0,
    ) -> tuple[dict[str, Any], float, list[tuple[int, list[int]]]]: ...
