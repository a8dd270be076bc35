"""nearfar's OpenEXR files: named parts with channels, and one JSON document in the header attribute `nearfar`."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any

from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import background, check, files, formats
from nearfar._base.errors import FormatError

ATTRIBUTE = "nearfar"
"""Header attribute of the first part that holds the document; OpenEXR reserves names such as `version`."""

Channels = Mapping[str, NDArray[Any]]
"""Images of a part by channel name: (H, W) float16, float32 or uint32, C-contiguous, all with the same shape."""


def write(
    path: str | os.PathLike[str],
    parts: Mapping[str, Channels],
    document: Mapping[str, Any],
    vectors: Mapping[str, tuple[float, float, float]] | None = None,
) -> None:
    """Write the channels of parts by the parts' names to a file, atomically and with lossless compression.

    `document` is a header made by `formats.header`, with the format's further fields. `vectors` are triples of numbers
    by name; every part's header gets them as float32 attributes, for programs that do not read `document`. ValueError
    or TypeError for images that OpenEXR cannot store.
    """
    text = json.dumps(dict(document), allow_nan=False)
    with files.atomic_file(path) as temporary:
        encoded: list[_core._Part] = []
        for name, channels in parts.items():
            document_attribute = {} if encoded else {ATTRIBUTE: text}
            encoded.append((name, dict(channels), {**document_attribute, **(vectors or {})}))
        files.write(temporary, _core.encode_exr(encoded).data)


def read(path: str | os.PathLike[str], name: str, version: int) -> tuple[dict[str, Any], dict[str, Channels]]:
    """Read a file that `write` made; return the document, and the channels of parts by the parts' names.

    `name` is the expected format without "nearfar.", `version` the newest supported one. FormatError for a file that is
    not an OpenEXR file of this format, or has a newer version of it.
    """
    data = background.run(check.path("path", path).read_bytes)
    try:
        parts = _core.decode_exr(data)
        document = formats.from_json(str(parts[0][2].get(ATTRIBUTE, "null"))) if parts else None
    except (FormatError, ValueError, RecursionError) as error:
        raise FormatError(f"{os.fspath(path)}: {error}") from None
    checked = formats.check(document, name, version, path)
    return checked, {part_name: channels for part_name, channels, _ in parts}


def check_kind(kind: str, values: NDArray[Any]) -> NDArray[Any]:
    """Return values read from a file if their type is of NumPy's kind ("f", "u"); ValueError otherwise."""
    if values.dtype.kind != kind:
        raise ValueError(f"expected numbers of kind {kind!r}, got {values.dtype}")
    return values
