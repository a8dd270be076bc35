"""Bytes, quality, seconds and memory of bundles, plain GLB, gltfpack, whole maps and scenes without instances.

python -m benchmarks.stream.bytes [--quick] [--plots out/bench]; gltfpack on the path adds its columns.
"""

from __future__ import annotations

import argparse
import tempfile
import time
import zlib
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import nearfar as nf
from benchmarks.harness.timing import machine, table
from benchmarks.stream import _encoder, _instances, _quality, _stages
from benchmarks.stream._near import Near, Packed, Place, client_scene, error, in_one_file, places
from benchmarks.stream.maps import whole_range
from nearfar.stream import _map_files as codec
from nearfar.stream._radii import PUBLISHED

PEERS = (("-c",), ("-cz",), ("-c", "-vpf"))
"""Options of gltfpack: positions of 14 bits a file, the same with its best compression, and floats of 15 bits."""

Measured = dict[str, list[int]]
"""Bytes of each ring from 0 on by column."""


def export(scene: nf.Scene, folder: Path, place: Place, **settings: Any) -> tuple[nf.stream.Bundle, float]:
    """Export a bundle; return it, and the seconds taken."""
    start = time.perf_counter()
    bundle = nf.stream.export(scene, folder, center=place.center, radii=PUBLISHED, **settings)
    return bundle, time.perf_counter() - start


def whole_maps(bundle: nf.stream.Bundle) -> list[int]:
    """Bytes of each ring's map as a whole: colour, and from ring 1 on ranges in the same planes as in changes."""
    scale, sizes = bundle._layout.scale, []
    for ring in range(bundle.count + 1):
        env = bundle.map(ring)
        size = sum(len(codec.encode_color(face, 90)) for face in env.color)
        if env.range is not None:
            size += sum(len(whole_range(face, scale.step)) for face in scale.codes(env.range))
        sizes.append(size)
    return sizes


def sizes(bundle: nf.stream.Bundle, near: Near, plain: Near, packed: dict[str, list[int]]) -> Measured:
    """Bytes of each ring by column."""
    rows = bundle.summary()
    return {
        "geometry": [0, *near.bytes_by_ring(images=False)],
        "textures": [0, *near.bytes_by_ring(images=True)],
        "colour": [row["color"] for row in rows],
        "range": [row["range"] for row in rows],
        "plain GLB": [0, *plain.bytes_by_ring(images=False)],
        **{name: [0, *found] for name, found in packed.items()},
        "whole map": whole_maps(bundle),
    }


def sizes_table(place: Place, near: Near, measured: Measured) -> str:
    """Table with a row for each ring, and their sums."""
    loads = [None, *near.rings.summary()]
    rows = []
    for ring in range(near.rings.count + 1):
        load = loads[ring]
        head = ["0", ""] if load is None else [f"{load['radius']:g}", f"{load['triangles']:,}"]
        rows.append([*head, *(f"{column[ring] / 1e3:,.0f}" for column in measured.values())])
    triangles = sum(load["triangles"] for load in loads[1:-1] if load is not None)
    rows.append(["all", f"{triangles:,}", *(f"{sum(column) / 1e3:,.0f}" for column in measured.values())])
    return table(f"{place.name}: kB", ["ring, m", "triangles", *measured], rows)


def print_one_file(rings: nf.stream.Rings, folder: Path) -> None:
    """Print bytes of all rings in one file, where gltfpack stores meshes of several rings once."""
    for options in PEERS:
        plain, packed = in_one_file(rings, folder, *options)
        if packed is not None:
            sizes = (f"{size / 1e3:,.0f} kB" for size in (plain, len(packed), len(zlib.compress(packed))))
            print("one file: {}; gltfpack {}: {}, then zlib {}".format(next(sizes), " ".join(options), *sizes))
    print()


def errors_table(place: Place, rings: nf.stream.Rings, decoded: dict[str, Any]) -> str:
    """Table of the maximum position errors of each ring in millimetres."""
    rows = [
        [name, *(f"{error(rings, ring, scene) * 1e3:.2f}" for ring, scene in enumerate(scenes, 1))]
        for name, scenes in decoded.items()
    ]
    return table(
        f"{place.name}: greatest error of a corner, mm", ["", *(f"{radius:g} m" for radius in PUBLISHED)], rows
    )


