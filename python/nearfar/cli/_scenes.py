"""Options for loading scenes, and the scenes that `-i` names: files, and procedural ones."""

from __future__ import annotations

import difflib
import inspect
import math
from dataclasses import dataclass, fields
from functools import cached_property
from pathlib import Path
from typing import Literal

import typer

import nearfar as nf
from nearfar._base import check, files
from nearfar._reduce import folder
from nearfar.cli._groups import Options, choice, option
from nearfar.cli._options import read_numbers

PROCEDURAL = ("city", "room", "factory", "forest", "beams", "spheres", "landscape", "world", "asteroids")
"""Names of the procedural scenes."""

MIDDLE = ((-500.0, -math.inf, -500.0), (500.0, math.inf, 500.0))
"""Part of a world for commands that need a scene: a square kilometre around its town."""

PARTS = ("error", "triangles", "origin", "lod", "height")
"""Loading options that select a part of a tileset or a city, or place it."""

_REASONS = {"up": "which stands upright already", "scale": "which is in metres already"}
"""Reasons why procedural scenes refuse an option; other options are refused because they describe files."""


@dataclass(frozen=True, kw_only=True)
class FileOptions(Options):
    """Options for loading the file of a world."""

    up: str = option("y", "AXIS", "Axis of the file that points up: x, y, z, -x, -y or -z.")
    scale: float | None = option(None, "METRES", "Metres in a unit of the file, 0.001 for millimetres.")
    on_invalid: Literal["raise", "drop"] = choice("raise", "Stop at vertices that are not finite, or drop their faces.")
    max_bytes: int | None = option(
        None, "BYTES", "Bytes that the file may unpack to; by default 100 times its size, from 256 MiB to 16 GiB."
    )

    @cached_property
    def loading(self) -> nf.LoadOptions:
        values = {field.name: getattr(self, field.name) for field in fields(self)}
        if values.get("origin") is not None:
            expected = "longitude,latitude,height such as 139.767,35.681,40"
            values["origin"] = read_numbers("--origin", values["origin"], expected, 3)
        return nf.LoadOptions(**values)


@dataclass(frozen=True, kw_only=True)
class ServedOptions(FileOptions):
    """Options for loading the files of scenes that are served."""

    blend: Literal["opaque", "cutout"] = choice(
        "opaque", "Draw materials that blend opaque, or cut them out where alpha is below 1/2."
    )


@dataclass(frozen=True, kw_only=True)
class SceneOptions(ServedOptions):
    """Options for loading the file of a scene, or a part of a tileset or a city."""

    error: float | None = option(
        None, "METRES", "Greatest geometric error of a tileset's tiles. By default all detail is read."
    )
    triangles: int | None = option(
        None, "N", "Greatest number of triangles of a tileset; tiles with great errors are refined first."
    )
    origin: str | None = option(
        None,
        "LON,LAT,HEIGHT",
        "Longitude and latitude in degrees and height in metres of (0, 0, 0) for a tileset on the Earth. By "
        "default its middle.",
    )
    lod: str | None = option(
        None, "LEVEL", "Greatest level of detail of CityJSON, such as 2.2; by default each object's highest."
    )
    height: str | None = option(
        None, "NAME", "Property of GeoJSON's or GeoParquet's footprints that states their height in metres."
    )


def is_reduced(text: str) -> bool:
    """Return whether `-i` is a folder written by `nearfar reduce` or `ReducedScene.save`."""
    files.restore(text)
    return (Path(text) / folder.DOCUMENT).is_file()


def open_reduced(text: str) -> nf.ReducedScene | nf.Impostors:
    """Load the folder given by `-i`: impostors if it has them, else the reduced scene."""
    return nf.Impostors.load(text) if folder.has_impostors(text) else nf.ReducedScene.load(text)


def is_procedural(text: str) -> bool:
    """Return whether `-i` names a procedural scene."""
    return text.partition(":")[0] in PROCEDURAL


def open_scene(text: str, loading: nf.LoadOptions) -> nf.Scene:
    """Load the file or make the procedural scene given by `-i`; report an extent that suggests another unit.

    Names of procedural scenes take precedence over files and folders: `./room` refers to a file.
    """
    if is_procedural(text):
        procedural = make_procedural(text, loading)
        if isinstance(procedural, nf.datasets.Asteroids):
            return procedural.scene()
        return procedural.query(MIDDLE) if isinstance(procedural, nf.datasets.World) else procedural
    if Path(text).is_dir():
        kind = "a reduced scene" if is_reduced(text) else f"no {folder.DOCUMENT}"
        has_tileset, has_manifest = ((Path(text) / name).is_file() for name in ("tileset.json", "manifest.json"))
        if has_tileset and has_manifest:
            kind = "a bundle, which nearfar.stream.open reads"
        elif has_tileset:
            return open_scene(str(Path(text) / "tileset.json"), loading)
        raise ValueError(f"{text}: expected a scene file, got a folder with {kind}")
    if not Path(text).exists() and (similar := difflib.get_close_matches(text.partition(":")[0], PROCEDURAL, 1)):
        raise ValueError(f"{text}: there is no such file (did you mean {similar[0]}?)")
    scene = nf.Scene.load(text, loading)
    if scene.report.unit_note:
        typer.echo(f"nearfar: {text}: {scene.report.unit_note}", err=True)
    return scene


def open_world(text: str, loading: nf.LoadOptions) -> nf.SceneSource:
    """Open the world given by `-i`, which may be larger than memory."""
    if is_procedural(text):
        return make_procedural(text, loading)
    return nf.open_source(text, loading)


def make_procedural(text: str, loading: nf.LoadOptions) -> nf.Scene | nf.datasets.World | nf.datasets.Asteroids:
    """Make a procedural scene such as "city:blocks=4,seed=1"; reject options of files."""
    name, _, settings = text.partition(":")
    for field in fields(loading):
        value = getattr(loading, field.name)
        if field.name not in ("on_invalid", "blend") and value != field.default:
            expected = "none" if field.default is None else field.default
            reason, got = _REASONS.get(field.name, "which is no file"), check.shortened(value)
            flag = f"--{field.name.replace('_', '-')}"
            raise ValueError(f"{flag}: expected {expected} with {name}, {reason}, got {got}")
    maker = getattr(nf.datasets, name)
    defaults = {k: p.default for k, p in inspect.signature(maker).parameters.items() if type(p.default) is int}
    arguments: dict[str, int] = {}
    for item in filter(None, settings.split(",")):
        key, _, value = item.partition("=")
        if key not in defaults:
            similar = difflib.get_close_matches(key, defaults, 1)
            hint = f" (did you mean {similar[0]}?)" if similar else ""
            raise ValueError(f"{name}: expected settings from {', '.join(defaults)}, got {check.shortened(key)}{hint}")
        try:
            arguments[key] = int(value)
        except ValueError:
            raise ValueError(f"{name}: expected a whole number for {key}, got {check.shortened(value)}") from None
    procedural: nf.Scene | nf.datasets.World | nf.datasets.Asteroids = maker(**arguments)
    return procedural
