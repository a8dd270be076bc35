"""Build backend: maturin, after a check for cargo with a one-sentence message if it is missing or too old.

As a script it only checks. Maturin alone would try to download a Rust toolchain without asking.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

Settings = dict[str, Any] | None


def require_cargo() -> None:
    """Exit with a message unless cargo is installed and new enough; Cargo.toml states the minimum version."""
    manifest = (Path(__file__).resolve().parent.parent / "Cargo.toml").read_text(encoding="utf-8")
    stated = re.search(r'^rust-version = "([\d.]+)"', manifest, re.MULTILINE)
    least = stated.group(1) if stated else "1.89"
    remedy = f"install Rust {least} or newer from https://rustup.rs and try again"
    if not shutil.which("cargo"):
        sys.exit(f"nearfar: building from source needs cargo, which is not on the PATH; {remedy}")
    output = subprocess.run(["cargo", "--version"], capture_output=True, text=True, check=False).stdout
    version = re.match(r"cargo (\d+)\.(\d+)", output)
    if not version:
        sys.exit(f"nearfar: building from source needs cargo, but `cargo --version` says {output.strip()!r}; {remedy}")
    if (int(version[1]), int(version[2])) < tuple(int(part) for part in least.split(".")[:2]):
        sys.exit(f"nearfar: building from source needs cargo {least}, but found {version[1]}.{version[2]}; {remedy}")


def get_requires_for_build_wheel(config_settings: Settings = None) -> list[str]:
    """Return no requirements beyond those in pyproject.toml; see PEP 517 and, for editable builds, PEP 660."""
    require_cargo()
    return []


get_requires_for_build_editable = get_requires_for_build_sdist = get_requires_for_build_wheel


def _hook(name: str) -> Callable[..., str]:
    """Return a hook of a build backend, which calls maturin's after the check for cargo."""

    def run(*arguments: Any, **settings: Any) -> str:
        require_cargo()
        return str(getattr(_maturin(), name)(*arguments, **settings))

    return run


prepare_metadata_for_build_wheel = _hook("prepare_metadata_for_build_wheel")
prepare_metadata_for_build_editable = _hook("prepare_metadata_for_build_editable")
build_wheel, build_editable, build_sdist = map(_hook, ("build_wheel", "build_editable", "build_sdist"))


def _maturin() -> Any:
    # Imported late, because the check must run before maturin is installed. Maturin's Python part searches PATH for its
    # program, which is missing there if the environment is not activated.
    import maturin

    os.environ["PATH"] = os.pathsep.join([str(Path(sys.executable).parent), os.environ.get("PATH", "")])
    return maturin


if __name__ == "__main__":
    require_cargo()
