"""Headsets by name: the geometry that their runtimes report, and the sources of these data.

`names()` lists them; each is an attribute, such as `nearfar.hmd.QUEST_2`, which is read from its file on first use.
"""

from __future__ import annotations

import difflib
import functools
import re
from importlib import resources

from nearfar._base import check
from nearfar.hmd._eye import Eye, TotalFov
from nearfar.hmd._hmd import CARDBOARD_LENSES, GENERIC_LENS, Hmd

__all__ = ["CARDBOARD_LENSES", "GENERIC_LENS", "Eye", "Hmd", "TotalFov", "get", "names"]

GALAXY_XR: Hmd
INDEX: Hmd
INDEX_PARALLEL: Hmd
PICO_4: Hmd
PIMAX_5K_PLUS: Hmd
PIMAX_CRYSTAL: Hmd
PSVR2: Hmd
QUEST_2: Hmd
QUEST_3: Hmd
RIFT_CV1: Hmd
RIFT_S: Hmd
VARJO_AERO: Hmd
VIVE: Hmd
VIVE_FOCUS_3: Hmd
VIVE_PRO: Hmd

_PROFILES = resources.files("nearfar.hmd") / "profiles"


@functools.cache
def names() -> tuple[str, ...]:
    """Return the names of all headsets, in alphabetical order."""
    return tuple(sorted(file.name.removesuffix(".json").upper() for file in _PROFILES.iterdir()))


def get(name: str) -> Hmd:
    """Return the headset of a name such as "QUEST_2" or "Quest 2"; ValueError for names that are not in `names()`."""
    upper = re.sub(r"[ -]+", "_", check.instance("name", name, str, "text")).upper()
    if upper not in names():
        similar = difflib.get_close_matches(upper, names(), 1)
        hint = f" (did you mean {similar[0]}?)" if similar else ""
        raise ValueError(f"name: expected one of {', '.join(names())}, got {check.shortened(name)}{hint}")
    return _load_profile(upper)


@functools.cache
def _load_profile(name: str) -> Hmd:
    file = _PROFILES / f"{name.lower()}.json"
    return Hmd._from_json(file.read_bytes(), str(file))


def __getattr__(name: str) -> Hmd:
    if name in names():
        return get(name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return [*__all__, *names()]
