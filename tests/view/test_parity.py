"""Pictures of the page compared with bent rays: four scenes, four radii and strengths of each, three poses."""

from __future__ import annotations

from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import open_page, still, wait_until
from tests.support.held_rings import HeldRings
from tests.support.page_pictures import camera, of_one_face, off
from tests.support.page_scenes import PAGE_SCENES
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

SIZE = (360, 240)


def shows(page: SteppedPage, start: dict[str, Any], ring: int) -> bool:
    """Draw a frame; returns whether it shows this ring."""
    shown = page.frame(start, 0.1)["shown"]
    return bool(shown) and shown["ring"] == ring


@pytest.mark.parametrize("name", PAGE_SCENES)
def test_pictures_equal_bent_rays(chromium: Any, tmp_path: Path, name: str) -> None:
    case = PAGE_SCENES[name]
    # Lossless, so that only the drawing differs.
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    bundle = nf.stream.export(case.make(), tmp_path / "bundle", center=case.center, radii=case.radii, **settings)
    start = {"position": list(case.center), "yaw": 0.0, "pitch": 0.0}
    with Server.of_bundle(bundle._reader.location) as server, open_page(chromium, *SIZE) as shown:
        held = HeldRings(shown, bundle)
        # Multiple samples would mix colours of several faces.
        shown.goto(f"{server.url}?aa=0&strategy=clovrd")
        page = SteppedPage(shown)
        for ring, radius, strength in ((0, 0.0, 0.0), *case.shown):
            if ring > 0:
                held.release(ring)
            wait_until(shown, partial(shows, page, start, ring))
            picture: dict[str, Any] = {"ring": ring, "radius": radius, "strength": strength}
            drawn = bundle.at(**picture)
            for away, yaw, pitch in case.poses:
                # Before ring 1 everything is shown from the centre.
                eye = np.add(case.center, away).tolist() if ring > 0 else case.center
                found = still(shown, picture, {"position": eye, "yaw": yaw, "pitch": pitch})
                frame = drawn.render(camera(eye, yaw, pitch, SIZE), channels=("color", "face_id"), method="exact")
                is_equal, inner = off(frame, found) <= 2, of_one_face(frame.require("face_id"))
                if ring == 0:
                    assert is_equal.mean() > 0.9
                    continue
                assert inner.mean() > 0.4
                assert is_equal[inner].mean() >= 0.99
                # Along edges of faces rounding of coordinates decides what a pixel shows.
                assert is_equal[~inner].mean() >= 0.9
        assert shown.printed == []
