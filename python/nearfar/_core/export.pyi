"""Kernels for streaming, exported by `nearfar._core`; there is no such module at run time."""

from typing import Any, final

import numpy as np
from numpy.typing import NDArray

from nearfar._core import Scene, _Report

# export -------------------------------------------------------------------------------------------------------------
@final
class Export:
    def __new__(
        cls,
        scene: Scene,
        groups: NDArray[np.uint16],
        count: int,
        *,
        names: list[str],
        images: list[str | None],
        step: float,
        compressed: bool,
        report: _Report | None = None,
    ) -> Export: ...
    def shared(self) -> list[tuple[bytes, list[int], dict[str, Any]]]: ...
    def glb(
        self, group: int, *, uris: list[str | None], report: _Report | None = None
    ) -> tuple[bytes, dict[str, Any]]: ...

def texels_per_radian(
    scene: Scene, distances: NDArray[np.float64], *, report: _Report | None = None
) -> NDArray[np.float64]: ...
def halved_texture(texels: NDArray[np.uint8], *, times: int, cutout: bool) -> NDArray[np.uint8]: ...
def encode_ranges(
    codes: NDArray[np.uint16],
    before: NDArray[np.uint16] | None,
    changed: NDArray[np.bool_],
    *,
    size: int,
    tile: int,
    tiles: NDArray[np.uint32],
    step: float,
) -> list[bytes]: ...
def decode_ranges(
    planes: list[bytes],
    before: NDArray[np.uint16] | None,
    *,
    faces: int,
    size: int,
    tile: int,
    tiles: NDArray[np.uint32],
    step: float,
) -> tuple[NDArray[np.uint16], NDArray[np.bool_]]: ...
