"""The command line: `nearfar demo | info | partition | bake | render`.

Of the stages it uses the public face only, and of the policies how files are written and headed. A user's mistake is
one sentence on standard error and exit status 1 (2 for a wrong command line); a traceback is a bug of ours.
"""

from __future__ import annotations

import sys

__all__ = ["main"]


def main() -> None:
    """Run the command that the arguments name, and leave with its status."""
    # Imported here: `import nearfar.cli` alone must not load typer and rich.
    from nearfar.cli._app import run

    sys.exit(run(sys.argv[1:]))
