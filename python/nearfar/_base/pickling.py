"""Pickling of values that cache a compiled counterpart."""

from __future__ import annotations

from typing import Any


class WithTwin:
    """A value with a compiled counterpart `_core`, made on first use; pickles and copies omit it."""

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_core"}
