"""Recognises nearfar's own files and folders by their content, and describes them for `nearfar info`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import nearfar as nf
from nearfar._base import formats, remote
from nearfar.cli import _export, _orthoview
from nearfar.cli._output import bytes_text, count, note_rows
from nearfar.cli._scenes import is_procedural, is_reduced
from nearfar.lod import _export as lod_files
from nearfar.orthoview._store import DOCUMENT
from nearfar.stream._store import MANIFEST

Rows = list[tuple[str, str]]
Own = nf.stream.Bundle | nf.orthoview.OrthoTree | nf.lod.LodModel


def open_own(source: str) -> Own | None:
    """Open a bundle, a tree of orthoviews or a model of levels; None for anything else. Errors as in their readers."""
    if is_procedural(source) or is_reduced(source):
        return None
    if remote.is_url(source):
        try:
            return nf.stream.open(source)
        except FileNotFoundError:
            return nf.orthoview.open(source)
    path = remote.local(source)
    if path.name == MANIFEST or (path / MANIFEST).is_file():
        return nf.stream.open(path)
    if (path / DOCUMENT).is_file():
        return nf.orthoview.open(path)
    return nf.lod.LodModel.load(path) if path.is_file() and lod_files.find_document(path) is not None else None


def describe(own: Own, source: str) -> tuple[dict[str, Any], Rows]:
    """Return the fields that describe the content in a document of schema "info", and the rows of the printed table."""
    if isinstance(own, nf.orthoview.OrthoTree):
        return {"kind": "orthoview", "orthoview": _orthoview.describe(own)}, [
            ("kind", "tree of orthoviews"),
            *_orthoview.content_rows(own, {}),
        ]
    return _bundle(own) if isinstance(own, nf.stream.Bundle) else _levels(own, remote.local(source))


def scene_of(own: Own) -> nf.Scene | None:
    """Return level 0 of a model with geometry; None for all else, which has no single scene."""
    return own.levels[0].scene if isinstance(own, nf.lod.LodModel) and own.levels is not None else None


def _bundle(bundle: nf.stream.Bundle) -> tuple[dict[str, Any], Rows]:
    settings = {name: getattr(bundle, name) for name in ("face_size", "pixels_per_degree", "split_px")}
    document = _export.describe(bundle) | settings | {"losses": list(bundle.losses)}
    rows = [
        ("kind", f"bundle of {count(document['triangles'])} triangles in {count(len(bundle.files))} files"),
        ("bytes", bytes_text(bundle.nbytes)),
        ("maps", f"6 × {bundle.face_size}²"),
        *_export.content_rows(bundle),
        *(("loss", loss) for loss in bundle.losses),
    ]
    if bundle.split_px is not None:
        rows.append(("triangles", f"split to errors of {bundle.split_px:g} px"))
    return {"kind": "bundle", "bundle": document}, [*rows, *note_rows(document)]


def _levels(model: nf.lod.LodModel, path: Path) -> tuple[dict[str, Any], Rows]:
    with formats.guarded(path):
        switches = (lod_files.find_document(path) or {}).get("switches") or [{}] * len(model)
        levels = [
            {
                "triangles": int(model.triangles[number]),
                "error": float(model.errors[number]),
                "screen_coverage": switch.get("screen_coverage"),
                "distance": None if (scaled := switch.get("distance_per_radius")) is None else scaled * model.radius,
            }
            for number, switch in zip(range(len(model)), switches, strict=True)
        ]
    document: dict[str, Any] = {
        "name": model.name,
        "radius": float(model.radius),
        "bytes": path.stat().st_size,
        "has_geometry": model.levels is not None,
        "levels": levels,
        "measured": model.measured,
    }
    geometry = "with" if document["has_geometry"] else "without"
    settings = (f"{name} {value}" for name, value in model.measured.items() if isinstance(value, int | float | str))
    return {"kind": "levels", "levels": document}, [
        ("kind", f"levels of detail of {model.name}, {geometry} geometry, {bytes_text(document['bytes'])}"),
        ("radius", f"{model.radius:.4g} m"),
        *((f"level {number}", _level_text(level)) for number, level in enumerate(levels)),
        ("measured", ", ".join(settings)),
    ]


def _level_text(level: dict[str, Any]) -> str:
    text = f"{count(level['triangles'])} triangles, error {level['error']:.3g} m"
    if level["distance"] is None:
        return text
    return f"{text}, from {level['distance']:.3g} m on ({100.0 * level['screen_coverage']:.3g} % of the picture)"
