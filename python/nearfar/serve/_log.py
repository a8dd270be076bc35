"""The log of servers, on standard error."""

from __future__ import annotations

from nearfar import _core
from nearfar._base import check


def begin(*, as_json: bool = False, level: str = "info") -> bool:
    """Write the log of all servers of this process to standard error from now on.

    Parameters
    ----------
    as_json
        One JSON object a line instead of text.
    level
        Least level: `error`, `warn`, `info` (each answer) or `debug` (connections that broke off).

    Returns
    -------
    bool
        False if a log is written already, which stays as it is.

    Raises
    ------
    ValueError
        For another level.
    """
    return _core.begin_log(
        check.choice("level", level, ("error", "warn", "info", "debug")), check.flag("as_json", as_json)
    )
