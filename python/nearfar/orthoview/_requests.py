"""Lists the requests that a flight makes for its parts, for simulations: names of files, and bytes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from nearfar.orthoview._cut import GEOMETRY, RECORD, Part, kind
from nearfar.orthoview._files import ByteRange, Files, join_ranges
from nearfar.orthoview._geometry_store import FOLDER, IMAGES
from nearfar.orthoview._tree import OrthoTree


class Request(NamedTuple):
    """Request for a file or a part of it."""

    file: str
    bytes: int
    """Bytes of the response."""

    @property
    def is_texture(self) -> bool:
        """Whether leaves share the file: one that has been received is not requested again."""
        return self.file.startswith(f"{FOLDER}/{IMAGES}/")


class RecordedFiles:
    """Reads the files of a store, and records the requests that a client behind a URL would make."""

    def __init__(self, files: Files) -> None:
        self._files, self.address = files, files.address
        self.requests: list[Request] = []

    def read(self, name: str) -> bytes | None:
        content = self._files.read(name)
        self.requests.append(Request(name, len(content or b"")))
        return content

    def read_parts(self, byte_ranges: Sequence[ByteRange]) -> list[bytes | None]:
        self.requests += [Request(part.file, part.length) for part in join_ranges(byte_ranges)]
        return self._files.read_parts(byte_ranges)


class FlightRequests:
    """Reads a tree part by part as a flight does, except that it looks up views without reading them."""

    def __init__(self, tree: OrthoTree) -> None:
        self._files = RecordedFiles(tree._files)
        self.opened = tree._open_store(self._files)

    def list_requests(self, part: Part) -> list[Request]:
        """List the requests for a part, which its thread makes one after the other if no texture is cached."""
        self._files.requests.clear()
        level, place, _ = part
        viewer, chunks = self.opened.viewer, self.opened.chunks
        if kind(part) == GEOMETRY:
            # The simulated caches decide whether the leaf and its textures are read again.
            viewer.near.read_undecoded(place)
        elif kind(part) == RECORD:
            self.opened.read_cells(level, place)
        else:
            for byte_range in chunks.locate([self.opened.layout.key(part)]):
                if byte_range is not None:
                    self._files.requests.append(Request(byte_range.file, byte_range.length))
        requests, self._files.requests = self._files.requests, []
        return requests

    def receive(self, part: Part) -> None:
        """Record that a part has arrived: later cuts use the cells of a subtree's record."""
        level, place, _ = part
        if kind(part) == RECORD:
            self.opened.viewer.cutter.read_record(level, place)
