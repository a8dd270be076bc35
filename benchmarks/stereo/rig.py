"""Error of hybrid stereo pictures by headset, plane and depth, and the time to make a rig."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from nearfar.hmd import Eye
from nearfar.stereo import HybridRig, mono_plane_for

PLANES = (1.6, 3.0, 8.0, 20.0, 40.0)
PAPER = HybridRig(
    left=Eye(nf.Fov(-1.391937, 1.247409, -1.464287, 1.468819), (-0.032, 0.0, 0.0)),
    right=Eye(nf.Fov(-1.246557, 1.398447, -1.472458, 1.465505), (0.032, 0.0, 0.0)),
    mono_plane=8.0,
    size=(1344, 1512),
)
"""The Vive of the paper, 1344 pixels across and eyes 64 mm apart."""


def errors() -> str:
    """Table of the maximum horizontal error of infinitely far points, and of planes for a pixel and for a bend."""
    paper = (PAPER.with_plane(m).max_error() for m in PLANES)
    rows: list[list[object]] = [["the paper's Vive, 1344 px, 64 mm", *paper, None, None]]
    for name in nf.hmd.names():
        hmd = nf.hmd.get(name)
        headset_errors = (HybridRig.of(hmd, mono_plane=m).max_error() for m in PLANES)
        planes = mono_plane_for(hmd=hmd, error_px=1.0), mono_plane_for(hmd=hmd, kink_deg=0.5)
        rows.append([f"{name}, {hmd.render_size[0]} px, {hmd.ipd * 1000:.0f} mm", *headset_errors, *planes])
    planes_of = ("m for 1 px {:.1f}", "m for a bend of 0.5° {:.1f}")
    header = ["headset", *(f"m = {m:g} m {{:.2f}}" for m in PLANES), *planes_of]
    return table("Greatest error in pixels, to the side, of infinitely far points", header, rows)


def times(repeat: int) -> str:
    """Table of the time to make a rig and to compute its properties, microseconds."""
    import timeit

    hmd = nf.hmd.VIVE
    rig = HybridRig.of(hmd, mono_plane=8.0)
    jobs = {
        "make a rig": lambda: HybridRig.of(hmd, mono_plane=8.0),
        "move its plane": lambda: rig.with_plane(7.0),
        "both homographies": lambda: (rig.homography("left"), rig.homography("right")),
        "its three cameras": lambda: rig.cameras((0.0, 1.7, 0.0)),
        "its greatest error": rig.max_error,
    }
    rows = [(name, 1e6 * min(timeit.repeat(job, number=repeat, repeat=5)) / repeat) for name, job in jobs.items()]
    return table("Time, one thread", "job | microseconds {:.1f}", rows)


def draw(path: Path) -> None:
    """Draw the error by depth for several planes, and the error of each pixel of an eye, as figure 2 of the paper."""
    figure, (left, right) = subplots(1, 2, figsize=(11, 4))
    depths = np.geomspace(1.0, 1000.0, 400)
    for plane in PLANES:
        rig = PAPER.with_plane(plane)
        left.plot(depths, [rig.max_error(float(depth)) for depth in depths], label=f"m = {plane:g} m")
    left.axhline(1.0, color="0.7", linewidth=0.8)
    left.set(xscale="log", yscale="log", ylim=(0.05, 30.0), xlabel="depth, m", ylabel="greatest error, pixels")
    left.legend()
    left.grid(alpha=0.3)
    image = right.imshow(np.linalg.norm(PAPER.error_field("left", math.inf), axis=-1), cmap="viridis")
    right.set(xticks=[], yticks=[], title="left eye, m = 8 m, infinitely far points")
    figure.colorbar(image, ax=right, label="error, pixels")
    save_figure(figure, path)


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots")
    print(errors())
    print(times(20 if arguments.quick else 2000))
    if arguments.plots is not None:
        draw(arguments.plots / "stereo_error.png")


if __name__ == "__main__":
    main()
