"""Exports models and scenes with levels as GLB with `MSFT_lod`; the curves give the sizes at which engines switch."""

from __future__ import annotations

import os
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, SupportsFloat

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check, files, formats
from nearfar._camera.camera import Camera, Fov
from nearfar._scene.levels import notes_of
from nearfar._scene.names import Names
from nearfar._scene.scene import Scene, core_of
from nearfar._scene.serialize import empty_core
from nearfar.hmd._hmd import Hmd
from nearfar.lod import _file
from nearfar.lod._levels import Level, Levels
from nearfar.lod._measured_levels import MeasuredLevels
from nearfar.lod._select.size import reference_solid_angle
from nearfar.lod._select.switches import Switches, read_floor, switches
from nearfar.lod._select.threshold import Kind, LodThreshold, threshold_of

if TYPE_CHECKING:
    from nearfar._scene import glb

EXTENSION, COVERAGE, EXTRAS_KEY = "MSFT_lod", "MSFT_screencoverage", "nearfar"
MEASURED = ("ratio", "error", "mean_error", "note")
"""Fields of `Level` that a GLB holds besides geometry: three numbers and a text."""
_IDENTITY = np.eye(4)
_MARK, _START = f'"nearfar.{_file.NAME}"'.encode(), 4096
"""Text that identifies a document, and the number of first bytes of a JSON file among which it occurs."""


def write(
    model: MeasuredLevels,
    path: Path,
    *,
    view: Hmd | Camera | Fov,
    threshold: LodThreshold,
    floor: Iterable[float],
    all_levels: bool,
) -> None:
    """Write a model as `.json` or `.glb`; `LodModel.export` documents the files."""
    sizes = switches(model, view=view, threshold=threshold, floor=floor)
    if not all_levels:
        numbers = np.flatnonzero(sizes.is_ever_shown)
        model, sizes = model.of_levels(numbers), sizes.of_levels(numbers)
    document = _file.encode_document(model) | {"switches": engine_levels(model, sizes)}
    if path.suffix.lower() == ".json":
        formats.write_json(path, document)
    else:
        _save(path, _glb_of(model, sizes, document))


def _glb_of(model: MeasuredLevels, sizes: Switches, document: dict[str, Any]) -> bytes:
    # Imported here: only files need an imaging library.
    from nearfar._scene import glb

    if model.levels is None:
        raise ValueError(f"model: expected one with the geometry of its levels, got {model.name!r} without")
    # Surfaces of all levels in one scene, and a mesh for each level.
    core, meshes = _core.with_surfaces(empty_core(), [level.scene._core for level in model.levels])
    count = len(meshes)
    placements = np.tile(_IDENTITY[None, :3], (count, 1, 1))
    combined = _core.with_instances(core, meshes, placements, np.zeros(count, np.int32), count)
    encoder = glb.Encoder(combined, [model.name], notes_of([model])["undrawn"])
    nodes, extensions = _chain(encoder, range(count), sizes)
    geometry = [{name: getattr(level, name) for name in MEASURED} for level in model.levels]
    extras = encoder.nodes[nodes[0]].setdefault("extras", {})
    extras[EXTRAS_KEY] = document | {"geometry": geometry, "frame": model.levels.frame.tolist()}
    return encoder.finish(nodes[:1], **extensions)


def read(target: Path) -> dict[str, Any]:
    """Read the fields of a model from a GLB that `write` made; FormatError for anything else, OSError if missing."""
    from nearfar._scene import glb

    data = target.read_bytes()
    with formats.guarded(target, "model of levels"):
        decoder = glb.Decoder(data, Names(1))
        nodes = decoder.document["nodes"]
        finest = nodes[decoder.document["scenes"][0]["nodes"][0]]
        document = finest["extras"][EXTRAS_KEY]
        fields, geometry = _file.fields(document, target), document["geometry"]
        chain = [finest, *(nodes[number] for number in finest.get("extensions", {}).get(EXTENSION, {"ids": []})["ids"])]
        if not len(chain) == len(geometry) == len(fields["triangles"]):
            raise ValueError(f"expected {len(fields['triangles'])} levels, got {len(chain)} nodes")
        name, surfaces = fields["name"], empty_core(surfaces=decoder.surfaces)
        levels = [
            Level(
                scene=Scene(surfaces.of_mesh(decoder.mesh(node)), Names((name,)), undrawn=decoder.undrawn),
                note=str(level["note"]),
                **{field: check.number(field, level[field]) for field in MEASURED[:3]},
            )
            for node, level in zip(chain, geometry, strict=True)
        ]
        return fields | {"levels": Levels(levels, name=name, frame=document["frame"])}


def find_document(path: Path) -> dict[str, Any] | None:
    """Return the document of a file that `write` or `LodModel.save` made, whatever its name; None for other files."""
    from nearfar._base import glb

    with path.open("rb") as file:
        start = file.read(_START)
        if not start.startswith(b"glTF") and _MARK not in start:
            return None
        data = start + file.read()
    if _MARK not in data:
        return None
    try:
        if data.startswith(b"glTF"):
            content, _ = glb.header(data)
            document = content["nodes"][content["scenes"][0]["nodes"][0]]["extras"][EXTRAS_KEY]
        else:
            document = formats.from_json(data)
        return dict(document) if document["format"] == f"nearfar.{_file.NAME}" else None
    except formats.DAMAGE:
        return None


