"""Files of the page, which are part of the package; copied into a bundle's folder, they show the bundle."""

from __future__ import annotations

import os
from functools import cache
from importlib import resources

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
"""Media types by file name suffix."""

POLICY = "; ".join(
    (
        "default-src 'none'",
        # meshoptimizer's decoder is WebAssembly.
        "script-src 'self' 'wasm-unsafe-eval'",
        "worker-src 'self'",
        "style-src 'self'",
        "img-src 'self' blob: data:",
        # A page may show a bundle from another host: ?bundle=https://…
        "connect-src 'self' https: http:",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'self'",
    )
)
"""Content-Security-Policy of the page: no content of a bundle is ever executed."""


@cache
def page_files() -> dict[str, bytes]:
    """Return the page's files by name."""
    folder = resources.files("nearfar.view") / "dist"
    return {file.name: file.read_bytes() for file in folder.iterdir() if file.name.rpartition(".")[2] in TYPES}


def write_page(path: str | os.PathLike[str]) -> None:
    """Write the page's files into a folder of content, so that any web server can show it.

    OSError if the folder has no such content, or cannot be written; FormatError for a damaged reduced scene, with the
    file's name in the message; ValueError for a reduced scene without a morph.

    Parameters
    ----------
    path
        A local folder that `nearfar.stream.export`, `ReducedScene.save` or `nearfar.orthoview.build` wrote. Any web
        server can then show it at the folder's address; the page loads nothing from other hosts. Headsets show bundles
        immersively only over https. For a reduced scene the folder also gets a bundle: `manifest.json`, `tileset.json`
        and `files/`.
    """
    if (folder := _tree.tree_folder(path)) is not None:
        contents = _tree.tree_page()
    elif (folder := _content.reduced_folder(path)) is not None:
        contents = {**_content.reduced_files(folder), **page_files()}
        (folder / _store.FOLDER).mkdir(exist_ok=True)
    else:
        folder, contents = remote.local(path), page_files()
        (folder / _store.MANIFEST).stat()
    for name, content in contents.items():
        with files.atomic_file(folder / name) as file:
            file.write_bytes(content)
