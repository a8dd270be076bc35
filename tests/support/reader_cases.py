"""Runs other programs' readers: scripts in Node, and a page in headless Chromium. They lie in tests/readers."""

from __future__ import annotations

import contextlib
import json
import os
import queue
import shutil
import signal
import subprocess
import time
from collections.abc import Iterable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from tests.support.range_server import RangeHandler, running

FOLDER = Path(__file__).resolve().parents[1] / "readers"
EXPORTERS = FOLDER.with_name("exporters")
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
SECONDS = 300
"""Timeout of a program in seconds."""

# WebGL 2 without a graphics card.
SOFTWARE = "--use-angle=swiftshader --enable-unsafe-swiftshader"
DRAWING = os.environ.get("NEARFAR_BROWSER_DRAWING", SOFTWARE)
"""Drawing flags of browsers; for a graphics card "--use-gl=angle --use-angle=gl-egl --ignore-gpu-blocklist"."""

BROWSER_FLAGS = (
    "--headless",
    "--no-sandbox",
    "--no-first-run",
    "--disable-quic",
    "--disable-sync",
    "--disable-dev-shm-usage",
    "--disable-background-networking",
    "--disable-component-update",
    *DRAWING.split(),
)


def no_node() -> str:
    """Return why scripts cannot run in Node, or "" if they can."""
    if not shutil.which("node"):
        return "node is not installed"
    return "" if (FOLDER / "node_modules").is_dir() else "`npm ci --prefix tests/readers` has not run"


def no_exporters() -> str:
    """Return why exporters cannot run in Node, or "" if they can."""
    if not shutil.which("node"):
        return "node is not installed"
    return "" if (EXPORTERS / "node_modules").is_dir() else "`npm ci --prefix tests/exporters` has not run"


def no_blender() -> str:
    """Return why models cannot be exported from Blender, or "" if they can; its operators change with its version."""
    if not shutil.which("blender"):
        return "Blender is not installed; see scripts/system-packages.sh"
    command = ["blender", "--version"]
    found = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False).stdout
    return "" if found.startswith("Blender 3.") else f"Blender 3 is needed, found {found.partition(chr(10))[0]!r}"


def no_web() -> str:
    """Return why the page cannot be built, or "" if it can."""
    if not shutil.which("npx"):
        return "npm is not installed"
    return "" if (FOLDER.parents[1] / "web" / "node_modules").is_dir() else "`npm ci --prefix web` has not run"


def no_browser() -> str:
    """Return why pages cannot be shown, or "" if they can."""
    return no_node() if browser() else f"there is no {' or '.join(BROWSERS)}; see scripts/system-packages.sh"


def browser() -> str | None:
    """The path of a browser, if there is one."""
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def node(script: str, given: Iterable[Path | str]) -> dict[str, Any]:
    """The JSON that a script prints about files and other arguments."""
    command = ["node", str(FOLDER / script), *map(str, given)]
    process = subprocess.run(command, capture_output=True, text=True, timeout=SECONDS, check=False)
    assert process.returncode == 0, process.stderr
    answer: dict[str, Any] = json.loads(process.stdout)
    return answer


class _Handler(RangeHandler):
    """Serves a folder of pages, and bundles below /bundles; receives the page's answer."""

    def __init__(
        self,
        *request: Any,
        pages: Path,
        job: bytes,
        bundles: Mapping[str, Path],
        answers: queue.Queue[bytes],
        **kept: Any,
    ) -> None:
        self._job, self._bundles, self._answers = job, bundles, answers
        super().__init__(*request, directory=str(pages), **kept)

    def translate_path(self, path: str) -> str:
        parts = path.split("/")
        if parts[1] == "bundles":
            return str(self._bundles[parts[2]].joinpath(*parts[3:]))
        return super().translate_path(path)

    def do_GET(self) -> None:  # noqa: N802 - the base class's name
        if self.path == "/job.json":
            self._reply(self._job, "application/json")
        else:
            super().do_GET()

    def do_POST(self) -> None:  # noqa: N802
        self._answers.put(self.rfile.read(int(self.headers["Content-Length"])))
        self._reply(b"", "text/plain")

    def _reply(self, content: bytes, kind: str) -> None:
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)


def in_browser(bundles: Mapping[str, Path], views: Mapping[str, dict[str, Any]], folder: Path) -> dict[str, Any]:
    """The parts of bundles that three.js and 3d-tiles-renderer load, by the bundles' names.

    Parameters
    ----------
    bundles
        Folders by name.
    views
        For each the `eye` and `target` in metres, `size` in pixels and the vertical `angle` in degrees of a picture.
    folder
        An empty folder for the browser's profile.
    """
    described = [
        {"name": name, "place": f"/bundles/{name}", "files": _glbs(path), "view": views[name]}
        for name, path in bundles.items()
    ]
    return answer_of("page.mjs", {"bundles": described}, folder, bundles)


def answer_of(
    module: str, job: Mapping[str, Any], folder: Path, folders: Mapping[str, Path] | None = None, pages: Path = FOLDER
) -> dict[str, Any]:
    """The answer posted to /result by a module that page.html loads and that reads its job from /job.json.

    Parameters
    ----------
    module, job
        The module's name, and its job.
    folder
        An empty folder for the browser's profile.
    folders
        Folders that the module finds by these names below /bundles.
    pages
        The folder of page.html.
    """
    answers: queue.Queue[bytes] = queue.Queue()
    handler = partial(_Handler, pages=pages, job=json.dumps(job).encode(), bundles=folders or {}, answers=answers)
    with running(handler) as url:
        answer = _answers_of_page(f"{url}page.html?{module}", answers, folder)
    assert "error" not in answer, answer["error"]
    return answer


def _glbs(bundle: Path) -> list[str]:
    return sorted(f"files/{path.name}" for path in (bundle / "files").glob("*.glb"))


def _answers_of_page(url: str, answers: queue.Queue[bytes], folder: Path) -> dict[str, Any]:
    """Show a page until it answers."""
    program = browser()
    assert program
    with (folder / "log").open("w") as log:
        command = [program, *BROWSER_FLAGS, f"--user-data-dir={folder / 'profile'}", url]
        process = subprocess.Popen(command, stdout=log, stderr=log, start_new_session=True)
        try:
            deadline = time.monotonic() + SECONDS
            while True:
                try:
                    answer: dict[str, Any] = json.loads(answers.get(timeout=1))
                    return answer
                except queue.Empty:
                    is_over = process.poll() is not None or time.monotonic() > deadline
                    assert not is_over, f"no answer from {program}: {(folder / 'log').read_text()[-2000:]}"
        finally:
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)
            process.wait()
