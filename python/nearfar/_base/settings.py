"""Groups of settings: frozen dataclasses whose fields a function also accepts as keywords."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import fields, replace
from typing import Any, ClassVar, TypeVar

from nearfar._base import check

Settings = TypeVar("Settings")


class Alternatives:
    """Base of settings with groups of fields that exclude each other, such as a radius and a budget."""

    _alternatives: ClassVar[tuple[tuple[str, ...], ...]] = ()
    """Names of the fields of each group; None means that a field is not set."""

    def _adapted_to(self, keywords: Mapping[str, Any]) -> dict[str, Any]:
        """Return None for each field that the keywords exclude, that is, of all groups but the one that they set."""
        groups = [names for names in self._alternatives if any(keywords.get(name) is not None for name in names)]
        others = [names for names in self._alternatives if len(groups) == 1 and names not in groups]
        return dict.fromkeys(name for names in others for name in names)


def gather(
    kind: type[Settings], settings: Settings | None, keywords: Mapping[str, Any], argument: str = "settings"
) -> Settings:
    """Return settings with the fields that a caller passed as keywords replaced.

    A keyword also resets fields that exclude it (`Alternatives`). `kind` is the dataclass of the settings, which checks
    its fields; settings of None stand for its defaults. `argument` is the name of the settings' argument in messages.
    TypeError for settings of another type, and for a keyword that is not a field.
    """
    names = [field.name for field in fields(kind)]  # type: ignore[arg-type]
    if unknown := sorted(keywords.keys() - set(names)):
        expected = f"a parameter of the function, or a field of its settings such as {kind.__name__}"
        raise TypeError(f"{unknown[0]}: expected {expected} ({', '.join(names)})")
    if settings is None:
        return kind(**keywords)
    check.instance(argument, settings, kind, kind.__name__)
    adapted = settings._adapted_to(keywords) if isinstance(settings, Alternatives) else {}
    return replace(settings, **(adapted | dict(keywords)))  # type: ignore[type-var]


def split(kind: type[Any], keywords: Mapping[str, Any]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Split the keywords of a function with two groups of settings: return all others, and the fields of `kind`."""
    fields_of_kind = {field.name: keywords[field.name] for field in fields(kind) if field.name in keywords}
    return {name: value for name, value in keywords.items() if name not in fields_of_kind}, fields_of_kind


def set_fields(instance: object, **values: Any) -> None:
    """Set fields of a frozen dataclass, for its `__post_init__`."""
    for name, value in values.items():
        object.__setattr__(instance, name, value)
