"""`nearfar orthoview`: builds, describes, updates, verifies and exports trees of orthoviews."""

from __future__ import annotations

import re
from collections.abc import Mapping
from contextlib import AbstractContextManager, nullcontext
from dataclasses import asdict, dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any

import typer
from numpy.typing import ArrayLike

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar._base.cluster import LOCAL
from nearfar._base.progress import duration
from nearfar.cli import _options as options
from nearfar.cli._cut import Box, read_box
from nearfar.cli._groups import Options, choice, flag, option
from nearfar.cli._options import FILES, PROCEDURAL, read_numbers
from nearfar.cli._output import Clock, bytes_text, check_folder, check_target, count, metres, show
from nearfar.cli._scenes import FileOptions, open_world
from nearfar.orthoview._choose_cell import expected_seconds, usual_directions
from nearfar.orthoview._settings import Compression
from nearfar.orthoview._store import DOCUMENT

VERSION = 1

World = Annotated[
    str,
    typer.Option(
        "-i",
        "--input",
        metavar="WORLD",
        help=f"Folder of tiles that `nearfar cut` wrote; scene file: {FILES}; or a procedural scene, world and "
        f"asteroids in full: {PROCEDURAL}.",
    ),
]
Store = Annotated[str, typer.Argument(metavar="STORE", help="Folder or URL of a tree.")]


@dataclass(frozen=True, kw_only=True)
class ViewOptions(Options):
    """Views of a tree's cells."""

    size: int = option(512, "PIXELS", "Width and height of a view, a multiple of 4.")
    directions: str = option(
        "9", "5|9|13|26|auto", "Number of directions from which cells are drawn; auto chooses by measurement."
    )
    depth_bits: int = option(12, "BITS", "Bits of a depth, 8 to 16.")
    normal_bits: int = option(16, "16|24", "Bits of a normal.")
    color: Compression = choice("zstd", "How colours are compressed.")
    quality: int | None = option(None, "0-100", "Quality of WebP; by default files are lossless.")
    layers: int = option(1, "1|2", "Layers of surfaces to store: 2 also stores those hidden behind the first.")
    geometry: bool = option(True, None, "Also write the triangles of leaves, as 3D Tiles.", "--geometry/--no-geometry")

    @cached_property
    def settings(self) -> nf.orthoview.ViewSettings:
        fields: dict[str, Any] = asdict(self)
        del fields["geometry"]
        if re.fullmatch("-?[0-9]{1,9}", self.directions):
            fields["directions"] = int(self.directions)
        return nf.orthoview.ViewSettings(**fields)


def build(
    *,
    world: World,
    output: Path = option(..., "STORE", "Folder to write; the same call resumes an interrupted one.", "-o --output"),
    cell: float | None = option(
        None, "METRES", "Side of the leaves' cubic cells; by default chosen by the number of triangles and of leaves."
    ),
    box: Box = None,
    views: ViewOptions,
    cluster: str | None = option(
        None, "local|ADDRESS", "local for one process per core, or the address of a Dask scheduler, tcp://HOST:PORT."
    ),
    scene_options: FileOptions,
    as_json: options.Json = False,
) -> None:
    """Build the tree of a world that may be larger than memory."""
    aabb = None if box is None else read_box(box)
    check_folder(output)
    source = open_world(world, scene_options.loading)
    if not (output / DOCUMENT).is_file():
        cell = _announce(source, cell, aabb, views)
    clock = Clock()
    with _client(cluster) as client, clock.step("build"):
        tree = nf.orthoview.build(
            source, output, cell=cell, aabb=aabb, geometry=views.geometry, settings=views.settings, cluster=client
        )
    _show(tree, as_json, source=world, seconds=clock.seconds)


MIN_ANNOUNCED = 20.0
"""Least expected duration of a build that is announced, seconds."""


def _announce(source: nf.SceneSource, cell: float | None, aabb: ArrayLike | None, views: ViewOptions) -> float:
    """Say which side of the leaves was chosen and why, and how long the build may take; return the side."""
    if cell is None:
        size, directions = views.settings.size, usual_directions(views.settings)
        choice = nf.orthoview.choose_cell(source, aabb=aabb, size=size, directions=directions)
        typer.echo(f"nearfar: chose --cell {choice.cell:g}: {choice}", err=True)
        cell = choice.cell
    side = check.positive("cell", cell)
    leaves, seconds = expected_seconds(source, side, aabb=aabb, settings=views.settings, geometry=views.geometry)
    if seconds >= MIN_ANNOUNCED:
        expected = f"the build of about {count(leaves)} leaves may take {duration(seconds)} in one process"
        typer.echo(f"nearfar: {expected}; a greater --cell, a smaller --size and a smaller --box save time", err=True)
    return side


