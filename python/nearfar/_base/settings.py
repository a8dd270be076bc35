"""Groups of settings: frozen dataclasses whose fields a function also accepts as keywords."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any, TypeVar

from nearfar._base import check

Settings = TypeVar("Settings")


def gather(
    kind: type[Settings], settings: Settings | None, keywords: Mapping[str, Any], argument: str = "settings"
) -> Settings:
    """Return settings with the fields that a caller passed as keywords replaced.

    Parameters
    ----------
    kind
        The dataclass, which checks its fields.
    settings
        The settings; None for the defaults.
    keywords
        New values of fields, by name.
    argument
        Name of the argument that held the settings, for messages.

    Raises
    ------
    TypeError
        Settings of another type, or a keyword that is no field.
    """
    names = [field.name for field in fields(kind)]  # type: ignore[arg-type]
    if unknown := sorted(keywords.keys() - set(names)):
        expected = f"a parameter of the function, or a field of its settings such as {kind.__name__}"
        raise TypeError(f"{unknown[0]}: expected {expected} ({', '.join(names)})")
    if settings is None:
        return kind(**keywords)
    return replace(check.instance(argument, settings, kind, kind.__name__), **keywords)  # type: ignore[type-var]


def split(kind: type[Any], keywords: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Split the keywords of a function that takes two groups: return those of other settings, and the fields of one."""
    names = {field.name for field in fields(kind)}
    return (
        {name: value for name, value in keywords.items() if name not in names},
        {name: value for name, value in keywords.items() if name in names},
    )
