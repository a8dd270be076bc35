"""The command line: `nearfar demo | info | partition | bake | reduce | render | compare | lod | stereo | … | view`.

User errors print one sentence on standard error and exit with status 1 (2 for a command line that cannot be read); a
traceback is a bug of nearfar.
"""

from __future__ import annotations

import os
import signal
import sys
import threading

__all__ = ["main"]


def main() -> None:
    """Run the command given by the arguments, and exit with its status."""
    catches_signals = threading.current_thread() is threading.main_thread()
    # An exception in the middle of an import could become another one, such as an ImportError.
    if catches_signals and signal.getsignal(signal.SIGINT) is signal.default_int_handler:
        signal.signal(signal.SIGINT, _end)
    # Imported late, so that `import nearfar.cli` does not load typer and rich.
    from nearfar.cli._app import run

    if catches_signals and signal.getsignal(signal.SIGINT) is _end:
        signal.signal(signal.SIGINT, signal.default_int_handler)
    sys.exit(run(sys.argv[1:]))


def _end(*_: object) -> None:
    """End the process at once: there is nothing to clean up before a command begins."""
    os.write(2, b"nearfar: interrupted\n")
    os._exit(128 + signal.SIGINT)
