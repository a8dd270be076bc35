"""Location of data files for tests and demonstrations, which are not part of the repository."""

from __future__ import annotations

import os
from pathlib import Path

from nearfar._base import check


def root() -> Path | None:
    """Return the data folder; None if there is none.

    The folder is `NEARFAR_DATA` if set, else the nearest `shared/data` above this file, else above the working
    directory.
    """
    path = os.environ.get("NEARFAR_DATA", "").strip()
    if path:
        return Path(path).expanduser()
    for start in (Path(__file__).resolve().parent, Path.cwd()):
        for folder in (start, *start.parents):
            if (folder / "shared" / "data").is_dir():
                return folder / "shared" / "data"
    return None


def find(relative: str) -> Path | None:
    """Return the path of a file or folder in the data folder, such as "city/tokyo_core_lod1.glb"; None if missing."""
    folder, path = root(), check.path("relative", relative)
    try:
        return folder / path if folder is not None and (folder / path).exists() else None
    except OSError:  # a name too long for the file system
        return None


def require(relative: str) -> Path:
    """Like `find`, but raises FileNotFoundError, which names the folder, if the file is missing."""
    path = find(relative)
    if path is None:
        folder = root()
        reason = f"not in {folder}" if folder else "there is no folder shared/data above the checkout"
        raise FileNotFoundError(f"{relative}: expected a data file, but {reason}; NEARFAR_DATA names another folder")
    return path
