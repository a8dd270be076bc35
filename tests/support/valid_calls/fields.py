"""The fields of an instance of a dataclass, as arguments of its constructor."""

from __future__ import annotations

from typing import Any


def fields(instance: Any) -> dict[str, Any]:
    """Return values by name."""
    return {name: getattr(instance, name) for name in instance.__dataclass_fields__}
