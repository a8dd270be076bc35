"""`nearfar info`: lists a scene's contents and the graphics adapters."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Annotated, Any

import numpy as np
import typer

import nearfar as nf
from nearfar._base import files, formats
from nearfar._reduce import folder
from nearfar._scene import preview as overview
from nearfar._trace.viewpoint import GROUND_SHAPE, is_roofed
from nearfar.cli import _options as options, _own_files, _viewpoint
from nearfar.cli._groups import flag, option
from nearfar.cli._output import Clock, bytes_text, check_target, count, metres, show, triangles_text
from nearfar.cli._render import camera
from nearfar.cli._scenes import SceneOptions, is_reduced, open_reduced, open_scene

VERSION = 1

_LABELS = {"textures": "textures drawn", "notes": "drawn differently", "used": "parts of the file used"}
"""Labels of report fields that differ from their names."""

PREVIEW = (480, 300)
"""Width and height of the preview in pixels."""

_INPUT = typer.Option(
    "-i",
    "--input",
    metavar="SCENE",
    help=f"{options.SCENE}; a file of `nearfar lod`; a folder of `nearfar reduce`; or the folder or URL of a bundle or "
    "of a tree of orthoviews.",
)


def info(
    *,
    scene: Annotated[str | None, _INPUT] = None,
    gpu: bool = flag("--gpu", "List the graphics adapters, and why any is not used."),
    preview: Path | None = option(
        None,
        "FILE",
        "Also render a small picture of the scene, .png: wide, open scenes and single objects from above, others from "
        "a user's eye.",
    ),
    scene_options: SceneOptions,
    as_json: options.Json = False,
) -> None:
    """List what a scene, or a file or folder of nearfar, contains: triangles, parts, extent, settings, unused parts."""
    if scene is None:
        if not gpu:
            raise typer.BadParameter("expected a scene, or --gpu", param_hint="--input")
        document = formats.header("adapters", VERSION) | describe_adapters()
        show(document, _adapter_rows(document), title="graphics adapters", as_json=as_json)
        return
    if preview is not None:
        check_target(preview, ".png")
    clock = Clock()
    with clock.step("load"):
        reduced = open_reduced(scene) if is_reduced(scene) else None
        own = None if reduced is not None else _own_files.open_own(scene)
        if own is not None:
            scene_options.refuse("with a file of nearfar, which is in metres")
            loaded = _own_files.scene_of(own)
        else:
            loaded = open_scene(scene, scene_options.loading) if reduced is None else reduced.scene
    document = formats.header("info", VERSION) | {"source": scene, "kind": "scene", "seconds": clock.seconds["load"]}
    rows: list[tuple[str, str]] = []
    if loaded is not None:
        document |= describe(loaded)
    if own is not None:
        facts, rows = _own_files.describe(own, scene)
        document |= facts
    if reduced is not None:
        document |= {"kind": "reduced", "reduced": describe_reduced(reduced, Path(scene))}
        rows += _reduced_rows(document["reduced"])
    if preview is not None:
        with clock.step("preview"):
            view = _save_preview(loaded, scene, reduced or own, preview)
        document["preview"] = {"file": str(preview), "view": view, "seconds": clock.seconds["preview"]}
    if loaded is not None:
        rows += _scene_rows(document)
    rows.append(("loaded in", f"{document['seconds']:.2f} s"))
    if preview is not None:
        rows.append(("preview", f"{preview}, {view}, took {document['preview']['seconds']:.2f} s"))
    if gpu:
        document["gpu"] = describe_adapters()
        rows += _adapter_rows(document["gpu"])
    show(document, rows, title=scene, as_json=as_json)


def _scene_rows(document: dict[str, Any]) -> list[tuple[str, str]]:
    facts = {_LABELS.get(key, key.replace("_", " ")): value for key, value in document["report"].items() if value}
    return [
        *((label, _value_text(value)) for label, value in facts.items()),
        *((name, metres(corner)) for name, corner in zip(("from", "to"), document["bounds"] or (), strict=False)),
        ("origin", metres(document["origin"])),
    ]


def describe_adapters() -> dict[str, Any]:
    """Return the document of the adapters, with the ones that the back ends use; schema "adapters"."""
    adapters = nf.gpu.adapters()
    selected, reason = None, ""
    try:
        selected = nf.gpu.selected()
    except nf.DeviceError as error:
        reason = str(error)
    if selected is not None and selected.note:
        reason = "only the CPU was found; install the driver of a graphics card to use the card"
    return {
        "adapters": [dataclasses.asdict(adapter) | {"note": adapter.note} for adapter in adapters],
        "gpu": None if selected is None else selected.label,
        "auto": None if selected is None or selected.note else selected.label,
        "why": reason,
    }


def _adapter_rows(document: dict[str, Any]) -> list[tuple[str, str]]:
    adapters = [
        (entry["backend"], f"{entry['name']}, {entry['kind']}, {entry['driver']}" + _suffix(entry["note"]))
        for entry in document["adapters"]
    ]
    return [
        *adapters,
        ("--backend gpu", document["gpu"] or "nothing"),
        ("--backend auto", (document["auto"] or "the CPU") + _suffix(document["why"])),
    ]


def _suffix(note: str) -> str:
    return f"; {note}" if note else ""


def describe(scene: nf.Scene) -> dict[str, Any]:
    """Return the part of the document that describes a scene; schema "info"."""
    return {
        "origin": scene.origin.tolist(),
        "triangles": int(scene.triangle_count),
        "objects": len(scene.object_names),
        "bounds": scene.bounds.tolist() if scene.triangle_count else None,
        "report": dataclasses.asdict(scene.report),
    }


def describe_reduced(source: nf.ReducedScene | nf.Impostors, path: Path) -> dict[str, Any]:
    """Return the part of the document that describes a reduced scene or impostors."""
    impostors = source if isinstance(source, nf.Impostors) else None
    reduced = source.published if isinstance(source, nf.Impostors) else source
    stats, env = reduced.stats, reduced.env
    map_entry = env and {"face_size": env.face_size, "channels": list(env.channels), "bytes": env.nbytes}
    return {
        "center": list(reduced.center),
        "r1": reduced.r1,
        "r2": reduced.r2,
        "morph": reduced.morph,
        "triangles": int(stats["triangles"]),
        "triangles_left": int(stats["drawn"]) if impostors is None else impostors.triangle_count,
        "map": map_entry,
        "impostors": None if impostors is None else {"reach": impostors.reach, **impostors.stats},
        "files": {
            name: (path / name).stat().st_size
            for name in (folder.LIGHT, folder.NEAR, folder.QUADS, folder.FAR, folder.DOCUMENT)
            if (path / name).is_file()
        },
    }


def _reduced_rows(document: dict[str, Any]) -> list[tuple[str, str]]:
    map_entry = document["map"]
    map_text = "none, nothing is far"
    if map_entry is not None:
        channels = ", ".join(map_entry["channels"])
        map_text = f"6 × {map_entry['face_size']}², {channels}, {bytes_text(map_entry['bytes'])}"
    return [
        ("reduced scene", triangles_text(document) + " triangles; the lines below are about these"),
        ("centre", metres(document["center"])),
        ("radii", f"r1 = {document['r1']:g} m, r2 = {document['r2']:g} m; morph {document['morph']}"),
        ("map", map_text),
        *_impostor_rows(document["impostors"]),
        ("files", ", ".join(f"{name} {bytes_text(size)}" for name, size in document["files"].items())),
    ]


def _impostor_rows(impostors: dict[str, Any] | None) -> list[tuple[str, str]]:
    if impostors is None:
        return []
    triangles, quads, layers = (count(impostors[name]) for name in ("triangles", "quads", "layers"))
    error = f"off by at most {impostors['error_px']:.3g} pixels of 1/20 degree within {impostors['reach']:g} m"
    return [("impostors", f"{quads} textured quads of {triangles} triangles, baked from {layers} centres, {error}")]


def _save_preview(
    scene: nf.Scene | None,
    source: str,
    subject: nf.ReducedScene | nf.Impostors | _own_files.Own | None,
    path: Path,
) -> str:
    """Write a picture of `source`; return a description of its view."""
    if isinstance(subject, nf.orthoview.OrthoTree):
        files.write_png(path, subject.preview())
        return "the whole world from each direction"
    if isinstance(subject, nf.stream.Bundle):
        subject = subject.at(subject.count)
        scene = subject.scene
    if scene is None:
        raise ValueError(f"preview: expected a file with geometry, got {source}, a model without")
    reduced = subject if isinstance(subject, nf.ReducedScene | nf.Impostors) else None
    text = "overview from above"
    view = _overview(scene, source) if reduced is None else None
    if view is None:
        user_view = None if reduced is None else _viewpoint.view_of(source)
        viewpoint = _viewpoint.choose(scene, source, None if reduced is None else reduced.center)
        eye, target = (viewpoint.eye, viewpoint.target) if user_view is None else (user_view.user, user_view.target)
        view, text = camera(eye, target, 90.0, PREVIEW), f"from {metres(eye)}"
    nf.render(scene if reduced is None else reduced, view, samples=4, channels=("color",)).save(path)
    return text


def _overview(scene: nf.Scene, source: str) -> nf.Camera | None:
    """Return a camera that looks down at a single object, or at open ground; None for rooms, and for known views."""
    if source.partition(":")[0] in _viewpoint.KNOWN:
        return None
    viewpoint = _viewpoint.choose(scene, source)
    extent = np.subtract(*overview.dense_bounds(scene._core, scene.bounds)[::-1])
    is_wide = extent.max() >= GROUND_SHAPE[0] and extent[1] <= GROUND_SHAPE[1] * extent.max()
    if viewpoint.is_outside or (is_wide and not is_roofed(scene, viewpoint.eye)):
        return overview.dense_view(scene._core, scene.bounds, PREVIEW)
    return None


def _value_text(value: int | str | tuple[str, ...]) -> str:
    if isinstance(value, int):
        return count(value)
    return value if isinstance(value, str) else "\n".join(value)
