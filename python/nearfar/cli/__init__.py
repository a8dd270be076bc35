"""The command line: `nearfar demo | info | partition | bake | reduce | render | compare | lod | stereo | … | view`.

User errors print one sentence on standard error and exit with status 1 (2 for a command line that cannot be read); a
traceback is a bug of nearfar.
"""

from __future__ import annotations

import sys

__all__ = ["main"]


def main() -> None:
    """Run the command given by the arguments, and exit with its status."""
    # Imported late, so that `import nearfar.cli` does not load typer and rich.
    from nearfar.cli._app import run

    sys.exit(run(sys.argv[1:]))
