"""Checks of arguments: each error message names the argument, the expected value and the actual one."""

from nearfar._base.check.arrays import FARTHEST, array, box, not_finite, output, plain, spheres, vector
from nearfar._base.check.describe import described, one_line, printable, shortened, shown
from nearfar._base.check.names import choice, instance, items, iterable, mapping, path, text, texts
from nearfar._base.check.numbers import (
    MAX_SIZE,
    at_least_zero,
    flag,
    integer,
    number,
    pair,
    positive,
    radii,
    size,
    within,
)

__all__ = [
    "FARTHEST",
    "MAX_SIZE",
    "array",
    "at_least_zero",
    "box",
    "choice",
    "described",
    "flag",
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
    "shown",
    "size",
    "spheres",
    "text",
    "texts",
    "vector",
    "within",
]
