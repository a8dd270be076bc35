"""Peers that cannot be installed in this environment, run as processes: one line in, one line out."""

from __future__ import annotations

import functools
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
from numpy.typing import NDArray

from benchmarks.harness.compare import Case

FOLDER = Path(__file__).resolve().parent / "peers"

CHECKOUT = FOLDER.parents[2]


@contextmanager
def sphere_peers(points: NDArray[np.float64], *names: str) -> Iterator[list[Case]]:
    """Exact solvers with the points loaded; those that cannot be built here are reported and left out.

    Their times include a line to the process and one back, some ten microseconds.
    """
    commands = {"cyminiball": cyminiball, "miniball crate": miniball_crate}
    with TemporaryDirectory() as folder:
        file = Path(folder) / "points.f64"
        points.astype(np.float64).tofile(file)
        workers, cases = [], []
        for name in names:
            try:
                command = commands[name]()
            except (subprocess.CalledProcessError, FileNotFoundError) as error:
                print(f"{name} is left out: {error}\n")
                continue
            worker = subprocess.Popen([*command, str(file)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
            workers.append(worker)
            cases.append(Case(name, functools.partial(_ask, worker)))
        try:
            yield cases
        finally:
            for worker in workers:
                worker.kill()
                worker.wait()


def cyminiball() -> list[str]:
    """Gärtner's Miniball in C++. It needs NumPy 1, so it gets a separate environment, which is made once."""
    folder = CHECKOUT / ".venv" / "cyminiball"
    python = folder / "bin" / "python"
    if not (folder / "ready").exists():
        subprocess.run([sys.executable, "-m", "venv", str(folder)], check=True)
        pip = [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        subprocess.run([*pip, "numpy<2", "cython", "setuptools<70", "wheel"], check=True)
        subprocess.run([*pip, "--no-build-isolation", "cyminiball==2.1.2"], check=True)
        (folder / "ready").touch()
    return [str(python), str(FOLDER / "cyminiball_worker.py")]


def miniball_crate() -> list[str]:
    """Welzl's algorithm in Rust."""
    target = CHECKOUT / "target" / "peers"
    manifest = FOLDER / "miniball" / "Cargo.toml"
    command = ["cargo", "build", "--release", "--quiet", "--manifest-path", str(manifest), "--target-dir", str(target)]
    subprocess.run(command, check=True)
    return [str(target / "release" / "miniball-peer")]


def _ask(worker: subprocess.Popen[str]) -> tuple[NDArray[np.float64], float]:
    assert worker.stdin is not None
    assert worker.stdout is not None
    worker.stdin.write("\n")
    worker.stdin.flush()
    return np.full(3, np.nan), float(worker.stdout.readline())
