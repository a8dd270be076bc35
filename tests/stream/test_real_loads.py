"""Loads of the page over a link, as benchmarks measure them: marks, files, and what no link can better."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from benchmarks.harness.loads import Network, network
from benchmarks.stream._loaded import files_until, load, plan, stages
from benchmarks.stream._requests import requests, simulated_requests
from nearfar.stream._compressed import sent
from tests.support import need
from tests.support.bundled_scenes import bundled_scenes

pytestmark = pytest.mark.slow

LINK = nf.stream.Link(20, rtt_ms=40, http=1, handshake=1)
STRATEGIES = ("clovr", "clovrd", "vis0", "vis1")


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("loads") / "bundle"
    made = nf.stream.export(
        bundled_scenes()["city"], folder, center=(3.0, 1.7, -2.0), radii=(10.0, 40.0), face_size=256, by_footprint=True
    )
    nf.view.write_page(folder)
    return made


@pytest.fixture(scope="module", params=["real", "throttle"])
def way(request: pytest.FixtureRequest) -> Iterator[Network]:
    need("browser")
    if request.param == "real":
        need("link")
    with network(LINK, real=request.param == "real") as found:
        yield found


@pytest.fixture(scope="module")
def opened(way: Network, bundle: nf.stream.Bundle) -> Iterator[tuple[Any, str]]:
    with way.shown(Path(bundle._reader.place)) as url, way.browser(url) as chromium:
        yield chromium, url


def least_seconds(bundle: nf.stream.Bundle, strategy: str, ring: int) -> float:
    """The time of the link for the files that a ring needs."""
    assert LINK.mbps
    return bytes_of(bundle, files_until(plan(bundle, strategy), ring)) * 8e-6 / LINK.mbps


def bytes_of(bundle: nf.stream.Bundle, names: set[str]) -> int:
    """Bytes of files on their way; another packer packs a little better or worse."""
    listed, read = bundle._manifest["files"], bundle._reader.read
    return int(0.97 * sum(sent(name, int(listed[name]["bytes"]), read) for name in names))


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_the_page_marks_what_it_has_and_shows(
    way: Network, opened: tuple[Any, str], bundle: nf.stream.Bundle, strategy: str
) -> None:
    found = load(way, *opened, bundle, strategy)
    rings = stages(strategy, len(plan(bundle, strategy).radii))
    for name, ring in rings.items():
        times = getattr(found, name)
        assert times["received"] <= times["ready"] <= times["shown"]
        # Chromium's own throttle lets a little more pass.
        assert times["received"] > 0.9 * least_seconds(bundle, strategy, ring) + LINK.rtt
    assert found.picture["ready"] <= found.total["ready"]
    assert found.first_ring["shown"] <= found.total["shown"]
    assert (found.picture == found.total) == strategy.startswith("vis")
    assert found.bytes > bytes_of(bundle, files_until(plan(bundle, strategy), rings["total"]))
    assert found.protocol == "http/1.1"
    if way.real:
        assert way.real.counts()["down"]["delivered_bytes"] > found.bytes


# Chromium's throttle has no windows and no handshakes.
@pytest.mark.parametrize("way", ["real"], indirect=True)
@pytest.mark.parametrize("strategy", ["clovrd", "vis0"])
def test_no_link_is_faster_than_its_simulation(
    way: Network, opened: tuple[Any, str], bundle: nf.stream.Bundle, strategy: str
) -> None:
    real = requests(way, *opened, bundle, strategy)
    ours = simulated_requests(bundle, LINK, strategy, 0)
    for name, seconds in real.items():
        assert 0.9 * ours[name] < seconds
