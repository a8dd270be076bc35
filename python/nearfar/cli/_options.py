"""Shared options of several commands, and the parsing of their values."""

from __future__ import annotations

import difflib
import inspect
import math
from collections.abc import Mapping
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

import nearfar as nf
from nearfar._base import check, files
from nearfar._reduce import default_radii, folder

Point = tuple[float, float, float]

FACE_SIZE = 1024
"""Default number of texels per side of a cube face."""

PROCEDURAL = ("city", "room", "factory", "forest", "beams", "spheres", "landscape", "world", "asteroids")
"""Names of the procedural scenes."""

MIDDLE = ((-500.0, -math.inf, -500.0), (500.0, math.inf, 500.0))
"""Part of a world for commands that need a scene: a square kilometre around its town."""


def read_point(option: str, text: str | None) -> Point | None:
    """Parse "x,y,z" or "x y z" in metres; None stays None."""
    if text is None:
        return None
    try:
        x, y, z = (float(part) for part in text.replace(",", " ").split())
    except ValueError:
        raise ValueError(f"{option}: expected x,y,z in metres such as 0,1.7,0, got {check.shortened(text)}") from None
    if not all(map(math.isfinite, (x, y, z))):
        raise ValueError(f"{option}: expected three finite numbers, got {check.shortened(text)}")
    return x, y, z


def read_size(option: str, text: str) -> tuple[int, int]:
    """Parse "WIDTHxHEIGHT" in pixels, such as "1280x720"."""
    try:
        width, height = (int(part) for part in text.split("x"))
    except ValueError:
        got = check.shortened(text)
        raise ValueError(f"{option}: expected WIDTHxHEIGHT in pixels such as 1280x720, got {got}") from None
    return check.size(option, (width, height))


def read_radii(text: str | None) -> list[float] | None:
    """Parse "r1,r2,..." in metres; None stays None."""
    if text is None:
        return None
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        got = check.shortened(text)
        raise ValueError(f"--radii: expected metres such as 10,22,63, got {got}") from None


def check_angle(fov: float) -> None:
    """Reject invalid fields of view before the work starts."""
    if not 0.0 < fov < 180.0:
        raise ValueError(f"--fov: expected degrees between 0 and 180, got {fov:g}")


def option(names: str, metavar: str, text: str) -> Any:
    """Describe an option with a value: its names, separated by spaces, its metavar, and its help text."""
    return typer.Option(*names.split(), metavar=metavar, help=text)


