"""The files of the page, which lie in the package; beside a bundle's manifest they show the bundle."""

from __future__ import annotations

import os
from functools import cache
from importlib import resources

from nearfar._base import files, remote
from nearfar.stream import _store
from nearfar.view import _content

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
    """Write the page's files into the folder of a bundle or a reduced scene, so that any web server shows it.

    Parameters
    ----------
    path
        A local folder that `nearfar.stream.export` or `ReducedScene.save` wrote. Its address shows the scene then; the
        page needs no server of nearfar, and no other host. Headsets show it immersively over https only. Beside a
        reduced scene it also needs the scene's parts as a bundle has them, which are written, too: `manifest.json`,
        `tileset.json` and `files/`.

    Raises
    ------
    OSError
        If the folder has neither, or cannot be written.
    FormatError
        For a reduced scene that is damaged; the message names the file.
    ValueError
        For a reduced scene without a morph.
    TypeError
        If `path` is no path.
    """
    saved = _content.reduced_folder(path)
    folder = remote.local(path) if saved is None else saved
    made: dict[str, bytes] = {}
    if saved is None:
        (folder / _store.MANIFEST).stat()
    else:
        made = {name: read() for name, read in _content.opened(folder).items()}
        (folder / _store.FOLDER).mkdir(exist_ok=True)
    for name, content in {**made, **page_files()}.items():
        with files.atomic_file(folder / name) as file:
            file.write_bytes(content)
