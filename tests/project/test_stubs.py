"""Tests that the stub of the compiled module agrees with the binary, name by name and argument by argument."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

CHECKOUT = Path(__file__).resolve().parents[2]


# pyo3 defines __all__ with all names; ruff forbids star imports. The stub has parts, the binary has none.
DIFFERENCES = "\n".join(f"nearfar\\._core\\.{name}" for name in ("__all__", "files", "gpu", "headset", "orthoview"))


@pytest.mark.slow
def test_the_stub_matches_the_binary(tmp_path: Path) -> None:
    allowed = tmp_path / "allowed.txt"
    allowed.write_text(DIFFERENCES)
    options = ["--mypy-config-file", "pyproject.toml", "--concise", "--allowlist", str(allowed)]
    process = subprocess.run(
        [sys.executable, "-m", "mypy.stubtest", "nearfar._core", *options],
        cwd=CHECKOUT,
        capture_output=True,
        text=True,
        timeout=300,
        check=False,
    )
    assert process.returncode == 0, process.stdout + process.stderr
