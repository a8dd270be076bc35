"""`nearfar orthoview`: builds, describes, updates, verifies and exports trees of orthoviews."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

import nearfar as nf
from nearfar._base import check, files, formats
from nearfar._base.cluster import LOCAL
from nearfar.cli import _options as options
from nearfar.cli._cut import read_box
from nearfar.cli._groups import Options
from nearfar.cli._options import option
from nearfar.cli._output import Clock, bytes_text, check_target, count, metres, show
from nearfar.cli._scenes import FileOptions, open_world

VERSION = 1

World = Annotated[
    str,
    option(
        "-i --input",
        "WORLD",
        "Folder of tiles, tileset, footprints, scene file or procedural scene; world and asteroids are taken whole.",
    ),
]
Store = Annotated[str, typer.Argument(metavar="STORE", help="Folder or URL of a tree.")]
BOX = option("--box", "X0,Z0,X1,Z1", "Least x and z and greatest x and z in metres; by default everything.")


@dataclass(frozen=True, kw_only=True)
class ViewOptions(Options):
    """Views of a tree's cells."""

    size: Annotated[int, option("--size", "PIXELS", "Width and height of a view, a multiple of 4.")] = 512
    directions: Annotated[
        str,
        option(
            "--directions",
            "5|9|13|26|auto",
            "Number of directions from which cells are drawn; auto chooses by measurement.",
        ),
    ] = "9"
    depth_bits: Annotated[int, option("--depth-bits", "BITS", "Bits of a depth, 8 to 16.")] = 12
    normal_bits: Annotated[int, option("--normal-bits", "16|24", "Bits of a normal.")] = 16
    color: Annotated[str, option("--color", "zstd|webp", "How colours are compressed.")] = "zstd"
    quality: Annotated[int | None, option("--quality", "0-100", "Quality of WebP; by default files are lossless.")] = (
        None
    )
    layers: Annotated[
        int, option("--layers", "1|2", "Layers of surfaces to store: 2 also stores those hidden behind the first.")
    ] = 1
    geometry: Annotated[
        bool, typer.Option("--geometry/--no-geometry", help="Also write the triangles of leaves, as 3D Tiles.")
    ] = True

    @cached_property
    def count(self) -> int | Literal["auto"]:
        """The number of directions, or `auto`."""
        return read_directions(self.directions)


def build(
    *,
    world: World,
    output: Annotated[
        Path, option("-o --output", "STORE", "Folder to write; the same call resumes an interrupted one.")
    ],
    cell: Annotated[float, option("--cell", "METRES", "Side of the leaves' cubic cells.")],
    box: Annotated[str | None, BOX] = None,
    views: ViewOptions,
    cluster: Annotated[
        str | None,
        option(
            "--cluster",
            "local|ADDRESS",
            "local for one process per core, or the address of a Dask scheduler, tcp://HOST:PORT.",
        ),
    ] = None,
    file: FileOptions,
    as_json: options.Json = False,
) -> None:
    """Build the tree of a world that may be larger than memory."""
    aabb = None if box is None else read_box(box)
    source = open_world(world, file.loading)
    clock = Clock()
    with _client(cluster) as client, clock.step("build"):
        tree = nf.orthoview.build(
            source,
            output,
            cell=cell,
            aabb=aabb,
            size=views.size,
            directions=views.count,
            depth_bits=views.depth_bits,
            normal_bits=views.normal_bits,
            color=views.color,  # type: ignore[arg-type]  # checked by `build`
            quality=views.quality,
            geometry=views.geometry,
            layers=views.layers,
            cluster=client,
        )
    _show(tree, as_json, source=world, seconds=clock.seconds)


def info(
    store: Store,
    preview: Annotated[Path | None, option("--preview", "FILE.png", "Write the views of the whole world.")] = None,
    as_json: options.Json = False,
) -> None:
    """Print what a tree holds."""
    if preview is not None:
        check_target(preview, ".png")
    tree = nf.orthoview.open(store)
    if preview is not None:
        from PIL import Image

        with files.atomic_file(preview) as temporary:
            Image.fromarray(tree.preview()).save(temporary, format="PNG")
    _show(tree, as_json, **({} if preview is None else {"preview": str(preview)}))


def update(
    *,
    store: Store,
    world: World,
    box: Annotated[
        str, option("--box", "X0,Z0,X1,Z1", "Box that has changed: least x and z and greatest x and z in metres.")
    ],
    file: FileOptions,
    as_json: options.Json = False,
) -> None:
    """Draw a part of a tree again, from the world as it is now, into a new generation of its store."""
    aabb = read_box(box)
    tree = nf.orthoview.open(store)
    source = open_world(world, file.loading)
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
    output: Annotated[Path, option("-o --output", "PLACE", "Folder to write; with --splats also a file .spz or .glb.")],
    splats: Annotated[
        bool, typer.Option("--splats", help="Write Gaussians for splat viewers: .spz, .glb or a folder of 3D Tiles.")
    ] = False,
    level: Annotated[int, option("--level", "N", "Level of the cells in a file, or of the finest tiles.")] = 0,
    box: Annotated[str | None, BOX] = None,
    light: Annotated[
        str, option("--light", "sun|none|X,Y,Z", "The light in the splats' colours: X,Y,Z points to the sun.")
    ] = "sun",
    compression: Annotated[str | None, option("--compression", "spz", "Put SPZ into .glb files and tiles.")] = None,
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
        counts = tree.export_splats(output, level=level, aabb=aabb, light=read_light(light), compression=compression)
    _show(tree, as_json, source=store, seconds=clock.seconds, splats=counts)


