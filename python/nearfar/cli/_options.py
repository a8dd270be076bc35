"""Shared options of several commands, and the parsing of their values."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Literal

import typer

import nearfar as nf
from nearfar._base import check
from nearfar._reduce import default_radii
from nearfar._trace.viewpoint import Viewpoint
from nearfar.cli._groups import Options, option

Point = tuple[float, float, float]

HEADSET = "quest_2"
"""Default headset."""

FACE_SIZE = 1024
"""Default number of texels per side of a cube face."""


def read_numbers(name: str, text: str, expected: str, count: int | None = None) -> list[float]:
    """Parse numbers separated by commas or spaces; ValueError if there are not `count` of them, or none."""
    try:
        numbers = [float(part) for part in text.replace(",", " ").split()]
    except ValueError:
        numbers = []
    if len(numbers) != (count or max(len(numbers), 1)):
        raise ValueError(f"{name}: expected {expected}, got {check.shortened(text)}")
    return numbers


def read_point(name: str, text: str | None) -> Point | None:
    """Parse "x,y,z" or "x y z" in metres; None stays None."""
    if text is None:
        return None
    x, y, z = read_numbers(name, text, "x,y,z in metres such as 0,1.7,0", 3)
    if not all(map(math.isfinite, (x, y, z))):
        raise ValueError(f"{name}: expected three finite numbers, got {check.shortened(text)}")
    return x, y, z


def read_size(name: str, text: str) -> tuple[int, int]:
    try:
        width, height = (int(part) for part in text.split("x"))
    except ValueError:
        got = check.shortened(text)
        raise ValueError(f"{name}: expected WIDTHxHEIGHT in pixels such as 1280x720, got {got}") from None
    return check.size(name, (width, height))


def check_angle(fov: float) -> None:
    if not 0.0 < fov < 180.0:
        raise ValueError(f"--fov: expected degrees between 0 and 180, got {fov:g}")


FILES = (
    "GLB, glTF, OBJ, PLY, OFF, STL, 3MF, CityJSON, GeoJSON, GeoParquet, also as .gz, 3D Tiles (a tileset, its address, "
    "or a tile), COLLADA and STEP with the packages pycollada and cascadio"
)
PROCEDURAL = "city, room, factory, forest, beams, spheres, landscape, world or asteroids, as in city:blocks=4,seed=1"
SCENE = f"Scene file: {FILES}; or a procedural scene: {PROCEDURAL}"
Input = Annotated[str, typer.Option("-i", "--input", metavar="SCENE", help=f"{SCENE}.")]
SceneOrFolder = Annotated[
    str, typer.Option("-i", "--input", metavar="SCENE", help=f"{SCENE}; or a folder of `nearfar reduce`.")
]
Folder = Annotated[Path, typer.Option("-o", "--output", metavar="FOLDER", help="Folder to write.")]
FaceSize = Annotated[int, typer.Option(metavar="TEXELS", help="Texels across a face of the cube map.")]
Samples = Annotated[int, typer.Option(metavar="N", help="Colour samples of each pixel.")]
WithRange = Annotated[
    bool, typer.Option("--range", help="Bake range in metres too, from which far pixels get their position.")
]
Backend = Annotated[
    Literal["auto", "cpu", "gpu"] | None,
    typer.Option(help="Renderer; `nearfar info --gpu` lists the graphics adapters. By default auto."),
]
Json = Annotated[bool, typer.Option("--json", help="Print a JSON document instead of text.")]


@dataclass(frozen=True, kw_only=True)
class ZoneOptions(Options):
    """Centre and radii of the zones."""

    center: str | None = option(
        None,
        "X,Y,Z",
        "Centre O in metres. By default 1.7 m above open ground near the scene's middle, or in front of an object.",
        "-c --center",
    )
    r1: float | None = option(
        None,
        "METRES",
        "Radius of the near zone, where geometry stays in place. By default from r2 and the ground around the centre.",
    )
    r2: float | None = option(
        None,
        "METRES",
        "Radius beyond which a map shows the scene (far zone); between the radii (intermediate zone) geometry is "
        "moved to meet the map. By default 50, in rooms two thirds of the way to the walls.",
    )

    def __post_init__(self) -> None:
        for name in ("r1", "r2"):
            if getattr(self, name) is not None:
                check.at_least_zero(name, getattr(self, name))
        check.radii(*default_radii.complete_radii(self.r1, self.r2))
        super().__post_init__()

    @cached_property
    def point(self) -> Point | None:
        """The centre; None for the default."""
        return read_point("--center", self.center)

    def choose_radii(self, scene: nf.Scene, viewpoint: Viewpoint) -> default_radii.Choice:
        """Return the radii; missing ones are chosen for the scene."""
        return default_radii.choose(scene, viewpoint, self.r1, self.r2)


@dataclass(frozen=True, kw_only=True)
class MapOptions(ZoneOptions):
    """Centre and radii of the zones, and the size of the map."""

    face_size: FaceSize = FACE_SIZE

    def __post_init__(self) -> None:
        check.integer("face_size", self.face_size, 1, 16384)
        super().__post_init__()


@dataclass(frozen=True, kw_only=True)
class PictureOptions(Options):
    """Size and samples of the pictures of a report."""

    size: str = option("960x600", "WxH", "Width and height of a picture in pixels.")
    samples: Samples = 4

    def __post_init__(self) -> None:
        check.integer("samples", self.samples, 1, 1024)
        super().__post_init__()

    @cached_property
    def pixels(self) -> tuple[int, int]:
        return read_size("--size", self.size)


@dataclass(frozen=True, kw_only=True)
class EyeOptions(Options):
    """Eye or head, its view, and the pixels of its pictures."""

    eye: str | None = option(
        None, "X,Y,Z", "User's eye U, or head of a headset, in metres. By default over open ground or before an object."
    )
    target: str | None = option(
        None, "X,Y,Z", "Point to look at, metres. By default the longest open view or the boundary at r2."
    )
    size: str | None = option(
        None, "WxH", "Pixels of a picture, for a headset those of an eye. By default the headset's, else 1280x720."
    )

    @cached_property
    def user(self) -> Point | None:
        """The eye or head; None for the default."""
        return read_point("--eye", self.eye)

    @cached_property
    def aim(self) -> Point | None:
        """The point to look at; None for the default."""
        return read_point("--target", self.target)

    def pixels(self, device: nf.Hmd | None) -> tuple[int, int]:
        """Return width and height of a picture; for a headset by default those of an eye."""
        if self.size is None and device is not None:
            return device.render_size
        return read_size("--size", "1280x720" if self.size is None else self.size)


@dataclass(frozen=True, kw_only=True)
class RingOptions(Options):
    """Rings of a region, and their maps."""

    radii: str | None = option(None, "R1,R2,...", "Radii of rings in metres, ascending; by default chosen by cost.")
    face_size: FaceSize = FACE_SIZE
    samples: Samples = 4

    @cached_property
    def metres(self) -> list[float] | None:
        """The radii; None for the default."""
        return None if self.radii is None else read_numbers("--radii", self.radii, "metres such as 10,22,63")


def headset(text: str) -> nf.Hmd:
    """Return a headset by name, in any case, or from a .json file."""
    if Path(text).suffix.lower() == ".json":
        return nf.Hmd.load(text)
    try:
        return nf.hmd.get(text)
    except ValueError as error:
        raise ValueError(str(error).replace("name:", "--hmd:", 1)) from None
