"""Kernels for levels of detail, exported by `nearfar._core`; there is no such module at run time."""

import numpy as np
from numpy.typing import NDArray

from nearfar._core import _F32, _F64, _U32, RadialLens, _Point, _Report

# lod ----------------------------------------------------------------------------------------------------------------
def fit_4pl(x: _F64, y: _F64, *, count: int, report: _Report | None = None) -> tuple[_F64, NDArray[np.uint8]]: ...

_Eye = tuple[_Point, tuple[float, float, float, float], tuple[float, float, float, float], _Point | None, float, float]

def select_levels(
    models: tuple[_F64, NDArray[np.int64], _F64],
    model_index: NDArray[np.int64],
    centers: _F64,
    radii: _F64,
    *,
    previous: NDArray[np.int32] | None,
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
) -> tuple[NDArray[np.int32], list[_F64], list[int]]: ...
def spend_triangles(
    models: tuple[_F64, NDArray[np.int64], _F64],
    triangles: NDArray[np.int64],
    model_index: NDArray[np.int64],
    centers: _F64,
    radii: _F64,
    *,
    previous: NDArray[np.int32] | None,
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
) -> tuple[NDArray[np.int32], list[_F64], list[int], tuple[float, int, float]]: ...
def check_weights(weight: _F64) -> None: ...
def first_alike(rows: NDArray[np.uint8]) -> _U32: ...
def pieces(faces: _U32, vertex_count: int) -> _U32: ...
def carry(
    positions: _F32, faces: _U32, corners: _F32, starts: _U32, *, report: _Report | None = None
) -> tuple[_U32, _F64]: ...
def collapse(
    positions: _F32, attributes: _F32, weights: _F32, is_seam: NDArray[np.bool_], faces: _U32, target: int, given: str
) -> tuple[_U32, float]: ...
