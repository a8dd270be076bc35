"""Checks of arguments: each error message names the argument, the expected value and the actual one."""

from nearfar._base.check.arrays import FARTHEST, array, box, counts, not_finite, output, plain, spheres, vector
from nearfar._base.check.describe import one_line, printable, shortened, type_and_value, value_or_type
from nearfar._base.check.names import choice, instance, items, iterable, mapping, path, text, texts
from nearfar._base.check.numbers import (
    MAX_SIZE,
    at_least_zero,
    flag,
    in_range,
    integer,
    number,
    pair,
    positive,
    radii,
    size,
)

__all__ = [
    "FARTHEST",
    "MAX_SIZE",
    "array",
    "at_least_zero",
    "box",
    "choice",
    "counts",
    "flag",
    "in_range",
    "instance",
    "integer",
    "items",
    "iterable",
    "mapping",
    "not_finite",
    "number",
    "one_line",
    "output",
    "pair",
    "path",
    "plain",
    "positive",
    "printable",
    "radii",
    "shortened",
    "size",
    "spheres",
    "text",
    "texts",
    "type_and_value",
    "value_or_type",
    "vector",
]
