"""Run time against error of bounding spheres: all methods, and peers such as trimesh."""

from __future__ import annotations

import dataclasses
import functools
import subprocess
import sys
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, Work, compare, print_limits
from benchmarks.harness.report import start

FOLDER = Path(__file__).resolve().parent / "peers"

CHECKOUT = FOLDER.parents[2]


@contextmanager
def sphere_peers(points: NDArray[np.float64], *names: str) -> Iterator[list[Case]]:
    """Exact solvers with the points loaded; those that cannot be built here are reported and left out.

    Their times include sending a line of text to the process and reading one back, some ten microseconds.
    """
    commands = {"cyminiball": cyminiball, "miniball crate": miniball_crate}
    with TemporaryDirectory() as folder, ExitStack() as stack:
        file = Path(folder) / "points.f64"
        points.astype(np.float64).tofile(file)
        cases = []
        for name in names:
            try:
                command = commands[name]()
            except (subprocess.CalledProcessError, FileNotFoundError) as error:
                print(f"{name} is left out: {error}\n")
                continue
            pipes: dict[str, Any] = {"stdin": subprocess.PIPE, "stdout": subprocess.PIPE, "text": True}
            worker = stack.enter_context(subprocess.Popen([*command, str(file)], **pipes))
            stack.callback(worker.kill)
            cases.append(Case(name, functools.partial(_ask, worker)))
        yield cases


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


Array = NDArray[np.float64]


def surface(count: int) -> Array:
    """Points on an uneven ellipsoid, similar to the vertices of meshes."""
    random = np.random.default_rng(0)
    points = random.normal(size=(count, 3))
    points /= np.linalg.norm(points, axis=1, keepdims=True)
    knobs = 1 + 0.3 * np.sin(5 * points[:, :1]) * np.cos(3 * points[:, 1:2])
    return np.asarray(points * knobs * [3, 2, 1])


def spheres(title: str, points: Array, *peers: str, repeat: int = 5) -> str:
    """Table of methods and peers; an error is the relative excess of the radius over the least one."""
    min_radius, single = nf.bounding_sphere(points)[1], points.astype(np.float32)

    def error(sphere: tuple[Array, float]) -> float:
        return abs(sphere[1] / min_radius - 1)

    cases = [Case(f"{OURS}, exact", partial(nf.bounding_sphere, points), error)]
    cases += [Case(f"{OURS}, exact, float32", partial(nf.bounding_sphere, single), error)]
    for method in ("average", "minmax", "ritter"):
        cases += [Case(f"{OURS}, {method}", partial(nf.bounding_sphere, points, method=method), error)]
    if "trimesh" in peers:
        cases += [Case("trimesh", partial(trimesh.nsphere.minimum_nsphere, points), error)]
    cases += [Case("memory read (NumPy's max)", points.max)]
    with sphere_peers(points, *(name for name in peers if name != "trimesh")) as peer_cases:
        cases += [dataclasses.replace(case, error=error) for case in peer_cases]
        return compare(title, cases, work=Work(bytes=points.nbytes), repeat=repeat)


def groups() -> str:
    points = surface(1_000_000)
    offsets = np.arange(0, len(points) + 1, 100)
    cases = [Case(f"{OURS}, bounding_spheres", lambda: nf.bounding_spheres(points, offsets))]
    cases += [Case(f"{OURS}, one by one", lambda: [nf.bounding_sphere(group) for group in points.reshape(-1, 100, 3)])]
    return compare("Bounding spheres of 10,000 groups of 100 points", cases, repeat=3)


def main() -> None:
    start(__doc__)
    print_limits()
    label, peers = "Bounding sphere of", ("cyminiball", "miniball crate")
    print(spheres(f"{label} 10⁴ points of a surface", surface(10_000), "trimesh", *peers), flush=True)
    print(spheres(f"{label} 10⁶ points of a surface", surface(1_000_000), *peers), flush=True)
    print(spheres(f"{label} 10⁷ points of a surface", surface(10_000_000), repeat=3), flush=True)
    ball = np.random.default_rng(1).normal(size=(1_000_000, 3))
    ball /= np.linalg.norm(ball, axis=1, keepdims=True)
    print(spheres(f"{label} 10⁶ cospherical points", ball, *peers), flush=True)
    print(groups())


if __name__ == "__main__":
    main()
