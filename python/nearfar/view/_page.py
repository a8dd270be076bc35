"""The files of the page, which lie in the package; beside a bundle's manifest they show the bundle."""

from __future__ import annotations

import os
from functools import cache
from importlib import resources

from nearfar._base import files
from nearfar.stream import _store

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
    """Write the page's files into the folder of a bundle, so that any web server shows it.

    Parameters
    ----------
    path
        A local folder that `nearfar.stream.export` wrote. Its address shows the bundle then; the page needs no server
        of nearfar, and no other host. Headsets show it immersively over https only.

    Raises
    ------
    OSError
        If there is no manifest, or the folder cannot be written.
    TypeError
        If `path` is no path.
    """
    folder = _store.local(path)
    (folder / _store.MANIFEST).stat()
    for name, content in page_files().items():
        with files.atomic_file(folder / name) as file:
            file.write_bytes(content)
