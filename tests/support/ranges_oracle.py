"""Ranges of maps decoded one texel after the other in plain Python, as documented in docs/stream.md."""

from __future__ import annotations

import math
import struct
import zlib
from itertools import pairwise
from typing import Any

NOTHING = 65535


class Planes:
    """Nine planes of a file, each read from its beginning."""

    def __init__(self, data: bytes) -> None:
        raw = zlib.decompress(data)
        lengths = struct.unpack("<9I", raw[:36])
        ends = [36 + sum(lengths[:number]) for number in range(10)]
        planes = [raw[start:end] for start, end in pairwise(ends)]
        self.bits = ["".join(f"{byte:08b}" for byte in plane) for plane in planes[:6]]
        self.bytes = [list(plane) for plane in planes[6:8]]
        half = len(planes[8]) // 2
        self.words = [256 * high + low for high, low in zip(planes[8][:half], planes[8][half:], strict=True)]

    def take(self, plane: int, count: int) -> int:
        taken, self.bits[plane] = self.bits[plane][:count], self.bits[plane][count:]
        return int(taken, 2)

    def residual(self, trust: str) -> int:
        folded = 0
        if trust == "high":
            folded = self.take(2, 1)
            if folded == 0:
                return 0
        if trust != "low":
            pair = self.take({"high": 3, "some": 4, "calm": 5}[trust], 2)
            folded += pair
            if pair < 3:
                return _unfolded(folded)
        byte = self.bytes[trust == "low"].pop(0)
        folded += byte
        if byte == 255:
            folded += self.words.pop(0)
        return _unfolded(folded)


def _unfolded(folded: int) -> int:
    return -(folded + 1) // 2 if folded % 2 else folded // 2


def exponential(x: float) -> float:
    """The first eleven terms of the series, from the last on."""
    total = 1.0
    for n in range(10, 0, -1):
        total = 1.0 + x / n * total
    return total


class Line:
    """The least-squares line through values of consecutive texels."""

    def __init__(self) -> None:
        self.value, self.slope, self.count = 0.0, 0.0, 0

    @property
    def next(self) -> float:
        return self.value + self.slope

    def add(self, value: float, fits: bool) -> None:
        if not fits:
            self.value, self.slope, self.count = value, 0.0, 1
            return
        error, predicted = value - self.next, self.next
        self.count = min(self.count + 1, 128)
        scale = 1.0 / (self.count * (self.count + 1.0))
        self.value = predicted + (4.0 * self.count - 2.0) * scale * error
        self.slope += 6.0 * scale * error


class Decoder:
    """Decodes faces of `size` texels a side with tiles of `tile`; `before` is None for whole faces."""

    def __init__(self, data: bytes, before: Any, count: int, size: int, tiles: Any, tile: int, step: float) -> None:
        self.planes, self.before, self.size, self.tile = Planes(data), before, size, tile
        self.listed = {int(number) for number in tiles}
        self.powers = [1.0]
        ratio = exponential(step)
        while len(self.powers) < NOTHING:
            self.powers.append(self.powers[-1] * ratio)
        self.half = exponential(0.5 * step)
        self.codes = [[[0] * size for _ in range(size)] for _ in range(count)] if before is None else before.tolist()
        self.changed = [[[False] * size for _ in range(size)] for _ in range(count)]
        for face in range(count):
            self._face(face)

    def _is_listed(self, face: int, y: int, x: int) -> bool:
        across = self.size // self.tile
        return face * across * across + y // self.tile * across + x // self.tile in self.listed

    def _code(self, value: float, distance: float) -> int:
        """The first code whose end is beyond the range predicted by a line."""
        if value <= 0.0:
            return NOTHING - 1
        low, high = 0, NOTHING - 1
        while low < high:
            middle = (low + high) // 2
            if distance / value < self.powers[middle] * self.half:
                high = middle
            else:
                low = middle + 1
        return low

    def _face(self, face: int) -> None:
        columns, last = [Line() for _ in range(self.size)], 0
        codes, changed = self.codes[face], self.changed[face]
        for y in range(self.size):
            row = Line()
            for x in range(self.size):
                is_listed = self._is_listed(face, y, x)
                if not is_listed and self.before is not None:
                    row, columns[x] = Line(), Line()
                    continue
                if is_listed:
                    changed[y][x] = self._predicted_change(face, y, x) != bool(self.planes.take(0, 1))
                is_new = self.before is None or changed[y][x]
                if is_new:
                    is_nothing = self._predicted_nothing(codes, y, x) != bool(self.planes.take(1, 1))
                    codes[y][x] = NOTHING if is_nothing else 0
                if codes[y][x] == NOTHING:
                    row, columns[x] = Line(), Line()
                    continue
                u, v = (2 * x + 1) / self.size - 1.0, (2 * y + 1) / self.size - 1.0
                distance = math.sqrt(1.0 + u * u + v * v)
                lines = (row, columns[x])
                guesses = [self._code(line.next, distance) if line.count else None for line in lines]
                if is_new:
                    guess, trust = self._predicted(codes, y, x, last, lines, guesses, distance)
                    codes[y][x] = (guess + self.planes.residual(trust)) % 65536
                last = codes[y][x]
                for line, own in zip(lines, guesses, strict=True):
                    most = 64 if line.count < 2 else 1
                    line.add(distance * (1.0 / self.powers[last]), own is not None and abs(own - last) <= most)

    def _predicted_change(self, face: int, y: int, x: int) -> bool:
        flags = self.changed[face]
        if y == 0 or x == 0:
            return flags[y][x - 1] if x else flags[y - 1][x] if y else False
        left, above, corner = flags[y][x - 1], flags[y - 1][x], flags[y - 1][x - 1]
        if self.before is None:
            return sorted((left, above, left + above - corner))[1] > 0
        old = self.before[face].astype(int)
        is_left = abs(old[y][x - 1] - old[y][x]) <= abs(old[y - 1][x] - old[y][x])
        return left if is_left else above

    def _predicted_nothing(self, codes: list[list[int]], y: int, x: int) -> bool:
        left = not x or codes[y][x - 1] == NOTHING
        above = not y or codes[y - 1][x] == NOTHING
        corner = not (x and y) or codes[y - 1][x - 1] == NOTHING
        return sorted((left, above, left + above - corner))[1] > 0

    def _predicted(
        self, codes: list[list[int]], y: int, x: int, last: int, lines: tuple[Line, Line], guesses: Any, distance: float
    ) -> tuple[int, str]:
        places = [(y, x - 1), (y - 1, x), (y - 1, x - 1), (y - 1, x + 1)]
        shown = [codes[b][a] if 0 <= a < self.size and b >= 0 else NOTHING for b, a in places]
        left, above, corner = shown[:3]
        if NOTHING in shown[:3]:
            beside = next((code for code in shown if code != NOTHING), last)
        else:
            beside = sorted((left, above, left + above - corner))[1]
        known = [(line, guess) for line, guess in zip(lines, guesses, strict=True) if line.count >= 3]
        if len(known) == 2:
            (row, first), (column, second) = known
            if abs(first - second) > 1:
                return (first if abs(first - beside) <= abs(second - beside) else second), "some"
            mean = (row.next * row.count + column.next * column.count) / (row.count + column.count)
            return self._code(mean, distance), "high" if row.count + column.count > 16 else "some"
        if known and abs(known[0][1] - beside) <= 1:
            return known[0][1], "high" if known[0][0].count > 8 else "some"
        is_calm = NOTHING not in (left, above) and abs(left - above) <= 8
        return beside, "calm" if is_calm else "low"
