"""Orthoviews, which `nearfar._core` exports; there is no such module at run time."""

from collections.abc import Sequence
from typing import final

import numpy as np
from numpy.typing import NDArray

from nearfar._core import Scene, _Report

_Direction = tuple[int, int, int]
_Format = tuple[int, int, int]
_U8 = NDArray[np.uint8]
_U16 = NDArray[np.uint16]

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
        report: _Report | None = None,
    ) -> OrthoViews: ...
    @staticmethod
    def from_arrays(
        directions: Sequence[_Direction], view_format: _Format, colors: _U8, depths: _U16, normals: _U16
    ) -> OrthoViews: ...
    def colors(self) -> _U8: ...
    def depths(self) -> _U16: ...
    def normals(self) -> _U16: ...
    def vectors(self) -> NDArray[np.float32]: ...
    @property
    def steps(self) -> int: ...
    def empty(self) -> list[bool]: ...
    def connected(self, bounds: tuple[float, float, float]) -> _U8: ...

@final
class OrthoParent:
    def __new__(cls, directions: Sequence[_Direction], view_format: _Format) -> OrthoParent: ...
    def add(self, octant: Sequence[int], child: OrthoViews) -> None: ...
    def finish(self) -> OrthoViews: ...

def orthoview_axes(direction: _Direction) -> tuple[list[list[float]], list[float]]: ...
def orthoview_steps(view_format: _Format) -> int: ...
def orthoview_surfels(bits: _U8) -> NDArray[np.bool_]: ...
