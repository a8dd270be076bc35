"""Bytes, quality, seconds and memory of bundles, plain GLB, gltfpack, whole maps and scenes without instances."""

from __future__ import annotations

import zlib
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

import nearfar as nf
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import folder_or_temporary, save_figure, start, subplots, table
from benchmarks.harness.timing import best, timed
from benchmarks.stream import _stages
from benchmarks.stream._near import (
    Near,
    Place,
    encode_groups,
    error,
    in_front_of_map,
    in_one_file,
    one_scene,
    packed_rings,
    places,
)
from benchmarks.stream.maps import whole_range
from nearfar import _core
from nearfar.stream import _map_files as codec
from nearfar.stream._radii import PUBLISHED

PEERS = (("-c",), ("-cz",), ("-c", "-vpf"))
"""Options of gltfpack: positions of 14 bits a file, the same with its best compression, and floats of 15 bits."""

RATES = (50e6, 100e6)
"""Rates of links, bits per second."""

BytesByRing = dict[str, list[int]]
"""Bytes of each ring from 0 on by column."""


@dataclass(frozen=True)
class Loading:
    """Bytes needed by a client: geometry with textures, and maps."""

    name: str
    encode: float
    """Seconds of encoding geometry on the server."""
    geometry: int
    maps: int
    """Bytes of maps."""
    decode_geometry: float
    decode_maps: float
    """Seconds of decoding by nearfar's own reader."""

    def total(self, rate: float) -> float:
        """Seconds until the last ring is available: all bytes over the link, then decoding, without overlap."""
        return 8.0 * (self.geometry + self.maps) / rate + self.decode_geometry + self.decode_maps


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


def sizes(bundle: nf.stream.Bundle, near: Near, plain: Near, packed: dict[str, list[int]]) -> BytesByRing:
    rows = bundle.summary()
    return {
        "geometry": [0, *near.bytes_by_ring(images=False)],
        "textures": [0, *near.bytes_by_ring(images=True)],
        "colour": [row["color"] for row in rows],
        "range": [row["range"] for row in rows],
        "plain GLB": [0, *plain.bytes_by_ring(images=False)],
        **{name: [0, *ring_bytes] for name, ring_bytes in packed.items()},
        "whole map": whole_maps(bundle),
    }


def sizes_table(place: Place, near: Near, measured: BytesByRing) -> str:
    """Table with a row for each ring, and their sums."""
    rings = [(ring["radius"], ring["triangles"]) for ring in near.rings.summary()[: near.rings.count]]
    columns = np.array([*measured.values()]) / 1e3
    heads = [(0, None), *rings, ("all", sum(triangles for _, triangles in rings))]
    rows = [[*head, *sizes] for head, sizes in zip(heads, [*columns.T, columns.sum(axis=1)], strict=True)]
    header = ["ring, m {:g}", "triangles {:,}", *(f"{name} {{:,.0f}}" for name in measured)]
    return table(f"{place.name}: kB", header, rows)


def print_one_file(rings: nf.stream.Rings, folder: Path) -> None:
    """Print bytes of all rings in one file, where gltfpack stores meshes of several rings once."""
    for options in PEERS:
        plain, packed = in_one_file(rings, folder, *options)
        if packed is not None:
            sizes = (f"{size / 1e3:,.0f} kB" for size in (plain, len(packed), len(zlib.compress(packed))))
            print("one file: {}; gltfpack {}: {}, then zlib {}".format(next(sizes), " ".join(options), *sizes))
    print()


def errors_table(place: Place, rings: nf.stream.Rings, decoded: dict[str, Any]) -> str:
    rows = [
        [name, *(error(rings, ring, scene) * 1e3 for ring, scene in enumerate(scenes, 1))]
        for name, scenes in decoded.items()
    ]
    header = ["", *(f"{radius:g} m {{:.2f}}" for radius in PUBLISHED)]
    return table(f"{place.name}: greatest error of a corner, mm", header, rows)


