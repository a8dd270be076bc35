"""Run time against error of the kernels on graphics devices (frames and long arrays), compared with the CPU."""

from __future__ import annotations

from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, compare, greatest_error, print_limits
from benchmarks.harness.report import start
from nearfar import _core, gpu

SIZE = (1920, 1080)
PLACE: dict[str, Any] = {"user": (3.0, 1.0, 2.0), "center": (0.0, 1.7, 0.0), "r1": 30.0, "r2": 50.0}


FIRST_ROWS = slice(100_000)


def greatest_difference(result: NDArray[Any], expected: NDArray[Any]) -> float:
    """Greatest difference between the first rows, without values that are NaN in either array."""
    first = result[FIRST_ROWS]
    return float(np.nanmax(np.where(first == expected, 0.0, np.abs(first.astype(np.float64) - expected))))


def share_that_differs(result: NDArray[Any], expected: NDArray[Any]) -> float:
    return float((result[FIRST_ROWS] != expected).mean())


def frames(label: str) -> None:
    """Compare similarity and discontinuity of two pictures of a city that are drawn on the device."""
    scene = nf.datasets.city(blocks=4, seed=0)
    fov = nf.Fov.symmetric(90, SIZE[0] / SIZE[1])
    views = [nf.Camera.look_at((x, 12, 0), (60, 5, 20), fov=fov, size=SIZE) for x in (0.0, 0.5)]
    first_frame, second_frame = (gpu.render(scene, view, channels=("color", "position")) for view in views)
    read = first_frame.read(), second_frame.read()
    mean, similarities = nf.ssim(*read, full=True)

    off = greatest_error(mean)

    def map_off(result: Any) -> float:
        return greatest_difference(result.map, similarities)

    cases = [
        Case(f"{OURS}, on the device", lambda: gpu.ssim(first_frame, second_frame), off),
        Case(f"{OURS}, on the device, with map", lambda: gpu.ssim(first_frame, second_frame, full=True), map_off),
        Case("read back, then CPU", lambda: nf.ssim(first_frame.read(), second_frame.read()), off),
        Case("CPU alone", lambda: nf.ssim(*read), off),
        Case("reading both back alone", lambda: (first_frame.read(), second_frame.read())),
    ]
    print(compare(f"SSIM of two frames of {SIZE[0]} × {SIZE[1]} pixels, {label}", cases))
    error_of = partial(greatest_difference, expected=nf.metrics.discontinuity(read[0], views[1]))
    cases = [
        Case(f"{OURS}, on the device", lambda: gpu.discontinuity(first_frame, views[1]), error_of),
        Case("read back, then CPU", lambda: nf.metrics.discontinuity(first_frame.read(), views[1]), error_of),
        Case("CPU alone", lambda: nf.metrics.discontinuity(read[0], views[1]), error_of),
    ]
    print(compare(f"Discontinuity of a frame of {SIZE[0]} × {SIZE[1]} pixels, ε = 17, {label}", cases))


def arrays(label: str) -> None:
    """Compare morph and look-up of 10⁷ rows, including upload and read-back."""
    random = np.random.default_rng(0)
    points = (random.random((10_000_000, 3), np.float32) - np.float32(0.5)) * np.float32(150)
    for kind in ("blend", "cylinder"):
        exact = nf.morph(points[FIRST_ROWS].astype(np.float64), **PLACE, kind=kind)
        error_of = partial(greatest_difference, expected=exact)
        cases = [Case(f"{OURS}, device", partial(gpu.morph, points, **PLACE, kind=kind), error_of)]
        cases += [Case("CPU", partial(nf.morph, points, **PLACE, kind=kind), error_of)]
        print(compare(f"Morph ({kind}) of 10⁷ float32 points, sent and read back, {label}", cases, repeat=3, unit="m"))
    faces = random.random((6, 1024, 1024), np.float32)
    for filter_name in ("nearest", "max"):
        error_of = partial(share_that_differs, expected=nf.cube_lookup(faces, points[FIRST_ROWS], filter=filter_name))
        cases = [Case(f"{OURS}, device", partial(gpu.cube_lookup, faces, points, filter=filter_name), error_of)]
        cases += [Case("CPU", partial(nf.cube_lookup, faces, points, filter=filter_name))]
        title = f"Lookup ({filter_name}) of 10⁷ directions in faces of 1024 texels, sent and read back, {label}"
        print(compare(title, cases, repeat=3, unit="share that differ"))


def main() -> None:
    start(__doc__)
    print_limits()
    for backend in sorted({row[1] for row in _core.gpu_adapters() if not row[4]}, reverse=True):
        device = _core.GpuDevice(backend)
        gpu.select(backend)
        frames(device.label)
        arrays(device.label)


if __name__ == "__main__":
    main()
