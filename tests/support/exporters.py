"""Models exported by other programs from the data's, and the similarity of their pictures to the plain files'."""

from __future__ import annotations

import functools
import gzip
import tempfile
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import data as data_files
from nearfar._scene.srgb import to_srgb
from tests.support.gltf_cases import decode, encode

FULL, GREY, PAINTED, FLAT = "all", "shape and normals", "shape and colours", "shape"
"""Parts of the plain file that a format and its exporter keep, so that pictures of them are compared."""

SIZE = (480, 320)
SAMPLES = 4

SOURCES = {
    "Duck": "objects/gltf/Duck.glb",
    "ducks": "objects/gltf/Duck.glb",
    "FlightHelmet": "objects/gltf/FlightHelmet/FlightHelmet.gltf",
    "garage": "interior/garage/garage.gltf",
    "armadillo": "objects/armadillo.obj",
    "bunny": "objects/bun_zipper.ply",
    "dragon": "objects/dragon/dragon_vrip_res4.ply.gz",
    "Manhattan": "city/manhattan_deckgl/manhattan_core.glb",
    "Tokyo": "city/tokyo23/tokyo_core_lod1.glb",
}
"""The plain files, below the data folder."""

EYES = {
    "garage": (((2.4, 1.7, 2.6), (-1.5, 1.0, -2.0)), ((0.6, 1.6, -2.6), (-0.4, 0.9, 2.0))),
    "Manhattan": (((-300.0, 400.0, 900.0), (900.0, 50.0, -500.0)), ((865.0, 2500.0, 2500.0), (865.0, 0.0, -300.0))),
    "Tokyo": (((-500.0, 300.0, 700.0), (100.0, 20.0, 0.0)), ((40.0, 2500.0, 2400.0), (40.0, 0.0, 100.0))),
}
"""Eye and target of the pictures, metres; other models are seen from two sides."""


@dataclass(frozen=True)
class Case:
    """A model to export."""

    source: str
    settings: str
    """The exporter's settings in words."""
    file: str
    """Name of the file."""
    options: Any = None
    """The settings as the exporter takes them."""
    compared: str = FULL
    """Parts of the plain file that the exporter keeps."""
    load: dict[str, Any] = field(default_factory=dict)
    """Arguments of `Scene.load`."""


def plain(source: str, folder: Path) -> Path:
    """Path of a source that other programs can read; what is not in the data is written to the folder."""
    path = data_files.require(SOURCES[source])
    if source == "ducks":
        return _write(folder / "plain-ducks.glb", lambda: _repeated(path))
    if path.suffix == ".gz":
        return _write(folder / path.stem, lambda: gzip.decompress(path.read_bytes()))
    return path


def _write(path: Path, content: Callable[[], bytes]) -> Path:
    if not path.exists():
        path.write_bytes(content())
    return path


def _repeated(path: Path) -> bytes:
    """The duck eight times, in nodes that share its mesh."""
    document, binary = decode(path)
    mesh = next(number for number, node in enumerate(document["nodes"]) if "mesh" in node)
    turns = [np.pi * number / 8 for number in range(8)]
    places = [
        {"mesh": document["nodes"][mesh]["mesh"], "translation": [150.0 * (n % 4), 0.0, 200.0 * (n // 4)]}
        | {"rotation": [0.0, float(np.sin(turn)), 0.0, float(np.cos(turn))], "scale": [1.0 - n / 16] * 3}
        for n, turn in enumerate(turns)
    ]
    first = len(document["nodes"])
    del document["nodes"][mesh]["mesh"]
    document["nodes"][mesh]["children"] = list(range(first, first + len(places)))
    document["nodes"] += places
    return encode(document, binary)


def cameras(source: str) -> list[nf.Camera]:
    """The views in which a source's models are compared."""
    views = EYES.get(source) or _eyes_around(scene(source).bounds)
    fov = nf.Fov.symmetric(60, SIZE[0] / SIZE[1])
    return [nf.Camera.look_at(eye, target, fov=fov, size=SIZE) for eye, target in views]


def _eyes_around(bounds: NDArray[np.float64]) -> list[tuple[Any, Any]]:
    middle, reach = bounds.mean(axis=0), np.linalg.norm(bounds[1] - bounds[0])
    sides = np.array([[0.55, 0.3, 0.75], [-0.75, 0.1, -0.6]])
    return [(tuple(middle + 1.1 * reach * side), tuple(middle)) for side in sides]


@functools.cache
def scene(source: str) -> nf.Scene:
    """The plain file's scene."""
    with tempfile.TemporaryDirectory() as folder:
        return nf.Scene.load(plain(source, Path(folder)))


@functools.cache
def pictures(source: str, kind: str) -> list[NDArray[np.uint8]]:
    """The plain file's pictures of a kind."""
    return render_views(scene(source), source, kind)


def render_views(scene: nf.Scene, source: str, kind: str) -> list[NDArray[np.uint8]]:
    """Pictures of a scene in the views of a source."""
    shown = scene if kind == FULL else _grey(scene, smooth=kind == GREY)
    frames = [nf.render(shown, camera, samples=SAMPLES, backend="cpu").to_image() for camera in cameras(source)]
    return frames + (_albedo(scene, source) if kind == PAINTED else [])


def _grey(scene: nf.Scene, *, smooth: bool) -> nf.Scene:
    """The triangles of a scene without materials, with or without vertex normals."""
    parts = nf._core.mesh_parts(scene._core.merged())
    builder = nf.SceneBuilder()
    normals = parts["normals"] if smooth else None
    builder.instance(builder.mesh(parts["positions"] + scene.origin, parts["faces"], normals=normals), name="all")
    return builder.build()


def _albedo(scene: nf.Scene, source: str) -> list[NDArray[np.uint8]]:
    frames = [nf.render(scene, camera, channels=("albedo",), backend="cpu") for camera in cameras(source)]
    return [np.rint(255 * to_srgb(np.nan_to_num(frame.require("albedo")))).astype(np.uint8) for frame in frames]


def share(case: Case, path: Path) -> float:
    """The least share over the views of pixels within 1/255 of the plain file's in all channels."""
    found = render_views(nf.Scene.load(path, **case.load), case.source, case.compared)
    return shared(pictures(case.source, case.compared), found)


def shared(one: list[NDArray[np.uint8]], other: list[NDArray[np.uint8]]) -> float:
    """The least share over the pictures of pixels within 1/255 in all channels."""
    pairs = zip(one, other, strict=True)
    return min(float((np.abs(a.astype(int) - b).max(axis=-1) <= 1).mean()) for a, b in pairs)
