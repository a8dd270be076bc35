"""Kernels for levels of detail, exported by `nearfar._core`; there is no such module at run time."""

from nearfar._core import _F32, _F64, _I32, _I64, _U8, _U32, RadialLens, _Bools, _Point, _Quad, _Report

# lod ----------------------------------------------------------------------------------------------------------------
def fit_4pl(x: _F64, y: _F64, *, count: int, report: _Report = None) -> tuple[_F64, _U8]: ...

_Eye = tuple[_Point, _Quad, _Quad, _Point | None, float, float]

def select_levels(
    models: tuple[_F64, _I64, _F64],
    model_index: _I64,
    centers: _F64,
    radii: _F64,
    *,
    previous: _I32 | None,
    eyes: list[_Eye],
    line: tuple[float, float],
    reference: float,
    limits_seen: bool,
    off: bool,
    cull: bool,
    apparent: str,
    lens: RadialLens | None,
    tan_omega: float,
    exact: bool,
    acuity: tuple[float, float] | None,
    hysteresis: float,
    fade: float,
    full: bool,
) -> tuple[_I32, list[_F64], list[int]]: ...
def spend_triangles(
    models: tuple[_F64, _I64, _F64],
    triangles: _I64,
    model_index: _I64,
    centers: _F64,
    radii: _F64,
    *,
    previous: _I32 | None,
    eyes: list[_Eye],
    line: tuple[float, float],
    cull: bool,
    apparent: str,
    lens: RadialLens | None,
    tan_omega: float,
    exact: bool,
    acuity: tuple[float, float] | None,
    hysteresis: float,
    budget: int,
    by_pixels: bool,
    weight: _F64 | None,
    floor: float | None,
    price: float | None,
    full: bool,
) -> tuple[_I32, list[_F64], list[int], tuple[float, int, float]]: ...
def check_weights(weight: _F64) -> None: ...
def first_alike(rows: _U8) -> _U32: ...
def pieces(faces: _U32, vertex_count: int) -> _U32: ...
def carry(
    positions: _F32, faces: _U32, corners: _F32, starts: _U32, *, report: _Report = None
) -> tuple[_U32, _F64]: ...
def collapse(
    positions: _F32, attributes: _F32, weights: _F32, is_seam: _Bools, faces: _U32, target: int, given: str
) -> tuple[_U32, float]: ...
