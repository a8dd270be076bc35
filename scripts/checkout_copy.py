"""A copy of the checkout in another folder, which may be changed and built while the checkout is in use."""

from __future__ import annotations

import io
import json
import os
import shutil
import signal
import subprocess
import sys
import tarfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from nearfar._base import data

RUST = (".rs", ".wgsl")
"""Suffixes of files that cargo compiles."""
TEST_TIMEOUT = 600
"""Timeout of tests, seconds; some faults make them wait for ever."""
MODULES = ("web", "tests/readers", "tests/exporters")
"""Folders with npm packages."""


class Refused(Exception):  # noqa: N818
    """A fault without a result."""


class Copy:
    """A copy of the checkout, with its build outputs."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        folder.mkdir(parents=True, exist_ok=True)
        python = os.pathsep.join([str(folder / "python"), str(folder)])
        self._environment = os.environ | {"PYTHONPATH": python, "PYTHONDONTWRITEBYTECODE": "1"}
        self._environment["COLUMNS"] = "1000"  # so that pytest does not cut messages
        self._environment |= {"CARGO_TARGET_DIR": str(folder / "target"), "PYO3_PYTHON": sys.executable}
        if root := data.root():
            self._environment["NEARFAR_DATA"] = str(root)

    def fill(self, checkout: Path, content: Mapping[str, tuple[bytes, int]]) -> None:
        """Set the files to `content`; unchanged ones keep their times, by which cargo finds what to compile."""
        listing = self.folder / ".mutations.json"
        previous_names = json.loads(listing.read_text()) if listing.exists() else []
        for name in set(previous_names) - content.keys():
            (self.folder / name).unlink(missing_ok=True)
        for name, (held, mode) in content.items():
            path = self.folder / name
            if not path.is_file() or path.read_bytes() != held:
                path.parent.mkdir(parents=True, exist_ok=True)
                path.write_bytes(held)
                path.chmod(mode)
        listing.write_text(json.dumps(sorted(content)))
        for name in MODULES:
            modules = checkout / name / "node_modules"
            if modules.is_dir() and not (self.folder / name / "node_modules").exists():
                (self.folder / name / "node_modules").symlink_to(modules.resolve())

    def run(self, *command: str, folder: str = ".") -> tuple[int, str]:
        """Run a program; return its status, below 0 if it was stopped, and its output."""
        pipes: dict[str, Any] = {"stdout": subprocess.PIPE, "stderr": subprocess.STDOUT, "errors": "replace"}
        process_settings: dict[str, Any] = {
            "cwd": self.folder / folder,
            "env": self._environment,
            "start_new_session": True,
        }
        process = subprocess.Popen(command, **pipes, **process_settings)
        try:
            output, _ = process.communicate(timeout=TEST_TIMEOUT)
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, signal.SIGKILL)
            output, _ = process.communicate()
            return -1, output
        return process.returncode, output

    def must(self, *command: str, folder: str = ".") -> None:
        """Run a program that must succeed; Refused otherwise."""
        status, output = self.run(*command, folder=folder)
        if status:
            raise Refused(f"does not build: {' '.join(command)}: {output.strip()[-400:]}")

    def build(self, suffix: str) -> None:
        """Build the component that files with a suffix belong to."""
        if suffix in RUST:
            self.must("cargo", "build", "--quiet", "--profile", "quick", "-p", "nearfar-module")
            new = self.folder / "python" / "nearfar" / "_core.abi3.so.new"
            shutil.copy(self.folder / "target" / "quick" / "lib_core.so", new)
            new.replace(new.with_suffix(""))
        elif suffix == ".ts":
            self.must("npx", "tsc", "--noEmit", folder="web")
            self.must("node", "build.mjs", folder="web")
            self.must("node", "build.mjs", "--tests", "build/tests", folder="web")
        else:
            self.must(sys.executable, "-c", f"import nearfar; assert nearfar.__file__.startswith({str(self.folder)!r})")


def content_at(checkout: Path, commit: str | None) -> dict[str, tuple[bytes, int]]:
    """Bytes and mode of each file of a commit, or of the working tree without ignored files."""
    git = ["git", "-C", str(checkout)]
    if commit:
        archive = subprocess.run([*git, "archive", commit], check=True, capture_output=True).stdout
        with tarfile.open(fileobj=io.BytesIO(archive)) as files:
            members = [(member, files.extractfile(member)) for member in files if member.isfile()]
            return {member.name: (file.read(), member.mode) for member, file in members if file}
    listed = subprocess.run([*git, "ls-files", "-coz", "--exclude-standard"], check=True, capture_output=True).stdout
    paths = {name: checkout / name for name in listed.decode().split("\0") if name}
    return {name: (path.read_bytes(), path.stat().st_mode & 0o777) for name, path in paths.items() if path.is_file()}