def sizes_and_quality(place: Place, folder: Path) -> tuple[BytesByRing, list[Loading]]:
    """Print the tables of bytes, errors, pictures and instances of a place."""
    scene = place.make()
    export = partial(nf.stream.export, scene, center=place.center, radii=PUBLISHED)
    bundle, spent = timed(export, folder / "bundle")
    rings = nf.stream.assign(scene, center=place.center, radii=PUBLISHED)
    near, plain = (Near.encode(rings, compressed=compressed, quality=None) for compressed in (True, False))
    (folder / "plain").mkdir()
    peers = {f"gltfpack {' '.join(options)}": packed_rings(plain, folder / "plain", *options) for options in PEERS}
    packed = {name: both for name, both in peers.items() if both is not None}
    published = Near.encode(rings, compressed=True)
    measured = sizes(bundle, published, plain, {name: both[0] for name, both in packed.items()})
    print(sizes_table(place, near, measured))
    squeezed = sum(len(zlib.compress(data)) for name, data in near.files.content.items() if not name.endswith("webp"))
    print(f"geometry after zlib {squeezed / 1e3:,.0f} kB; bundle, manifest and tileset took {spent.wall:.1f} s\n")
    print_one_file(rings, folder)
    decoded = {"bundle": near.scenes(), **{name: both[1] for name, both in packed.items()}}
    print(errors_table(place, rings, decoded))
    lossless: dict[str, Any] = {"compression": None, "quality": None, "range_error": 1e-6, "step": 1e-6}
    reference = export(folder / "lossless", **lossless)
    base, last = reference.at(reference.count), reference.map(reference.count)
    compared = {"bundle": bundle.at(bundle.count)}
    for name, parts in decoded.items():
        compared[f"{name}: geometry alone"] = in_front_of_map(one_scene(parts, bundle._moving), last)
    print(table(f"{place.name}: pictures", PICTURES, picture_rows(place, scene, base, compared)))
    del base, compared, decoded, packed, peers
    loadings, expanded = measure_loading(place, bundle)
    print(f"near part {expanded:.0f} MB plain with copies; maps {loadings[0].maps / 1e3:,.0f} kB, "
          f"decoded in {loadings[0].decode_maps:.2f} s\n")  # fmt: skip
    print(table(f"{place.name}: loading", LOADING, loading_rows(loadings)))
    return measured, loadings


def measure_loading(place: Place, bundle: nf.stream.Bundle) -> tuple[list[Loading], float]:
    """Loading of four encodings of the same rings, and MB of their plain vertex and index arrays with copies expanded.

    A vertex takes 32 bytes (position, normal and texture coordinates in float32), a triangle 12.
    """
    maps = sum(row["color"] + row["range"] for row in bundle.summary())
    decode_maps = best(lambda: bundle.map(bundle.count), repeat=3, warm=False).wall
    loadings = []
    for instanced in (True, False):
        rings = nf.stream.assign(place.make(instanced=instanced), center=place.center, radii=PUBLISHED)
        for compressed in (True, False):
            near = min((Near.encode(rings, compressed=compressed) for _ in range(2)), key=lambda near: near.seconds)
            name = f"{'instances' if instanced else 'copies'}, {'meshopt' if compressed else 'plain'}"
            sent = sum(near.bytes_by_ring(images=False)) + sum(near.bytes_by_ring(images=True))
            seconds = best(lambda near=near: one_scene(near.scenes()), repeat=3, warm=False).wall  # type: ignore[misc]
            loadings.append(Loading(name, near.seconds, sent, maps, seconds, decode_maps))
    meshes = (mesh for scene in near.scenes() if scene for mesh in _core.scene_parts(scene._core)["meshes"])
    return loadings, sum(32 * mesh.vertex_count + 12 * mesh.face_count for mesh in meshes) / 1e6


LOADING = "geometry | kB {:,.0f} | encode, s {:.2f} | decode, s {:.2f} | 50 Mbit/s, s {:.2f} | 100 Mbit/s, s {:.2f}"
LOADING += " | ratio at 50 {:.2f} | at 100 {:.2f}"


def loading_rows(loadings: list[Loading]) -> list[list[object]]:
    """Make a row for each encoding; the last columns are loading times relative to the first encoding's."""
    totals = [[each.total(rate) for rate in RATES] for each in loadings]
    return [
        [each.name, each.geometry / 1e3, each.encode, each.decode_geometry, *times, *np.divide(times, totals[0])]
        for each, times in zip(loadings, totals, strict=True)
    ]


FOV, SIZE = nf.Fov.symmetric(90, 1.6), (640, 400)
"""Field of view and size of the views."""
TURNS = (0.4, 2.0, 3.5, 5.1)
"""Viewing directions of a user, radians."""


def cameras(place: Place) -> Iterator[nf.Camera]:
    for user in place.users:
        eye = np.add(place.center, user)
        for turn in TURNS:
            yield nf.Camera.look_at(eye, np.add(eye, (np.cos(turn), 0.03, np.sin(turn))), fov=FOV, size=SIZE)


PICTURES = " | PSNR {:.2f} | SSIM {:.4f} | least PSNR {:.1f} | least SSIM {:.4f}"
PICTURES += " | PSNR to the truth {:.2f} | SSIM {:.4f}"


def picture_rows(
    place: Place, truth: nf.Scene, base: nf.ReducedScene, compared: Mapping[str, nf.ReducedScene]
) -> list[list[object]]:
    """PSNR and SSIM of all pictures, in sRGB codes: mean and least against the base, mean against the truth."""
    sources = {"without loss": base, **compared}
    against_base: dict[str, list[tuple[float, float]]] = {name: [] for name in sources}
    against_truth: dict[str, list[tuple[float, float]]] = {name: [] for name in sources}
    for camera in cameras(place):
        true = nf.render(truth, camera).to_image()
        pictures = {name: nf.render(source, camera).to_image() for name, source in sources.items()}
        for name, picture in pictures.items():
            against_truth[name].append(similarity(true, picture))
            if name != "without loss":
                against_base[name].append(similarity(pictures["without loss"], picture))
    rows: list[list[object]] = []
    for name, values in against_base.items():
        cells = [*np.mean(values, axis=0), *np.min(values, axis=0)] if values else [None] * 4
        rows.append([name, *cells, *np.mean(against_truth[name], axis=0)])
    return rows