def read_light(text: str) -> str | tuple[float, ...] | None:
    """Parse the light: a word or three numbers."""
    if text in ("sun", "none"):
        return None if text == "none" else text
    try:
        x, y, z = map(float, text.split(","))
    except ValueError:
        raise ValueError(f"--light: expected sun, none or X,Y,Z, got {check.shortened(text)}") from None
    return x, y, z


def read_directions(text: str) -> int | Literal["auto"]:
    """Parse a number of directions, or `auto`."""
    if text == "auto":
        return "auto"
    try:
        return int(text)
    except ValueError:
        got = check.shortened(text)
        raise ValueError(f"--directions: expected 5, 9, 13, 26 or auto, got {got}") from None


@contextmanager
def _client(cluster: str | None) -> Iterator[Any]:
    """Yield the cluster given by `--cluster`."""
    if cluster is None or cluster == LOCAL:
        yield cluster
        return
    if "://" not in cluster:
        raise ValueError(
            f"--cluster: expected local or an address such as tcp://host:8786, got {check.shortened(cluster)}"
        )
    try:
        from distributed import Client
    except ImportError:
        raise ImportError('clusters need the Python package distributed: pip install "nearfar[cluster]"') from None
    with Client(cluster) as client:
        yield client


def _show(tree: nf.orthoview.OrthoTree, as_json: bool, **facts: Any) -> None:
    """Print the content of a tree, and the result of the command."""
    held = tree.held
    document = formats.header("orthoview_info", VERSION) | {
        "store": tree.path,
        "complete": tree.is_complete,
        "failed": {"_".join(map(str, place)): reason for place, reason in tree.failed.items()},
        "generation": tree.generation,
        "cell": tree.cell,
        "bounds": tree.bounds.tolist(),
        "levels": tree.levels,
        "leaves": list(tree.cells(0)),
        "directions": [list(direction) for direction in tree.directions],
        "size": tree.size,
        "held": held,
        "done": tree.done,
        "geometry": tree.geometry,
    }
    each = bytes_text(held["bytes"] / max(held["chunks"] // 3, 1))
    low, high = tree.bounds
    rows = [
        ("leaves", f"{' × '.join(map(str, tree.cells(0)))} of {tree.cell:g} m, {count(held['leaves'])} not empty"),
        ("from, to", f"{metres(low)}; {metres(high)}"),
        ("levels", str(tree.levels)),
        ("views", f"{len(tree.directions)} directions, {tree.size} × {tree.size} pixels"),
        ("held", f"{count(held['cells'])} cells, {bytes_text(held['bytes'])}, {each} a view"),
        *_geometry_rows(tree.geometry),
        ("updates", str(tree.generation)),
        *(("done", f"{name} {count(number)}") for name, number in sorted(tree.done.items())),
        *((name, f"{value:.2f} s") for name, value in facts.get("seconds", {}).items()),
    ]
    if "files" in facts:
        rows.append(("files", f"{count(facts['files'])}, all as they were written"))
    if "splats" in facts:
        rows += _splat_rows(facts["splats"])
    if not tree.is_complete:
        rows.append(("incomplete", f"{count(len(tree.failed))} leaves failed; the same call completes the tree"))
        rows += [("", f"{place}: {reason}") for place, reason in list(tree.failed.items())[:5]]
    show(document | facts, rows, title=tree.path, as_json=as_json)


def _splat_rows(counts: dict[str, int]) -> list[tuple[str, str]]:
    """Return table rows for files written for splat viewers."""
    (parts,) = (f"{count(counts[name])} {name}" for name in ("cells", "tiles") if name in counts)
    each = bytes_text(counts["bytes"] / counts["splats"])
    return [
        ("splats", f"{count(counts['splats'])} for {count(counts['pixels'])} pixels, in {parts}"),
        ("written", f"{bytes_text(counts['bytes'])}, {each} a splat"),
    ]


def _geometry_rows(facts: dict[str, Any] | None) -> list[tuple[str, str]]:
    """Return table rows for the triangles of leaves."""
    if facts is None:
        return []
    stands, moving = f"{count(facts['triangles'])} triangles in {count(facts['leaves'])} leaves", facts["moving"]
    rows = [("geometry", f"{stands}, {bytes_text(facts['bytes'])}, off by {1e3 * facts['error']:.2g} mm at most")]
    if moving["triangles"]:
        rows.append(("moving", f"{count(moving['triangles'])} triangles of {count(moving['objects'])} objects"))
    return rows
