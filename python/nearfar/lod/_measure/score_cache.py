"""Caches scores of levels, so that an interrupted measurement resumes."""

from __future__ import annotations

import io
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

VERSION = 3
"""Version of the measurement; a change invalidates cached scores."""

SUFFIX = ".npy"

SAVE_INTERVAL_S = 5.0
"""Seconds between two writes during a measurement: a killed process loses at most the scores of this time."""


def content(scene: Scene) -> str:
    """Hash of all properties of a scene that are drawn."""
    parts = parts_of(scene._core)
    del parts["material_tags"]
    return cache.key("scene", parts)


class ScoreCache:
    """Files with the scores (D, V) of each level, NaN where unknown.

    `contents` has the hash of each level, base first; `settings` are all other parameters that determine scores. Cached
    scores are copied to `scores` (K, D, V), and `save` writes new ones.
    """

    def __init__(self, contents: Sequence[str], settings: Iterable[object], scores: NDArray[np.float32]) -> None:
        settings = tuple(settings)
        base = contents[0]
        self._keys = [cache.key("lod.measure", VERSION, __version__, base, level, settings) for level in contents]
        self._scores = scores
        self._farther: dict[int, NDArray[np.float32]] = {}
        """Cached scores at further distances than those measured now, by level."""
        self._saved_at = time.monotonic()
        for number in range(1, len(contents)):
            self._load(number)
        self._saved = scores.copy()

    def _load(self, number: int) -> None:
        path = cache.find(self._keys[number], SUFFIX)
        if path is None:
            return
        try:
            # Read first: np.load from a file may raise TypeError on Ctrl-C while it detects the file type.
            stored = np.load(io.BytesIO(path.read_bytes()), allow_pickle=False)
        except (OSError, ValueError, EOFError):
            # The file was removed meanwhile or is damaged: measure again.
            return
        scores = self._scores[number]
        if stored.ndim != 2 or stored.shape[1] != scores.shape[1] or stored.dtype != scores.dtype:
            return
        shared = min(len(stored), len(scores))
        scores[:shared] = np.where(np.isnan(scores[:shared]), stored[:shared], scores[:shared])
        self._farther[number] = stored[shared:]

    def save_at_times(self) -> None:
        """Write new scores, unless they were written recently."""
        if time.monotonic() - self._saved_at > SAVE_INTERVAL_S:
            self.save()

    def save(self) -> None:
        """Write new scores, together with cached ones of further distances."""
        for number in range(1, len(self._keys)):
            scores = self._scores[number]
            if np.array_equal(scores, self._saved[number], equal_nan=True):
                continue
            cache.keep(self._keys[number], SUFFIX, partial(self._write, number))
            self._saved[number] = scores
        self._saved_at = time.monotonic()

    def _write(self, number: int, path: Path) -> None:
        scores = self._scores[number]
        data = io.BytesIO()
        np.save(data, np.concatenate([scores, self._farther.get(number, scores[:0])]), allow_pickle=False)
        path.write_bytes(data.getbuffer())
