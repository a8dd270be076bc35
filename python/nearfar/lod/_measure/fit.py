"""Fits four-parameter logistic curves to samples, many at a time."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._base.settings import set_fields

_OUTCOMES = (
    ("fitted", ""),
    ("step", "y changes between two samples, or with one in between: other b and c fit as well"),
    ("open", "the samples end before a plateau: a, c or d is far away and undetermined"),
    ("flat", "all y are the same"),
    ("flat", "the mean is as likely as the curve, given noise"),
    ("unfittable", "fewer than 4 different x where x and y are finite"),
    ("unfittable", "an x is below 0"),
    ("unfittable", "the parameters are beyond float64"),
)
"""Status and reason by the kernel's outcome number."""
_STATUS, _REASON = (np.array(column) for column in zip(*_OUTCOMES, strict=True))
_TOO_FEW = 5
"""The kernel's outcome number for fewer than 4 samples."""


@dataclass(frozen=True, eq=False, repr=False)
class Curve4PL:
    """One curve y = d + (a−d) / (1 + (x/c)^b), or many: from `fit_4pl`, or from the parameters alone.

    `a, b, c, d = curve` unpacks the parameters, `curve(x)` evaluates it. For many curves, `len(curves)` is their
    number, `curves[k]` is one of them, and slices, masks and index arrays select some. Parameters and other fields are
    numbers for one curve and float64 (K,) for many.

    ValueError and TypeError for parameters of different shapes, infinite ones, values that are not real numbers, or b
    and c that are not above 0.
    """

    a: Any
    """y at x = 0."""
    b: Any
    """Steepness, always above 0; y rises if a < d."""
    c: Any
    """x at which y is halfway between a and d, above 0."""
    d: Any
    """y at x = ∞."""
    rms: Any = None
    """Root mean squared residual, in the unit of y; NaN if nothing was fitted."""
    status: Any = None
    """Outcome "fitted", "step", "open", "flat" or "unfittable", see `fit_4pl`. For parameters alone: "unfittable" if
    one of them is NaN, "flat" if a = d, else "fitted"."""
    reason: Any = None
    """Reason for a status other than "fitted", in words."""

    def __post_init__(self) -> None:
        if self.status is None:
            if self.rms is not None or self.reason is not None:
                raise ValueError("status: expected the outcomes if rms or reason is given, got None")
            set_fields(self, **_fields_from_parameters(self.a, self.b, self.c, self.d))

    @property
    def is_many(self) -> bool:
        """Whether this holds many curves, possibly none; False for a single curve."""
        return isinstance(self.a, np.ndarray)

    @property
    def ok(self) -> Any:
        """Whether a curve was found, neither flat nor unfittable: bool, or (K,) of bool."""
        ok = np.isin(self.status, ("fitted", "step", "open"))
        return ok if ok.ndim else bool(ok)

    @cached_property
    def rows(self) -> NDArray[np.float64]:
        """Parameters a, b, c and d of many curves (K, 4); NaN where there is none."""
        return np.column_stack([np.asarray(parameter, np.float64) for parameter in self])

    def __iter__(self) -> Iterator[Any]:
        """Iterate over the parameters a, b, c, d."""
        return iter((self.a, self.b, self.c, self.d))

    def __len__(self) -> int:
        """Number of curves."""
        if not self.is_many:
            raise TypeError("curve: expected several curves, got a single one")
        return len(self.a)

    def __bool__(self) -> bool:
        """Return True, also for no curves; `ok` says whether curves were found."""
        return True

    def __getitem__(self, index: Any) -> Curve4PL:
        """Select one of many curves by its number, or several by a slice, a mask (K,) of bool, or an index array."""
        selected = _normalized_index(index, len(self))
        fields = (*self, self.rms, self.status, self.reason)
        # `item` instead of `field[number]`: NumPy loses a Ctrl-C that arrives while it makes a scalar of a string.
        return Curve4PL(*(field.item(selected) if isinstance(selected, int) else field[selected] for field in fields))

    def __repr__(self) -> str:
        if self.is_many:
            return f"Curve4PL({len(self.a)} curves, {int(self.ok.sum())} ok)"
        numbers = ", ".join(f"{name}={getattr(self, name):.6g}" for name in ("a", "b", "c", "d", "rms"))
        return f"Curve4PL({numbers}, status={self.status!r})"

    def __call__(self, x: ArrayLike) -> Any:
        """Evaluate at x ≥ 0 of any shape; for K curves at (M,), shared by all, or (K, M). ∞ gives d, NaN gives NaN.

        Returns float64 in the shape of x, (K, M) for K curves; NaN for unfittable curves. Plateaus far outside the
        samples lose no digits, unlike in the formula above.
        """
        xs = check.array("x", x, columns=None, dtype=np.float64)
        if (xs < 0).any():
            raise ValueError(f"x: expected numbers of at least 0, got {np.nanmin(xs)}")
        a, b, c, d = self
        if self.is_many:
            if xs.ndim not in (1, 2) or (xs.ndim == 2 and len(xs) != len(a)):
                raise ValueError(f"x: expected shape (M,) or ({len(a)}, M), got {xs.shape}")
            a, b, c, d = (field[:, None] for field in self)
        with np.errstate(divide="ignore", over="ignore", under="ignore", invalid="ignore"):
            is_near = np.abs(xs / c - 1) < 0.5
            steps = b * np.where(is_near, np.log1p((xs - c) / c), np.log(xs) - np.log(c))
            small = np.exp(-np.abs(steps))
            # Computed from the nearer plateau, so that a plateau far away cancels no digits.
            fraction = small / (1 + small)
            values = np.where(steps < 0, a + (d - a) * fraction, d + (a - d) * fraction)
        return values if values.ndim else float(values)


