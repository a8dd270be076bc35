"""Sites of `nearfar serve`: bundles, reduced scenes, and scenes."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import typer

import nearfar as nf
from nearfar._base import cache, check
from nearfar._base.remote import is_url
from nearfar.cli._groups import option
from nearfar.cli._options import RingOptions
from nearfar.cli._scenes import is_procedural, open_scene
from nearfar.cli._viewpoint import choose
from nearfar.serve._site import CACHE_BYTES, LoadedScene, Site


@dataclass(frozen=True, kw_only=True)
class RegionOptions(RingOptions):
    """Regions that are made on request, and the size of their cache."""

    grid: float = option(2.0, "METRES", "Spacing of the grid to which the centres of scenes' regions move.")
    cache_bytes: int = option(CACHE_BYTES, "BYTES", "Bytes on disk for the regions of each scene; 0 keeps none.")

    def __post_init__(self) -> None:
        super().__post_init__()
        check.integer("cache_bytes", self.cache_bytes, 0, 1 << 62)

    @property
    def settings(self) -> dict[str, Any]:
        """Arguments of `LoadedScene`."""
        return {"grid": self.grid, "radii": self.metres, "face_size": self.face_size, "samples": self.samples}


def read(
    sources: Sequence[str], loading: nf.LoadOptions, regions: RegionOptions
) -> tuple[dict[str, Site], list[LoadedScene]]:
    """Return sites by name, with an empty name for a single one, and the scenes that are being loaded."""
    named = [_split_source(source) for source in sources]
    names = [name for name, _ in named]
    repeated = next((name for name in names if names.count(name) > 1), None)
    if repeated is not None:
        raise ValueError(f"SOURCE: expected different names, got {repeated!r} twice: write NAME=SOURCE")
    sites, scenes = {}, []
    for name, text in named:
        if is_url(text) or Path(text).is_dir() or Path(text).suffix.lower() == ".json":
            sites[name] = Site.of_bundle(text)
            continue
        scene = _scene(text, loading, regions)
        folder = scene.cache_folder() if regions.cache_bytes else None
        sites[name] = Site.of_scene(scene, folder, regions.cache_bytes)
        scenes.append(scene)
    return (sites if len(sites) > 1 else {"": sites[names[0]]}), scenes


def loaded_text(scene: LoadedScene) -> str:
    """Wait for a scene, and describe it in a sentence; raise ValueError if it cannot be loaded."""
    return f"{scene.title} is loaded: {scene.wait().triangle_count:,} triangles"


def print_when_loaded(scenes: Sequence[LoadedScene]) -> None:
    """Print a line when each scene is loaded, or why it cannot be loaded; waits in background threads."""

    def print_result(scene: LoadedScene) -> None:
        try:
            typer.echo(loaded_text(scene))
        except ValueError as error:
            typer.echo(f"nearfar: {error}", err=True)

    for scene in scenes:
        threading.Thread(target=print_result, args=(scene,), daemon=True).start()


def _split_source(source: str) -> tuple[str, str]:
    """Split "name=path"; by default the name of the file, the folder or the procedural scene is used."""
    name, sign, path = source.partition("=")
    if sign and not {"/", ":"} & set(name) and not Path(source).exists():
        return name, path
    return source.partition(":")[0] if is_procedural(source) else Path(source.rstrip("/")).absolute().stem, source


def _scene(text: str, loading: nf.LoadOptions, regions: RegionOptions) -> LoadedScene:
    start = partial(choose, source=text)
    if not is_procedural(text):
        # Report a missing file now rather than at a client's first request.
        Path(text).stat()
        return LoadedScene.of_file(text, loading, start=start, **regions.settings)
    load = partial(open_scene, text, loading)
    source = cache.key("procedural", nf.__version__, text)
    return LoadedScene(load, title=text, source=source, start=start, **regions.settings)
