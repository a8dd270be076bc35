"""`nearfar cut`: extracts a part of a world, as one GLB or as a folder of tiles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated

import typer

import nearfar as nf
from nearfar._base import check
from nearfar._source.protocol import unread_in
from nearfar.cli import _options as options
from nearfar.cli._groups import option
from nearfar.cli._output import check_folder, check_target, count
from nearfar.cli._scenes import FileOptions, open_scene, open_world

INDEX = "tiles.json"
"""Name of the index file of a folder of tiles."""

Box = Annotated[
    str | None,
    typer.Option(metavar="X0,Z0,X1,Z1", help="Least x and z and greatest x and z in metres; by default everything."),
]


def cut(
    *,
    world: str = option(
        ...,
        "WORLD",
        f"Folder of tiles that `nearfar cut` wrote; scene file: {options.FILES}; or a procedural scene: "
        f"{options.PROCEDURAL}.",
        "-i --input",
    ),
    output: Path = option(..., "FILE|FOLDER", "GLB to write; with --cell a folder of tiles.", "-o --output"),
    box: Box = None,
    cell: float | None = option(None, "METRES", "Write tiles of this width; the same call resumes an interrupted one."),
    detail: float = option(0.0, "METRES", "Greatest geometric error; 0 for full detail."),
    scene_options: FileOptions,
) -> None:
    """Cut a part out of a world that may be larger than memory: triangles that touch a box, whole."""
    aabb = read_box(box)
    check.at_least_zero("detail", detail)
    if cell is not None:
        check.positive("cell", cell)
        check_folder(output)
    else:
        check_target(output, ".glb")
    source = open_source(world, scene_options.loading)
    if isinstance(source, nf.Scene):
        _report(unread_in(None, source))
    if cell is not None:
        failed = nf.write_tiles(source, output, cell=cell, aabb=aabb, detail=detail)
        typer.echo(f"{output}: {nf.open_source(output)!r}")
        if failed:
            tiles = "1 tile is" if len(failed) == 1 else f"{count(len(failed))} tiles are"
            typer.echo(f"nearfar: {tiles} incomplete; the same call writes them again", err=True)
            _report([f"{x}_{z}: {reason}" for (x, z), reason in failed.items()])
        return
    part = source.query(aabb, detail)
    _report(unread_in(source, part))
    if not part.triangle_count:
        (x0, _, z0), (x1, _, z1) = source.bounds.tolist()
        spans = f"{world} spans {x0:g},{z0:g},{x1:g},{z1:g}"
        raise ValueError(f"--box: expected one with triangles, got {box or 'none'}; {spans}")
    nf.lod.export(part, output, view=nf.Fov.symmetric(90.0))
    typer.echo(f"{output}: {count(part.triangle_count)} triangles")


_MAX_REPORTED = 5
"""Greatest number of reasons that are reported."""


def _report(reasons: Sequence[str]) -> None:
    """Report why parts of the world are missing."""
    for reason in reasons[:_MAX_REPORTED]:
        typer.echo(f"nearfar: {reason}", err=True)
    if len(reasons) > _MAX_REPORTED:
        typer.echo(f"nearfar: and {count(len(reasons) - _MAX_REPORTED)} more", err=True)


def read_box(text: str | None) -> tuple[options.Point, options.Point]:
    """Parse "x0,z0,x1,z1" in metres as a box of unlimited height; None means everything."""
    if text is None:
        return (-math.inf, -math.inf, -math.inf), (math.inf, math.inf, math.inf)
    x0, z0, x1, z1 = options.read_numbers("--box", text, "x0,z0,x1,z1 in metres such as 0,0,200,200", 4)
    if not (x0 <= x1 and z0 <= z1):
        raise ValueError(f"--box: expected least x and z before greatest x and z, got {check.shortened(text)}")
    return (x0, -math.inf, z0), (x1, math.inf, z1)


def open_source(text: str, loading: nf.LoadOptions) -> nf.SceneSource:
    """Open the source given by `-i`: a folder of tiles, or a scene."""
    if (Path(text) / INDEX).is_file() or Path(text).name == INDEX:
        return open_world(text, loading)
    return open_scene(text, loading)
