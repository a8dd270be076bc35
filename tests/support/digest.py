"""Digests of results, bit for bit, so that calls can be compared."""

from __future__ import annotations

import dataclasses
import hashlib
import re
from collections.abc import Iterator, Mapping
from typing import Any

import numpy as np

import nearfar as nf


def digest(value: Any) -> str:
    """Return a digest of arrays, scenes, records, texts and numbers, and of collections of them."""
    state = hashlib.sha256()
    _feed(state, value)
    return state.hexdigest()[:16]


def _feed(state: Any, value: Any) -> None:
    if isinstance(value, np.ndarray):
        native = value.dtype.newbyteorder("=")
        state.update(f"{native}{value.shape}".encode() + np.ascontiguousarray(value, native).tobytes())
    elif isinstance(value, bytes):
        state.update(value)
    elif isinstance(value, nf.Scene):
        _feed(state, value.triangles())
    elif isinstance(value, Mapping):
        _feed(state, [(repr(key), value[key]) for key in value])
    elif isinstance(value, list | tuple | Iterator):
        for item in value:
            _feed(state, item)
    elif dataclasses.is_dataclass(value) and not isinstance(value, type):
        for field in dataclasses.fields(value):
            if field.name != "stats":  # Their values contain times.
                _feed(state, getattr(value, field.name, None))
    else:
        # Numbers and texts only: an interrupted `repr` of an array changes the next one.
        state.update(re.sub(" at 0x[0-9a-f]+", "", repr(value)).encode())
