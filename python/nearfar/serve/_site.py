"""Documents of a site: the page with a bundle, or with a scene whose regions are made on demand."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from nearfar import stream
from nearfar._base.remote import is_url
from nearfar.serve._scene import LoadedScene
from nearfar.stream._on_demand import next_part
from nearfar.stream._store import FOLDER, MANIFEST
from nearfar.view._content import of_bundle, reduced_files, reduced_folder
from nearfar.view._page import INDEX, TYPES, page_files
from nearfar.view._tree import tree_files, tree_folder, tree_page

CACHE_BYTES = 2 * 10**9
"""Default size of a scene's disk cache, bytes."""

Source = bytes | tuple[str, int] | Callable[[], bytes]
"""Content of a document: bytes, path and size of a file, or a function that reads it."""

Document = tuple[str, str, bool, Source]
"""Name, media type, whether the name identifies the content, and the content."""

Demand = tuple[Callable[[list[float]], object], Callable[..., object], float, str | None, int]
"""Functions that begin a region and make its next part, the grid's spacing, and the cache's folder and bytes."""


@dataclass(frozen=True)
class Site:
    """Documents and regions below one path of a server."""

    content: Mapping[str, Source] = field(default_factory=dict)
    """Documents besides the page, by name."""
    demand: Demand | None = None
    """Maker of regions on demand."""
    title: str = ""
    """Short description of the scene."""
    has_page: bool = True
    """Whether the scene's page is served at the root."""

    @classmethod
    def of_bundle(cls, path: str | os.PathLike[str]) -> Site:
        """Serve a bundle, a reduced scene or a tree of orthoviews; errors as for the functions that open them."""
        if (tree := tree_folder(path)) is not None:
            return cls({**tree_files(tree), **tree_page()}, title="orthoviews", has_page=False)
        if (reduced := reduced_folder(path)) is not None:
            return cls(reduced_files(reduced), title="reduced scene")
        _check_folder(path)
        bundle = stream.open(path)
        content: dict[str, Source] = dict(of_bundle(bundle, bundle._reader.read))
        regions = len(bundle.centers)
        title = f"{regions} region{'s' if regions > 1 else ''}, {bundle.nbytes / 1e6:,.1f} MB"
        return cls(content if is_url(path) else {**content, **_local_files(bundle)}, title=title)

    @classmethod
    def of_scene(cls, scene: LoadedScene, cache: Path | None, cache_bytes: int = CACHE_BYTES) -> Site:
        """Serve a scene whose regions are made on demand.

        The cache is a folder for only this scene with these settings, such as `LoadedScene.cache_folder()`; None keeps
        regions in memory, up to a quarter of a gigabyte.
        """
        demand = (scene.parts, next_part, scene.grid, None if cache is None else os.fspath(cache), cache_bytes)
        return cls(scene.documents(), demand, title="regions are made where you go")

    def documents(self) -> list[Document]:
        """List the site's documents, including the page's."""
        content = {**(page_files() if self.has_page else {}), **self.content}
        paths = {"": INDEX} if INDEX in content else {}
        return [_document(path, name, content[name]) for path, name in {**paths, **{n: n for n in content}}.items()]


def _check_folder(path: str | os.PathLike[str]) -> None:
    """Raise FileNotFoundError for a folder without content that can be served."""
    if not is_url(path) and Path(path).is_dir() and not (Path(path) / MANIFEST).exists():
        message = (
            "expected a folder that `nearfar export` or `nearfar reduce` wrote, or a store of orthoviews; "
            "it has no manifest.json, reduced.json or zarr.json"
        )
        raise FileNotFoundError(errno.ENOENT, message, os.fspath(path))


def _document(path: str, name: str, source: Source) -> Document:
    """Return a document below a path; it is read now, unless its name identifies the content."""
    is_content_name = name.startswith(f"{FOLDER}/")
    content = source() if callable(source) and not is_content_name else source
    return path, TYPES.get(name.rpartition(".")[2], TYPES["bin"]), is_content_name, content


def _local_files(bundle: stream.Bundle) -> dict[str, tuple[str, int]]:
    """Return path and size of a local bundle's files, which the server reads itself; ValueError for a linked folder."""
    folder = Path(bundle._reader.location).resolve() / FOLDER
    if folder.is_symlink():
        raise ValueError(f"{folder}: expected a folder of the bundle, got a link")
    files = bundle._manifest["files"]
    return {name: (os.fspath(folder.parent / name), entry["bytes"]) for name, entry in files.items()}
