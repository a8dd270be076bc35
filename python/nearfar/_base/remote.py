"""Access to URLs through fsspec, and local paths given as URLs."""

from __future__ import annotations

import errno
import importlib.util
import os
import urllib.parse
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from nearfar._base import check

LOCAL = ("file://", "local://")
"""Prefixes of URLs of local paths."""

READ_ONLY = {"http", "https"}
"""Schemes of web URLs, which fsspec reads over HTTP and cannot write."""

HTTP_PACKAGES = "'fsspec[http]'"
"""Package with which fsspec reads web URLs, as an argument of pip."""


def is_url(path: object) -> bool:
    """Return whether a path is a URL, such as https://… or s3://…; file://… is a local path."""
    return isinstance(path, str) and "://" in path and not path.startswith(LOCAL)


def local(path: str | os.PathLike[str]) -> Path:
    """Convert a local path or file:// URL to a path; ValueError or TypeError if it is invalid."""
    if isinstance(path, str) and path.startswith(LOCAL):
        kind, _, path = path.partition("://")
        # `Path.as_uri` escapes spaces and non-ASCII letters; fsspec's "local" has unescaped paths.
        path = urllib.parse.unquote(path) if kind == "file" else path
    return check.path("path", path)


def system(url: str) -> tuple[Any, str]:
    """Return the file system of a URL, and the path in it."""
    check.text("path", url)
    is_web = url.partition("://")[0] in READ_ONLY
    if not importlib.util.find_spec("fsspec"):
        command = f"pip install {HTTP_PACKAGES if is_web else 'fsspec'}"
        raise ValueError(f"path: expected a folder, or fsspec installed ({command}), got {check.shortened(url)}")
    import fsspec

    try:
        file_system, path = fsspec.core.url_to_fs(url)
    except ImportError as error:
        needed = f"pip install {HTTP_PACKAGES}" if is_web else check.one_line(str(error), 180)
        raise ValueError(
            f"path: expected the package that fsspec needs for this URL ({needed}), got {check.shortened(url)}"
        ) from None
    except Exception as error:  # each file system has its own errors
        raise ValueError(
            f"path: expected a URL that fsspec can open, got {check.shortened(url)}: {check.one_line(str(error), 180)}"
        ) from None
    if not path.strip("/"):
        raise ValueError(f"path: expected a URL with a folder, got {check.shortened(url)}")
    return file_system, path.rstrip("/")


@contextmanager
def as_os_errors(url: str, deed: str) -> Iterator[None]:
    """Convert exceptions of file system libraries to OSError with the URL; a missing file raises FileNotFoundError.

    MemoryError remains one.
    """
    try:
        yield
    except MemoryError:
        raise
    except FileNotFoundError:
        raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), url) from None
    except Exception as error:
        reason = check.one_line(str(error), 180) or type(error).__name__
        code = getattr(error, "errno", None) or errno.EIO
        raise OSError(code, f"cannot be {deed}: {reason}", url) from error
