"""Pickling of values that cache a compiled counterpart, and of values with a read-only mapping of counts."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from nearfar._base import check
from nearfar._base.settings import set_fields


class WithTwin:
    """A value with a compiled counterpart `_core`, made on first use; pickles and copies omit it."""

    def __getstate__(self) -> dict[str, Any]:
        return {name: value for name, value in self.__dict__.items() if name != "_core"}


class WithStats:
    """A frozen dataclass whose counts `stats` are in a mapping proxy, so read-only; pickles store them as a dict."""

    stats: Mapping[str, Any]

    def _freeze_stats(self) -> None:
        set_fields(self, stats=MappingProxyType(dict(check.mapping("stats", self.stats, "counts by name"))))

    def __getstate__(self) -> dict[str, Any]:
        return self.__dict__ | {"stats": dict(self.stats)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state | {"stats": MappingProxyType(state["stats"])})
