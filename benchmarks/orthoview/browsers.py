"""The page of trees, 3d-tiles-renderer and Spark in one Chromium: pictures after equal bytes, and a flight.

STORE is a tree with geometry; without one a city is built. 3d-tiles-renderer reads the leaves' geometry, Spark the
cells of the cuts as SPZ files. All receive their bytes through one gate, which stops after a given number of bytes.
Pages need a browser and `npm ci --prefix tests/readers`.
"""

from __future__ import annotations

import math
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from benchmarks.harness.pictures import similarity
from benchmarks.harness.report import folder_or_temporary, start, table
from benchmarks.harness.timing import timed
from benchmarks.orthoview._clients import CLIENTS, Route, open_client, prepare
from benchmarks.orthoview._gate import Gate, serve
from tests.support.browser import started

STEPS = (0.5, 1.0, 2.0, 4.0, 8.0)
"""Megabytes after which pictures are taken at the first place."""
MEGABYTES_A_PLACE = 2.0
"""Further megabytes at each later place."""
PLACES = 4
SHEET = (1.0, 4.0)
"""Megabytes of the sheet's pictures at the first place; its last row shows the last place."""
PACE = 0.4
"""Factor of the route's speed in the flight: software draws few frames per second."""
RTT_MS = 20.0
PICTURE_TIMEOUT = 180.0
"""Timeout of a picture, seconds."""
TRUTH_ERROR_PX = 1e-6
"""Error at which all visible leaves are drawn as triangles."""
Array = NDArray[np.float64]
Truth = tuple[Array, NDArray[np.bool_], Array]
"""A picture, the pixels fully covered by surfaces, and a picture of the sky only."""


def main() -> None:
    options = start(
        __doc__,
        "--out",
        store={"nargs": "?", "help": "a tree with geometry"},
        error=(3.0, "error_px of the page's cuts"),
        splat_error=(12.0, "error_px of Spark's cuts"),
        height=(120.0, "metres above the bottom of the tree"),
        speed=(float, "metres a second; by default the flight crosses a twentieth of the world"),
        seconds=30.0,
        mbps=(20.0, "link of the flight"),
        viewers={"nargs": "+", "default": list(CLIENTS), "choices": list(CLIENTS)},
        only={"default": None, "choices": ("standing", "flying"), "help": "one of the two tables"},
        work=(Path, "folder that keeps intermediate files: SPZ files, truths, pictures"),
    )
    with folder_or_temporary(options.work) as folder:
        tree = nf.orthoview.open(options.store) if options.store else city(folder)
        speed = options.speed or float(np.ptp(tree.bounds[:, 0])) / 20 / options.seconds
        route = Route(tree, options.height, speed, options.seconds, options.error, options.splat_error)
        folders, gate, counted = prepare(route, folder), Gate(), frozenset({"store", "splats"})
        with (
            serve(folders, gate, counted) as url,
            started(flags=["--js-flags=--max-old-space-size=4096"]) as chromium,
        ):
            if options.only != "flying":
                compare_standing(chromium, url, route, gate, options, folder)
            if options.only != "standing":
                measure_flight(chromium, url, route, gate, options)


def city(folder: Path) -> nf.orthoview.OrthoTree:
    """Build a tree of 1 km of a city."""
    box = np.array([[-512.0, -9.0, -512.0], [511.0, 200.0, 511.0]])
    world = nf.datasets.city(blocks=12, detail=1)
    return nf.orthoview.build(world, folder / "city.zarr", cell=64, aabb=box, size=128, directions=9)


def compare_standing(chromium: Any, url: str, route: Route, gate: Gate, options: Namespace, folder: Path) -> None:
    """Compare pictures after equal numbers of bytes, which grow at the first place, and further at each later place."""
    places = [round(n * (len(route.poses) - 1) / (PLACES - 1)) for n in range(PLACES)]
    stops = [(places[0], step) for step in STEPS]
    stops += [(place, STEPS[-1] + (n + 1) * MEGABYTES_A_PLACE) for n, place in enumerate(places[1:])]
    stops.append((places[-1], math.inf))
    truths = {place: truth_of(route, place, folder) for place in places}
    rows: list[list[str]] = []
    for name in options.viewers:
        begin, requests_before = gate.sent, gate.requests
        gate.mbps, gate.rtt_ms = math.inf, 0.0
        gate.allow(begin + 1e6 * stops[0][1])
        with open_client(chromium, url, name, route, gate) as client:
            for place, megabytes in stops:
                gate.allow(begin + 1e6 * megabytes)
                facts = client.wait_at(place, PICTURE_TIMEOUT)
                requests = gate.requests - requests_before
                amounts = [f"{(gate.sent - begin) / 1e6:.2f}", f"{requests}", f"{facts['missing']}"]
                row = [f"{place * route.step:g}", f"{megabytes:g}", name, *amounts]
                rows.append(row + compare(name, client.picture(), truths[place], folder / file_of(name, row)))
                print(rows[-1], facts, flush=True)
    rows.sort(key=lambda row: (float(row[0]), float(row[1])))
    header = "place, s | MB allowed | viewer | MB | requests | missing | PSNR, dB | SSIM | holes, %"
    print(table("Pictures after equal bytes", header, rows))
    if options.out is not None:
        sheet_stops = [(places[0], step) for step in SHEET] + [stops[-2]]
        sheet(truths, sheet_stops, folder, options.out / "orthoview_browsers.png")


