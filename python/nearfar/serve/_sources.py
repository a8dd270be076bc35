"""Cache key of a scene's file and all files that it refers to."""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from urllib.parse import unquote

from nearfar._base import cache
from nearfar._base.version import __version__

LIBRARY = re.compile(rb"^\s*mtllib\s+(.+?)\s*$", re.MULTILINE)
"""Pattern of material libraries that an OBJ refers to."""

PICTURE = re.compile(rb"^\s*(?:map_\w+|bump|disp|decal|refl)\s+(?:.*\s)?(\S+)\s*$", re.MULTILINE)
"""Pattern of pictures that materials refer to."""


def key(path: Path, settings: Mapping[str, object]) -> str | None:
    """Hash a file, the files that it refers to, the loading settings, and the version of nearfar.

    References of glTF and OBJ are followed; other formats are assumed to be self-contained. None if the file cannot be
    read, so that the loader reports the error.
    """
    try:
        digests = {path.name: _digest(path)}
        for name in _referred(path):
            # A missing file changes the scene, so it changes the key.
            digests[name] = _digest(path.parent / name) if (path.parent / name).is_file() else "none"
    except (OSError, ValueError):
        return None
    return cache.key("serve.source", __version__, digests, dict(settings))


def _referred(path: Path) -> Iterator[str]:
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
