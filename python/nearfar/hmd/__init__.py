"""Headsets by name: what their runtimes report, each with its source. They are read on first use.

`names()` lists them; each is an attribute, such as `nearfar.hmd.QUEST_2`.
"""

from __future__ import annotations

import functools
from importlib import resources

from nearfar._eyes import Eye, TotalFov
from nearfar._hmd import Hmd

__all__ = ["Eye", "Hmd", "TotalFov", "get", "names"]

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


def names() -> tuple[str, ...]:
    """Names of all headsets, in alphabetical order."""
    return tuple(sorted(__annotations__))


@functools.cache
def get(name: str) -> Hmd:
    """Return the headset of a name such as "QUEST_2"; ValueError for names that are not in `names()`."""
    if name not in __annotations__:
        raise ValueError(f"name: expected one of {', '.join(names())}, got {name!r}")
    file = resources.files("nearfar.hmd") / "profiles" / f"{name.lower()}.json"
    return Hmd.from_json(file.read_bytes(), str(file))


def __getattr__(name: str) -> Hmd:
    if name in __annotations__:
        return get(name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return [*__all__, *names()]
