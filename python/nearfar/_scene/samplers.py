"""Samplers of glTF textures: how an image continues beyond its borders, and how magnified texels are filtered."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

Sampler = tuple[int, int, int]
"""glTF's codes `wrapS`, `wrapT` and `magFilter`."""

CLAMP = 33071
REPEATED: Sampler = (10497, 10497, 9729)
"""Default sampler: repeats the image and filters linearly."""

_WRAPS = (REPEATED[0], 33648, CLAMP)
_FILTERS = (9728, REPEATED[2])
_CHOICES = {"wrapS": _WRAPS, "wrapT": _WRAPS, "magFilter": _FILTERS}


def from_gltf(sampler: Mapping[str, Any]) -> Sampler:
    """Return the drawn part of a document's sampler; unknown codes count as absent."""
    codes = zip(_CHOICES.items(), REPEATED, strict=True)
    wrap_s, wrap_t, filter_ = (
        sampler[key] if sampler.get(key) in known else default for (key, known), default in codes
    )
    return wrap_s, wrap_t, filter_


def to_gltf(sampler: Sampler) -> dict[str, int]:
    """Return the entries of a document's sampler; none for `REPEATED`."""
    codes = zip(_CHOICES, sampler, REPEATED, strict=True)
    return {key: code for key, code, default in codes if code != default}
