"""Documents of a site: the page with a bundle, or with a scene that is loaded while its server already responds."""

from __future__ import annotations

import errno
import hashlib
import json
import math
import os
import re
import secrets
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any, TypeVar
from urllib.parse import unquote

from nearfar import stream
from nearfar._base import background, cache, check, formats, progress
from nearfar._base.remote import is_url
from nearfar._base.version import __version__
from nearfar._scene.builder import SceneBuilder
from nearfar._scene.options import LoadOptions
from nearfar._scene.scene import Scene
from nearfar._trace import viewpoint
from nearfar._trace.viewpoint import Viewpoint
from nearfar.stream._growth import Growth
from nearfar.stream._manifest import NEAR_SHARE
from nearfar.stream._on_demand import OnDemand, Part, next_part
from nearfar.stream._store import FOLDER, MANIFEST
from nearfar.view._content import of_bundle, reduced_files, reduced_folder
from nearfar.view._page import INDEX, TYPES, page_files
from nearfar.view._tree import tree_files, tree_folder, tree_page

SITE, SCENE, VERSION = "on_demand", "scene", 1
"""Format names of a site's manifest and of its scene document, and their version."""

Result = TypeVar("Result")

POLL_SECONDS = 0.05
"""Time between two checks whether a scene is loaded."""

LIBRARY = re.compile(rb"^\s*mtllib\s+(.+?)\s*$", re.MULTILINE)
"""Pattern of material libraries that an OBJ refers to."""

PICTURE = re.compile(rb"^\s*(?:map_\w+|bump|disp|decal|refl)\s+(?:.*\s)?(\S+)\s*$", re.MULTILINE)
"""Pattern of pictures that materials refer to."""

CACHE_BYTES = 2 * 10**9
"""Default size of a scene's disk cache, bytes."""

Source = bytes | tuple[str, int] | Callable[[], bytes]
"""Content of a document: bytes, path and size of a file, or a function that reads it."""

Document = tuple[str, str, bool, Source]
"""Name, media type, whether the name identifies the content, and the content."""

Demand = tuple[Callable[[list[float]], object], Callable[..., object], float, str | None, int]
"""Functions that begin a region and make its next part; spacing of the grid; folder and bytes of the cache."""


class LoadedScene:
    """Loads a scene in a background thread, and makes its regions; requests wait until it is loaded.

    `load` returns the scene; if it raises, requests fail with its message. `title` names the scene for users. `source`
    is a hash of all input files and settings of `load`; without it, None, the disk cache does not outlast a run.
    `start` chooses the start pose of pages whose address has none; the default is an open area of the scene. `settings`
    and their errors are those of `nearfar.stream._on_demand.OnDemand`.
    """

    def __init__(
        self,
        load: Callable[[], Scene],
        *,
        title: str = "scene",
        source: str | None = None,
        start: Callable[[Scene], Viewpoint] = viewpoint.find,
        **settings: Any,
    ) -> None:
        self.title, self._source, self._settings = check.text("title", title), source, settings
        # Settings are checked before the scene is loaded.
        self.grid = OnDemand(_triangle(), **settings).grid
        self._regions = background.Later(lambda: OnDemand(load(), **settings))
        self._start = background.Later(lambda: start(self._regions.result().scene))

    @classmethod
    def of_file(cls, path: str | os.PathLike[str], options: LoadOptions | None = None, **settings: Any) -> LoadedScene:
        """Load a file as `nearfar.Scene.load` does; `settings` are the settings of the class."""
        file, loading = check.path("path", path), options or LoadOptions()
        load = partial(Scene.load, file, loading)
        source = _source_key(file, {name: getattr(loading, name) for name in ("up", "on_invalid", "scale", "blend")})
        return cls(load, **{"title": file.name, "source": source, **settings})

    def wait(self) -> Scene:
        """Wait for the scene and return it; MemoryError or ValueError with a message if it cannot be loaded."""
        return self._result(self._regions).scene

    def cache_folder(self) -> Path | None:
        """Return the cache folder for this scene with these settings; None without `source`."""
        if self._source is None:
            return None
        settings = {name: _plain(value) for name, value in self._settings.items()}
        return cache.folder() / "regions" / cache.key(SITE, VERSION, self._source, settings)

    def parts(self, center: list[float]) -> Iterator[Part]:
        """Make the region of a place as `OnDemand.parts` does; the first part waits for the scene."""
        while not self._regions.ready:
            progress.look()
            time.sleep(POLL_SECONDS)
        yield from self._result(self._regions).parts(center)

    def documents(self) -> Mapping[str, bytes | Callable[[], bytes]]:
        """List the documents that a page loads first: a manifest, and a scene document that waits for the scene.

        The scene document gets a new name at each start, because clients may cache files for ever.
        """
        name = f"{FOLDER}/{secrets.token_hex(8)}.json"
        manifest = formats.header(SITE, VERSION, title=self.title, grid=self.grid, scene=name)
        return {MANIFEST: _encode(manifest), name: lambda: _encode(self._scene_document())}

    def _scene_document(self) -> dict[str, Any]:
        """Return the scene document; if loading failed, it has the reason."""
        try:
            regions, start = self._result(self._regions), self._result(self._start)
        except (MemoryError, ValueError) as error:
            return formats.header(SCENE, VERSION, failed=str(error))
        scene, settings, (x, _, z) = regions.scene, regions.settings, start.forward
        return formats.header(
            SCENE,
            VERSION,
            triangles=scene.triangle_count,
            objects=len(scene.object_names),
            bounds=scene.bounds.tolist(),
            start={"position": list(start.eye), "yaw": math.atan2(-x, -z)},
            face_size=settings.face_size,
            near_share=NEAR_SHARE,
            growth=Growth((1.0,), speed=settings.speed).to_manifest(),
            is_static=not scene.poses,
            notes=list(scene._notes),
        )

    def _result(self, work: background.Later[Result]) -> Result:
        """Wait for the result of work on the scene; MemoryError or ValueError with a message if it failed."""
        try:
            return work.result()
        except Exception as error:
            kind = MemoryError if isinstance(error, MemoryError) else ValueError
            raise kind(f"{self.title}: the scene cannot be loaded: {error}") from None


