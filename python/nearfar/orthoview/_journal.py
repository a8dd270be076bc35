"""The journal of a subtree: a line for each cell that is done, so that work that was ended goes on after it."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any, BinaryIO

from nearfar.orthoview._grid import Place

Chunk = tuple[int, int]
"""First byte and length of a chunk in its shard."""


class Journal:
    """Cells that are done, each with the places of its chunks by the names of their arrays."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._file: BinaryIO | None = None
        self.cells: dict[tuple[int, Place], dict[str, Chunk]] = {}
        if path.exists():
            self._read()

    def _read(self) -> None:
        """Read all whole lines, and drop what a line that was cut off left."""
        whole = 0
        for line in self._path.read_bytes().splitlines(keepends=True):
            if not line.endswith(b"\n"):
                break
            entry = json.loads(line)
            x, y, z = entry["place"]
            chunks = {array: (start, length) for array, (start, length) in entry["chunks"].items()}
            self.cells[entry["level"], (x, y, z)] = chunks
            whole += len(line)
        with self._path.open("r+b") as file:
            file.truncate(whole)

    def add(self, level: int, place: Place, chunks: dict[str, Chunk]) -> None:
        """Note that a cell is done; its chunks have been handed to the system before."""
        if self._file is None:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            self._file = self._path.open("ab", buffering=0)
        entry: dict[str, Any] = {"level": level, "place": place, "chunks": chunks}
        self._file.write(json.dumps(entry, separators=(",", ":")).encode() + b"\n")
        self.cells[level, place] = chunks

    def of_array(self, array: str) -> Iterator[tuple[Place, Chunk]]:
        """Places of an array's cells that have a chunk, with it."""
        for (_, place), chunks in self.cells.items():
            if array in chunks:
                yield place, chunks[array]

    def close(self) -> None:
        """Close the file, which stays as it is."""
        if self._file is not None:
            self._file.close()
            self._file = None

    def remove(self) -> None:
        """Remove the file: the subtree is complete."""
        self.close()
        self._path.unlink(missing_ok=True)
