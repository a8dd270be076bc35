"""Values with a compiled twin."""

from __future__ import annotations

from typing import Any


class WithTwin:
    """A value whose compiled twin `_core` is made on first use: pickles and copies go without it."""

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_core"}