def _fields_from_parameters(*parameters: Any) -> dict[str, Any]:
    """Fields of curves given by a, b, c and d alone."""
    names = ("a", "b", "c", "d")
    arrays = [
        check.array(name, value, columns=None, dtype=np.float64) for name, value in zip(names, parameters, strict=True)
    ]
    shape = arrays[0].shape
    if len(shape) > 1:
        raise ValueError(f"a: expected a number or shape (K,), got {shape}")
    for name, array in zip(names, arrays, strict=True):
        if array.shape != shape:
            raise ValueError(f"{name}: expected shape {shape}, as a has, got {array.shape}")
        if np.isinf(array).any():
            raise ValueError(
                f"{name}: expected finite numbers, or NaN for no curve, got {array.flat[np.isinf(array).argmax()]}"
            )
    a, b, c, d = arrays
    for name, array in (("b", b), ("c", c)):
        if (array <= 0).any():
            raise ValueError(f"{name}: expected numbers above 0, got {np.nanmin(array)}")
    status = np.where(np.isnan(arrays).any(axis=0), "unfittable", np.where(a == d, "flat", "fitted"))
    reason = np.where(status == "unfittable", "a parameter is NaN", "")
    fields = dict(
        zip((*names, "rms", "status", "reason"), (*arrays, np.full(shape, np.nan), status, reason), strict=True)
    )
    return fields if shape else {name: field.item() for name, field in fields.items()}


def _normalized_index(index: Any, count: int) -> Any:
    """Convert an index of `count` curves to a number, a slice or an array for their fields."""
    if isinstance(index, slice):
        return np.arange(count)[index]
    selected = check.plain("index", index)
    if isinstance(index, list) and not index:
        return selected.astype(np.intp)
    is_mask = selected.dtype == bool and selected.ndim == 1
    if selected.ndim > 1 or not (is_mask or np.issubdtype(selected.dtype, np.integer)):
        raise TypeError(
            f"index: expected a number, a slice, a mask or whole numbers (M,), got {check.type_and_value(index)}"
        )
    if is_mask and len(selected) != count:
        raise IndexError(f"index: expected a mask of shape ({count},), got {selected.shape}")
    if not is_mask:
        out_of_range = selected[(selected < -count) | (selected >= count)]
        if out_of_range.size:
            raise IndexError(f"index: expected numbers from {-count} to {count - 1}, got {out_of_range.flat[0]}")
    return selected if selected.ndim else int(selected)


def fit_4pl(x: ArrayLike, y: ArrayLike) -> Curve4PL:
    """Fit the four-parameter logistic curve y = d + (a−d) / (1 + (x/c)^b) by least squares to one or many rows.

    ValueError for shapes that do not match; TypeError for values that are not real numbers. Sources: Liebisch (2021),
    who fits it to SSIM over solid angles; Golub, Pereyra (1973): a and d follow from b and c.

    Parameters
    ----------
    x
        (N,), shared by all rows, or (K, N); at least 0, in any unit, such as solid angles in steradians.
    y
        (N,) or (K, N), in any unit, such as SSIM. Samples with NaN or infinite x or y are ignored: pad rows of
        different lengths with NaN. Other types are converted to float64.

    Returns
    -------
    Curve4PL
        Fields are numbers if x and y are (N,), else arrays (K,); `a, b, c, d = fit_4pl(x, y)`. Rising y has a < d:
        b is always above 0. Bad data never raises; `status` gives each curve's outcome, and `reason` the reason:

        - "fitted": the least-squares curve.
        - "step": y changes between two samples, or with a single one in between. The residual is minimal, but other b
          and c give the same residual.
        - "open": the samples end before a plateau (a and d are more than 100 times as far apart as the range of y).
          The residual decreases towards infinite parameters, and this curve's residual is as good as minimal. Call the
          curve instead of evaluating the formula, which loses digits.
        - "flat": y is constant, or a constant with noise is nearly as likely: (S/S₀)^((N−2)/2) ≥ 0.01, where S is the
          sum of squared residuals of the curve and S₀ that of the mean. 92 to 97 of 100 curves of pure noise are flat.
          a and d are the mean, b is 1 and c the middle of the samples.
        - "unfittable": fewer than 4 different x, an x below 0, or parameters beyond float64 (plateaus that overflow).
          All parameters are NaN.

        On noiseless data parameters are recovered to a relative 1e-9 if the samples show both plateaus.
    """
    xs = check.array("x", x, columns=None, dtype=np.float64)
    ys = check.array("y", y, columns=None, dtype=np.float64)
    if ys.ndim not in (1, 2):
        raise ValueError(f"y: expected shape (N,) or (K, N), got {ys.shape}")
    if xs.ndim == 2 and ys.ndim == 1 and xs.shape[1:] == ys.shape:
        ys = np.ascontiguousarray(np.broadcast_to(ys, xs.shape))
    if xs.shape not in (ys.shape, ys.shape[-1:]):
        shapes = " or ".join(str(shape) for shape in dict.fromkeys((ys.shape[-1:], ys.shape)))
        raise ValueError(f"x: expected shape {shapes}, as y has, got {xs.shape}")
    rows, count = (1, *ys.shape)[-2:]
    if count:
        with progress.bar("fitting") as report:
            table, outcomes = _core.fit_4pl(xs.ravel(), ys.ravel(), count=count, report=report)
    else:
        table, outcomes = np.full((rows, 5), np.nan), np.full(rows, _TOO_FEW, np.uint8)
    a, b, c, d, rms = (column.copy() for column in table.T)
    fitted = Curve4PL(a, b, c, d, rms, _STATUS[outcomes], _REASON[outcomes])
    return fitted if ys.ndim == 2 else fitted[0]
