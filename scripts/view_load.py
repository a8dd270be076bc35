"""Makes docs/view_load.gif: the page while a bundle loads, for a user who sways beside the centre.

python -m scripts.view_load
"""

from __future__ import annotations

import base64
import io
import math
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

import nearfar as nf
from nearfar.cli._page import caption
from nearfar.serve._server import Server
from tests.support.browser import open_page, started, wait_for_ring

TARGET = Path(__file__).resolve().parents[1] / "docs" / "view_load.gif"
SIZE = (400, 250)
CENTER = (-10.5, 1.7, -14.0)
YAW, PITCH = -0.03, 0.05
RADII, SPEED = (10.0, 20.0, 40.0), 2.0
"""Radii in metres; degrees per second at which the picture turns while the morph grows."""
STEP, SHOWN = 1 / 3, 0.1
"""Seconds of the page between two pictures, and display time of each."""
SWAY, PERIOD = 0.7, 6.0
"""Amplitude in metres to either side, and period in seconds of the page."""

# Draws a frame of the page, without its clock.
FRAME = """([pose, seconds]) => {
  const { viewer } = window.nearfar;
  viewer.renderer.setAnimationLoop(null);
  viewer.frame(pose, seconds);
  const { shown } = viewer.facts;
  const url = viewer.renderer.domElement.toDataURL('image/png');
  return { url, ring: shown?.fading?.ring ?? shown?.ring ?? 0, grown: shown?.grown, isFading: !!shown?.fading };
}"""


def main() -> None:
    """Export the city, load it in the page on a stepped clock, and write the pictures."""
    scene = nf.datasets.city(blocks=3, detail=1)
    with tempfile.TemporaryDirectory() as folder, started() as chromium:
        bundle = nf.stream.export(scene, Path(folder) / "city", center=CENTER, radii=RADII, speed=SPEED)
        with Server.of_bundle(bundle._reader.location) as server, open_page(chromium, *SIZE) as page:
            page.goto(server.url)
            assert wait_for_ring(page, 0) == ""
            frames = shown_while_it_loads(page, bundle)
    palette = frames[len(frames) // 2].quantize(192, dither=Image.Dither.NONE)
    reduced = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in frames]
    settings: dict[str, Any] = {"duration": round(1000 * SHOWN), "loop": 0, "optimize": True}
    reduced[0].save(TARGET, save_all=True, append_images=reduced[1:], **settings)


def shown_while_it_loads(page: Any, bundle: nf.stream.Bundle) -> list[Image.Image]:
    """Return the page's pictures until the last ring has grown, each with a caption below."""
    frames: list[Image.Image] = []
    remaining_frames = round(PERIOD / STEP)
    while remaining_frames:
        angle = 2 * math.pi * len(frames) * STEP / PERIOD
        position = [CENTER[0] + SWAY * math.sin(angle), CENTER[1], CENTER[2]]
        state = page.evaluate(FRAME, [{"position": position, "yaw": YAW, "pitch": PITCH}, STEP])
        ring, grown = state["ring"], state["grown"]
        text = "a map and cars" if ring == 0 else f"{ring} of {bundle.count} rings, R = {grown['radius']:.0f} m"
        frames.append(captioned(state["url"], text))
        is_over = ring == bundle.count and grown["radius"] == bundle.radii[-1] and grown["strength"] == 1
        remaining_frames -= is_over
    return frames


def captioned(url: str, text: str) -> Image.Image:
    """Add a line of text to a picture of the canvas."""
    data = base64.b64decode(url.partition(",")[2])
    picture = np.asarray(Image.open(io.BytesIO(data)).convert("RGB"))
    return Image.fromarray(caption(picture, text))


if __name__ == "__main__":
    main()
