"""Cases of damaged scene files: the scene works in all stages, or an error names the file."""

from __future__ import annotations

import gzip
import json
import random
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from tests.attack import mutate, mutate_json, seeds
from tests.attack.case import ACCEPTED, Case, Finding, Kind, Plan, check_sentence, refused
from tests.support.gltf_cases import encode, join
from tests.support.verdict import FOREIGN

MAX_TRIANGLES = 10_000
"""Maximum number of triangles of scenes that go through all stages; larger ones are only drawn."""

FARTHEST = 1e29
"""Maximum size in metres for which the package accepts a camera beside the scene."""


def kinds(*, own_only: bool) -> list[Kind]:
    """Return a kind for each format; `own_only` leaves out the files of the data folder."""

    def files(suffix: str) -> list[seeds.Files]:
        return (seeds.scene_files() if own_only else seeds.all_scene_files())[suffix]

    packed = Kind("scene ply.gz", lambda dice: _packed(files("ply"), dice), run, share=0.3)
    return [*(_kind(suffix, files) for suffix in seeds.SUFFIXES), packed]


def _kind(suffix: str, found: Callable[[str], list[seeds.Files]]) -> Kind:
    def make(dice: random.Random) -> tuple[Plan, seeds.Files]:
        listed = found(suffix)
        # The first seeds have the most features.
        files = dict(dice.choice(listed[:2] if dice.random() < 0.5 else listed))
        names = list(files)
        name = names[0] if len(names) == 1 or dice.random() < 0.75 else dice.choice(names[1:])
        if name != names[0] and dice.random() < 0.1:
            del files[name]
        else:
            files[name] = _damaged(name, files[name], dice, [next(iter(other.values())) for other in listed])
        return plan(dice, names[0]), files

    return Kind(f"scene {suffix}", make, run, share=2.0 if suffix in ("glb", "gltf", "obj") else 1.0)


def plan(dice: random.Random, name: str) -> Plan:
    options: Plan = {}
    if dice.random() < 0.5:
        options["on_invalid"] = "drop"
    if dice.random() < 0.2:
        options["blend"] = "cutout"
    if dice.random() < 0.1:
        options["up"] = dice.choice(("z", "-x"))
    if dice.random() < 0.1:
        options["scale"] = dice.choice((1e-3, 1e3, 1e-30, 1e30))
    return {"file": name, "options": options, "all": dice.random() < 0.3}


def _packed(listed: list[seeds.Files], dice: random.Random) -> tuple[Plan, seeds.Files]:
    data = dice.choice(listed)["a.ply"]
    inside = dice.random() < 0.5
    data = gzip.compress(mutate.damaged(data, dice) if inside else data, mtime=0)
    return plan(dice, "a.ply.gz"), {"a.ply.gz": data if inside else mutate.damaged(data, dice)}


def _damaged(name: str, data: bytes, dice: random.Random, others: list[bytes]) -> bytes:
    suffix = Path(name).suffix
    if suffix == ".glb" and dice.random() < 0.75:
        document, binary = split(data)
        if document is not None:
            return damaged_glb(document, binary, dice)
    if suffix in (".gltf", ".json", ".geojson") and dice.random() < 0.75:
        try:
            return mutate_json.text(mutate_json.damaged(json.loads(data), dice), dice)
        except ValueError:
            pass
    if suffix == ".3mf" and dice.random() < 0.8:
        members = seeds.members(data)
        chosen = dice.choice(list(members))
        members[chosen] = mutate.damaged(members[chosen], dice)
        return seeds.packed(members)
    return mutate.damaged(data, dice, others)


def split(data: bytes) -> tuple[Any, bytes]:
    """Return a GLB's document and its arrays; None for other data."""
    try:
        length = struct.unpack_from("<I", data, 12)[0]
        return json.loads(data[20 : 20 + length]), data[28 + length :]
    except (ValueError, struct.error, RecursionError):
        return None, b""


def damaged_glb(document: Any, binary: bytes, dice: random.Random) -> bytes:
    """Damage the document or the arrays of a GLB; its chunks stay consistent."""
    if dice.random() < 0.7:
        return join(mutate_json.text(mutate_json.damaged(document, dice), dice), binary)
    return encode(document, mutate.damaged(binary, dice))


def run(case: Case, folder: Path) -> str:
    """Load a scene and use it."""
    path = folder / case.plan["file"]
    try:
        scene = nf.Scene.load(path, **case.plan["options"])
    except nf.SceneError as error:
        check_sentence(error, path)
        # A decompressor's own words may follow in parentheses.
        if FOREIGN.search(str(error).partition(" (Error ")[0]):
            raise Finding(f"the message is about the code that reads: {error!s:.200}") from error
        return refused(error)
    use(scene, folder, everything=case.plan["all"] and scene.triangle_count <= MAX_TRIANGLES)
    return ACCEPTED


def use(scene: nf.Scene, folder: Path, *, everything: bool) -> None:
    """Draw a loaded scene; with `everything` also reduce it and save its files."""
    if scene.triangle_count <= 0 or not np.isfinite(scene.bounds).all() or not str(scene.report):
        raise Finding(f"a scene of {scene.triangle_count} triangles within {scene.bounds.tolist()} was loaded")
    low, high = scene.bounds
    middle, extent = (low + high) / 2, float(max(np.max(high - low), 1e-6))
    repr(scene)
    if extent + np.abs(scene.bounds).max() > FARTHEST:
        return
    camera = nf.Camera.look_at(
        middle + np.multiply(extent, (0.3, 0.2, 1.5)), middle, fov=nf.Fov.symmetric(60), size=(16, 16)
    )
    channels = ("color", "range", "object_id", "face_id", "position", "normal")
    frame = nf.render(scene, camera, channels=channels, backend="cpu")
    if np.isnan(frame.require("color")).any() or np.isnan(frame.require("range")).any():
        raise Finding("a frame with NaN was rendered")
    if not everything:
        return
    reduced = nf.reduce(scene, center=middle, r1=0.1 * extent, r2=0.3 * extent, face_size=8, samples=1, backend="cpu")
    # A user beyond r₁ sees edges bent so much that they are split into very many.
    user = middle + np.multiply(extent, (0.05, 0.0, 0.02))
    settings: dict[str, Any] = {"user": user, "tolerance_px": 4.0, "backend": "cpu"}
    shown = reduced.render(camera, **settings)
    reduced.save(folder / "reduced", half=False)
    again = nf.ReducedScene.load(folder / "reduced").render(camera, **settings)
    if shown.require("color").tobytes() != again.require("color").tobytes():
        raise Finding("a reduced scene is drawn otherwise after it was saved and loaded")
