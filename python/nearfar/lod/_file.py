"""JSON files of `MeasuredLevels`, the data of a `LodModel` without its geometry."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from nearfar._base import check, formats
from nearfar.lod._measure.fit import Curve4PL
from nearfar.lod._measure.statistic import Samples
from nearfar.lod._measured_levels import MeasuredLevels

NAME, VERSION = "lod", 2
PARAMETERS = ("a", "b", "c", "d", "rms")
STATUSES = ("fitted", "step", "open", "flat", "unfittable")
"""Values of `Curve4PL.status`, explained in `nearfar.lod.fit_4pl`."""


def encode_document(model: MeasuredLevels) -> dict[str, Any]:
    """Encode a model without its geometry."""
    curves = [None, *(_curve(model.curves[number]) for number in range(len(model.curves)))]
    return formats.header(NAME, VERSION) | {
        "name": model.name,
        "center": [float(x) for x in model.center],
        "radius": float(model.radius),
        "sigma": [float(x) for x in model.sigma],
        "pixel": model.pixel,
        "levels": [
            {"triangles": int(count), "error": float(error), "curve": curve}
            for count, error, curve in zip(model.triangles, model.errors, curves, strict=True)
        ],
        "samples": None if model.samples is None else _samples(model.samples),
        "measured": model.measured,
    }


def _curve(curve: Curve4PL) -> dict[str, Any]:
    numbers = {name: _rows(np.asarray(getattr(curve, name))) for name in PARAMETERS}
    return numbers | {"status": curve.status, "reason": curve.reason}


def _samples(samples: Samples) -> dict[str, Any]:
    views = None if samples.views is None else _rows(samples.views)
    return {"sigma": samples.sigma.tolist(), "score": _rows(samples.score), "views": views}


def _rows(values: NDArray[Any]) -> Any:
    """Convert to nested lists: None for NaN, which JSON lacks; float32 by its shortest digits, to keep files small."""
    if values.ndim:
        return [_rows(row) for row in values]
    return None if np.isnan(values) else float(str(values))


def read(path: Path) -> dict[str, Any]:
    """Read the fields of a model, which `MeasuredLevels` checks further; errors as in `fields` and `read_json`."""
    return fields(formats.read_json(path, NAME, VERSION), path)


def fields(data: dict[str, Any], path: Path) -> dict[str, Any]:
    """Decode a model's fields from the result of `encode_document`; FormatError for other or damaged documents."""
    formats.check(data, NAME, VERSION, path)
    with formats.guarded(path):
        levels, samples = data["levels"], data["samples"]
        if not levels or levels[0]["curve"] is not None:
            raise ValueError("levels: expected the base first, which has no curve")
        least, greatest = (check.at_least_zero("sigma", value) for value in data["sigma"])
        return {name: data[name] for name in ("name", "center", "radius", "pixel", "measured")} | {
            "sigma": (least, greatest),
            "triangles": [check.integer("triangles", level["triangles"], 1, 2**62) for level in levels],
            "errors": [check.number("error", level["error"]) for level in levels],
            "curves": _curves([level["curve"] for level in levels[1:]]),
            "samples": None if samples is None else _read_samples(samples),
        }


def _curves(curves: list[dict[str, Any]]) -> Curve4PL:
    numbers = {name: _array(name, [curve[name] for curve in curves], 1) for name in PARAMETERS}
    statuses = [check.choice("status", curve["status"], STATUSES) for curve in curves]
    reasons = [curve["reason"] for curve in curves]
    if not all(isinstance(reason, str) for reason in reasons):
        raise TypeError("reason: expected text")
    return Curve4PL(**numbers, status=np.array(statuses, dtype=np.str_), reason=np.array(reasons, dtype=np.str_))


def _read_samples(samples: dict[str, Any]) -> Samples:
    sigma, score = _array("sigma", samples["sigma"], 1), _array("score", samples["score"], 2)
    if not (np.isfinite(sigma) & (sigma > 0)).all():
        raise ValueError("samples: expected solid angles (sigma) above 0")
    if samples["views"] is None:
        return Samples(sigma, score)
    views = _array("views", samples["views"], 3, np.float32)
    if views.shape[:2] != score.shape:
        raise ValueError(
            f"samples: expected views of {len(score)} levels at {len(sigma)} solid angles, got {views.shape}"
        )
    return Samples(sigma, score, views)


def _array(name: str, values: Any, axes: int, dtype: type[np.floating[Any]] = np.float64) -> NDArray[Any]:
    """Convert to an array, None to NaN; ValueError for another number of axes or numbers beyond the type."""
    with np.errstate(over="ignore"):
        array: NDArray[Any] = np.array(values, dtype=np.float64).astype(dtype)
    if array.ndim != axes:
        raise ValueError(f"{name}: expected numbers with {axes} axes, got {array.ndim}")
    if np.isinf(array).any():
        raise ValueError(f"{name}: expected numbers up to {np.finfo(dtype).max:.3g}")
    return array
