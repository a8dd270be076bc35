"""Selected levels, usable as an array, and the numbers that determined them."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import InitVar, dataclass, field
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import DTypeLike, NDArray

from nearfar._base import check
from nearfar._base.settings import set_fields

Array = NDArray[np.float64]

COLUMNS = ("sigma", "sigma_seen", "threshold", "score", "shown")
"""Columns filled with `full=True`."""


@dataclass(frozen=True)
class Spent:
    """Result of spending a budget."""

    price: float
    """λ: weighted score per drawn triangle of the first step that did not fit, or the kept price. 0 if everything that
    improves the score is drawn."""
    triangles: int
    """Number of triangles of the levels of all objects in view, each object counted once."""
    drawn: int
    """Number of triangles that are drawn, which the budget limits: each object counts as often as its `draws` say, by
    default once."""
    score: float
    """Weighted mean of the levels' scores over the objects in view, as predicted by the curves. NaN if no object in
    view has a weight."""


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Selection(NDArrayOperatorsMixin):
    """Levels of N objects chosen by `select`, and with `full=True` the numbers that determined them.

    It can be indexed, iterated, compared and computed with like the int32 array (N,) of its levels, and has that
    array's attributes and methods; results are plain arrays. `full=True` fills the columns from `sigma` to `shown`, all
    (N,) float64, and takes about twice the time. Without it they raise an AttributeError.

    With several cameras, columns have the numbers of the first camera that required the level. Under a budget they have
    those of the camera that shows the object largest, and the greatest threshold. NaN marks numbers that were not
    needed.
    """

    level: NDArray[np.int32]
    """Level of each object, 0 the finest; −1 out of view."""
    counts: Mapping[str, int]
    """Number of objects by outcome. For each camera, or once under a budget, each object has one of these outcomes:
    "culled" (out of view), "one_level" (in view, nothing to choose), "settled" (another camera already required level
    0), "large" (so large that no curve reaches the threshold, or with `limit="own"` above σ₁/₁₆) or "asked". Of the
    objects "asked", "lens" counts those whose σ′ was computed, "table" those whose level was in a table of the model,
    and "formula" those whose curves were evaluated."""
    columns: InitVar[Mapping[str, Array]]
    spent: Spent | None = None
    """Price, triangles and mean score under a budget; else None."""
    sigma: Array = field(init=False)
    """σ, steradians; 4π around the eye. NaN if the object is out of view or has one level."""
    sigma_seen: Array = field(init=False)
    """σ′, the apparent size, steradians: σ, its value through the lens or on the panel, or the part resolved by the
    eye. NaN if no curve was evaluated."""
    threshold: Array = field(init=False)
    """f(σ): the least score. NaN if no curve was evaluated."""
    score: Array = field(init=False)
    """Score of the level at the apparent size: 1 for level 0. NaN out of view."""
    shown: Array = field(init=False)
    """Fractional level while levels fade: 2.3 means 0.7 of level 2 and 0.3 of level 3. Equal to `level` without a fade,
    never greater, −1 out of view."""

    def __post_init__(self, columns: Mapping[str, Array]) -> None:
        set_fields(self, **check.mapping("columns", columns, "arrays by name"))

    @property
    def coarser(self) -> NDArray[np.int32]:
        """The coarser of the two blended levels (N,); needs `shown`."""
        return np.ceil(self.shown).astype(np.int32)

    @property
    def finer_weight(self) -> Array:
        """Weight of level `coarser` − 1 in the picture (N,), 0 to below 1; the rest is `coarser`. Needs `shown`."""
        return np.asarray(np.ceil(self.shown) - self.shown)

    def __repr__(self) -> str:
        levels, numbers = np.unique(self.level, return_counts=True)
        parts = (f"{level}: {number:,}" for level, number in zip(levels.tolist(), numbers.tolist(), strict=True))
        return f"Selection({len(self)} objects; {', '.join(parts)})"

    # The levels as an array -------------------------------------------------------------------------------------------
    def __len__(self) -> int:
        """Return the number of objects."""
        return len(self.level)

    def __bool__(self) -> bool:
        return bool(self.level)

    def __getitem__(self, index: Any) -> Any:
        return self.level[index]

    def __setitem__(self, index: Any, value: Any) -> None:
        self.level[index] = value

    def __iter__(self) -> Iterator[Any]:
        return iter(self.level)

    def __array__(self, dtype: DTypeLike | None = None, copy: bool | None = None) -> NDArray[Any]:
        return self.level.astype(self.level.dtype if dtype is None else dtype, copy=bool(copy))

    def __array_ufunc__(self, ufunc: np.ufunc, method: str, *inputs: Any, **options: Any) -> Any:
        if "out" in options:
            options["out"] = tuple(map(_levels_of, options["out"]))
        return getattr(ufunc, method)(*map(_levels_of, inputs), **options)

    def __getattr__(self, name: str) -> Any:
        """Attributes and methods of the levels' array, such as `shape`, `max` and `tolist`."""
        if name in COLUMNS or hasattr(type(self), name):
            raise AttributeError(f"{name}: expected a selection made with full=True, which fills it")
        # Pickling and protocols look up special methods, also before the fields are set: the array's would be wrong.
        if name.startswith("_") or name in ("level", "counts", "spent"):
            raise AttributeError(f"Selection has no attribute {name!r}")
        return getattr(self.level, name)


def _levels_of(value: object) -> object:
    return value.level if isinstance(value, Selection) else value
