"""Cases of damaged files of the package's own formats: whatever loads can be saved, and loads again unchanged."""

from __future__ import annotations

import hashlib
import json
import random
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from nearfar import _core
from nearfar._base import exr
from tests.attack import mutate, mutate_json, seeds
from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan, check_sentence, refused
from tests.attack.kind_scenes import damaged_glb, split

CAMERA = nf.Camera((0, 1, 0), fov=nf.Fov.symmetric(90), size=(8, 8))

LOADERS: dict[str, Callable[[Path], Any]] = {
    "reduced": nf.ReducedScene.load,
    "bundle": nf.stream.open,
    "envmap.exr": nf.EnvMap.load,
    "frame.exr": nf.Frame.load,
    "lod.json": nf.lod.LodModel.load,
    "lod.glb": nf.lod.LodModel.load,
    "hmd.json": nf.Hmd.load,
    "hmdq.json": nf.Hmd.load,
}


FOLDERS = ("reduced", "bundle")
"""Kinds stored as folders."""


def kinds() -> list[Kind]:
    return [_kind(name) for name in LOADERS]


def _kind(name: str) -> Kind:
    def make(dice: random.Random) -> tuple[Plan, seeds.Files]:
        files = dict(seeds.saved_files()[name])
        others = list(files.values())
        chosen = dice.choice(list(files))
        if len(files) > 1 and dice.random() < 0.03:
            del files[chosen]
        else:
            files[chosen] = _damaged(chosen, files[chosen], dice, others)
            if name == "bundle" and dice.random() < 0.9:
                _list_again(files, chosen)
        return {"name": name}, files

    return Kind(f"saved {name}", make, run, share=2.0 if name in FOLDERS else 1.0)


def _list_again(files: seeds.Files, name: str) -> None:
    """List the size and hash of a bundle's damaged file in its manifest, so that checks beyond these are reached."""
    if name != "manifest.json":
        manifest = json.loads(files["manifest.json"])
        manifest["files"][name] = {"bytes": len(files[name]), "sha256": hashlib.sha256(files[name]).hexdigest()}
        files["manifest.json"] = json.dumps(manifest).encode()


def _damaged(name: str, data: bytes, dice: random.Random, others: list[bytes]) -> bytes:
    suffix = Path(name).suffix
    if suffix == ".json" and dice.random() < 0.8:
        return mutate_json.text(mutate_json.damaged(json.loads(data), dice), dice)
    if suffix == ".glb" and dice.random() < 0.8:
        return damaged_glb(*split(data), dice)
    if suffix == ".exr" and dice.random() < 0.6:
        return _damaged_exr(data, dice)
    return mutate.damaged(data, dice, others)


def _damaged_exr(data: bytes, dice: random.Random) -> bytes:
    """Change the header, a channel or a block of an EXR file, which stays valid."""
    parts = _core.decode_exr(data)
    _, channels, attributes = parts[dice.randrange(len(parts))]
    name = dice.choice(list(channels))
    match dice.randrange(8):
        case 0:
            del channels[name]
        case 1:
            channels[f"{name}2"] = channels[name]
        case 2:
            with np.errstate(all="ignore"):
                channels[name] = channels[name].astype(dice.choice((np.float16, np.float32, np.uint32)))
        case 3:
            channels[name] = np.full_like(channels[name], dice.choice((0, 1, 65504)))
        case 4 if channels[name].dtype != np.uint32:
            channels[name][...] = dice.choice((np.nan, np.inf, -np.inf, -1.0))
        case 5:
            size = dice.choice(((1, 1), (8, 4), (4, 8), (16, 16), (1, 300)))
            for key, values in channels.items():
                channels[key] = np.resize(values, size)
        case 6:
            parts.append(parts[0])
        case _:
            text = mutate_json.damaged(json.loads(str(parts[0][2][exr.ATTRIBUTE])), dice)
            try:
                parts[0][2][exr.ATTRIBUTE] = mutate_json.text(text, dice).decode()
            except UnicodeDecodeError:
                attributes[exr.ATTRIBUTE] = "\xff"
    try:
        return _core.encode_exr(parts).tobytes()
    except (ValueError, OverflowError):
        return mutate.damaged(data, dice)


def run(case: Case, folder: Path) -> str:
    """Load an object, use it, and save and load it twice."""
    name = case.plan["name"]
    is_folder = name in FOLDERS
    path = folder if is_folder else folder / name
    load = LOADERS[name]
    try:
        what = load(path)
    except nf.FormatError as error:
        check_sentence(error, path)
        return refused(error)
    except FileNotFoundError as error:
        if len(case.files) == len(seeds.saved_files()[name]):
            raise
        return refused(error)
    if name == "bundle":
        return _use_bundle(what, path)
    _use(name, what)
    results = folder / ".results"
    results.mkdir()
    saved = []
    for number in range(2):
        path = results / f"{number}{'' if is_folder else Path(name).suffix}"
        _save(name, what, path)
        saved.append(_bytes(path))
        what = load(path)
    # hmdq's files contain the time, and their sources the runtime's name.
    if saved[0] != saved[1] and name != "hmdq.json":
        raise Finding("what was loaded is saved otherwise after it was saved and loaded")
    return ACCEPTED


def _use_bundle(bundle: nf.stream.Bundle, path: Path) -> str:
    """Show every ring; all files have been read by then."""
    repr(bundle)
    bundle.summary()
    try:
        for ring in range(bundle.count + 1):
            # Splitting moved objects of a thousand kilometres, as in damaged files, would take too long.
            frame = bundle.at(ring).render(CAMERA, method="exact", backend="cpu")
            if np.isnan(frame.require("color")).any():
                raise Finding("a frame with NaN was rendered")
        bundle.verify()
    except nf.FormatError as error:
        check_sentence(error, path)
        return refused(error)
    return ACCEPTED


def _use(name: str, what: Any) -> None:
    repr(what)
    match name:
        case "reduced":
            frame = what.render(CAMERA, backend="cpu")
            if np.isnan(frame.require("color")).any() and (what.env is None or np.isfinite(what.env.color).all()):
                raise Finding("a frame with NaN was rendered")
            _ = what.stats
        case "envmap.exr":
            what.sample([[0, 0, 1], [1, 0, 0]])
        case "frame.exr" if "color" in what.channels:
            what.to_image()
        case "lod.json" | "lod.glb":
            model: nf.lod.LodModel = what
            nf.lod.select([model], [0], [[0, 0, -5]], [0.1], camera=CAMERA, k=0.9, d=1.0)
        case "hmd.json" | "hmdq.json":
            # Views that do not contain the head's horizontal plane have no angles, and their error says so.
            with suppress(ValueError):
                _ = what.total_fov


def _save(name: str, what: Any, path: Path) -> None:
    match name:
        case "reduced":
            what.save(path, half=False)
        case "envmap.exr":
            what.save(path, half=False)
        case "lod.glb":
            what.export(path, view=CAMERA, k=0.5, d=1.0, all_levels=True)
        case _:
            what.save(path)


def _bytes(path: Path) -> list[tuple[str, bytes]]:
    files = sorted(path.iterdir()) if path.is_dir() else [path]
    return [(item.name if path.is_dir() else "", item.read_bytes()) for item in files]
