"""Simulated clients behave like the page: they request the same files in the same order, and show the same states."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from nearfar.stream._growth import Growth, PictureState, PictureTimeline
from nearfar.stream._loading import Loader, follow
from nearfar.stream._simulate import _sizes
from nearfar.stream._strategies import RATE, STRATEGIES, HeadPath, Strategy, plan_of
from nearfar.stream._transport import Transport
from tests.support import need
from tests.support.browser import SMALL, open_page
from tests.support.bundled_scenes import bundled_scenes
from tests.support.stepped_page import SteppedPage
from tests.support.web_cases import run

pytestmark = pytest.mark.slow

CENTER = (3.0, 1.7, -2.0)
RADII = (10.0, 22.0, 63.0)
SPEED, FADE = 0.7, 0.5

DRIVER = """
import { readFileSync, writeFileSync } from 'node:fs';
import { createStage, NOTHING_NEAR } from './stage.mjs';
const [, , input, output] = process.argv;
const told = JSON.parse(readFileSync(input, 'utf8')).map(({ manner, settings, steps }) => {
  const stage = createStage(settings, manner);
  stage.enter(NOTHING_NEAR);
  return steps.map(({ arrives, seconds, least }) => {
    for (const ring of arrives) stage.arrive(ring);
    const shown = stage.advance(seconds, least);
    if (!shown) return [-1, 0, 0, 0];
    return [shown.ring, shown.grown.radius, shown.grown.strength, shown.fading?.share ?? 0];
  });
});
writeFileSync(output, JSON.stringify(told));
"""


def walks() -> list[dict[str, Any]]:
    """Random arrival times, random frame times, and users at random distances."""
    dice = np.random.default_rng(3)
    settings = {"radii": RADII, "speed": SPEED, "reach": 1.0, "nearShare": 0.7, "fade": FADE}
    found = []
    for number in range(60):
        manner = {"isSmooth": number % 3 < 2, "isWhole": number % 5 == 0}
        waiting, steps = [0, 1, 2, 3], []
        for _ in range(200):
            arrives = [waiting.pop(0) for _ in range(int(dice.integers(0, 3))) if waiting and dice.random() < 0.2]
            least = float(dice.choice([0.0, 5.0, 15.0]))
            steps.append({"arrives": arrives, "seconds": float(dice.choice([0.0, 1 / 72, 0.3, 2.0])), "least": least})
        found.append({"manner": manner, "settings": settings, "steps": steps})
    return found


def states(walk: dict[str, Any]) -> list[list[float]]:
    growth = Growth(RADII, speed=SPEED, fade=FADE)
    timeline = PictureTimeline(RADII, growth, is_smooth=walk["manner"]["isSmooth"], is_whole=walk["manner"]["isWhole"])
    found = []
    for step in walk["steps"]:
        for ring in step["arrives"]:
            timeline.arrive(ring)
        shown: PictureState = timeline.advance(step["seconds"], step["least"])
        found.append([shown.ring, shown.radius, shown.strength, shown.share])
    return found


def test_states_equal_the_page(tmp_path: Path) -> None:
    need("web")
    run("npx", "esbuild", "src/show/stage.ts", "--bundle", "--format=esm", f"--outfile={tmp_path / 'stage'}.mjs")
    (tmp_path / "driver.mjs").write_text(DRIVER)
    given = walks()
    (tmp_path / "in.json").write_text(json.dumps(given))
    run("node", str(tmp_path / "driver.mjs"), str(tmp_path / "in.json"), str(tmp_path / "out.json"))
    for walk, told in zip(given, json.loads((tmp_path / "out.json").read_text()), strict=True):
        np.testing.assert_allclose(states(walk), told, rtol=0, atol=1e-9)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    settings: dict[str, Any] = {"center": CENTER, "radii": (10.0, 14.0, 40.0), "face_size": 64, "by_footprint": True}
    return nf.stream.export(bundled_scenes()["city"], tmp_path_factory.mktemp("simulation") / "b", **settings)


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_files_are_requested_in_the_order_of_the_page(
    strategy: Strategy, chromium: Any, bundle: nf.stream.Bundle
) -> None:
    plan = plan_of(strategy, bundle._region, 0, bundle._manifest["dynamic"])
    transport = Transport(nf.stream.Link(50.0, rtt_ms=5.0))
    path = HeadPath.parse(None, CENTER)
    loader = Loader(plan, _sizes(bundle, False), transport, 0.0)
    fold_margin = float(bundle.fold_margins[bundle.number])
    follow(loader, bundle.growth, path, fold_margin, rate=RATE, duration=math.inf)
    asked, urls = dict[str, None](), list[str]()
    names = [*bundle.files, "manifest.json"]
    with Server.of_bundle(bundle._reader.location) as server, open_page(chromium, *SMALL) as page:
        page.on("request", lambda request: asked.update(dict.fromkeys(n for n in names if request.url.endswith(n))))
        page.on("request", lambda request: urls.append(request.url))
        page.goto(f"{server.url}?strategy={strategy}")
        SteppedPage(page).load({"position": list(CENTER), "yaw": 0.0, "pitch": 0.0}, 10.0)
        assert page.evaluate("() => window.nearfar.viewer.facts.arrived") == len(plan.radii)
    assert list(asked) == list(transport.asked)
    # No requests about rooms if no room is named.
    assert not any("rooms" in url for url in urls)