def compare(name: str, rgba: NDArray[np.uint8], truth: Truth, file: Path) -> list[str]:
    """Save a viewer's picture; return PSNR and SSIM with the truth, and the share of holes, as text."""
    reference, solid, sky = truth
    picture = rgba[..., :3] / 255.0
    if name.startswith("nearfar"):
        # The canvas has no alpha: pixels with the sky's colour are empty.
        is_hole = np.abs(picture - sky).max(axis=-1) < 2 / 255
    else:
        is_hole = rgba[..., 3] < 128
        picture = picture + (1 - rgba[..., 3:] / 255.0) * sky
    Image.fromarray(np.rint(255 * picture.clip(0, 1)).astype(np.uint8)).save(file)
    psnr, ssim = similarity(reference, picture)
    return [f"{psnr:.1f}", f"{ssim:.3f}", f"{100 * (is_hole & solid).sum() / solid.sum():.2f}"]


def file_of(name: str, stop: Sequence[object]) -> str:
    return f"{name}-{stop[0]}-{stop[1]}.png"


def measure_flight(chromium: Any, url: str, route: Route, gate: Gate, options: Namespace) -> None:
    """Measure the first picture over a link with an empty cache, and then a flight from its place."""
    rows = []
    for name in options.viewers:
        sent_before, requests_before = gate.sent, gate.requests
        gate.mbps, gate.rtt_ms = options.mbps, RTT_MS
        gate.allow(math.inf)
        with open_client(chromium, url, name, route, gate) as client:
            facts, first_timing = timed(client.wait_at, 0, PICTURE_TIMEOUT)
            sent_at_departure = gate.sent
            moments, frame_ms, missing = client.fly(PACE).T
        frame_share = np.diff(np.append(moments, route.seconds)) / route.seconds
        first = (sent_at_departure - sent_before) / 1e6, first_timing.wall, facts["missing"]
        later = (gate.sent - sent_at_departure) / 1e6, gate.requests - requests_before, len(frame_ms)
        stalled = 100 * (missing > 0).mean(), 100 * frame_share[missing > 0].sum()
        rows.append([name, *first, *later, *stalled, np.median(frame_ms), np.percentile(frame_ms, 95)])
        print(rows[-1], flush=True)
    title = f"{route.seconds:g} s at {PACE * route.speed:g} m/s, {options.mbps:g} Mbit/s, {RTT_MS:g} ms"
    header = "viewer | first picture, MB {:.1f} | s {:.0f} | missing | flight, MB {:.1f} | requests in all | frames"
    header += " | stalled, % of frames {:.0f} | % of time {:.0f} | median frame, ms {:.0f} | 95 % {:.0f}"
    print(table(title, header, rows))


def truth_of(route: Route, place: int, folder: Path) -> Truth:
    """Render all leaves' triangles, the pixels fully covered by them, and the sky only."""
    camera = route.camera(place)
    file = folder / f"truth-{place}.npz"
    if not file.is_file():
        frame = route.tree.render(camera, error_px=TRUTH_ERROR_PX, samples=4, channels=("color", "coverage"))
        assert frame.stats["views"] == 0
        np.savez(file, picture=frame.to_image(), coverage=frame.require("coverage"))
    with np.load(file) as arrays:
        picture, coverage = arrays["picture"], arrays["coverage"]
    sky = route.tree.render(camera, t_max=1e-3, channels=("color",)).to_image()
    return picture / 255.0, coverage > 0.999, sky / 255.0


def sheet(truths: dict[int, Truth], stops: list[tuple[int, float]], folder: Path, path: Path) -> None:
    """Draw a row for each stop: the truth, and the available pictures of viewers."""
    rows = []
    for place, megabytes in stops:
        files = [folder / file_of(name, (place, f"{megabytes:g}")) for name in CLIENTS]
        pictures = [np.asarray(Image.open(file)) for file in files if file.is_file()]
        rows.append(np.concatenate([np.rint(255 * truths[place][0]).astype(np.uint8), *pictures], axis=1))
    codes = np.concatenate(rows)
    small = Image.fromarray(codes).resize((codes.shape[1] // 2, codes.shape[0] // 2), Image.Resampling.BOX)
    small.quantize(128).save(path, optimize=True)


if __name__ == "__main__":
    main()
