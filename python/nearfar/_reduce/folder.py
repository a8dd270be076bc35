"""Reads and writes reduced scenes as folders: near geometry as GLB, environment map as EXR, other data as JSON."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

from nearfar._base import check, files, formats
from nearfar._cubemap.envmap import EnvMap
from nearfar._impostor.settings import ImpostorSettings
from nearfar._scene.joined import move_origin
from nearfar._scene.moving_rows import frames_of, moving_rows
from nearfar._scene.names import MAX_OBJECTS, Names, names_of
from nearfar._scene.scene import Scene

NAME, VERSION = "reduced", 2
"""Name of the document's format without "nearfar.", and its version."""
NEAR, FAR, DOCUMENT = "near.glb", "far.exr", "reduced.json"
"""Names of the files in a folder."""
QUADS, LIGHT = "far.glb", "light.glb"
"""Names of the files of impostors: the far part alone, and near and far part together."""

IMPOSTOR_SETTINGS = tuple(field.name for field in fields(ImpostorSettings))
"""Names of the settings of impostors that a folder stores."""

COUNTS = ("triangles", "near", "intermediate", "nsf", "nsf_at_r1", "sf", "rays")
"""Names of counts of the whole scene, which are stored because the near part does not determine them."""

REASONS = ("center", "r2", "r1", "radii")
"""Parameters that `reduce` may choose, in the order of its reasons; "radii" means both radii at once."""


@dataclass(frozen=True)
class Contents:
    """The parts of a reduced scene that a folder stores."""

    near: Scene
    env: EnvMap | None
    center: tuple[float, float, float]
    r1: float
    r2: float
    morph: str
    boundary: str
    counts: dict[str, int]
    """`COUNTS` of the scene that was reduced."""
    reasons: Mapping[str, str] = field(default_factory=dict)
    """Reasons for the centre and radii that `reduce` chose, by their names in `REASONS`."""
    impostors: dict[str, Any] | None = None
    """Settings, counts and layers of impostors; None for a reduced scene with a map alone."""


def save(
    path: str | os.PathLike[str], contents: Contents, *, half: bool, extra: Mapping[str, bytes] | None = None
) -> None:
    """Write a folder atomically; `ReducedScene.save` describes its files. `extra` are further files by name."""
    from nearfar._scene import glb

    near, env, target = contents.near, contents.env, check.path("path", path)
    document = formats.header(
        NAME,
        VERSION,
        origin=near.origin.tolist(),
        color_space="linear",
        center=list(contents.center),
        r1=contents.r1,
        r2=contents.r2,
        morph=contents.morph,
        boundary=contents.boundary,
        files={"near": NEAR, "far": None if env is None else FAR},
        counts=contents.counts,
        moving=moving_rows(near),
        notes=list(near.report.notes),
        **_object_names(near, env),
        **({"reasons": dict(contents.reasons)} if contents.reasons else {}),
        **({} if contents.impostors is None else {"impostors": contents.impostors}),
    )
    with files.atomic_folder(target, marker=DOCUMENT) as folder:
        # Other files of the folder are relative to the centre.
        extras = {"center": list(contents.center), "origin": [0.0, 0.0, 0.0], "r1": contents.r1, "r2": contents.r2}
        files.write(folder / NEAR, glb.encode(near._core, near.object_names, near._undrawn, extras))
        if env is not None:
            env.save(folder / FAR, half=half)
        for name, data in (extra or {}).items():
            files.write(folder / name, data)
        (folder / DOCUMENT).write_text(formats.to_json(document, compact=True), encoding="utf-8")


def _object_names(near: Scene, env: EnvMap | None) -> dict[str, Any]:
    """Return the field `object_names`; empty if the other files list the names.

    The file of a map with object numbers lists all names. Without such a map, only objects of the near part are
    visible, whose names are those of the nodes in its file. For nameless objects the field is their number.
    """
    names = near._names.source
    if isinstance(names, int):
        return {"object_names": names}
    is_listed = env is None or env.object_id is None or env.object_names == tuple(names)
    return {} if is_listed else {"object_names": list(names)}


def _names(stated: Any) -> Sequence[str] | int:
    """Check the field `object_names`: names, or the number of nameless objects."""
    if isinstance(stated, list | tuple):
        return names_of("object_names", stated)
    return check.integer("object_names", stated, 0, MAX_OBJECTS)


def has_impostors(path: str | os.PathLike[str]) -> bool:
    """Return whether a folder has impostors; errors as in `load`."""
    return formats.read_json(Path(path) / DOCUMENT, NAME, VERSION).get("impostors") is not None


def load(path: str | os.PathLike[str]) -> Contents:
    """Read a folder; FormatError if a file is damaged or too new, OSError if one is missing."""
    from nearfar._scene import glb

    folder = check.path("path", path)
    if folder.name == DOCUMENT:
        folder = folder.parent
    files.restore(folder)
    document = formats.read_json(folder / DOCUMENT, NAME, VERSION)
    with formats.guarded(folder / DOCUMENT):
        object_names = document.get("object_names")
        center = check.vector("center", document["center"])
        if max(map(abs, center)) > check.FARTHEST:
            raise ValueError(f"center: expected numbers up to {check.FARTHEST:g}, got {center}")
        near_radius, far_radius = check.radii(document["r1"], document["r2"])
        counts = {name: check.integer(name, document["counts"][name], 0, 2**62) for name in COUNTS}
        has_map = document["files"]["far"] is not None
        texts = check.mapping("reasons", document.get("reasons", {}), "texts by name")
        reasons = {name: check.text(name, texts[name]) for name in REASONS if name in texts}
        stated = document.get("impostors")
        impostors = None if stated is None else dict(check.mapping("impostors", stated, "values by name"))
        notes = tuple(check.instance("notes", note, str, "texts") for note in document.get("notes", []))
    data = (folder / NEAR).read_bytes()
    env = EnvMap.load(folder / FAR) if has_map else None
    if object_names is None and env is not None and env.object_id is not None:
        object_names = env.object_names
    with formats.guarded(folder / DOCUMENT):
        known_names = None if object_names is None else Names(_names(object_names))
    with formats.guarded(folder / NEAR):
        decoder = glb.Decoder(data, known_names)
        core, names, undrawn = decoder.decode(), decoder.names, decoder.undrawn
    with formats.guarded(folder / DOCUMENT):
        frames, load_placements = frames_of(document["moving"], names, core.moving_placements(), NEAR)
        near = Scene(core, names, frames=frames, load_placements=load_placements, notes=notes, undrawn=undrawn)
        return Contents(
            near,
            env,
            center,
            near_radius,
            far_radius,
            check.choice("morph", document["morph"], ("blend", "cylinder", "none")),
            check.choice("boundary", document["boundary"], ("r1", "r2")),
            counts,
            reasons,
            impostors,
        )


def load_quads(folder: Path, center: tuple[float, float, float]) -> Scene:
    """Read the far part of impostors; FormatError if the file is damaged, OSError if it is missing."""
    path = folder / QUADS
    if not path.is_file():
        raise FileNotFoundError(f"{path}: expected the quads of impostors, found no file")
    with formats.guarded(path):
        quads = move_origin(Scene.load(path), center)
        return quads._derived(quads._core, quads._load_placements, used=())
