"""Zones against planes: the bend of a beam from pixel to pixel, the error, and the time of a frame."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np

import nearfar as nf
from benchmarks.harness.report import save_figure, start, subplots, table
from benchmarks.harness.timing import best
from benchmarks.stereo.rig import PAPER

PLANE = 3.0
ENDS = (4.0, 6.0, 12.0, 24.0)
HEAD = (0.0, 1.7, 0.0)
BEAM = ((-0.16, 1.5, -1.4), (0.9, 1.25, -30.0))
"""Beam ends visible beside the left eye's axis, metres."""


def beam() -> nf.Scene:
    """A beam of 6 × 6 cm over a plain floor."""
    import trimesh

    ends = np.array(BEAM)
    axis = ends[1] - ends[0]
    bar = trimesh.creation.box((0.06, 0.06, float(np.linalg.norm(axis))))
    bar.apply_transform(trimesh.geometry.align_vectors((0.0, 0.0, 1.0), axis))
    bar.apply_translation(ends.mean(axis=0))
    bar.visual.face_colors = (224, 96, 48)
    floor = trimesh.creation.box((80.0, 0.1, 80.0)).apply_translation((0.0, -0.05, 0.0))
    floor.visual.face_colors = (150, 150, 140)
    scene = trimesh.Scene()
    scene.add_geometry(bar, geom_name="bar")
    scene.add_geometry(floor, geom_name="floor")
    return nf.Scene.from_trimesh(scene)


def greatest_turn(rig: nf.stereo.HybridRig) -> float:
    """Maximum change of the beam's direction, degrees, over ten of the paper's pixels of the left eye's picture."""
    camera = rig.cameras(HEAD)[0]
    fov = rig.left.fov
    density = PAPER.size[0] / (fov.right - fov.left)
    start, end = (np.subtract(point, camera.position) for point in BEAM)
    depths = 1.0 / np.linspace(-1.0 / start[2], -1.0 / end[2], 2000)
    tangents = []
    for depth in depths:
        fraction = (depth + start[2]) / (start[2] - end[2])
        point = start + fraction * (end - start)
        tangents.append(rig.shown("left", point[:2] / depth, depth=float(depth)))
    path = np.array(tangents) * density
    lengths = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))])
    steps = np.arange(0.0, lengths[-1], 10.0)
    even = np.stack([np.interp(steps, lengths, column) for column in path.T], axis=-1)
    angles = np.unwrap(np.arctan2(*np.diff(even, axis=0).T))
    return float(np.degrees(np.abs(np.diff(angles)).max()))


def measure(size: tuple[int, int], repeat: int) -> str:
    scene = nf.datasets.beams()
    rows = []
    base = nf.stereo.HybridRig(left=PAPER.left, right=PAPER.right, mono_plane=PLANE, size=size)
    for rig in (base, *(base.with_plane((PLANE, end)) for end in ENDS)):
        timing = best(partial(rig.render, scene, HEAD, backend="cpu", channels=("color",)), repeat=repeat)
        end = f"{PLANE:g} to {rig.planes[1]:g}" if rig.has_zone else f"{PLANE:g}"
        rows.append([end, rig.max_error(), greatest_turn(rig), timing.wall])
    header = "plane or zone, m | greatest error, px {:.1f} | greatest turn of a beam in ten pixels, degrees {:.3f}"
    header += " | frame of beams, s {:.2f}"
    return table(f"Zones, {size[0]} × {size[1]} pixels an eye", header, rows)


def draw(path: Path) -> None:
    """Draw the beam through a plane and through a zone, and the errors of both."""
    scene, base = beam(), nf.stereo.HybridRig(left=PAPER.left, right=PAPER.right, mono_plane=PLANE, size=PAPER.size)
    zone = base.with_plane((PLANE, 12.0))
    figure, axes = subplots(1, 3, figsize=(11, 4), width_ratios=(1, 1, 1.2))
    for axis, rig, title in ((axes[0], base, "a plane at 3 m"), (axes[1], zone, "a zone from 3 to 12 m")):
        picture = rig.render(scene, HEAD, samples=8, backend="cpu", channels=("color",)).left.to_image()
        height, width = picture.shape[:2]
        row, column = round(height * 0.56), round(width * 0.515)
        axis.imshow(picture[row - 95 : row, column - 50 : column + 45], interpolation="nearest")
        axis.set(title=title, xticks=[], yticks=[])
    depths = np.geomspace(1.0, 60.0, 300)
    for rig, name in ((base, "plane"), (zone, "zone")):
        axes[2].semilogx(depths, [rig.max_error(float(depth)) for depth in depths], label=name)
    axes[2].set(xlabel="depth, metres", ylabel="greatest error, pixels", title="Paper's Vive, 1344 pixels")
    axes[2].legend()
    axes[2].grid(alpha=0.3)
    save_figure(figure, path, dpi=90)


def main() -> None:
    arguments = start(__doc__, "--quick", "--plots")
    print(measure((168, 189) if arguments.quick else PAPER.size, 1 if arguments.quick else 3))
    if arguments.plots is not None:
        draw(arguments.plots / "stereo_zone.png")


if __name__ == "__main__":
    main()
