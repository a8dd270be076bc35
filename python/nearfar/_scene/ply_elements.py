"""Elements of PLY files: their header, and their properties as arrays, from text and binary data of either byte order.

Source: G. Turk, The PLY Polygon File Format.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from nearfar import _core
from nearfar._base import check
from nearfar._base.errors import SceneError, UnusableError

_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4"}
_TYPES |= {"int8": "i1", "uint8": "u1", "int16": "i2", "uint16": "u2", "int32": "i4", "uint32": "u4"}
_TYPES |= {"float": "f4", "float32": "f4", "double": "f8", "float64": "f8"}
_TYPES |= {"int64": "i8", "uint64": "u8", "float16": "f2"}
"""NumPy types; files use the last three although the format does not define them."""
_LENGTHS = frozenset(_TYPES.values()) - {"f2"}
"""Types that may state the length of a list."""

_MAX_DIGITS = 18
"""Maximum number of digits of a row count, so that it fits into 64 bits."""

_MAX_WHOLE = 2.0**53
"""Magnitude below which integers are exact in float64, the type of numbers in text."""

_BYTE_ORDERS = {"ascii": "=", "binary_little_endian": "<", "binary_big_endian": ">"}


@dataclass(frozen=True)
class Lists:
    """Values of a list property."""

    values: NDArray[np.generic]
    """Values of all rows."""
    offsets: NDArray[np.int64]
    """Row r has the values from ``offsets[r]`` to ``offsets[r + 1]``."""


@dataclass(frozen=True)
class _Property:
    name: str
    kind: str
    """NumPy type, without byte order."""
    count_kind: str
    """NumPy type of a list's length; empty for a scalar."""


@dataclass
class Element:
    """Rows of one kind, such as vertices."""

    name: str
    count: int
    """Number of rows."""
    properties: list[_Property] = field(default_factory=list)
    scalars: dict[str, NDArray[np.generic]] = field(default_factory=dict)
    """Values (R,) of scalar properties by name."""
    lists: dict[str, Lists] = field(default_factory=dict)


@dataclass
class Ply:
    """Content of a PLY file."""

    elements: dict[str, Element]
    texture: str = ""
    """Name of the texture's file, from a comment; empty for none."""


def parse(data: bytes) -> Ply:
    """Read a file; UnusableError if it is damaged."""
    ply, order, start = _header(data)
    is_text = order == "="
    body = _numbers(data[start:]) if is_text else data[start:]
    reader, end = _Reader(body, order, is_text), 0
    for element in ply.elements.values():
        end = reader.read(element, end)
    return ply


def _header(data: bytes) -> tuple[Ply, str, int]:
    """Parse the header; return the elements without rows, the byte order, and the offset of the data."""
    ending = next((ending for ending in (b"\r\n", b"\n", b"\r") if data[3:].lstrip(b" \t").startswith(ending)), b"")
    if not ending or not data.startswith(b"ply"):
        raise UnusableError("it does not begin like a PLY file")
    offset, ply, order = data.index(ending) + len(ending), Ply({}), ""
    element: Element | None = None
    while True:
        end = data.find(ending, offset)
        line = data[offset : len(data) if end < 0 else end].decode(errors="replace").strip()
        offset = len(data) if end < 0 else end + len(ending)
        match line.split():
            case ["end_header", *_] if order:
                return ply, order, offset
            case ["format", name, *_] if name in _BYTE_ORDERS:
                order = _BYTE_ORDERS[name]
            case ["comment" | "obj_info", "TextureFile", *_]:
                ply.texture = line.partition("TextureFile")[2].strip()
            case ["comment" | "obj_info", *_] | []:
                pass
            case ["element", name, number] if _is_count(number) and name not in ply.elements:
                element = ply.elements[name] = Element(name, int(number))
            case ["property", "list", count_kind, kind, name] if element is not None and _type(count_kind) in _LENGTHS:
                element.properties.append(_Property(name, _type(kind), _type(count_kind)))
            case ["property", kind, name] if element is not None:
                element.properties.append(_Property(name, _type(kind), ""))
            case _:
                raise UnusableError(f"its header has the line {check.shortened(line)}")
        if end < 0:
            raise UnusableError("its header has no end")


def _is_count(number: str) -> bool:
    return number.isdecimal() and len(number) <= _MAX_DIGITS


