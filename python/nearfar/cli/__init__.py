"""The command line: `nearfar demo | info | partition | bake | reduce | render | compare | lod | stereo | … | view`.

A user's mistake prints one sentence on standard error and ends with exit status 1 (2 for a wrong command line); a
traceback is a bug of nearfar.
"""

from __future__ import annotations

import sys

__all__ = ["main"]


def main() -> None:
    """Run the command that the arguments name, and exit with its status."""
    # A late import, so that `import nearfar.cli` alone does not load typer and rich.
    from nearfar.cli._app import run

    sys.exit(run(sys.argv[1:]))
