"""Loads of the page over a link, as measured by benchmarks: marks, files, and lower bounds."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from benchmarks.harness.loads import Network, network
from benchmarks.stream._loaded import files_until, load, plan, requests, simulated_requests, stages
from nearfar.stream._simulate import transfer_size
from nearfar.stream._strategies import Strategy
from tests.support import need
from tests.support.bundled_scenes import bundled_scenes

pytestmark = pytest.mark.slow

LINK = nf.stream.Link(50, rtt_ms=40, http=1, handshake=1)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("loads") / "bundle"
    made = nf.stream.export(
        bundled_scenes()["city"], folder, center=(3.0, 1.7, -2.0), radii=(10.0, 40.0), face_size=256, by_footprint=True
    )
    nf.view.write_page(folder)
    return made


def least_seconds(bundle: nf.stream.Bundle, strategy: Strategy, ring: int) -> float:
    """Transfer time on the link of the files that a ring needs."""
    assert LINK.mbps
    return bytes_of(bundle, files_until(plan(bundle, strategy), ring)) * 8e-6 / LINK.mbps


def bytes_of(bundle: nf.stream.Bundle, names: set[str]) -> int:
    """Transferred bytes of files; another compressor packs slightly better or worse."""
    listed, read = bundle._manifest["files"], bundle._reader.read
    return int(0.97 * sum(transfer_size(name, int(listed[name]["bytes"]), read) for name in names))


def check(way: Network, opened: tuple[Any, str], bundle: nf.stream.Bundle, strategy: Strategy) -> None:
    found = load(way, *opened, bundle, strategy)
    rings = stages(strategy, len(plan(bundle, strategy).radii))
    for name, ring in rings.items():
        times = getattr(found, name)
        assert times["received"] <= times["ready"] <= times["shown"]
        # Chromium's own throttle passes slightly more.
        assert times["received"] > 0.9 * least_seconds(bundle, strategy, ring) + LINK.rtt
    assert found.picture["ready"] <= found.total["ready"]
    assert found.first_ring["shown"] <= found.total["shown"]
    assert (found.picture == found.total) == strategy.startswith("vis")
    assert found.bytes > bytes_of(bundle, files_until(plan(bundle, strategy), rings["total"]))
    assert found.protocol == "http/1.1"
    if way.real:
        assert way.real.counts()["down"]["delivered_bytes"] > found.bytes


def check_bound(way: Network, opened: tuple[Any, str], bundle: nf.stream.Bundle, strategy: Strategy) -> None:
    """Check that no link is faster than its simulation; Chromium's throttle has no windows and no handshakes."""
    real = requests(way, *opened, bundle, strategy)
    ours = simulated_requests(bundle, LINK, strategy, 0)
    for name, seconds in real.items():
        assert 0.9 * ours[name] < seconds


@pytest.mark.parametrize(("kind", "strategies"), [("real", ("clovrd", "vis1")), ("throttle", ("clovr", "vis0"))])
def test_the_page_marks_loaded_and_displayed_rings(
    bundle: nf.stream.Bundle, kind: str, strategies: tuple[Strategy, ...]
) -> None:
    need("browser")
    if kind == "real":
        need("link")
    with (
        network(LINK, real=kind == "real") as way,
        way.serve_bundle(Path(bundle._reader.location)) as url,
        way.browser(url) as chromium,
    ):
        for strategy in strategies:
            check(way, (chromium, url), bundle, strategy)
        if kind == "real":
            check_bound(way, (chromium, url), bundle, "clovrd")