def draw(path: Path, results: Sequence[tuple[Place, BytesByRing, list[Any]]]) -> None:
    """Draw bytes of rings and loading times, a column for each place."""
    figure, grid = subplots(2, len(results), figsize=(4.4 * len(results), 6.4), squeeze=False)
    colors = {name: f"C{number}" for number, name in enumerate(results[-1][1])}
    for column, (place, measured, loadings) in enumerate(results):
        axes = grid[0, column]
        for name, values in measured.items():
            total = [sum(values[: ring + 1]) / 1e6 for ring in range(len(PUBLISHED) + 1)]
            style = "o-" if name in ("geometry", "textures", "colour", "range") else "--"
            axes.plot([0, *PUBLISHED], total, style, color=colors[name], label=name, markersize=4)
        axes.set(title=place.name, xlabel="ring, m", ylabel="" if column else "MB until the ring", ylim=0)
        axes = grid[1, column]
        for shift, rate in zip((-0.2, 0.2), RATES, strict=True):
            totals = [each.total(rate) for each in loadings]
            axes.barh([number + shift for number in range(len(totals))], totals, 0.38, label=f"{rate / 1e6:g} Mbit/s")
        axes.set(xlabel="seconds of loading", yticks=range(len(loadings)))
        axes.set_yticklabels([each.name for each in loadings] if not column else [""] * len(loadings))
        axes.invert_yaxis()
    grid[0, -1].legend(fontsize=8, loc="center left", bbox_to_anchor=(1.0, 0.5))
    grid[1, -1].legend(fontsize=8)
    save_figure(figure, path, dpi=90)


def speed_and_memory(quick: bool, samples: int) -> None:
    seconds, memory, speeds = [], [], []
    stages = partial(_stages.measure_in_process, samples=samples, quick=quick)
    for number, place in enumerate(places(quick)):
        scene = place.make()
        with folder_or_temporary() as folder:
            settings: dict[str, Any] = {"center": place.center, "radii": PUBLISHED, "samples": samples}
            _, export_time = timed(nf.stream.export, scene, folder / "bundle", **settings)
        figures = stages(number, instanced=True)
        seconds.append(_stages.row(place.name, figures, export_time.wall))
        memory.append(_stages.memory_row(place.name, figures))
        for name, instanced in (("", True), (", copies", False)):
            rings = nf.stream.assign(place.make(instanced=instanced), center=place.center, radii=PUBLISHED)
            speeds.append(encoder_row(place.name + name, rings))
    memory.append(_stages.memory_row("city, crossing, copies", stages(0, instanced=False)))
    title = f"CPU seconds of stages, maps of 6 × {_stages.FACE_SIZE}², {samples} samples"
    sums = ("sum", "their wall time", "export, wall")
    columns = [f"{stage} {{:.2f}}" for stage in _stages.WORK] + [f"{name} {{:.1f}}" for name in sums]
    print(table(title, ["", *columns, "rays : one map {:.2f}", "bake : one map {:.2f}"], seconds))
    kinds = ("arrays", "loaded", "with tree", "peak", "peak : with tree")
    print(table("memory, GB", ["", "triangles {:,}", *(f"{kind} {{:.2f}}" for kind in kinds)], memory))
    print(table("encoder of geometry", ENCODER, speeds))


ENCODER = " | MB in {:.1f} | gathered, CPU ms {:.0f} | and encoded {:.0f}"
ENCODER += " | MB/s a core, all {:.0f} | encoding alone {:.0f}"


def encoder_row(name: str, rings: nf.stream.Rings) -> list[object]:
    """MB of the compressed arrays, CPU milliseconds, MB/s per core.

    The time of compression is the difference from writing the same files uncompressed. That copies the arrays, with
    longer normals, so the difference is a few milliseconds too small. It is left out below a tenth of the total.
    """
    encode = partial(encode_groups, rings.scene, rings.codes(), range(1, rings.count + 1))
    megabytes = sum(facts["raw_bytes"] for facts in encode(compressed=True)[1]) / 1e6
    plain, packed = (best(partial(encode, compressed=compressed), repeat=5).cpu for compressed in (False, True))
    alone = packed - plain
    speed = megabytes / alone if alone > 0.1 * packed else "–"
    return [name, megabytes, 1e3 * plain, 1e3 * packed, megabytes / packed, speed]


def main() -> None:
    options = start(__doc__, "--quick", "--plots", samples=(4, "of the maps whose baking is timed"))
    speed_and_memory(options.quick, options.samples)
    results = []
    for place in places(options.quick):
        with folder_or_temporary() as folder:
            results.append((place, *sizes_and_quality(place, folder)))
    if options.plots:
        draw(options.plots / "stream_bytes.png", results)


if __name__ == "__main__":
    main()
