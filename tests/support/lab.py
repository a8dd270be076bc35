"""A running JupyterLab, and one notebook in it, driven by Playwright."""

from __future__ import annotations

import base64
import io
import json
import os
import queue
import subprocess
import sys
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import nbformat
import numpy as np
from numpy.typing import NDArray

from tests.support.reader_cases import SECONDS

READY = "() => window.jupyterapp?.shell.currentWidget?.sessionContext?.session?.kernel?.status === 'idle'"

RUN = """async (number) => {
  const panel = window.jupyterapp.shell.currentWidget;
  panel.content.activeCellIndex = number;
  await window.jupyterapp.commands.execute('notebook:run-cell');
  const cell = panel.content.widgets[number].model;
  return cell.outputs.toJSON();
}"""

VIEWS = """() => [...document.querySelectorAll('.nearfar-view')].map((host) => {
  const { arrived, isLoading, shown } = host.nearfar?.viewer?.facts ?? {};
  return { arrived, isLoading, ring: shown?.ring };
})"""

PHOTO = """async (number) => {
  const host = document.querySelectorAll('.nearfar-view')[number];
  const blob = await host.nearfar.viewer.photo();
  const bytes = new Uint8Array(await blob.arrayBuffer());
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(''));
}"""


@contextmanager
def server(folder: Path) -> Iterator[str]:
    """Run JupyterLab for the notebooks of a folder; yields its address. It writes nothing elsewhere."""
    names = ("JUPYTER_CONFIG_DIR", "JUPYTER_DATA_DIR", "JUPYTER_RUNTIME_DIR", "IPYTHONDIR", "JUPYTERLAB_SETTINGS_DIR")
    homes = {name: str(folder / ".jupyter" / name.lower()) for name in (*names, "JUPYTERLAB_WORKSPACES_DIR")}
    line = [sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ServerApp.port=0"]
    line += ["--ServerApp.ip=127.0.0.1", "--IdentityProvider.token=", f"--ServerApp.root_dir={folder}"]
    line += ["--LabApp.expose_app_in_browser=True", "--LabApp.news_url=None"]
    with subprocess.Popen(
        line, stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True, env=os.environ | homes
    ) as program:
        try:
            yield _address(program)
        finally:
            program.terminate()
            try:
                program.wait(timeout=30)
            except subprocess.TimeoutExpired:
                program.kill()


def _address(program: subprocess.Popen[str]) -> str:
    """The address that the server prints; AssertionError with its whole output if there is none."""
    lines: queue.Queue[str] = queue.Queue()

    def read() -> None:
        assert program.stderr
        for line in program.stderr:
            lines.put(line)
        lines.put("")

    threading.Thread(target=read, daemon=True).start()
    told, deadline = "", time.monotonic() + SECONDS
    while time.monotonic() < deadline:
        line = lines.get(timeout=SECONDS)
        told += line
        if "http://127.0.0.1:" in line:
            return "http://127.0.0.1:" + line.split("http://127.0.0.1:")[1].split("/")[0]
        if not line:
            break
    raise AssertionError(f"JupyterLab does not start: {told}")


class Notebook:
    """A notebook in a page of the browser."""

    def __init__(self, page: Any, url: str, folder: Path, cells: Sequence[str]) -> None:
        self.page = page
        document = nbformat.v4.new_notebook(cells=[nbformat.v4.new_code_cell(cell) for cell in cells])
        # Otherwise JupyterLab asks for it.
        document.metadata["kernelspec"] = {"name": "python3", "display_name": "Python 3", "language": "python"}
        nbformat.write(document, folder / "notebook.ipynb")
        page.goto(f"{url}/lab/tree/notebook.ipynb", timeout=SECONDS * 1e3)
        page.wait_for_function(READY, timeout=SECONDS * 1e3)

    def run(self, number: int) -> str:
        """Run a cell; returns its printed text. AssertionError with the traceback of an error."""
        outputs = self.page.evaluate(RUN, number)
        assert not any(output["output_type"] == "error" for output in outputs), json.dumps(outputs)[:4000]
        return "".join("".join(output.get("text", "")) for output in outputs)

    def photo(self, number: int = 0) -> NDArray[np.uint8]:
        """The picture (H, W, 3) of a view."""
        from PIL import Image

        data = base64.b64decode(self.page.evaluate(PHOTO, number))
        return np.asarray(Image.open(io.BytesIO(data)).convert("RGB"))

    def until(self, condition: str) -> None:
        """Wait for a condition in the page."""
        from playwright.sync_api import TimeoutError as Late

        try:
            self.page.wait_for_function(condition, timeout=SECONDS * 1e3)
        except Late:
            views, printed = self.page.evaluate(VIEWS), getattr(self.page, "printed", [])
            raise AssertionError(f"it does not happen: {condition}; views: {views}; printed: {printed}") from None
