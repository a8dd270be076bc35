"""Makes docs/stream.jpg: a client's pictures of a bundle, ring by ring, and the full scene.

python -m scripts.stream_picture
"""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from PIL import Image

import nearfar as nf
from nearfar.cli._page import caption

TARGET = Path(__file__).resolve().parents[1] / "docs" / "stream.jpg"
VIEW = nf.Camera.look_at((1.0, 1.6, 0.5), (-2.0, 4.0, -40.0), fov=nf.Fov.symmetric(90, 1.6), size=(640, 400))


def main() -> None:
    """Export the city, draw each ring, and write the picture."""
    scene = nf.datasets.city(blocks=3)
    with tempfile.TemporaryDirectory() as folder:
        bundle = nf.stream.export(scene, Path(folder) / "city", center=(0.0, 1.7, 0.0))
        pictures = []
        for ring, row in enumerate(bundle.summary()):
            size = sum(row[kind] for kind in ("dynamic", "geometry", "color", "range")) / 1000
            text = "first picture: a map and cars" if ring == 0 else f"ring {ring}, to {row['radius']:.0f} m"
            picture = nf.render(bundle.at(ring), VIEW, samples=8, channels=("color",)).to_image()
            pictures.append(caption(picture, f"{text}, {size:,.0f} kB"))
    truth = nf.render(scene, VIEW, samples=8, channels=("color",)).to_image()
    pictures.append(caption(truth, f"full scene: {scene.triangle_count:,} triangles"))
    blank = [np.full_like(pictures[0], 255)] * (len(pictures) % 2)
    rows = [np.concatenate(pair, axis=1) for pair in zip(pictures[::2], [*pictures[1::2], *blank], strict=True)]
    Image.fromarray(np.concatenate(rows)).save(TARGET, quality=84, optimize=True)


if __name__ == "__main__":
    main()