def _triangle() -> Scene:
    builder = SceneBuilder()
    builder.instance(builder.mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]), name="triangle")
    return builder.build()


def _encode(document: dict[str, Any]) -> bytes:
    return formats.to_json(document, compact=True).encode()


def _plain(value: Any) -> Any:
    """Convert a setting to a type that cache keys accept."""
    return value if value is None or isinstance(value, bool | int | float | str | tuple | list) else repr(value)


def _source_key(path: Path, settings: Mapping[str, object]) -> str | None:
    """Hash a file, the files that it refers to, the loading settings, and the version of nearfar.

    References of glTF and OBJ are followed; other formats are assumed to be self-contained. None if the file cannot be
    read, so that the loader reports the error.
    """
    try:
        digests = {path.name: _digest(path)}
        for name in _referenced_files(path):
            # A missing file changes the scene, so it changes the key.
            digests[name] = _digest(path.parent / name) if (path.parent / name).is_file() else "none"
    except (OSError, ValueError):
        return None
    return cache.key("serve.source", __version__, digests, dict(settings))


def _referenced_files(path: Path) -> Iterator[str]:
    """Yield the names of the files that a file refers to, relative to its folder."""
    kind = path.suffix.lower()
    if kind == ".gltf":
        document = json.loads(path.read_bytes())
        for section in ("buffers", "images"):
            uris = (entry.get("uri", "data:") for entry in document.get(section, ()))
            yield from (unquote(uri) for uri in uris if not uri.startswith("data:"))
    elif kind == ".obj":
        for library in _names(LIBRARY, path):
            yield library
            library_path = path.parent / library
            yield from _names(PICTURE, library_path) if library_path.is_file() else ()


def _names(pattern: re.Pattern[bytes], path: Path) -> list[str]:
    return [name.decode(errors="replace") for name in pattern.findall(path.read_bytes())]


def _digest(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


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
        if not is_url(path) and Path(path).is_dir() and not (Path(path) / MANIFEST).exists():
            expected = "expected a folder that `nearfar export` or `nearfar reduce` wrote, or a store of orthoviews"
            reason = "it has no manifest.json, reduced.json or zarr.json"
            raise FileNotFoundError(errno.ENOENT, f"{expected}; {reason}", os.fspath(path))
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


def _document(path: str, name: str, source: Source) -> Document:
    """Return a document at a path. Its source is read now, unless its name identifies the content."""
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
