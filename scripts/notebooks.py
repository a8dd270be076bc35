"""Runs the notebooks and saves them with their outputs: `python scripts/notebooks.py [FOLDER] [NAME ...]`."""

from __future__ import annotations

import sys
import time
from pathlib import Path

import nbformat
from nbclient import NotebookClient

CHECKOUT = Path(__file__).resolve().parent.parent


def main() -> None:
    """Run notebooks/*.ipynb, or those named, in order; the first one that fails stops the run with its error."""
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/notebooks")
    folder.mkdir(parents=True, exist_ok=True)
    candidates = sorted((CHECKOUT / "notebooks").glob("*.ipynb"))
    for path in [path for path in candidates if path.stem in sys.argv[2:]] or candidates:
        started = time.perf_counter()
        notebook = nbformat.read(path, as_version=4)
        # A notebook runs in its own folder, as in an editor.
        resources = {"metadata": {"path": str(path.parent)}}
        NotebookClient(notebook, timeout=600, kernel_name="python3", resources=resources).execute()
        nbformat.write(notebook, folder / path.name)
        print(f"{folder / path.name}: {time.perf_counter() - started:.0f} s", flush=True)


if __name__ == "__main__":
    main()
