"""The map of the page's immersive mode as a browser layer, and multisampling of its framebuffer.

Layers are tested with a stand-in for the browser's part of WebXR Layers (web/tests/xr/layers.ts): no browser has a
headset here. The stand-in draws the layers of a session onto the canvas.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import need
from tests.support.headset import (
    HEADSETS,
    Floor,
    Quaternion,
    Vector,
    about,
    capture,
    empty_hands,
    eyes,
    floor_of,
    floor_under,
    folder_of,
    frames,
    look,
    push,
    share_equal,
    times,
    worn,
)

pytestmark = pytest.mark.slow

SIZE = (160, 160)
CENTER: Vector = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0)
START: Vector = (3.4, 1.7, -2.3)
PLACE = ",".join(map(str, START))
YAW = 0.6
FIRST: Vector = (0.0, 1.6, 0.0)
HEAD: tuple[Vector, Quaternion] = ((0.15, 1.5, -0.1), times(about((0, 1, 0), 2.0), about((1, 0, 0), -0.3)))


CLEAR = "window.emulated.layers.clear > 0.1"
"""The page leaves pixels to the layer."""


def counts(page: Any) -> dict[str, Any]:
    """Counts of the stand-in for layers."""
    return dict(page.evaluate("() => window.emulated.layers"))


def cameras(floor: Floor) -> dict[str, nf.Camera]:
    return eyes(floor, HEAD, HEADSETS["quest2"], SIZE)


def test_a_browser_layer_shows_the_map_while_nothing_changes(chromium: Any, city: nf.Scene, tmp_path: Path) -> None:
    need("web")
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    # Nothing moves.
    scene = city.subset(objects=[name for name in city.object_names if name not in city.poses])
    bundle = nf.stream.export(scene, tmp_path / "bundle", center=CENTER, radii=RADII, **settings)
    held = bundle._manifest["regions"][0]["rings"][2]["geometry"]
    with (
        Server.of_bundle(folder_of(bundle)) as server,
        worn(chromium, f"{server.url}#p={PLACE}&yaw={YAW}", "quest2", SIZE, 1, layers=True, held=held) as page,
    ):
        empty_hands(page)
        look(page, *HEAD)
        found = capture(page, f"shown.grown.strength === 1 && {CLEAR}")
        assert counts(page)["writes"] == 1
        assert (
            share_equal(bundle, {"ring": 1, **found.shown["grown"]}, found, cameras(floor_under(START, YAW, FIRST)))
            >= 0.99
        )
        # The map stays in place when the user turns.
        push(page, "right", 1.0, 0.0)
        frames(page, 3)
        turned = floor_of(page, CENTER)
        assert np.degrees(turned.yaw - YAW) == pytest.approx(-30)
        found = capture(page, CLEAR)
        assert share_equal(bundle, {"ring": 1, **found.shown["grown"]}, found, cameras(turned)) >= 0.99
        assert counts(page)["writes"] == 1
        # A map lost by the browser is copied again, and drawn by the page in the meantime.
        page.evaluate("() => { window.emulated.layers.cube.needsRedraw = true; }")
        frames(page, 3)
        assert counts(page)["writes"] == 2
        # three.js discards samples when it resolves them: later draws would be lost on a device.
        page.evaluate("() => { Object.assign(window.emulated.layers, { lost: 0, resolves: 0 }); }")
        frames(page, 5)
        # With one sample per pixel there would be nothing to resolve.
        assert counts(page)["resolves"] >= 4
        assert counts(page)["lost"] == 0
        # The page draws the map while it changes.
        page.let_go()
        # Counts of that very frame: a busy machine may have drawn others before the answer arrives.
        noted = "((window.clearThen = window.emulated.layers.clear), true)"
        found = capture(page, f"shown.fading && shown.fading.share > 0.1 && {noted}")
        assert page.evaluate("() => window.clearThen") == 0
        assert found.shown["fading"]["ring"] == 2
        found = capture(page, f"shown.ring === 2 && shown.grown.radius === {RADII[1]} && {CLEAR}")
        assert share_equal(bundle, {"ring": 2, **found.shown["grown"]}, found, cameras(turned)) >= 0.99
        assert counts(page)["writes"] == 3
        assert page.printed == []
