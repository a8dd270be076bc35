"""Chunks of a GLB, which cases modify separately."""

from __future__ import annotations

import json
import struct
from typing import Any

from tests.attack.seeds import glb


def split(data: bytes) -> tuple[Any, bytes]:
    """Return a GLB's document and its arrays; None for other data."""
    try:
        length = struct.unpack_from("<I", data, 12)[0]
        return json.loads(data[20 : 20 + length]), data[28 + length :]
    except (ValueError, struct.error, RecursionError):
        return None, b""


def glb_of_chunks(document: bytes, binary: bytes) -> bytes:
    """Return a GLB of these chunks."""
    return glb(document, binary)