def sizes_and_quality(place: Place, folder: Path) -> tuple[Measured, list[Any]]:
    """Print the tables of bytes, errors, pictures and instances of a place."""
    scene = place.make()
    bundle, seconds = export(scene, folder / "bundle", place)
    rings = nf.stream.assign(scene, center=place.center, radii=PUBLISHED)
    near, plain = (Near.encode(rings, compressed=compressed, quality=None) for compressed in (True, False))
    (folder / "plain").mkdir()
    peers = Packed(plain, folder / "plain")
    found = {f"gltfpack {' '.join(options)}": peers.rings(*options) for options in PEERS}
    packed = {name: both for name, both in found.items() if both is not None}
    published = Near.encode(rings, compressed=True)
    measured = sizes(bundle, published, plain, {name: both[0] for name, both in packed.items()})
    print(sizes_table(place, near, measured))
    squeezed = sum(len(zlib.compress(data)) for name, data in near.files.content.items() if not name.endswith("webp"))
    print(f"geometry after zlib {squeezed / 1e3:,.0f} kB; the bundle with manifest and tileset took {seconds:.1f} s\n")
    print_one_file(rings, folder)
    decoded = {"bundle": near.scenes(), **{name: both[1] for name, both in packed.items()}}
    print(errors_table(place, rings, decoded))
    lossless: dict[str, Any] = {"compression": None, "quality": None, "range_error": 1e-6, "step": 1e-6}
    reference, _ = export(scene, folder / "lossless", place, **lossless)
    base, last = reference.at(reference.count), reference.map(reference.count)
    compared = {"bundle": bundle.at(bundle.count)}
    compared |= {
        f"{name}: geometry alone": client_scene(scenes, last, bundle._moving) for name, scenes in decoded.items()
    }
    header = ["", "PSNR", "SSIM", "least PSNR", "least SSIM", "PSNR to the truth", "SSIM"]
    print(table(f"{place.name}: pictures", header, _quality.rows(place, scene, base, compared)))
    del base, compared, decoded, packed, found
    loadings, expanded = _instances.loadings(place, bundle)
    print(f"near part {expanded:.0f} MB plain with copies; maps {loadings[0].maps / 1e3:,.0f} kB, "
          f"decoded in {loadings[0].decode_maps:.2f} s\n")  # fmt: skip
    header = ["geometry", "kB", "encode, s", "decode, s", "50 Mbit/s, s", "100 Mbit/s, s", "ratio at 50", "at 100"]
    print(table(f"{place.name}: loading", header, _instances.rows(loadings)))
    return measured, loadings


def draw(path: Path, found: Sequence[tuple[Place, Measured, list[Any]]]) -> None:
    """Draw bytes of rings and loading times, a column for each place."""
    import matplotlib as mpl

    mpl.use("agg")
    from matplotlib import pyplot as plt

    figure, grid = plt.subplots(2, len(found), figsize=(4.4 * len(found), 6.4), layout="constrained", squeeze=False)
    colors = {name: f"C{number}" for number, name in enumerate(found[-1][1])}
    for column, (place, measured, loadings) in enumerate(found):
        axes = grid[0, column]
        for name, values in measured.items():
            total = [sum(values[: ring + 1]) / 1e6 for ring in range(len(PUBLISHED) + 1)]
            style = "o-" if name in ("geometry", "textures", "colour", "range") else "--"
            axes.plot([0, *PUBLISHED], total, style, color=colors[name], label=name, markersize=4)
        axes.set(title=place.name, xlabel="ring, m", ylabel="" if column else "MB until the ring", ylim=0)
        axes = grid[1, column]
        for shift, rate in zip((-0.2, 0.2), _instances.RATES, strict=True):
            totals = [each.total(rate) for each in loadings]
            axes.barh([number + shift for number in range(len(totals))], totals, 0.38, label=f"{rate / 1e6:g} Mbit/s")
        axes.set(xlabel="seconds of loading", yticks=range(len(loadings)))
        axes.set_yticklabels([each.name for each in loadings] if not column else [""] * len(loadings))
        axes.invert_yaxis()
    grid[0, -1].legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    grid[1, -1].legend(fontsize=8)
    figure.savefig(path, dpi=90)
    plt.close(figure)


def speed_and_memory(quick: bool, samples: int) -> None:
    """Print the tables of stages, memory and the encoder's speed."""
    seconds, memory, speeds = [], [], []
    for number, place in enumerate(places(quick)):
        scene = place.make()
        with tempfile.TemporaryDirectory() as folder:
            _, whole = export(scene, Path(folder) / "bundle", place, samples=samples)
        found = _stages.measured(number, instanced=True, samples=samples, quick=quick)
        seconds.append(_stages.row(place.name, found, whole))
        memory.append(_stages.memory_row(place.name, found))
        for name, instanced in (("", True), (", copies", False)):
            copies = place.make(instanced=instanced)
            rings = nf.stream.assign(copies, center=place.center, radii=PUBLISHED)
            speeds.append(_encoder.row(place.name + name, rings))
    memory.append(
        _stages.memory_row("city, crossing, copies", _stages.measured(0, instanced=False, samples=samples, quick=quick))
    )
    title = f"CPU seconds of stages, maps of 6 × {_stages.FACE_SIZE}², {samples} samples"
    sums = ["sum", "their wall time", "export, wall", "rays : one map", "bake : one map"]
    print(table(title, ["", *_stages.WORK, *sums], seconds))
    print(table("memory, GB", ["", "triangles", "arrays", "loaded", "with tree", "peak", "peak : with tree"], memory))
    print(table("encoder of geometry", _encoder.HEADER, speeds))


def main() -> None:
    """Print the tables and draw the plot."""
    parse = argparse.ArgumentParser(description=__doc__)
    parse.add_argument("--quick", action="store_true", help="smaller scenes")
    parse.add_argument("--plots", type=Path, help="folder for plots")
    parse.add_argument("--samples", type=int, default=4, help="of the maps whose baking is timed")
    arguments = parse.parse_args()
    print(machine(), flush=True)
    speed_and_memory(arguments.quick, arguments.samples)
    found = []
    for place in places(arguments.quick):
        with tempfile.TemporaryDirectory() as folder:
            found.append((place, *sizes_and_quality(place, Path(folder))))
    if arguments.plots:
        arguments.plots.mkdir(parents=True, exist_ok=True)
        draw(arguments.plots / "stream_bytes.png", found)


if __name__ == "__main__":
    main()
