"""A key of all that a scene's file holds and refers to, so that what was made of it is found again."""

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
"""Materials that an OBJ refers to."""

PICTURE = re.compile(rb"^\s*(?:map_\w+|bump|disp|decal|refl)\s+(?:.*\s)?(\S+)\s*$", re.MULTILINE)
"""Pictures that materials refer to."""


def key(path: Path, how: Mapping[str, object]) -> str | None:
    """Hash a file, the files that it refers to, how it is loaded, and the version of nearfar.

    Those of glTF and OBJ are followed; other kinds are taken to be whole. None if the file cannot be read, so that what
    loads it says why.
    """
    try:
        found = {path.name: _digest(path)}
        for other in _referred(path):
            # One that is missing makes another scene than one that is there.
            found[str(other)] = _digest(path.parent / other) if (path.parent / other).is_file() else "none"
    except (OSError, ValueError):
        return None
    return cache.key("serve.source", __version__, found, dict(how))


def _referred(path: Path) -> Iterator[str]:
    """Names of the files that a file refers to, relative to its folder."""
    kind = path.suffix.lower()
    if kind == ".gltf":
        document = json.loads(path.read_bytes())
        for listed in ("buffers", "images"):
            uris = (entry.get("uri", "data:") for entry in document.get(listed, ()))
            yield from (unquote(uri) for uri in uris if not uri.startswith("data:"))
    elif kind == ".obj":
        for library in _names(LIBRARY, path):
            yield library
            place = path.parent / library
            yield from _names(PICTURE, place) if place.is_file() else ()


def _names(pattern: re.Pattern[bytes], path: Path) -> list[str]:
    return [name.decode(errors="replace") for name in pattern.findall(path.read_bytes())]


def _digest(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
