"""The map of the page's immersive mode as a layer of the browser's, and samples of its framebuffer.

Layers are tested with a stand-in for the browser's part of WebXR Layers (web/tests/xr/layers.ts): no browser has a
headset here. The stand-in draws the layers of a session onto the canvas.
"""

from __future__ import annotations

from collections.abc import Iterator
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
    alike,
    capture,
    empty_hands,
    eyes,
    floor_of,
    floor_under,
    folder_of,
    frames,
    look,
    push,
    times,
    worn,
)

pytestmark = pytest.mark.slow

SIZE = (240, 240)
CENTER: Vector = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0)
START: Vector = (3.4, 1.7, -2.3)
YAW = 0.6
FIRST: Vector = (0.0, 1.6, 0.0)
HEAD: tuple[Vector, Quaternion] = ((0.15, 1.5, -0.1), times(about((0, 1, 0), 2.0), about((1, 0, 0), -0.3)))
PICTURE = {"ring": 2, "radius": RADII[1], "strength": 1.0}


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("layer") / "bundle"
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    scene = nf.datasets.city(blocks=3, detail=1)
    # Nothing moves.
    scene = scene.subset(objects=[name for name in scene.object_names if name not in scene.poses])
    return nf.stream.export(scene, folder, center=CENTER, radii=RADII, **settings)


@pytest.fixture(scope="module")
def server(bundle: nf.stream.Bundle) -> Iterator[str]:
    need("web")
    with Server.of_bundle(folder_of(bundle)) as running:
        yield running.url


def address(server: str, query: str) -> str:
    place = ",".join(map(str, START))
    return f"{server}?{query}#p={place}&yaw={YAW}"


def counts(page: Any) -> dict[str, Any]:
    """Counts of the stand-in for layers."""
    return dict(page.evaluate("() => window.emulated.layers"))


@pytest.mark.parametrize("kind", HEADSETS)
def test_a_layer_of_the_browser_shows_the_map(chromium: Any, server: str, bundle: nf.stream.Bundle, kind: str) -> None:
    def cameras(floor: Floor) -> dict[str, nf.Camera]:
        return eyes(floor, HEAD, HEADSETS[kind], SIZE)

    with worn(chromium, address(server, "aa=0&strategy=clovrd"), kind, SIZE, 2, layers=True) as page:
        empty_hands(page)
        look(page, *HEAD)
        found = capture(page, "window.emulated.layers.clear > 0.1")
        assert counts(page)["writes"] == 1
        assert alike(bundle, PICTURE, found, cameras(floor_under(START, YAW, FIRST))) >= 0.99
        # The map stays where it is when the user turns.
        push(page, "right", 1.0, 0.0)
        frames(page, 3)
        turned = floor_of(page, CENTER)
        assert np.degrees(turned.yaw - YAW) == pytest.approx(-30)
        found = capture(page, "window.emulated.layers.clear > 0.1")
        assert alike(bundle, PICTURE, found, cameras(turned)) >= 0.99
        assert counts(page)["writes"] == 1
        # A map that the browser loses is copied again, and drawn by the page in the meantime.
        page.evaluate("() => { window.emulated.layers.cube.needsRedraw = true; }")
        frames(page, 3)
        assert counts(page)["writes"] == 2
        assert page.printed == []


def test_the_page_draws_the_map_while_it_changes(chromium: Any, server: str, bundle: nf.stream.Bundle) -> None:
    held = bundle._manifest["regions"][0]["rings"][2]["geometry"]
    with worn(chromium, address(server, "aa=0"), "quest3", SIZE, 1, layers=True, held=held) as page:
        empty_hands(page)
        look(page, *HEAD)
        capture(page, "shown.ring === 1 && shown.grown.strength === 1 && window.emulated.layers.clear > 0.1")
        assert counts(page)["writes"] == 1
        page.let_go()
        # Of that very frame: a busy machine may have shown others when the answer is here.
        noted = "((window.clearThen = window.emulated.layers.clear), true)"
        found = capture(page, f"shown.fading && shown.fading.share > 0.1 && {noted}")
        assert page.evaluate("() => window.clearThen") == 0
        assert found.shown["fading"]["ring"] == 2
        capture(page, "shown.ring === 2 && window.emulated.layers.clear > 0.1")
        assert counts(page)["writes"] == 2


def test_samples_are_resolved_once_a_frame(chromium: Any, server: str) -> None:
    """three.js lets go of samples when it resolves them: what is drawn after that would be lost on a device."""
    with worn(chromium, address(server, "strategy=clovrd"), "quest3", SIZE, 2, layers=True) as page:
        page.evaluate("() => { Object.assign(window.emulated.layers, { lost: 0, resolves: 0 }); }")
        frames(page, 5)
        found = counts(page)
        # With one sample a pixel there would be nothing to resolve.
        assert found["resolves"] >= 4
        assert found["lost"] == 0
