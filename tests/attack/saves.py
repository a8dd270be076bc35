"""Objects in two versions with their files, for cases that disturb a save over an older file."""

from __future__ import annotations

import functools
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import nearfar as nf
from tests.attack.case import Finding
from tests.attack.kind_saved import LOADERS
from tests.attack.seeds import saved_objects
from tests.support import bundle_cases
from tests.support.digest import digest

SAVES = (*(name for name in LOADERS if name != "hmdq.json"), "flat.png", "frame.png")
"""Names of the files and folders; those of hmdq contain a time."""


@dataclass(frozen=True)
class Save:
    """A way to save an object to a file."""

    name: str
    """Name of the file or folder."""
    first: Any
    """The older version, which is on the disk before."""
    second: Any
    """The newer version, which is saved over it."""
    write: Callable[[Any, Path], None]

    @functools.cached_property
    def digests(self) -> tuple[str, str]:
        """Digests of the files of both versions."""
        with tempfile.TemporaryDirectory() as folder:
            paths = [Path(folder) / f"{number}{Path(self.name).suffix}" for number in range(2)]
            self.write(self.first, paths[0])
            self.write(self.second, paths[1])
            return _digest(paths[0]), _digest(paths[1])


@functools.cache
def save_of(name: str) -> Save:
    """Return a save with both versions and their digests computed, so that timing covers the save alone."""
    (first, write), (second, _) = _objects(other=False)[name], _objects(other=True)[name]
    save = Save(name, first, second, write)
    assert save.digests[0] != save.digests[1]
    return save


@functools.cache
def _objects(*, other: bool) -> dict[str, tuple[Any, Callable[[Any, Path], None]]]:
    return saved_objects(other=other)


def _digest(path: Path) -> str:
    if path.is_dir():
        return digest(sorted(bundle_cases.content(path).items()))
    return digest(path.read_bytes())


def check_saved(save: Save, folder: Path) -> str:
    """Check that the old or the new version is complete, and that a save over it leaves no other files.

    Returns "old" or "new".
    """
    path = folder / save.name
    if save.name in LOADERS:
        # The load may restore a file that was set aside.
        try:
            found = LOADERS[save.name](path)
            if isinstance(found, nf.stream.Bundle):
                found.verify()
        except (nf.Error, OSError) as error:
            raise Finding(f"{save.name} is lost or damaged: {type(error).__name__}: {error}") from error
    there = _digest(path) if path.exists() else "nothing"
    if there not in save.digests:
        raise Finding(f"{save.name} is neither the old nor the new version")
    save.write(save.second, path)
    left = [item.name for item in folder.iterdir() if item.name != save.name]
    if left or _digest(path) != save.digests[1]:
        raise Finding(f"after the next save of {save.name} there is {', '.join(left) or 'another version'}")
    return "old" if there == save.digests[0] else "new"
