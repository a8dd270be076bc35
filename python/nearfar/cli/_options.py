"""Shared options of several commands, and the parsing of their values."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

import nearfar as nf
from nearfar._base import check
from nearfar._reduce import default_radii
from nearfar._trace.viewpoint import Viewpoint
from nearfar.cli._groups import Options

Point = tuple[float, float, float]

FACE_SIZE = 1024
"""Default number of texels per side of a cube face."""


def read_numbers(option: str, text: str, expected: str, count: int | None = None) -> list[float]:
    """Parse numbers that commas or spaces separate; ValueError unless there are `count`, or any for None."""
    try:
        numbers = [float(part) for part in text.replace(",", " ").split()]
    except ValueError:
        numbers = []
    if len(numbers) != (count or max(len(numbers), 1)):
        raise ValueError(f"{option}: expected {expected}, got {check.shortened(text)}")
    return numbers


def read_point(option: str, text: str | None) -> Point | None:
    """Parse "x,y,z" or "x y z" in metres; None stays None."""
    if text is None:
        return None
    x, y, z = read_numbers(option, text, "x,y,z in metres such as 0,1.7,0", 3)
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
Folder = Annotated[Path, option("-o --output", "FOLDER", "Folder to write.")]
FaceSize = Annotated[
    int | None, option("--face-size", "TEXELS", f"Texels across a face of the cube map. By default {FACE_SIZE}.")
]
Samples = Annotated[int, option("--samples", "N", "Colour samples of each pixel.")]
BACKENDS: tuple[Literal["auto", "cpu", "gpu"], ...] = ("auto", "cpu", "gpu")
"""Names of back ends."""

Backend = Annotated[
    str | None,
    option("--backend", "auto|cpu|gpu", "Renderer; `nearfar info --gpu` lists the graphics adapters. By default auto."),
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


@dataclass(frozen=True, kw_only=True)
class ZoneOptions(Options):
    """Centre and radii of the zones."""

    center: Annotated[
        str | None,
        option(
            "-c --center",
            "X,Y,Z",
            "Centre O in metres. By default 1.7 m above open ground near the scene's middle, or in front of an object.",
        ),
    ] = None
    r1: Annotated[
        float | None,
        option(
            "--r1",
            "METRES",
            "Radius of the near zone, where geometry stays where it is. By default it follows from r2 by the ground.",
        ),
    ] = None
    r2: Annotated[
        float | None,
        option(
            "--r2",
            "METRES",
            "Radius beyond which a map shows the scene (far zone); between the radii (intermediate zone) geometry is "
            "moved to meet the map. By default 50, in rooms two thirds of the way to the walls.",
        ),
    ] = None

    def __post_init__(self) -> None:
        for name, radius in (("--r1", self.r1), ("--r2", self.r2)):
            if radius is not None:
                check.at_least_zero(name, radius)
        check.radii(*default_radii.complete_radii(self.r1, self.r2))
        super().__post_init__()

    @cached_property
    def point(self) -> Point | None:
        """The centre; None for the default."""
        return read_point("--center", self.center)

    def choose_radii(self, scene: nf.Scene, place: Viewpoint) -> default_radii.Choice:
        """Return the radii, those that are not given chosen for the scene."""
        return default_radii.choose(scene, place, self.r1, self.r2)


@dataclass(frozen=True, kw_only=True)
class MapOptions(ZoneOptions):
    """Centre and radii of the zones, and the size of the map."""

    face_size: FaceSize = None

    @property
    def texels(self) -> int:
        """Number of texels per side of a face."""
        return FACE_SIZE if self.face_size is None else self.face_size


@dataclass(frozen=True, kw_only=True)
class PictureOptions(Options):
    """Size and samples of the pictures of a report."""

    size: Annotated[str, option("--size", "WxH", "Width and height of a picture in pixels.")] = "960x600"
    samples: Samples = 4

    @cached_property
    def pixels(self) -> tuple[int, int]:
        """Width and height."""
        return read_size("--size", self.size)


@dataclass(frozen=True, kw_only=True)
class RingOptions(Options):
    """Rings of a region, and their maps."""

    radii: Annotated[
        str | None,
        option("--radii", "R1,R2,...", "Radii of the rings in metres, ascending; chosen for the scene by default."),
    ] = None
    face_size: FaceSize = None
    samples: Samples = 4

    @cached_property
    def metres(self) -> list[float] | None:
        """The radii; None for the default."""
        return None if self.radii is None else read_numbers("--radii", self.radii, "metres such as 10,22,63")

    @property
    def texels(self) -> int:
        """Number of texels per side of a face."""
        return FACE_SIZE if self.face_size is None else self.face_size


def check_backend(text: str | None) -> Literal["auto", "cpu", "gpu"] | None:
    """Return a back end; reject unknown ones before the work starts."""
    return None if text is None else check.choice("--backend", text, BACKENDS)


def headset(text: str) -> nf.Hmd:
    """Return a headset by name, in any case, or from a .json file."""
    if Path(text).suffix.lower() == ".json":
        return nf.Hmd.load(text)
    try:
        return nf.hmd.get(text)
    except ValueError as error:
        raise ValueError(f"--hmd: {error}") from None
