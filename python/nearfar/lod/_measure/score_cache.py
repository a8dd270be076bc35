"""Scores of levels that outlive the process: a measurement that was stopped goes on where it was."""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from functools import partial
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from nearfar._base import cache
from nearfar._base.version import __version__
from nearfar._scene.scene import Scene
from nearfar._scene.serialize import parts_of

VERSION = 1
"""Of the way levels are measured."""

SUFFIX = ".npy"

EVERY = 5.0
"""Seconds between two writings while work goes on: what a killed process loses."""


def content(scene: Scene) -> str:
    """Hash of all that is drawn of a scene."""
    return cache.key("scene", parts_of(scene._core))


class Kept:
    """Scores of each level (D, V), NaN where there are none yet, in the cache.

    Parameters
    ----------
    contents
        Of each level, the base first.
    settings
        All else that scores depend on.
    scores
        (K, D, V); what is in the cache is filled in, and `save` keeps it.
    """

    def __init__(self, contents: Sequence[str], settings: Iterable[object], scores: NDArray[np.float64]) -> None:
        settings = tuple(settings)
        base = contents[0]
        self._keys = [cache.key("lod.measure", VERSION, __version__, base, own, settings) for own in contents]
        self._scores = scores
        self._further: dict[int, NDArray[np.float64]] = {}
        self._saved = time.monotonic()
        for number in range(1, len(contents)):
            self._load(number)
        self._known = scores.copy()

    def _load(self, number: int) -> None:
        path = cache.find(self._keys[number], SUFFIX)
        if path is None:
            return
        try:
            found = np.load(path, allow_pickle=False)
        except (OSError, ValueError, EOFError):
            # Removed in between, or damaged: it is measured again.
            return
        own = self._scores[number]
        if found.ndim != 2 or found.shape[1] != own.shape[1] or found.dtype != own.dtype:
            return
        shared = min(len(found), len(own))
        own[:shared] = np.where(np.isnan(own[:shared]), found[:shared], own[:shared])
        self._further[number] = found[shared:]

    def save_at_times(self) -> None:
        """Keep what is new, unless that was done just before."""
        if time.monotonic() - self._saved > EVERY:
            self.save()

    def save(self) -> None:
        """Keep what is new, beside what is known of more distances than ours."""
        for number in range(1, len(self._keys)):
            own = self._scores[number]
            if np.array_equal(own, self._known[number], equal_nan=True):
                continue
            cache.keep(self._keys[number], SUFFIX, partial(self._write, number))
            self._known[number] = own
        self._saved = time.monotonic()

    def _write(self, number: int, path: Path) -> None:
        own = self._scores[number]
        with open(path, "wb") as file:
            np.save(file, np.concatenate([own, self._further.get(number, own[:0])]), allow_pickle=False)
