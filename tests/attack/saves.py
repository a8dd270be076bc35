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
from tests.attack.operations import ZONES, digest, shared
from tests.support import bundle_cases
from tests.support.lod_cases import SMALL, levels


@dataclass(frozen=True)
class Save:
    """How an object's file is written and read."""

    name: str
    """Of the file or folder."""
    make: Callable[[], tuple[Any, Any]]
    """Makes two versions."""
    write: Callable[[Any, Path], None]
    read: Callable[[Path], Any] | None
    """None for files that are only written."""

    @property
    def first(self) -> Any:
        """The version that lies there before."""
        return _versions(self)[0]

    @property
    def second(self) -> Any:
        """The version that is saved over it."""
        return _versions(self)[1]


@functools.cache
def _versions(save: Save) -> tuple[Any, Any]:
    return save.make()


def _reduced() -> tuple[Any, Any]:
    it = shared()
    return it.reduced, nf.reduce(it.scene, **ZONES, face_size=64, samples=1, backend="cpu")


def _maps() -> tuple[Any, Any]:
    return tuple(it.env for it in _reduced())


def _frames() -> tuple[Any, Any]:
    it = shared()
    return it.frame, nf.render(it.scene, it.camera, samples=2, backend="cpu")


def _models() -> tuple[Any, Any]:
    return shared().model, nf.lod.measure(levels(7, 5, 4), **SMALL)


def _export(model: Any, path: Path) -> None:
    model.export(path, view=shared().camera, k=0.5, d=1.0, all_levels=True)


def _bundles() -> tuple[Any, Any]:
    return bundle_cases.village(), bundle_cases.village(height=2.0)


def _export_bundle(scene: Any, path: Path) -> None:
    nf.stream.export(scene, path, **bundle_cases.SETTINGS)


def _read_bundle(path: Path) -> None:
    nf.stream.open(path).verify()


SAVES = {
    "bundle": Save("bundle", _bundles, _export_bundle, _read_bundle),
    "reduced": Save("reduced", _reduced, lambda it, path: it.save(path), nf.ReducedScene.load),
    "map": Save("map.exr", _maps, lambda it, path: it.save(path), nf.EnvMap.load),
    "flat map": Save(
        "flat.png",
        _maps,
        lambda it, path: it.save_equirectangular(path),
        None,
    ),
    "frame": Save("frame.exr", _frames, lambda it, path: it.save(path), nf.Frame.load),
    "picture": Save("frame.png", _frames, lambda it, path: it.save(path), None),
    "model": Save("model.json", _models, lambda it, path: it.save(path), nf.lod.LodModel.load),
    "levels": Save("model.glb", _models, _export, nf.lod.LodModel.load),
    "headset": Save("hmd.json", lambda: (nf.hmd.INDEX, nf.hmd.VIVE), lambda it, path: it.save(path), nf.Hmd.load),
}
"""Every file that the package writes by a method, and bundles."""


@functools.cache
def _digests(save: Save) -> tuple[str, str]:
    """Digests of the files of both versions."""
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for number, version in enumerate((save.first, save.second)):
            path = Path(folder) / f"{number}{Path(save.name).suffix}"
            save.write(version, path)
            found.append(_digest(path))
    return found[0], found[1]


def prepare(save: Save) -> None:
    """Make both versions and their digests, so that a later save takes its own time alone."""
    _digests(save)


def _digest(path: Path) -> str:
    files = sorted(item for item in path.rglob("*") if item.is_file()) if path.is_dir() else [path]
    return digest([[item.relative_to(path).as_posix(), item.read_bytes()] for item in files])


def check_saved(save: Save, folder: Path) -> str:
    """Check that the old or the new version lies there, whole, and that a save over it leaves nothing else.

    Returns "old" or "new".
    """
    path = folder / save.name
    if save.read is not None:
        # It may put back what was set aside.
        try:
            save.read(path)
        except (nf.Error, OSError) as error:
            raise Finding(f"{save.name} is lost or damaged: {type(error).__name__}: {error}") from error
    found = _digest(path) if path.exists() else "nothing"
    if found not in _digests(save):
        raise Finding(f"{save.name} is neither the old nor the new version")
    save.write(save.second, path)
    left = [item.name for item in folder.iterdir() if item.name != save.name]
    if left or _digest(path) != _digests(save)[1]:
        raise Finding(f"after the next save of {save.name} there is {', '.join(left) or 'another version'}")
    return "old" if found == _digests(save)[0] else "new"
