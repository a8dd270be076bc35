"""Pictures of the page beside those of bent rays: three scenes, three radii and strengths of each, three poses."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.browser import opened, still, wait_for_ring
from tests.support.page_pictures import camera, of_one_face, off
from tests.support.page_scenes import PAGE_SCENES, PageScene

pytestmark = pytest.mark.slow

SIZE = (360, 240)


@pytest.fixture(scope="module", params=list(PAGE_SCENES))
def exported(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> tuple[PageScene, nf.stream.Bundle]:
    """A scene and its bundle; without loss, so that only the drawing differs."""
    case = PAGE_SCENES[request.param]
    folder = tmp_path_factory.mktemp("parity") / "bundle"
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    return case, nf.stream.export(case.make(), folder, center=case.center, radii=case.radii, **settings)


@pytest.mark.parametrize("number", [0, 1, 2])
def test_pictures_are_those_of_bent_rays(
    chromium: Any, exported: tuple[PageScene, nf.stream.Bundle], number: int
) -> None:
    case, bundle = exported
    ring, radius, strength = case.shown[number]
    picture: dict[str, Any] = {"ring": ring, "radius": radius, "strength": strength}
    with Server.of_bundle(bundle._reader.place) as server, opened(chromium, *SIZE) as shown:
        # Samples within a pixel would mix colours of several faces.
        shown.goto(f"{server.url}?aa=0&rings={ring}")
        assert wait_for_ring(shown, ring) == ""
        for away, yaw, pitch in case.poses:
            eye = tuple(np.add(case.center, away).tolist())
            found = still(shown, picture, {"position": list(eye), "yaw": yaw, "pitch": pitch})
            view = camera(eye, yaw, pitch, SIZE)
            frame = bundle.at(**picture).render(view, channels=("color", "face_id"), method="exact")
            is_equal = off(frame, found) <= 2
            inner = of_one_face(frame.require("face_id"))
            assert inner.mean() > 0.4
            assert is_equal[inner].mean() >= 0.99
            # Along edges of faces a rounded coordinate decides what a pixel shows.
            assert is_equal[~inner].mean() >= 0.9
        # Nothing breaks the policy for contents, and shaders have no warnings.
        assert shown.printed == []
