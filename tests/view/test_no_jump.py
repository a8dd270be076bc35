"""Complete loads of a city on a stepped clock: no frame of the page jumps, unlike CloVRd, which shows rings at once."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import open_page, wait_until
from tests.support.held_rings import HeldRings
from tests.support.page_pictures import continuity
from tests.support.stepped_page import SteppedPage

pytestmark = pytest.mark.slow

SIZE = (640, 400)
RATE = 72.0
RADII = (10.0, 17.0, 22.0, 32.0, 63.0)
PAIRS = 5
"""Numbers of compared pairs of consecutive frames in a cross-fade, and while the morph grows for a ring."""
SMOOTH = 0.999
"""Least continuity: that of bent rays in the same growth is 0.99902 (docs/stream.md)."""


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    """The city along the avenue, at the height of CloVR's users."""
    (x, _, z), _ = nf.datasets.street_view()
    folder = tmp_path_factory.mktemp("load") / "bundle"
    scene = nf.datasets.city(blocks=3, detail=1)
    return nf.stream.export(scene, folder, center=(x, 1.3, z), radii=RADII, face_size=512)


@pytest.fixture(scope="module")
def pose(bundle: nf.stream.Bundle) -> dict[str, Any]:
    """A user 1 m beside the centre, who looks along the avenue."""
    x, y, z = bundle.center
    return {"position": [x - 1.0, y, z], "yaw": 0.0, "pitch": 0.0}


def of_load(page: SteppedPage, held: HeldRings, pose: dict[str, Any], growth: nf.stream.Growth) -> dict[str, Any]:
    """Continuity while rings fade in, and of pairs of frames while the morph grows, by ring."""
    found: dict[str, Any] = {"fade": [], "growth": []}
    for ring in range(1, len(RADII) + 1):
        held.release(ring)
        wait_for(page, pose, ring)
        first = continuity([page.picture(pose, 1 / RATE)[1] for _ in range(4)])
        # Then to the end of the fade, where the growth begins.
        middle = pairs(page, pose, growth.fade - 6 / RATE)
        last = continuity([page.picture(pose, 1 / RATE)[1] for _ in range(6)])
        found["fade"].append(np.concatenate([first, middle, last]))
        found["growth"].append(pairs(page, pose, growth.seconds(ring) - growth.fade))
        told = page.frame(pose, 60.0)
        assert told["shown"]["ring"] == ring
        assert told["shown"]["grown"] == {"radius": RADII[ring - 1], "strength": 1}
    return found


def pairs(page: SteppedPage, pose: dict[str, Any], seconds: float) -> NDArray[np.float64]:
    """Continuity of pairs of frames a step apart, spread over some seconds."""
    scores = []
    for _ in range(PAIRS):
        page.frame(pose, max(seconds / PAIRS - 2 / RATE, 0.0))
        scores.append(continuity([page.picture(pose, 1 / RATE)[1] for _ in range(2)])[0])
    return np.array(scores)


def wait_for(page: SteppedPage, pose: dict[str, Any], ring: int) -> None:
    """Draw frames of zero duration until a ring is loaded."""
    wait_until(page.page, lambda: page.frame(pose, 0.0)["arrived"] >= ring)


@pytest.mark.stress
def test_a_load_is_smooth_and_clovrd_jumps(chromium: Any, bundle: nf.stream.Bundle, pose: dict[str, Any]) -> None:
    with Server.of_bundle(bundle._reader.location) as server:
        with open_page(chromium, *SIZE) as shown:
            held = HeldRings(shown, bundle)
            shown.goto(server.url)
            page = SteppedPage(shown)
            wait_for(page, pose, 0)
            smooth = of_load(page, held, pose, bundle.growth)
            assert shown.printed == []
        with open_page(chromium, *SIZE) as shown:
            held = HeldRings(shown, bundle)
            shown.goto(f"{server.url}?strategy=clovrd")
            page = SteppedPage(shown)
            wait_for(page, pose, 0)
            pictures = [page.picture(pose, 1 / RATE)[1]]
            for ring in range(1, len(RADII) + 1):
                held.release(ring)
                wait_for(page, pose, ring)
                pictures.append(page.picture(pose, 1 / RATE)[1])
    switches = continuity(pictures)
    worst = min(scores.min() for kind in smooth.values() for scores in kind)
    assert worst >= SMOOTH
    assert 1 - switches.min() > 20 * (1 - SMOOTH)
    assert (1 - switches > 5 * (1 - SMOOTH)).all()