def info(
    store: Store,
    preview: Path | None = option(None, "FILE.png", "Write the views of the whole world."),
    as_json: options.Json = False,
) -> None:
    """Print what a tree holds."""
    if preview is not None:
        check_target(preview, ".png")
    tree = nf.orthoview.open(store)
    if preview is not None:
        files.write_png(preview, tree.preview())
    _show(tree, as_json, **({} if preview is None else {"preview": str(preview)}))


def update(
    *,
    store: Store,
    world: World,
    box: str = option(..., "X0,Z0,X1,Z1", "Box that has changed: least x and z and greatest x and z in metres."),
    scene_options: FileOptions,
    as_json: options.Json = False,
) -> None:
    """Draw a part of a tree again, from the world as it is now, into a new generation of its store."""
    aabb = read_box(box)
    tree = nf.orthoview.open(store)
    source = open_world(world, scene_options.loading)
    clock = Clock()
    with clock.step("update"):
        updated = tree.update(aabb, source)
    _show(updated, as_json, source=world, seconds=clock.seconds)


def verify(store: Store, as_json: options.Json = False) -> None:
    """Compare all files of a tree with the sizes and hashes that its store lists."""
    tree = nf.orthoview.open(store)
    clock = Clock()
    with clock.step("verify"):
        files = tree.verify()
    _show(tree, as_json, files=files, seconds=clock.seconds)


def export(
    store: Store,
    output: Path = option(..., "PLACE", "Folder to write; with --splats also a file .spz or .glb.", "-o --output"),
    splats: bool = flag("--splats", "Write Gaussians for splat viewers: .spz, .glb or a folder of 3D Tiles."),
    level: int = option(0, "N", "Level of the cells in a file, or of the finest tiles."),
    box: Box = None,
    light: str = option("sun", "sun|none|X,Y,Z", "The light in the splats' colours: X,Y,Z points to the sun."),
    compression: str | None = option(None, "spz", "Put SPZ into .glb files and tiles."),
    as_json: options.Json = False,
) -> None:
    """Write the newest generation of a tree as plain Zarr, for any reader, or for splat viewers."""
    if not splats and (level, box, light, compression) != (0, None, "sun", None):
        raise ValueError("--level, --box, --light and --compression need --splats")
    tree = nf.orthoview.open(store)
    clock = Clock()
    if not splats:
        with clock.step("export"):
            compacted = tree.compact(output)
        _show(compacted, as_json, source=store, seconds=clock.seconds)
        return
    aabb = None if box is None else read_box(box)
    with clock.step("export"):
        counts = tree.export_splats(output, level=level, aabb=aabb, light=_read_light(light), compression=compression)
    _show(tree, as_json, source=store, seconds=clock.seconds, splats=counts)


def _read_light(text: str) -> str | tuple[float, ...] | None:
    """Parse the light: a word or three numbers."""
    if text in ("sun", "none"):
        return None if text == "none" else text
    return tuple(read_numbers("light", text, "sun, none or X,Y,Z", 3))


def _client(cluster: str | None) -> AbstractContextManager[Any]:
    """Return the cluster given by `--cluster`."""
    if cluster is None or cluster == LOCAL:
        return nullcontext(cluster)
    if "://" not in cluster:
        got = check.shortened(cluster)
        raise ValueError(f"--cluster: expected local or an address such as tcp://host:8786, got {got}")
    try:
        from distributed import Client
    except ImportError:
        raise ImportError('clusters need the Python package distributed: pip install "nearfar[cluster]"') from None
    client: AbstractContextManager[Any] = Client(cluster)
    return client


def _show(tree: nf.orthoview.OrthoTree, as_json: bool, **facts: Any) -> None:
    """Print the content of a tree, and the result of the command."""
    show(describe(tree) | facts, content_rows(tree, facts), title=tree.path, as_json=as_json)


