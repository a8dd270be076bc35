"""Loads files that claim too much in a separate process, and returns the errors and memory."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

from tests.support import PEAK


def refused_twice(path: Path) -> tuple[str, str, int]:
    """Return the errors under the default limit of bytes and under one of 2⁵⁰, and the bytes by which memory grew."""
    code = f"{PEAK}\nimport sys, nearfar as nf\nstart = peak()\nfor most in (None, 1 << 50):\n"
    code += "    try: nf.Scene.load(sys.argv[1], max_bytes=most)\n"
    code += "    except nf.SceneError as error: print(error)\nprint(peak() - start)"
    environment = os.environ | {"PYTHONPATH": os.pathsep.join(sys.path)}
    command = [sys.executable, "-c", code, str(path)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=600, check=True, env=environment)
    first, second, more = done.stdout.splitlines()
    return first, second, int(more)
