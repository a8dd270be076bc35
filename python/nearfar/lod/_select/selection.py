"""What was chosen, and by which numbers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False, kw_only=True, repr=False)
class Selection:
    """Levels of objects, with what decided them; `select` makes it with `full=True`.

    All arrays are (N,). Of several eyes the numbers are those of the eye that asked for the level, the first of them
    where several did. Numbers that nobody had to compute are NaN.
    """

    level: NDArray[np.int32]
    """The level of each object; −1 outside of the view."""
    sigma: Array
    """σ, steradians; 4π around the eye. NaN where the object is not in view or has one level."""
    sigma_seen: Array
    """The size at which curves were read, steradians: σ, σ′ through the lens, or what the eye sees of that. NaN where
    no curve was asked."""
    threshold: Array
    """f(σ): the least score. NaN where no curve was asked."""
    score: Array
    """Score of the level at the size that is seen: 1 for level 0. NaN outside of the view."""
    shown: Array
    """The level as it fades over: 2.3 is 0.7 of level 2 and 0.3 of level 3. Equal to `level` without a fade, never more
    than it, −1 outside of the view."""
    counts: dict[str, int]
    """What was done. Each object is one of these for each eye: "culled" (not in view), "one_level" (in view, nothing to
    choose), "settled" (another eye asked for level 0 already), "large" (larger than curves are asked for) or "asked".
    Of those asked: "lens" (σ′ was computed), "table" (the level stood in a table of the model), "formula" (curves were
    evaluated)."""

    @property
    def coarser(self) -> NDArray[np.int32]:
        """The coarser of the two levels that are shown (N,)."""
        return np.ceil(self.shown).astype(np.int32)

    @property
    def finer_weight(self) -> Array:
        """How much of level `coarser` − 1 is shown (N,), 0 to below 1; the rest is `coarser`."""
        return np.asarray(np.ceil(self.shown) - self.shown)

    def __len__(self) -> int:
        """How many objects there are."""
        return len(self.level)

    def __repr__(self) -> str:
        levels, numbers = np.unique(self.level, return_counts=True)
        parts = (f"{level}: {number:,}" for level, number in zip(levels.tolist(), numbers.tolist(), strict=True))
        return f"Selection({len(self)} objects; {', '.join(parts)})"
