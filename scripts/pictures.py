"""Makes the pictures of the README: `python -m scripts.pictures [city] [tokyo] [curve] [lod]`, into docs/.

City and Tokyo show truth, conventional and continuous method from one eye: the city also impostors, and Tokyo an
enlarged part of each.
"""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image

import nearfar as nf
from nearfar._base import data
from nearfar.cli._page import caption, save_curve
from scripts.lod_picture import draw_lod

DOCS = Path(__file__).resolve().parent.parent / "docs"
SIZE = (1440, 900)
COLUMN = 480
R1, R2 = 30.0, 50.0

Box = tuple[float, float, float, float]
Point = tuple[float, float, float]


def main() -> None:
    """Make the pictures named, or all."""
    DOCS.mkdir(exist_ok=True)
    requested = sys.argv[1:] or ["city", "tokyo", "curve", "lod"]
    if "city" in requested or "curve" in requested:
        city = nf.datasets.city()
        eye, _ = nf.datasets.street_view()
        if "city" in requested:
            draw_city(city, eye)
        if "curve" in requested:
            save_curve(DOCS, nf.load_curve(city, center=eye), R2)
    if "tokyo" in requested:
        tokyo = nf.Scene.load(data.require("city/tokyo23/tokyo_core_lod1.glb"))
        center, forward = np.array([115.0, 1.7, 192.15]), np.array([-0.866, 0.15, 0.5])
        aside = center + 8.0 * np.array([0.5, 0.0, 0.866])
        compare("tokyo", tokyo, point(center), point(aside), point(aside + forward), (0.34, 0.1, 0.8, 0.72))
    if "lod" in requested:
        draw_lod(DOCS / "lod.png")


def draw_city(city: nf.Scene, center: Point) -> None:
    """Draw the city for a user 8 m beside the centre: truth, both published methods, and impostors."""
    user = (center[0], center[1], center[2] - 8.0)
    fov = nf.Fov.symmetric(90, SIZE[0] / SIZE[1])
    view = nf.Camera.look_at(user, np.add(user, (-40.0, 5.3, 0.0)), fov=fov, size=SIZE)
    reduced = nf.reduce(city, center=center, r1=R1, r2=R2, face_size=2048, samples=2)
    impostors = nf.reduce(city, center=center, r2=R2, far="impostors")
    counts = (f"{impostors.triangle_count:,} triangles", f"{impostors.stats['triangles']:,} of them textured quads")
    sources: dict[str, nf.Renderable] = {
        f"the whole city: {city.triangle_count:,} triangles": city,
        f"conventional: {reduced.stats['drawn']:,} triangles and a cube map": reduced.with_morph("none"),
        "continuous: the same, joined by a morph": reduced,
        "impostors: " + ", ".join(counts): impostors,
    }
    cells = []
    for text, source in sources.items():
        whole = Image.fromarray(nf.render(source, view, samples=8, channels=("color",)).to_image())
        small = whole.resize((SIZE[0] // 2, SIZE[1] // 2), Image.Resampling.LANCZOS)
        cells.append(caption(np.asarray(small), text))
    gap = np.full((len(cells[0]), 6, 3), 255, np.uint8)
    rows = [np.concatenate([cells[n], gap, cells[n + 1]], axis=1) for n in (0, 2)]
    Image.fromarray(np.concatenate(rows)).save(DOCS / "city.jpg", quality=86, optimize=True)


def compare(name: str, scene: nf.Scene, center: Point, user: Point, target: Point, part: Box) -> None:
    """Render the pictures side by side, with an enlarged part of each below."""
    view = nf.Camera.look_at(user, target, fov=nf.Fov.symmetric(90, SIZE[0] / SIZE[1]), size=SIZE)
    reduced = nf.reduce(scene, center=center, r1=R1, r2=R2, face_size=2048, samples=2)
    sources: dict[str, nf.Scene | nf.ReducedScene] = {
        f"truth: {scene.triangle_count:,} triangles": scene,
        f"conventional: {reduced.stats['drawn']:,} and a map": reduced.with_morph("none"),
        f"continuous: {reduced.stats['drawn']:,} and a map": reduced,
    }
    frames = {text: nf.render(source, view, samples=8, channels=("color",)) for text, source in sources.items()}
    columns = [column(frame.to_image(), text, part) for text, frame in frames.items()]
    gap = np.full((len(columns[0]), 6, 3), 255, np.uint8)
    sheet = np.concatenate([piece for one in columns for piece in (one, gap)][:-1], axis=1)
    Image.fromarray(sheet).save(DOCS / f"{name}.jpg", quality=86, optimize=True)


def column(picture: NDArray[np.uint8], text: str, part: Box) -> NDArray[np.uint8]:
    """Scale a picture down under its caption, above an enlarged part."""
    whole, (width, height) = Image.fromarray(picture), SIZE
    small = whole.resize((COLUMN, COLUMN * height // width), Image.Resampling.LANCZOS)
    box = (part[0] * width, part[1] * height, part[2] * width, part[3] * height)
    tall = round(COLUMN * (box[3] - box[1]) / (box[2] - box[0]))
    large = whole.resize((COLUMN, tall), Image.Resampling.LANCZOS, box=box)
    gap = np.full((6, COLUMN, 3), 255, np.uint8)
    return np.concatenate([caption(np.asarray(small), text), gap, np.asarray(large)])


def point(values: NDArray[np.float64]) -> Point:
    """A position as three numbers."""
    x, y, z = (float(value) for value in values)
    return x, y, z


if __name__ == "__main__":
    main()