def _type(name: str) -> str:
    if name not in _TYPES:
        raise UnusableError(f"its header has the unknown type {check.shortened(name)}")
    return _TYPES[name]


def _numbers(text: bytes) -> bytes:
    """Convert text to binary numbers of type float64."""
    try:
        return _core.parse_numbers(text).tobytes()
    except SceneError as error:
        raise UnusableError(str(error)) from None


class _Reader:
    """Reads rows from binary data; for a text file these are its numbers as float64."""

    def __init__(self, data: bytes, order: str, is_text: bool) -> None:
        self._data, self._order, self._is_text = data, order, is_text

    def read(self, element: Element, start: int) -> int:
        """Read the rows of an element from a byte on; return the end."""
        properties = element.properties
        if not element.count or not properties:
            for prop in properties:
                self._store(element, prop, np.zeros((0,), self._dtype(prop.kind)), np.zeros(1, np.int64))
            return start
        end = self._equal_rows(element, start)
        return self._rows(element, start) if end is None else end

    def _dtype(self, kind: str) -> np.dtype[np.generic]:
        """Type of a number in the data."""
        return np.dtype("f8") if self._is_text else np.dtype(self._order + kind)

    def _store(self, element: Element, prop: _Property, values: NDArray[np.generic], ends: NDArray[np.int64]) -> None:
        """Store a column as its declared type; `ends` are a list's offsets.

        Integers in lists of a text are indices: they are not clipped; NaN and inexact ones become −1.
        """
        if self._is_text and prop.kind[0] != "f" and prop.count_kind:
            is_whole = np.abs(values) < _MAX_WHOLE
            element.lists[prop.name] = Lists(np.where(is_whole, values, -1.0).astype(np.int64), ends)
            return
        if self._is_text and prop.kind[0] != "f":
            # Values out of range become the nearest ones.
            limits = np.iinfo(prop.kind)
            values = np.clip(np.nan_to_num(values.astype(np.float64)), limits.min, limits.max)
        values = values.astype(prop.kind, copy=False)
        if prop.count_kind:
            element.lists[prop.name] = Lists(values, ends)
        else:
            element.scalars[prop.name] = values

    def _equal_rows(self, element: Element, start: int) -> int | None:
        """Read rows whose lists are as long as the first row's, and return the end; None if lengths differ."""
        offset, columns = start, []
        for prop in element.properties:
            length = 1
            if prop.count_kind:
                kind = self._dtype(prop.count_kind)
                length = self._length(kind, offset)
                columns.append((prop, kind, offset, -1))
                offset += kind.itemsize
            columns.append((prop, self._dtype(prop.kind), offset, length))
            offset += length * self._dtype(prop.kind).itemsize
        stride, rows = offset - start, element.count
        if start + rows * stride > len(self._data):
            if any(prop.count_kind for prop in element.properties):
                return None
            raise UnusableError(f"it is cut off in element {check.shortened(element.name)}")
        for prop, kind, first, length in columns:
            shape, strides = (rows, max(length, 1)), (stride, kind.itemsize)
            values = np.ndarray(shape, kind, self._data, first, strides) if length else np.zeros((rows, 0), kind)
            if length < 0 and (values != values[0]).any():
                element.lists.clear()
                return None
            if length >= 0:
                self._store(element, prop, values.ravel(), np.arange(rows + 1) * length)
        return start + rows * stride

    def _rows(self, element: Element, start: int) -> int:
        """Read rows whose lists differ in length; return the end."""
        properties = [
            (self._dtype(prop.kind).itemsize, self._dtype(prop.count_kind).str[1:] if prop.count_kind else "")
            for prop in element.properties
        ]
        try:
            columns, end = _core.read_ply_rows(self._data, start, element.count, properties, self._order == ">")
        except SceneError as error:
            raise UnusableError(f"{error} in element {check.shortened(element.name)}") from None
        for prop, (octets, offsets) in zip(element.properties, columns, strict=True):
            self._store(element, prop, octets.view(self._dtype(prop.kind)), offsets)
        return end

    def _length(self, kind: np.dtype[np.generic], start: int) -> int:
        """Length of a list, stated at a byte."""
        if start + kind.itemsize > len(self._data):
            raise UnusableError("it is cut off")
        length = float(np.frombuffer(self._data, kind, 1, start)[0])
        if not 0 <= length <= len(self._data):
            raise UnusableError(f"it has a list of {length:g} numbers")
        return int(length)
