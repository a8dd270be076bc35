"""The four strategies on a virtual clock: order of files, times, growth, bytes, and invalid input."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import httpx
import numpy as np
import pytest

import nearfar as nf
from benchmarks.stream import _comparison
from nearfar.serve._server import Server
from nearfar.stream._strategies import STRATEGIES, Strategy, plan_of
from tests.support import need
from tests.support.bundle_cases import write

LINK = nf.stream.Link(8.0)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    return write(tmp_path_factory.mktemp("simulate") / "b", by_footprint=True)


def size_of(bundle: nf.stream.Bundle, names: Any) -> int:
    return sum(bundle._manifest["files"][name]["bytes"] for name in set(names))


def manifest_size(bundle: nf.stream.Bundle) -> int:
    return len((Path(bundle._reader.location) / "manifest.json").read_bytes())


@pytest.mark.parametrize("strategy", STRATEGIES)
def test_without_delay_each_ring_appears_with_its_last_byte(bundle: nf.stream.Bundle, strategy: Strategy) -> None:
    line = nf.stream.simulate(bundle, link=LINK, strategy=strategy)
    plan = plan_of(strategy, bundle._region, 0, bundle._manifest["dynamic"])
    names: list[str] = []
    for step in plan.steps:
        names += step.files
        if step.ring is None or (strategy == "clovr" and step.ring > 1):
            continue
        least = (manifest_size(bundle) + size_of(bundle, names)) / 1e6
        if strategy == "clovrd" and step.ring >= 1:
            # Files of the next ring arrive in between.
            assert line.ring_times[step.ring] >= least - 1e-9
        else:
            assert line.ring_times[step.ring] == pytest.approx(least, rel=1e-9) or step.ring == 1
    assert line.total == pytest.approx(line.ring_times[-1])
    assert line.bytes_at(line.total) == manifest_size(bundle) + size_of(bundle, names)
    assert len(line.files) == len(set(names)) + 1


def test_compressed_files_equal_the_servers(bundle: nf.stream.Bundle) -> None:
    line = nf.stream.simulate(bundle, link=LINK, strategy="clovrd", gzip=True)
    plain = nf.stream.simulate(bundle, link=LINK, strategy="clovrd")
    with Server.of_bundle(bundle._reader.location) as server, httpx.Client(base_url=server.url, timeout=60) as asking:
        sent = {}
        for name in plain.files:
            with asking.stream("GET", name, headers={"Accept-Encoding": "gzip"}) as answer:
                sent[name] = int(answer.headers["content-length"])
    whole = plain.bytes_at(plain.total)
    # The server's manifest contains spaces, and another compressor packs slightly better or worse.
    assert line.bytes_at(line.total) == pytest.approx(sum(sent.values()), rel=0.03)
    assert line.bytes_at(line.total) < 0.8 * whole
    assert line.total < 0.8 * plain.total


def test_a_ring_waits_until_the_one_before_it_has_faded_in(bundle: nf.stream.Bundle) -> None:
    smooth, hard = (nf.stream.simulate(bundle, link=LINK, strategy=name) for name in ("clovr", "clovrd"))
    assert hard.ring_times[2] < smooth.ring_times[1] + 0.1
    between = smooth.ring_times[2] - smooth.ring_times[1]
    # On the virtual clock, whose frames are 1/72 s long: the fade begins and ends with a frame.
    assert bundle.growth.fade <= between < bundle.growth.fade + 3 / 72
    assert smooth.ring_times[:2] == pytest.approx(hard.ring_times[:2])


def test_frames_follow_the_growth(bundle: nf.stream.Bundle) -> None:
    line, growth = nf.stream.simulate(bundle, link=LINK), bundle.growth
    frames = line.frames
    assert (np.diff(frames["time"]) > 0).all()
    assert (frames["ring"][0], frames["ring"][-1]) == (-1, 2)
    assert (frames["radius"][-1], frames["strength"][-1]) == (12.0, 1.0)
    # Ring 1 grows until ring 2 fades in, which pauses it meanwhile.
    grows = (frames["ring"] == 1) & (frames["share"] == 0)
    first = frames["time"][grows][1]
    shown = [growth.strength(1, growth.fade + time - first) for time in frames["time"][grows][1:]]
    np.testing.assert_allclose(frames["strength"][grows][1:] - frames["strength"][grows][1], shown, atol=1e-9)
    # The total growth of both rings, and both fades.
    whole = growth.seconds(1) + growth.seconds(2)
    assert line.grown - line.ring_times[1] == pytest.approx(whole, abs=6 / 72)


def test_hard_switches_show_each_ring_at_once(bundle: nf.stream.Bundle) -> None:
    frames = nf.stream.simulate(bundle, link=nf.stream.Link(0.5), strategy="clovrd").frames
    assert frames["ring"].tolist() == [-1, 0, 1, 2]
    assert frames["radius"].tolist() == [0.0, 0.0, 5.0, 12.0]
    assert frames["strength"].tolist() == [0.0, 0.0, 1.0, 1.0]
    assert not frames["share"].any()


def test_vis0_is_blank_until_loaded_and_vis1_shows_portions(bundle: nf.stream.Bundle) -> None:
    link = nf.stream.Link(0.5)
    whole, parts = (nf.stream.simulate(bundle, link=link, strategy=name) for name in ("vis0", "vis1"))
    assert whole.frames["ring"].tolist() == [-1, len(whole.radii)]
    assert parts.frames["ring"].tolist() == list(range(-1, len(parts.radii) + 1))
    assert whole.picture == parts.picture == whole.first_ring == whole.total
    assert parts.first_ring < whole.first_ring
    assert whole.frames["time"][1] - whole.picture == pytest.approx(0.0, abs=1.01 / 72)


def test_a_distant_user_waits_for_a_radius_that_does_not_fold(bundle: nf.stream.Bundle) -> None:
    x, y, z = bundle.center
    # The margin of ring 1 is 0.7 · 5 m.
    strengths: dict[Strategy, list[float]] = {"clovrd": [0.0, 1.0], "clovr": [0.0]}
    for strategy, shown in strengths.items():
        line = nf.stream.simulate(bundle, link=nf.stream.Link(0.5), strategy=strategy, head_path=(x + 4.0, y, z))
        of_ring = line.frames["strength"][(line.frames["ring"] == 1) & (line.frames["share"] == 0)]
        assert of_ring.tolist() == shown[: len(of_ring)] or not of_ring.any()
        assert line.frames["strength"][-1] == 1.0


def test_an_hour_with_a_user_who_walks(bundle: nf.stream.Bundle) -> None:
    x, y, z = bundle.center
    path = [[0.0, x, y, z], [1800.0, x + 3.0, y, z], [3600.0, x, y, z]]
    line = nf.stream.simulate(bundle, link=nf.stream.Link(0.0001), head_path=path, duration=3600.0)
    assert line.received[-1, 0] <= 3600.0
    assert line.bytes_at(3600.0) == pytest.approx(3600.0 * 12.5, rel=0.01) or math.isfinite(line.total)


def test_decoding_takes_time_in_two_workers(bundle: nf.stream.Bundle) -> None:
    plain = nf.stream.simulate(bundle, link=LINK, strategy="clovrd")
    slow = nf.stream.simulate(bundle, link=LINK, strategy="clovrd", decode_mbs=0.1)
    first = bundle._region["rings"][0]["map"]["color"]
    assert slow.picture - plain.picture == pytest.approx(size_of(bundle, first) / 1e5, rel=0.2)


def test_frame_times_follow_triangle_counts(bundle: nf.stream.Bundle) -> None:
    line = nf.stream.simulate(bundle, link=LINK, frame_ms=2.0, triangles_per_second=1e6)
    np.testing.assert_allclose(line.frames["seconds"], 0.002 + line.frames["triangles"] / 1e6)
    moving = bundle._manifest["dynamic"]["triangles"]
    rows = [row["triangles"] for row in bundle.summary()]
    assert line.frames["triangles"][0] == 0
    assert line.frames["triangles"][-1] == moving + sum(rows)
    # Two pictures while a ring fades in.
    assert line.frames["triangles"].max() == 2 * moving + 2 * rows[1] + rows[2]
    assert line.geometry_share[0] == 0.0
    assert line.geometry_share[-1] == 1.0


def test_the_greatest_radius_that_a_link_loads_in_time(bundle: nf.stream.Bundle) -> None:
    times = nf.stream.simulate(bundle, link=LINK, strategy="clovrd").ring_times
    for seconds, radius in ((times[1] * 0.99, 0.0), (times[1] * 1.01, 5.0), (times[2] * 1.01, 12.0)):
        assert nf.stream.radius_for(bundle, link=LINK, seconds=seconds) == radius


def test_a_timeline_is_saved(bundle: nf.stream.Bundle, tmp_path: Path) -> None:
    line = nf.stream.simulate(bundle, link=LINK, strategy="clovrd", duration=0.02)
    line.to_json(tmp_path / "line.json")
    found = json.loads((tmp_path / "line.json").read_text())
    assert found == line.to_dict()
    assert found["total"] is None
    assert "clovrd" in repr(line)
    with pytest.raises(ValueError, match="time: expected times of at least 0"):
        line.bytes_at(-1.0)


def test_a_timeline_is_plotted(bundle: nf.stream.Bundle, monkeypatch: pytest.MonkeyPatch) -> None:
    need("matplotlib")
    monkeypatch.setenv("MPLBACKEND", "agg")
    line = nf.stream.simulate(bundle, link=LINK, strategy="clovrd")
    for value, rows in (("bytes", line.received[:, 1]), ("radius", line.frames["radius"])):
        np.testing.assert_array_equal(line.plot(value=value).lines[0].get_ydata(), rows)


def test_bundles_without_objects_by_footprint_are_refused(tmp_path: Path) -> None:
    plain = write(tmp_path / "b")
    with pytest.raises(ValueError, match="export the scene with by_footprint=True"):
        nf.stream.simulate(plain, link=LINK, strategy="vis0")


# Statistics of the benchmark of strategies ----------------------------------------------------------------------------
def test_users_are_seeded_and_two_metres_off() -> None:
    center = (1.0, 1.3, -2.0)
    found = _comparison.users(center)
    assert found == _comparison.users(center) != _comparison.users(center, seed=2)
    assert len(found) == 20
    for (x, y, z), _ in found:
        assert math.hypot(x - 1.0, z + 2.0) == pytest.approx(2.0)
        assert y == 1.3


def test_the_greatest_z_of_twenty_pairs_is_3_92() -> None:
    dice = np.random.default_rng(2)
    base = dice.uniform(0.0, 0.1, 20)
    # Each strategy has more than the previous one, by different amounts; the last two differ at random.
    noise = dice.normal(0.0, 0.01, (20, 4))
    values = base[:, None] + np.array([0.0, 0.2, 0.5, 0.5]) + noise
    chi, p, pairs = _comparison.significance(values)
    assert chi > 50.0
    assert p < 1e-10
    for pair in pairs[:-1]:
        assert pair.z == pytest.approx(-3.92, abs=0.01)
        assert pair.p == pytest.approx(8.9e-5, abs=1e-6)
    assert abs(pairs[-1].z) < 2.64
    assert pairs[-1].p > _comparison.ALPHA


def test_the_level_is_corrected_for_six_comparisons() -> None:
    assert pytest.approx(0.008333, abs=1e-6) == _comparison.ALPHA


def test_means_weight_values_by_duration() -> None:
    times, values = np.array([0.0, 1.0, 3.0]), np.array([0.0, 1.0, 0.5])
    assert _comparison.mean_over_time(times, values, 4.0) == pytest.approx(2.5 / 4.0)
    assert _comparison.mean_over_time(times, values, 2.0) == pytest.approx(0.5)