def export(
    scene: Scene,
    path: str | os.PathLike[str],
    *,
    view: Hmd | Camera | Fov,
    k: SupportsFloat | None = None,
    d: SupportsFloat | None = None,
    threshold: LodThreshold | Kind | None = None,
    quality: SupportsFloat | None = None,
    floor: Iterable[SupportsFloat] = (),
    all_levels: bool = False,
) -> None:
    """Write a scene whose objects have levels as a GLB for engines that switch levels themselves.

    Each object is a node with its level 0, `MSFT_lod` and `MSFT_screencoverage`. Its other levels are nodes outside the
    scene at the same place; objects of one model share their meshes. Programs without the extension show level 0. All
    other objects are unchanged. Materials keep the properties that nearfar does not draw: maps of normals, metal,
    roughness and occlusion, blending, and single-sided faces.

    ValueError and TypeError for arguments out of range; OSError if the file cannot be written.

    Parameters
    ----------
    scene
        Scene with or without levels; moving objects are written in their present poses.
    path
        Name ending in `.glb`; written atomically.
    view, k, d, threshold, quality, floor
        As in `switches`, for the coverages.
    all_levels
        Also write levels that are never shown because a coarser one is good enough up to the same or a greater size.
    """
    from nearfar._scene import glb

    limit, heights = threshold_of(threshold, k, d, quality), read_floor(floor)
    all_levels = check.flag("all_levels", all_levels)
    reference_solid_angle(view)  # rejects anything but a view, also for scenes without levels
    core, table, target = core_of(scene), scene._table, check.path("path", path, ".glb")
    if table is None:
        _save(target, glb.encode(core, scene.object_names, scene._undrawn))
        return
    sizes = [switches(model, view=view, threshold=limit, floor=heights) for model in table.models]
    has_levels = table.row_of >= 0
    placements, numbers = _core.placements_of(core, has_levels)
    unleveled_scene = core.without_objects(has_levels)
    written = [np.flatnonzero(size.is_ever_shown | all_levels) for size in sizes]
    sizes = [size.of_levels(levels) for size, levels in zip(sizes, written, strict=True)]
    # Objects without levels come first, then the levels of each object, each level as a static instance.
    rows_and_models = zip(table.row_of[numbers].tolist(), table.model_of[numbers].tolist(), strict=True)
    rows = [[table.meshes[row][level] for level in written[model]] for row, model in rows_and_models]
    counts = np.array([len(row) for row in rows], np.int64)
    meshes = [mesh for row in rows for mesh in row]
    objects = np.repeat(numbers, counts).astype(np.int32)
    combined = _core.with_instances(
        unleveled_scene, meshes, np.repeat(placements, counts, axis=0), objects, len(meshes)
    )
    encoder = glb.Encoder(combined, scene.object_names, scene._undrawn)
    _save(
        target, _encode_scene(encoder, combined, unleveled_scene, counts, [sizes[m] for m in table.model_of[numbers]])
    )


def _encode_scene(
    encoder: glb.Encoder, combined: _core.Scene, others: _core.Scene, counts: NDArray[np.int64], sizes: list[Switches]
) -> bytes:
    static_count = others.instance_count - len(others.moving_objects())
    leveled_count = int(counts.sum())
    has_faces = np.diff(combined.triangle_offsets()) > 0
    unleveled = [*range(static_count), *range(static_count + leveled_count, combined.instance_count)]
    roots = [encoder.place(number) for number in unleveled if has_faces[number]]
    tops = list(roots)
    extensions: dict[str, Any] = {}
    start = static_count
    for count, switch in zip(counts.tolist(), sizes, strict=True):
        nodes, used = _chain(encoder, range(start, start + count), switch)
        extensions |= used
        roots.append(nodes[0])
        tops += nodes
        start += count
    for node in tops:
        _move(encoder.nodes[node], combined.origin)
    return encoder.finish(roots, **extensions)


def engine_levels(model: MeasuredLevels, sizes: Switches) -> list[dict[str, Any]]:
    """JSON entry of each level for engines: the size up to which it is shown; no distance for one that never is."""
    return [
        {
            "triangles": int(model.triangles[level]),
            "solid_angle": float(sizes.solid_angle[level]),
            "screen_coverage": float(sizes.screen_coverage[level]),
            "screen_height": float(sizes.screen_height[level]),
            "distance_per_radius": float(distance) if np.isfinite(distance) else None,
        }
        for level, distance in enumerate(sizes.distance)
    ]


def _chain(encoder: glb.Encoder, instances: range, sizes: Switches) -> tuple[list[int], dict[str, Any]]:
    """Add the levels of an object as nodes, to which the first one refers.

    Returns the nodes' numbers, and the document's list of used extensions if there is more than one level.
    """
    nodes = [encoder.place(number) for number in instances]
    if len(nodes) == 1:
        return nodes, {}
    for level, node in enumerate(nodes[1:], 1):
        encoder.nodes[node]["name"] += f"_lod{level}"
    encoder.nodes[nodes[0]]["extensions"] = {EXTENSION: {"ids": nodes[1:]}}
    encoder.nodes[nodes[0]].setdefault("extras", {})[COVERAGE] = sizes.coverages()
    return nodes, {"extensionsUsed": [EXTENSION]}


def _move(node: dict[str, Any], origin: tuple[float, float, float]) -> None:
    """Move a node from coordinates relative to the origin to world coordinates."""
    if any(origin):
        matrix = node.setdefault("matrix", _IDENTITY.ravel().tolist())
        matrix[12:15] = [value + shift for value, shift in zip(matrix[12:15], origin, strict=True)]


def _save(path: Path, data: bytes) -> None:
    with files.atomic_file(path) as temporary:
        files.write(temporary, data)