def describe(tree: nf.orthoview.OrthoTree) -> dict[str, Any]:
    """Return the document of a tree; schema "orthoview_info"."""
    return formats.header("orthoview_info", VERSION) | {
        "store": tree.path,
        "complete": tree.is_complete,
        "failed": {"_".join(map(str, leaf)): reason for leaf, reason in tree.failed.items()},
        "generation": tree.generation,
        "cell": tree.cell,
        "bounds": tree.bounds.tolist(),
        "levels": tree.levels,
        "leaves": list(tree.cells(0)),
        "directions": [list(direction) for direction in tree.directions],
        "size": tree.size,
        "unbuilt": tree.unbuilt,
        "held": tree.held,
        "done": tree.done,
        "geometry": tree.geometry,
    }


def content_rows(tree: nf.orthoview.OrthoTree, facts: Mapping[str, Any]) -> list[tuple[str, str]]:
    """Return the table rows of a tree, and of the facts of a command: `seconds`, `files` and `splats`."""
    held = tree.held
    view_bytes = bytes_text(held["bytes"] / max(held["chunks"] // 3, 1))
    cells = f"{count(held['cells'])} {'cell' if held['cells'] == 1 else 'cells'}"
    grid = " × ".join(map(str, tree.cells(0)))
    low, high = tree.bounds
    rows = [
        ("leaves", f"{grid} cells of {tree.cell:g} m, {count(held['leaves'])} not empty"),
        ("from, to", f"{metres(low)}; {metres(high)}"),
        ("levels", f"{tree.levels}, the leaves are the first; a cell of each further level has twice the side"),
        ("views", f"{len(tree.directions)} directions of each cell, {tree.size} × {tree.size} pixels"),
        ("stored views", f"of {cells}, {bytes_text(held['bytes'])}, {view_bytes} a view on average"),
        *_geometry_rows(tree.geometry),
        ("updates", f"{count(tree.generation)} since the build"),
        ("last update" if "reloaded" in tree.done else "build", _work_text(tree.done)),
        *((f"{name} took", f"{value:.2f} s") for name, value in facts.get("seconds", {}).items()),
    ]
    if "files" in facts:
        rows.append(("files", f"{count(facts['files'])}, all as they were written"))
    if "splats" in facts:
        rows += _splat_rows(facts["splats"])
    if not tree.is_complete:
        missing = [f"{count(tree.unbuilt)} leaves are not built yet"] * (tree.unbuilt > 0)
        missing += [f"{count(len(tree.failed))} leaves failed"] * bool(tree.failed)
        text = ", ".join(missing) or "the build has not ended"
        rows.append(("incomplete", f"{text}; the call that built it completes the tree"))
        rows += [("", f"{leaf}: {reason}") for leaf, reason in list(tree.failed.items())[:5]]
    return rows


def _work_text(done: Mapping[str, int]) -> str:
    """Describe the work of a build or of an update."""
    texts = {
        "drawn": "rendered the views of {}",
        "empty": "found {} empty",
        "composed": "made the views of {} from those of the level below",
        "reloaded": "read {} again",
    }
    units = {"drawn": ("leaf", "leaves"), "empty": ("leaf", "leaves"), "composed": ("cell", "cells")}
    parts = []
    for name, text in texts.items():
        if name in done:
            one, several = units.get(name, ("chunk", "chunks"))
            parts.append(text.format(f"{count(done[name])} {one if done[name] == 1 else several}"))
    return "; ".join(parts)


def _splat_rows(counts: dict[str, int]) -> list[tuple[str, str]]:
    (parts,) = (f"{count(counts[name])} {name}" for name in ("cells", "tiles") if name in counts)
    splat_bytes = bytes_text(counts["bytes"] / counts["splats"])
    return [
        ("splats", f"{count(counts['splats'])} for {count(counts['pixels'])} pixels, in {parts}"),
        ("written", f"{bytes_text(counts['bytes'])}, {splat_bytes} a splat"),
    ]


def _geometry_rows(facts: dict[str, Any] | None) -> list[tuple[str, str]]:
    if facts is None:
        return []
    static, moving = f"{count(facts['triangles'])} triangles in {count(facts['leaves'])} leaves", facts["moving"]
    rows = [("geometry", f"{static}, {bytes_text(facts['bytes'])}, off by {1e3 * facts['error']:.2g} mm at most")]
    if moving["triangles"]:
        rows.append(("moving", f"{count(moving['triangles'])} triangles of {count(moving['objects'])} objects"))
    return rows