INPUT = option(
    "-i --input",
    "SCENE",
    "Scene file (GLB, glTF, OBJ, PLY, STL, 3D Tiles …), or city, room, factory, forest, beams, spheres, landscape, "
    "world or asteroids, as in city:blocks=4,seed=1.",
)
Input = Annotated[str, INPUT]
Up = Annotated[str, option("--up", "AXIS", "Axis of the file that points up: x, y, z, -x, -y or -z.")]
Scale = Annotated[
    float | None,
    option("--scale", "METRES", "Metres in a unit of the file, 0.001 for millimetres."),
]
MaxBytes = Annotated[
    int | None,
    option(
        "--max-bytes",
        "BYTES",
        "Bytes that the file may unpack to; by default 100 times its size, at least 256 MiB, at most 16 GiB.",
    ),
]
Blend = Annotated[
    str,
    option("--blend", "opaque|cutout", "Draw materials that blend opaque, or cut them out where alpha is below 1/2."),
]
TileError = Annotated[
    float | None,
    option("--error", "METRES", "Greatest geometric error of a tileset's tiles. By default all detail is read."),
]
TileTriangles = Annotated[
    int | None,
    option("--triangles", "N", "Greatest number of triangles of a tileset; tiles with great errors are refined first."),
]
TileOrigin = Annotated[
    str | None,
    option(
        "--origin",
        "LON,LAT,HEIGHT",
        "Longitude and latitude in degrees and height in metres of (0, 0, 0) for a tileset on the Earth. By default "
        "its middle.",
    ),
]
CityLod = Annotated[
    str | None,
    option("--lod", "LEVEL", "Greatest level of detail of CityJSON, such as 2.2; by default each object's highest."),
]
CityHeight = Annotated[
    str | None,
    option("--height", "NAME", "Property of GeoJSON's or GeoParquet's footprints that states their height in metres."),
]
Invalid = Annotated[
    str, option("--on-invalid", "raise|drop", "Stop at vertices that are not finite, or drop their faces.")
]
Center = Annotated[
    str | None,
    option(
        "-c --center",
        "X,Y,Z",
        "Centre O in metres. By default 1.7 m above open ground near the scene's middle, or in front of an object.",
    ),
]
Target = Annotated[
    str | None,
    option("--target", "X,Y,Z", "Point to look at, metres. By default a view that the boundary at r2 crosses."),
]
Degrees = Annotated[float, option("--fov", "DEGREES", "Horizontal field of view.")]
Folder = Annotated[Path, option("-o --output", "FOLDER", "Folder to write.")]
Inner = Annotated[
    float | None,
    option(
        "--r1", "METRES", "Radius of the near zone, where geometry stays where it is. By default 30, less in rooms."
    ),
]
Outer = Annotated[
    float | None,
    option(
        "--r2",
        "METRES",
        "Radius beyond which a map shows the scene (far zone); between the radii (intermediate zone) geometry is moved "
        "to meet the map. By default 50, less in rooms.",
    ),
]
FaceSize = Annotated[
    int | None, option("--face-size", "TEXELS", f"Texels across a face of the cube map. By default {FACE_SIZE}.")
]
Size = Annotated[str, option("--size", "WxH", "Width and height of a picture in pixels.")]
Samples = Annotated[int, option("--samples", "N", "Colour samples of each pixel.")]
BACKENDS: tuple[Literal["auto", "cpu", "gpu"], ...] = ("auto", "cpu", "gpu")
"""Names of back ends."""

Backend = Annotated[
    str | None,
    option("--backend", "auto|cpu|gpu", "Renderer; `nearfar info --gpu` lists the graphics adapters. By default auto."),
]
RingRadii = Annotated[
    str | None,
    option("--radii", "R1,R2,...", "Radii of the rings in metres, ascending; chosen for the scene by default."),
]
WithRange = Annotated[
    bool, typer.Option("--range", help="Bake range in metres too, from which far pixels get their position.")
]
SCENE_OR_FOLDER = option(
    "-i --input",
    "SCENE",
    "Scene file (GLB, glTF, OBJ, PLY, STL …), city, room, factory, forest, beams, spheres, landscape, world or "
    "asteroids, as in city:blocks=4,seed=1, or a folder that `nearfar reduce` wrote.",
)
SceneOrFolder = Annotated[str, SCENE_OR_FOLDER]
Json = Annotated[bool, typer.Option("--json", help="Print a JSON document instead of text.")]


def check_backend(text: str | None) -> Literal["auto", "cpu", "gpu"] | None:
    """Return a back end; reject unknown ones before the work starts."""
    return None if text is None else check.choice("--backend", text, BACKENDS)


def faces(face_size: int | None) -> int:
    """Return the number of texels per side of a face."""
    return FACE_SIZE if face_size is None else face_size


def check_radii(r1: float | None, r2: float | None) -> None:
    """Reject invalid radii before the work starts; radii that are None are chosen by the scene."""
    for name, radius in (("--r1", r1), ("--r2", r2)):
        if radius is not None:
            check.at_least_zero(name, radius)
    check.radii(*default_radii.completed(r1, r2))


def is_reduced(text: str) -> bool:
    """Return whether `-i` is a folder written by `nearfar reduce` or `ReducedScene.save`."""
    files.restore(text)
    return (Path(text) / folder.DOCUMENT).is_file()


WHOLE: Mapping[str, Any] = {"error": None, "triangles": None, "origin": None, "lod": None, "height": None}
"""Arguments of `nearfar.Scene.load` that select a part of a tileset or a city, and its place: everything."""


