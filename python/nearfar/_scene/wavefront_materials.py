"""Properties of Wavefront materials that are not drawn."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

OPAQUE = "with transparency drawn opaque"

_MAPS = {
    "a normal map": ("map_bump", "bump", "norm", "map_kn"),
    "emission": ("map_ke",),
    "an opacity map": ("map_d",),
    "metal or gloss": ("map_ks", "map_ns", "map_pr", "map_pm", "map_refl", "refl"),
}


def differences(entries: Mapping[str, Any]) -> tuple[str, ...]:
    """What of a material is neither drawn nor saved, phrased to follow "2 materials".

    Parameters
    ----------
    entries
        Keywords of the material in small letters with their values: numbers, or words as the file has them.
    """
    lost = {what for what, keywords in _MAPS.items() if any(keyword in entries for keyword in keywords)}
    if max(_numbers(entries.get("ke"))) > 0.0:
        lost.add("emission")
    if min(_numbers(entries.get("pm"))) > 0.0:
        lost.add("metal or gloss")
    notes = [f"with {what} drawn and saved without it" for what in _MAPS if what in lost]
    if min(_numbers(entries.get("d"), 1.0)) < 1.0 or max(_numbers(entries.get("tr"))) > 0.0:
        notes.append(OPAQUE)
    return tuple(notes)


def _numbers(value: Any, default: float = 0.0) -> list[float]:
    """The finite numbers of an entry, or the default if it has none."""
    values = value if isinstance(value, list | tuple) else [value]
    found = []
    for item in values:
        try:
            number = float(item)
        except (TypeError, ValueError):
            continue
        if math.isfinite(number):
            found.append(number)
    return found or [default]
