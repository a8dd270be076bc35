"""One line about skipped tests: their number, their requirements, and the command that installs these."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable

INSTALLERS = {
    "sudo scripts/system-packages.sh": {
        *("adapter", "assimp", "blender", "browser", "exporters", "gl", "glslang", "node", "pyrender", "vulkan", "web")
    },
    "NEARFAR_DATA=FOLDER": {"data", "tokyo"},
    "a checkout with git": {"git"},
    "another system": {"fork", "linux", "link"},
}
"""Commands, or requirements, and the parts that they provide; `make setup` provides all other parts."""


def untested(reasons: Iterable[str]) -> str:
    """Describe skipped tests by the reasons that pytest reports for them; "" if none was skipped."""
    counts = Counter(_part(reason) for reason in reasons)
    if not counts:
        return ""
    parts = ", ".join(f"{part} ({count})" for part, count in counts.most_common())
    installers = sorted({_installer(part) for part in counts}, key=[*INSTALLERS, "make setup"].index)
    return f"not tested: {sum(counts.values()):,}, which need {parts}; to test them: {', '.join(installers)}"


def _part(reason: str) -> str:
    found = re.match(r"Skipped: (\w+): ", reason)
    return found[1] if found else reason.removeprefix("Skipped: ")


def _installer(part: str) -> str:
    return next((command for command, parts in INSTALLERS.items() if part in parts), "make setup")