def parts_of(
    error: float | None, triangles: int | None, origin: str | None, lod: str | None, height: str | None
) -> dict[str, Any]:
    """Return the arguments of `nearfar.Scene.load` for `--error`, `--triangles`, `--origin`, `--lod` and `--height`."""
    place = None
    if origin is not None:
        try:
            longitude, latitude, metres = (float(part) for part in origin.replace(",", " ").split())
        except ValueError:
            expected = "longitude,latitude,height such as 139.767,35.681,40"
            raise ValueError(f"--origin: expected {expected}, got {check.shortened(origin)}") from None
        place = (longitude, latitude, metres)
    return {"error": error, "triangles": triangles, "origin": place, "lod": lod, "height": height}


def open_scene(
    text: str,
    *,
    up: str,
    on_invalid: str,
    scale: float | None,
    max_bytes: int | None = None,
    blend: str = "opaque",
    parts: Mapping[str, Any] = WHOLE,
) -> nf.Scene:
    """Load the file or make the procedural scene given by `-i`; report an extent that suggests another unit.

    Names of procedural scenes take precedence over files and folders: `./room` refers to a file.
    """
    if scale is not None:
        check.positive("--scale", scale)
    if max_bytes is not None:
        check.integer("--max-bytes", max_bytes, 1, 1 << 62)
    if text.partition(":")[0] in PROCEDURAL:
        made = procedural(text, up=up, scale=scale, max_bytes=max_bytes, parts=parts)
        if isinstance(made, nf.datasets.Asteroids):
            return made.scene()
        return made.query(MIDDLE) if isinstance(made, nf.datasets.World) else made
    if Path(text).is_dir():
        kind = "a reduced scene" if is_reduced(text) else f"no {folder.DOCUMENT}"
        if all((Path(text) / name).is_file() for name in ("manifest.json", "tileset.json")):
            kind = "a bundle, which nearfar.stream.open reads"
        raise ValueError(f"{text}: expected a scene file, got a folder with {kind}")
    try:
        scene = nf.Scene.load(
            text, up=up, on_invalid=on_invalid, scale=scale, max_bytes=max_bytes, blend=blend, **parts
        )
    except ValueError as error:
        if str(error).partition(":")[0] not in parts:
            raise
        raise ValueError(f"--{error}") from None
    if scene.report.unit_note:
        typer.echo(f"nearfar: {text}: {scene.report.unit_note}", err=True)
    return scene


def headset(text: str) -> nf.Hmd:
    """Return a headset by name, in any case, or from a .json file."""
    if Path(text).suffix.lower() == ".json":
        return nf.Hmd.load(text)
    try:
        return nf.hmd.get(text)
    except ValueError as error:
        raise ValueError(f"--hmd: {error}") from None


def procedural(
    text: str, *, up: str, scale: float | None, max_bytes: int | None, parts: Mapping[str, Any] = WHOLE
) -> nf.Scene | nf.datasets.World | nf.datasets.Asteroids:
    """Make a procedural scene such as "city:blocks=4,seed=1"; reject options of files."""
    name, _, settings = text.partition(":")
    if up != "y":
        raise ValueError(f"--up: expected y with {name}, which stands upright already, got {check.shortened(up)}")
    if scale is not None:
        raise ValueError(f"--scale: expected none with {name}, which is in metres already, got {scale:g}")
    if max_bytes is not None:
        raise ValueError(f"--max-bytes: expected none with {name}, which is no file, got {max_bytes}")
    for key, value in parts.items():
        if value is not None:
            raise ValueError(f"--{key}: expected none with {name}, which is no file, got {check.shortened(value)}")
    maker = getattr(nf.datasets, name)
    defaults = {k: p.default for k, p in inspect.signature(maker).parameters.items() if type(p.default) is int}
    chosen: dict[str, int] = {}
    for item in filter(None, settings.split(",")):
        key, _, value = item.partition("=")
        if key not in defaults:
            near = difflib.get_close_matches(key, defaults, 1)
            hint = f" (did you mean {near[0]}?)" if near else ""
            raise ValueError(f"{name}: expected settings from {', '.join(defaults)}, got {check.shortened(key)}{hint}")
        try:
            chosen[key] = int(value)
        except ValueError:
            raise ValueError(f"{name}: expected a whole number for {key}, got {check.shortened(value)}") from None
    made: nf.Scene | nf.datasets.World | nf.datasets.Asteroids = maker(**chosen)
    return made
