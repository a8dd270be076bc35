"""Texture statements of Wavefront materials: their options, and file names written on other operating systems.

Source: Alias|Wavefront, MTL material format, "Options for texture map statements".
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from nearfar._scene.samplers import CLAMP, REPEATED, Sampler

_ONE_VALUE = ("-blendu", "-blendv", "-boost", "-bm", "-cc", "-clamp", "-imfchan", "-texres", "-type")
"""Options with one value."""
_UP_TO_THREE = ("-o", "-s", "-t")
"""Options with one to three numbers."""
_DRAWN = ("-o", "-s", "-blendu", "-blendv", "-cc", "-clamp", "-texres")
"""Options that are applied, or that only concern filtering."""


@dataclass(frozen=True)
class Placing:
    """Transform of texture coordinates: scale, then offset."""

    scale: tuple[float, float] = (1.0, 1.0)
    offset: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True)
class MapStatement:
    """A texture with its options."""

    file: str
    """Name as written."""
    placing: Placing = Placing()
    is_clamped: bool = False
    """Whether the border texels continue beyond the image; otherwise it repeats."""
    undrawn: tuple[str, ...] = ()
    """Options that are not applied."""


def parse_map(text: str) -> MapStatement:
    """Split a statement, without its keyword, into options and the file name, which may contain spaces."""
    values: dict[str, list[str]] = {}
    rest = text.strip()
    while True:
        option, *remainders = rest.split(maxsplit=1) or [""]
        option, remainder = option.lower(), "".join(remainders)
        words = remainder.split()
        if option in _ONE_VALUE:
            size = 1
        elif option == "-mm":
            size = 2
        elif option in _UP_TO_THREE:
            size = next((n for n, word in enumerate(words[:3]) if _number(word) is None), min(3, len(words)))
        else:
            break
        if len(words) <= size:
            break
        values[option] = words[:size]
        rest = remainder.split(maxsplit=size)[size]
    placing = Placing(_pair(values.get("-s", []), 1.0), _pair(values.get("-o", []), 0.0))
    undrawn = tuple(
        option
        for option, words in values.items()
        if option not in _DRAWN and (option, [word.lower() for word in words]) not in _WITHOUT_EFFECT
    )
    is_clamped = [word.lower() for word in values.get("-clamp", ())] == ["on"]
    return MapStatement(rest.strip('"'), placing, is_clamped, undrawn)


def _pair(words: list[str], default: float) -> tuple[float, float]:
    """First two numbers of an option; missing ones are the default."""
    first, second, *_ = [*map(float, words), default, default]
    return first, second


_WITHOUT_EFFECT = (("-mm", ["0", "1"]), ("-bm", ["1"]), ("-boost", ["0"]))
"""Options whose stated value is the default."""


def _number(word: str) -> float | None:
    try:
        number = float(word)
    except ValueError:
        return None
    return number if math.isfinite(number) else None


def placing_of(image: Any) -> Placing:
    """Transform of texture coordinates, from the statement that trimesh stores with an image, if any."""
    return _statement(image).placing


def sampler_of(image: Any) -> Sampler:
    """Sampler of a texture, from the statement that trimesh stores with an image, if any."""
    return (CLAMP, CLAMP, REPEATED[2]) if _statement(image).is_clamped else REPEATED


def _statement(image: Any) -> MapStatement:
    return parse_map(getattr(image, "info", {}).get("file_path", ""))


class TextureFiles:
    """Resolver for trimesh that understands options in texture statements and paths of other operating systems."""

    def __init__(self, files: Any) -> None:
        self._files = files

    def get(self, text: str) -> bytes:
        """Read the file that a statement names; raises the resolver's errors."""
        return self.open(parse_map(text).file)

    def open(self, name: str) -> bytes:
        """Read a file by its name as written, else with forward slashes, else by its last part; resolver's errors."""
        slashes = name.replace("\\", "/")
        candidates = list(dict.fromkeys([name, slashes, slashes.rpartition("/")[2]]))
        for candidate in candidates[:-1]:
            try:
                data: bytes = self._files.get(candidate)
            except MemoryError:
                raise
            except Exception:  # resolvers may raise any type
                continue
            return data
        return self._files.get(candidates[-1])  # type: ignore[no-any-return]
