"""Explains exceptions of readers in one sentence each."""

from __future__ import annotations

import errno
import gzip
import re
import zipfile
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from nearfar._base import check
from nearfar._base.errors import SceneError, UnusableError


@contextmanager
def explained(label: str, *, passed: type[Exception] = SceneError) -> Iterator[None]:
    """Convert a reader's exception to a SceneError that names the file and gives the reason in one sentence.

    Lack of memory remains a MemoryError, because it may be the fault of the system: `Budget` refuses files that claim
    too much.
    """
    try:
        yield
    except (SceneError, passed):
        raise
    except Exception as error:
        if isinstance(error, MemoryError) or (isinstance(error, OSError) and error.errno == errno.ENOMEM):
            reason = _first_line(error) or "reading it needs more memory than there is"
            raise MemoryError(f"{label}: {reason}") from error
        raise SceneError(f"{label}: {reason_of(error)}") from error


def reason_of(error: Exception) -> str:
    """Return the reason for an exception of a reader, on one line."""
    return check.one_line(_reason_of(error), _MAX_LENGTH)


def _reason_of(error: Exception) -> str:
    match error:
        case UnusableError():
            return str(error)
        case ModuleNotFoundError(name=name) if name in _DETECTORS:
            return "it is damaged, or its text is in an unknown encoding"
        case ModuleNotFoundError():
            return f"reading it needs the Python package '{error.name}', which is not installed"
        case ImportError():  # for example a shared library for which no address space is left
            return f"reading it needs a library that cannot be loaded ({_first_line(error)})"
        case gzip.BadGzipFile() | EOFError() | zlib.error():
            return f"its compressed data is damaged ({error})"
        case OSError():
            return f"a file that it refers to cannot be read: {Path(str(error.filename or error)).name}"
        case UnicodeDecodeError():
            return f"its text is not in a known encoding ({error.reason} at byte {error.start})"
        case RecursionError():
            return "its parts are nested too deeply"
        case KeyError():
            return f"it lacks an entry that it needs: {error.args[0] if error.args else 'unknown'}"
        case AssertionError():
            return "lengths or offsets in it contradict each other" + (f" ({error})" if str(error) else "")
        case IndexError():
            return "it refers to an item that it does not contain"
        case zipfile.BadZipFile():
            return f"its archive is damaged ({_first_line(error)})"
        case ValueError() | RuntimeError():  # raised by trimesh for unknown versions and formats
            return _reader_sentence(_first_line(error))
        case AttributeError() | TypeError():
            return "one of its entries has the wrong type"
        case _:
            return "it is not well-formed"


def _reader_sentence(reason: str) -> str:
    """Turn the message of a reader's exception into a reason; `_REASONS` replaces messages that are about code."""
    for pattern, template in _REASONS:
        if match := pattern.search(reason):
            reason = template.format(*filter(None, match.groups()))
            break
    return f"it cannot be read: {reason or 'no reason given'}"


def _first_line(error: Exception) -> str:
    return next(iter(str(error).splitlines()), "")


_MAX_LENGTH = 300
"""Greatest number of characters of a reason, which may quote the file."""

_DETECTORS = ("chardet", "charset_normalizer")
"""Packages that trimesh uses to guess the encoding of text that is not UTF-8."""

_REASONS = (
    (
        re.compile(r"could not convert string to \w+: (.+)|invalid literal for [^:]*: (.+)"),
        "{} instead of a number",
    ),
    (
        re.compile(r"reshape array|array element|to unpack|unmatched data|operands could not|inhomogeneous|dimensions"),
        "one of its rows has too few or too many numbers",
    ),
    (re.compile(r"negative seek|buffer is smaller|buffer size|beyond the end"), "it is cut off"),
    (re.compile(r"no field of name (\w+)"), "it lacks an entry that it needs: {}"),
)
"""Patterns of messages of Python and NumPy, with the sentence about the file that replaces them."""
