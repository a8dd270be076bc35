"""Journal of a subtree: a line for each finished cell, so that an interrupted build resumes after it."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from nearfar.orthoview._grid import Place

Chunk = tuple[int, int]
"""First byte and length of a chunk in its shard."""


class Journal:
    """Finished cells, each with the byte ranges of its chunks by array name."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self.cells: dict[tuple[int, Place], dict[str, Chunk]] = {}
        self.guests: dict[Place, list[Place]] = {}
        """Guests of finished leaves that have some."""
        if path.exists():
            self._read()

    def _read(self) -> None:
        """Read the lines up to the first invalid one, and truncate the file there: the writer was interrupted."""
        whole = 0
        for line in self._path.read_bytes().splitlines(keepends=True):
            try:
                self._take(json.loads(line if line.endswith(b"\n") else b""))
            except (KeyError, TypeError, ValueError):
                break
            whole += len(line)
        os.truncate(self._path, whole)

    def _take(self, entry: dict[str, Any]) -> None:
        x, y, z = entry["place"]
        chunks = {str(array): (int(start), int(length)) for array, (start, length) in entry["chunks"].items()}
        self.cells[entry["level"], (x, y, z)] = chunks
        if guests := [(u, v, w) for u, v, w in entry.get("guests", [])]:
            self.guests[x, y, z] = guests

    def add(self, level: int, place: Place, chunks: dict[str, Chunk], guests: list[Place]) -> None:
        """Record a finished cell and its guests; its chunks must have been written before."""
        self._path.parent.mkdir(parents=True, exist_ok=True)
        entry = {"level": level, "place": place, "chunks": chunks} | ({"guests": guests} if guests else {})
        with self._path.open("ab") as file:
            file.write(json.dumps(entry, separators=(",", ":")).encode() + b"\n")
        self.cells[level, place] = chunks
        if guests:
            self.guests[place] = guests

    def of_array(self, array: str) -> Iterator[tuple[Place, Chunk]]:
        """Places of cells that have a chunk in an array, with the chunk."""
        for (_, place), chunks in self.cells.items():
            if array in chunks:
                yield place, chunks[array]

    def sizes(self) -> dict[tuple[int, Place, str], int]:
        """Bytes that each array's shard must have, by level and place of one of its cells and by array."""
        reached: dict[str, tuple[int, Place, int]] = {}
        for (level, place), chunks in self.cells.items():
            for array, (start, length) in chunks.items():
                _, _, before = reached.get(array, (level, place, 0))
                reached[array] = level, place, max(before, start + length)
        return {(level, place, array): size for array, (level, place, size) in reached.items()}

    def remove(self) -> None:
        """Forget all cells and delete the file."""
        self.cells.clear()
        self.guests.clear()
        self._path.unlink(missing_ok=True)
