"""Log of all servers, on standard error."""

from __future__ import annotations

from nearfar import _core
from nearfar._base import check


def begin(*, as_json: bool = False, level: str = "info") -> bool:
    """Start writing the log of all servers of this process to standard error.

    Parameters
    ----------
    as_json
        Whether to write one JSON object per line instead of text.
    level
        Least level: `error`, `warn`, `info` (each response) or `debug` (broken connections).

    Returns
    -------
    bool
        False if logging was started already; it continues unchanged.

    Raises
    ------
    ValueError
        For another level.
    """
    return _core.begin_log(
        check.choice("level", level, ("error", "warn", "info", "debug")), check.flag("as_json", as_json)
    )
