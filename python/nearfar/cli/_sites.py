"""Sites of `nearfar serve`: bundles, reduced scenes, and scenes."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import partial
from pathlib import Path

import typer

import nearfar as nf
from nearfar._base import cache
from nearfar._base.remote import is_url
from nearfar._trace.viewpoint import Viewpoint
from nearfar.cli import _options as options
from nearfar.cli._viewpoint import choose
from nearfar.serve._scene import LoadedScene
from nearfar.serve._site import Site


@dataclass(frozen=True)
class Loading:
    """Options for loading the files of scenes."""

    up: str
    on_invalid: str
    scale: float | None
    max_bytes: int | None
    blend: str


@dataclass(frozen=True)
class Regions:
    """Options for making regions, and the size of their cache."""

    cache_bytes: int
    grid: float
    radii: list[float] | None
    face_size: int
    samples: int


def read(sources: Sequence[str], loading: Loading, regions: Regions) -> tuple[dict[str, Site], list[LoadedScene]]:
    """Return sites by name, with an empty name for a single one, and the scenes that are being loaded."""
    named = [_split_source(source) for source in sources]
    names = [name for name, _ in named]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise ValueError(f"SOURCE: expected different names, got {twice!r} twice: write NAME=SOURCE")
    sites, scenes = {}, []
    for name, text in named:
        if _is_folder(text):
            sites[name] = Site.of_bundle(text)
            continue
        scene = _scene(text, loading, regions)
        folder = scene.cache_folder() if regions.cache_bytes else None
        sites[name] = Site.of_scene(scene, folder, regions.cache_bytes)
        scenes.append(scene)
    return (sites if len(sites) > 1 else {"": sites[names[0]]}), scenes


def loaded(scene: LoadedScene) -> str:
    """Wait for a scene, and describe it in a sentence; raise ValueError if it cannot be loaded."""
    return f"{scene.title} is loaded: {scene.wait().triangle_count:,} triangles"


def tell_of(scenes: Sequence[LoadedScene]) -> None:
    """Print for each scene when it is loaded or why it cannot be, in background threads."""

    def tell(scene: LoadedScene) -> None:
        try:
            typer.echo(loaded(scene))
        except ValueError as error:
            typer.echo(f"nearfar: {error}", err=True)

    for scene in scenes:
        threading.Thread(target=tell, args=(scene,), daemon=True).start()


def _split_source(source: str) -> tuple[str, str]:
    """Split "name=path"; the default name is that of the file, the folder or the procedural scene."""
    name, sign, path = source.partition("=")
    if sign and not {"/", ":"} & set(name) and not Path(source).exists():
        return name, path
    procedural, _, _ = source.partition(":")
    return procedural if procedural in options.PROCEDURAL else Path(source.rstrip("/")).absolute().stem, source


def _is_folder(text: str) -> bool:
    return is_url(text) or Path(text).is_dir() or Path(text).suffix.lower() == ".json"


def _scene(text: str, loading: Loading, regions: Regions) -> LoadedScene:
    settings = {name: value for name, value in asdict(regions).items() if name != "cache_bytes"}
    start = partial(_start, text)
    procedural, _, _ = text.partition(":")
    if procedural not in options.PROCEDURAL:
        # Report a missing file now, and not at a client's first request.
        Path(text).stat()
        return LoadedScene.of_file(text, start=start, **asdict(loading), **settings)
    load = partial(options.open_scene, text, **asdict(loading))
    source = cache.key("procedural", nf.__version__, text)
    return LoadedScene(load, title=text, source=source, start=start, **settings)


def _start(text: str, scene: nf.Scene) -> Viewpoint:
    return choose(scene, text)
