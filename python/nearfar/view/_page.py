"""The files of the page, which lie in the package; beside a bundle's manifest they show the bundle."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cache
from importlib import resources
from pathlib import Path

from nearfar._base import files, remote
from nearfar.stream import _store
from nearfar.view import _content, _tree

INDEX = "index.html"

TYPES = {
    "html": "text/html; charset=utf-8",
    "js": "text/javascript; charset=utf-8",
    "css": "text/css; charset=utf-8",
    "json": "application/json",
    "webp": "image/webp",
    "glb": "model/gltf-binary",
    "bin": "application/octet-stream",
}
"""Media types by the ends of names."""

POLICY = "; ".join(
    (
        "default-src 'none'",
        # meshoptimizer's decoder is WebAssembly.
        "script-src 'self' 'wasm-unsafe-eval'",
        "worker-src 'self'",
        "style-src 'self'",
        "img-src 'self' blob: data:",
        # A page may show a bundle of another host: ?bundle=https://…
        "connect-src 'self' https: http:",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'self'",
    )
)
"""Content-Security-Policy under which the page works: nothing that a bundle says is ever run."""


@cache
def page_files() -> dict[str, bytes]:
    """The page's files by name."""
    folder = resources.files("nearfar.view") / "dist"
    return {file.name: file.read_bytes() for file in folder.iterdir() if file.name.rpartition(".")[2] in TYPES}


def write_page(path: str | os.PathLike[str]) -> None:
    """Write the page's files into the folder of what it shows, so that any web server shows it.

    Parameters
    ----------
    path
        A local folder that `nearfar.stream.export`, `ReducedScene.save` or `nearfar.orthoview.build` wrote. Its address
        shows the scene then; the page needs no server of nearfar, and no other host. Headsets show bundles immersively
        over https only. Beside a reduced scene the page also needs the scene's parts as a bundle has them, which are
        written, too: `manifest.json`, `tileset.json` and `files/`.

    Raises
    ------
    OSError
        If the folder has none of them, or cannot be written.
    FormatError
        For a reduced scene that is damaged; the message names the file.
    ValueError
        For a reduced scene without a morph.
    TypeError
        If `path` is no path.
    """
    tree = _tree.tree_folder(path)
    if tree is not None:
        _write(tree, _tree.tree_page())
        return
    saved = _content.reduced_folder(path)
    folder = remote.local(path) if saved is None else saved
    made: dict[str, bytes] = {}
    if saved is None:
        (folder / _store.MANIFEST).stat()
    else:
        made = {name: read() for name, read in _content.opened(folder).items()}
        (folder / _store.FOLDER).mkdir(exist_ok=True)
    _write(folder, {**made, **page_files()})


def _write(folder: Path, contents: Mapping[str, bytes]) -> None:
    for name, content in contents.items():
        with files.atomic_file(folder / name) as file:
            file.write_bytes(content)
