"""Both eyes of the page's immersive mode, in emulated headsets, compared with `nearfar.render`."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import need
from tests.support.browser import wait_until
from tests.support.headset import (
    HEADSETS,
    Quaternion,
    Vector,
    about,
    capture,
    empty_hands,
    expected,
    eyes,
    floor_of,
    floor_under,
    folder_of,
    frames,
    look,
    point,
    rest,
    share_alike,
    share_equal,
    squeeze,
    times,
    worn,
)

pytestmark = pytest.mark.slow

SIZE = (160, 160)
CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0)
START: Vector = (3.4, 1.7, -2.3)
YAW = 0.6
HEADS: tuple[tuple[Vector, Quaternion], ...] = (
    ((0.0, 1.6, 0.0), (0.0, 0.0, 0.0, 1.0)),
    ((0.3, 1.35, -0.25), times(about((0, 1, 0), 2.0), about((1, 0, 0), -0.3))),
    ((-0.4, 1.8, 0.2), times(about((0, 1, 0), -1.3), about((0, 0, 1), 0.25))),
)
FIRST: Vector = (0.0, 1.6, 0.0)
SETTINGS: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}


def eyes_of(head: tuple[Vector, Quaternion], kind: str) -> dict[str, nf.Camera]:
    return eyes(floor_under(START, YAW, FIRST), head, HEADSETS[kind], SIZE)


def test_each_eye_sees_the_picture_of_its_own_position(chromium: Any, city: nf.Scene, tmp_path: Path) -> None:
    need("web")
    kind = "quest3"
    bundle = nf.stream.export(city, tmp_path / "bundle", center=CENTER, radii=RADII, **SETTINGS)
    held = bundle._manifest["regions"][0]["rings"][2]["geometry"]
    place = ",".join(map(str, START))
    with (
        Server.of_bundle(folder_of(bundle)) as server,
        worn(
            chromium, f"{server.url}?aa=0#p={place}&yaw={YAW}&pitch=-0.2", kind, SIZE, 1, layers=True, held=held
        ) as page,
    ):
        empty_hands(page)
        look(page, *HEADS[1])
        found = capture(page, "shown.ring === 1 && shown.grown.strength === 1")
        assert found.shown["fading"] is None
        # No browser layer shows the map where something moves.
        assert bundle._manifest["dynamic"]
        assert page.evaluate("() => window.emulated.layers.cube") is None
        # A ring fades in for both eyes.
        page.let_go()
        found = capture(page, "shown.fading && shown.fading.ring === 2 && Math.abs(shown.fading.share - 0.5) < 0.35")
        grown, share = found.shown["grown"], found.shown["fading"]["share"]
        cameras = eyes_of(HEADS[1], kind)
        for side, pixels in (("left", found.left), ("right", found.right)):
            before, inner = expected(bundle, {"ring": 1, **grown}, cameras[side])
            after, inner_after = expected(bundle, {"ring": 2, **grown}, cameras[side])
            blended = (1 - share) * np.rint(before) + share * np.rint(after)
            assert np.abs(after - before).max() > 30
            assert share_alike(pixels, blended, inner & inner_after) >= 0.98
        for head in HEADS:
            look(page, *head)
            found = capture(page, f"shown.ring === 2 && !shown.fading && shown.grown.radius === {RADII[1]}")
            cameras = eyes_of(head, kind)
            for side, pixels in (("left", found.left), ("right", found.right)):
                codes, inner = expected(bundle, {"ring": 2, **found.shown["grown"]}, cameras[side])
                assert inner.mean() > 0.4
                assert share_alike(pixels, codes, inner) >= 0.99
            # Shaders received both eyes' positions relative to the centre, and no others.
            places = np.array([np.subtract(cameras[side].position, CENTER) for side in ("left", "right")])
            assert found.eyes.shape == (2, 3)
            assert np.abs(found.eyes[np.argsort(found.eyes[:, 0])] - places[np.argsort(places[:, 0])]).max() < 1e-5
        assert page.printed == []


def test_walking_on_leads_to_the_next_region(chromium: Any, tmp_path: Path) -> None:
    """A jump leads across the border between two centres, where the next one's picture takes over for both eyes."""
    need("web")
    centers = [CENTER, (CENTER[0], CENTER[1], CENTER[2] - 8.0)]
    scene = nf.datasets.city(blocks=2, detail=1)
    bundle = nf.stream.export(scene, tmp_path / "regions", center=centers, radii=(10.0,), **SETTINGS)
    level: Quaternion = (0.0, 0.0, 0.0, 1.0)
    place = f"{CENTER[0]},{CENTER[1]},{CENTER[2] - 2.5}"
    with (
        Server.of_bundle(folder_of(bundle)) as running,
        worn(chromium, f"{running.url}?aa=0&strategy=clovrd#p={place}&yaw=0", "quest3", SIZE, 1) as page,
    ):
        look(page, FIRST, level)
        # Level from a height of 1.5 m: four metres ahead.
        point(page, "right", (0.0, 1.5, 0.0), level)
        point(page, "left", (0.0, -90.0, 0.0), level)
        frames(page, 3)
        squeeze(page, "right", 1)
        frames(page, 3)
        squeeze(page, "right", 0)
        wait_until(page, lambda: page.evaluate("() => window.nearfar.viewer.facts.region") == 1)
        empty_hands(page)
        rest(page)
        wait_until(page, lambda: page.evaluate("() => window.nearfar.viewer.facts.leaving") is None)
        found = capture(page, "shown.ring === 1 && window.nearfar.viewer.facts.region === 1")
        floor = floor_of(page, centers[1])
        assert np.hypot(*(floor.position - centers[1])[[0, 2]]) < 7
        region, grown = bundle.region(1), found.shown["grown"]
        cameras = eyes(floor, (FIRST, level), HEADSETS["quest3"], SIZE)
        assert share_equal(region, {"ring": 1, **grown}, found, cameras) >= 0.98
