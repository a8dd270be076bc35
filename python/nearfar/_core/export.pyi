"""Kernels for streaming, exported by `nearfar._core`; there is no such module at run time."""

from typing import Any, final

from nearfar._core import _F64, _U8, _U16, _U32, Scene, _Bools, _Report

# export -------------------------------------------------------------------------------------------------------------
@final
class Export:
    def __new__(
        cls,
        scene: Scene,
        groups: _U16,
        count: int,
        *,
        names: list[str],
        images: list[str | None],
        step: float,
        compressed: bool,
        report: _Report = None,
    ) -> Export: ...
    def shared(self) -> list[tuple[bytes, list[int], dict[str, Any]]]: ...
    def glb(self, group: int, *, uris: list[str | None], report: _Report = None) -> tuple[bytes, dict[str, Any]]: ...

def texels_per_radian(scene: Scene, distances: _F64, *, report: _Report = None) -> _F64: ...
def halved_texture(texels: _U8, *, times: int, cutout: bool) -> _U8: ...
def encode_ranges(
    codes: _U16, before: _U16 | None, changed: _Bools, *, size: int, tile: int, tiles: _U32, step: float
) -> list[bytes]: ...
def decode_ranges(
    planes: list[bytes], before: _U16 | None, *, faces: int, size: int, tile: int, tiles: _U32, step: float
) -> tuple[_U16, _Bools]: ...
