"""Links against bytes over rate and a packet-by-packet oracle; measures of simulated clients' pictures."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.stream._client_pictures import Pictures, SceneParts
from nearfar.stream._growth import PictureState
from nearfar.stream._strategies import Strategy
from nearfar.stream._transport import Transport
from tests.support.bundle_cases import village, write
from tests.support.transport_oracle import SEGMENT, Oracle

SIZES = {
    "one": [3_000_000],
    "small": [8_000] * 30,
    "mixed": np.random.default_rng(1).integers(2_000, 400_000, 40).tolist(),
}


def times(sizes: list[int], link: nf.stream.Link, seed: int = 0) -> list[float]:
    """Arrival times of files requested at time 0."""
    transport = Transport(link, seed=seed)
    for number, size in enumerate(sizes):
        transport.ask(str(number), size)
    while transport.next_time() < math.inf:
        transport.advance(transport.next_time())
    assert transport.curve[-1] == (max(transport.arrived.values()), sum(sizes))
    return [transport.arrived[str(number)] for number in range(len(sizes))]


@pytest.mark.parametrize("http", [1, 2])
@pytest.mark.parametrize("mbps", [0.1, 50.0, 10_000.0])
def test_without_delay_and_loss_time_equals_bytes_over_rate(http: int, mbps: float) -> None:
    sizes = SIZES["mixed"]
    assert max(times(sizes, nf.stream.Link(mbps, http=http))) == pytest.approx(sum(sizes) * 8 / (mbps * 1e6), rel=1e-12)


def test_a_trace_is_followed() -> None:
    link = nf.stream.Link(trace=([0.0, 1.0, 3.0], [8.0, 0.0, 16.0]))
    # 1 MB in the first second, nothing for two, then 2 MB a second.
    assert times([3_000_000], link) == pytest.approx([4.0])
    assert times([1_000_000], link) == pytest.approx([1.0])
    same = nf.stream.Link(trace=([0.0, 0.3, 0.5], [50.0, 50.0, 50.0]))
    assert times(SIZES["mixed"], same) == pytest.approx(times(SIZES["mixed"], nf.stream.Link(50.0)), rel=1e-9)


@pytest.mark.parametrize("name", SIZES)
@pytest.mark.parametrize("http", [1, 2])
@pytest.mark.parametrize(("mbps", "rtt"), [(5.0, 0.0), (5.0, 50.0), (50.0, 10.0), (50.0, 50.0), (300.0, 30.0)])
def test_the_last_file_arrives_as_in_a_packet_simulation(name: str, http: int, mbps: float, rtt: float) -> None:
    found = max(times(SIZES[name], nf.stream.Link(mbps, rtt_ms=rtt, http=http)))
    oracle = Oracle(SIZES[name], rate=mbps * 125e3, rtt=rtt / 1e3, loss=0.0, http=http)
    # The oracle interleaves responses by packets, ours by frames of 16 KiB, and small files are shorter than those.
    assert found == pytest.approx(max(oracle.arrived.values()), rel=0.05 if name == "small" else 0.03)


@pytest.mark.parametrize("loss", [0.003, 0.02])
def test_losses_delay_files_as_in_a_packet_simulation(loss: float) -> None:
    settings: dict[str, Any] = {"loss": loss, "http": 2}
    ours = [max(times(SIZES["mixed"], nf.stream.Link(50.0, rtt_ms=30.0, **settings), seed)) for seed in range(12)]
    theirs = [
        max(Oracle(SIZES["mixed"], rate=50 * 125e3, rtt=0.03, **settings, seed=seed).arrived.values())
        for seed in range(12)
    ]
    assert np.mean(ours) == pytest.approx(np.mean(theirs), rel=0.2)
    assert np.std(ours) > 0.0


@pytest.mark.parametrize("loss", [0.004, 0.02])
def test_a_long_transfer_has_the_rate_of_the_square_root_law(loss: float) -> None:
    # Long enough that the window left by slow start hardly matters.
    size, rtt = 60_000_000, 0.02
    found = np.mean([times([size], nf.stream.Link(1_000.0, rtt_ms=1e3 * rtt, loss=loss), seed) for seed in range(4)])
    # Mathis et al. 1997.
    assert size / found == pytest.approx(SEGMENT / rtt * math.sqrt(1.5 / loss), rel=0.25)


def test_a_seed_decides_which_packets_are_lost() -> None:
    link = nf.stream.Link(50.0, rtt_ms=30.0, loss=0.01)
    assert times(SIZES["mixed"], link, 3) == times(SIZES["mixed"], link, 3)
    assert times(SIZES["mixed"], link, 3) != times(SIZES["mixed"], link, 4)


def test_a_handshake_precedes_the_first_request() -> None:
    for handshake in (0.0, 1.0, 2.0):
        link = nf.stream.Link(80.0, rtt_ms=100.0, handshake=handshake)
        # A window's worth: the request, the response, and its bytes.
        assert times([10_000], link) == pytest.approx([0.1 * (handshake + 1.0) + 0.001])


def test_empty_files_arrive_with_the_response() -> None:
    assert times([0, 1000, 0], nf.stream.Link(8.0, rtt_ms=10.0, handshake=0.0)) == pytest.approx([0.01, 0.011, 0.01])


def test_a_csv_file_is_a_trace(tmp_path: Path) -> None:
    path = tmp_path / "trace.csv"
    path.write_text("seconds,mbps\n0,8\n1,0\n3,16\n")
    assert nf.stream.Link(trace=path) == nf.stream.Link(trace=([0, 1, 3], [8, 0, 16]))


@pytest.mark.parametrize("text", ["0,1\n1\n", "a,b\nc,d\n", "0,1,2\n"])
def test_damaged_csv_files_are_named(text: str, tmp_path: Path) -> None:
    path = tmp_path / "trace.csv"
    path.write_text(text)
    with pytest.raises(nf.FormatError, match=r"trace\.csv.*row 1|trace\.csv.*row 2"):
        nf.stream.Link(trace=path)


# Measures of simulated clients ----------------------------------------------------------------------------------------
LINK = nf.stream.Link(1.0)
EYE = (1.0, 1.7, 0.5)
SIZE = 32


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return village()


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    return write(tmp_path_factory.mktemp("seen") / "b", by_footprint=True)


def simulate(bundle: nf.stream.Bundle, scene: nf.Scene, strategy: Strategy, **more: Any) -> nf.stream.Timeline:
    given: dict[str, Any] = {"head_path": EYE, "size": SIZE, "every": 10.0, **more}
    return nf.stream.simulate(bundle, link=LINK, strategy=strategy, scene=scene, **given)


@pytest.mark.parametrize(("ring", "radius"), [(1, 5.0), (2, 12.0), (2, 7.0)])
def test_pictures_of_rings_equal_a_reduced_scene(
    bundle: nf.stream.Bundle, scene: nf.Scene, ring: int, radius: float
) -> None:
    camera = nf.Camera.look_at(EYE, (0.0, 1.0, -9.0), fov=nf.Fov.symmetric(90.0), size=(96, 64))
    parts = SceneParts.bake(scene, bundle, camera, SIZE)
    found = Pictures(parts, by_footprint=False).picture(PictureState(ring, radius, 1.0), EYE)
    own = bundle.radii[ring - 1]
    reduced = nf.reduce(
        scene, center=bundle.center, r1=0.7 * own, r2=own, unit="object", morph="cylinder",
        channels=("color", "range", "object_id"), face_size=bundle._manifest["map"]["face_size"], samples=1,
    )  # fmt: skip
    frame = reduced.with_growth(radius).render(camera, channels=("color", "object_id"))
    assert (found.objects != frame.require("object_id")).mean() < 0.002


def test_the_first_map_shows_the_view_from_the_centre(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    line = simulate(bundle, scene, "clovr", head_path=bundle.center)
    # Seen from the centre all states equal the truth, except for texels.
    assert (line.pictures["ovc"][1:] == 1.0).all()
    assert line.pictures["ofc"][1:].min() > 0.9


def test_vis0_shows_nothing_until_the_end_and_vis1_increases(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    whole, parts = (simulate(bundle, scene, strategy).pictures for strategy in ("vis0", "vis1"))
    assert whole["ovc"][0] == 0.0
    assert len(whole["ovc"]) == 2
    assert (np.diff(parts["ovc"]) >= 0.0).all()
    assert parts["ovc"][1] < 0.5
    # The same objects at the end.
    for kind in ("ovc", "ofc"):
        assert whole[kind][-1] == parts[kind][-1] > 0.8


@pytest.mark.slow
def test_growth_is_smooth_where_switches_jump(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    smooth, hard = (simulate(bundle, scene, strategy) for strategy in ("clovr", "clovrd"))
    least = [line.pictures["continuity"][line.pictures["time"] > line.picture + 0.02].min() for line in (smooth, hard)]
    assert least[0] > 0.999 > 0.99 > least[1]
    # Both end with the same picture.
    for kind in ("ovc", "ofc"):
        assert smooth.pictures[kind][-1] == hard.pictures[kind][-1]


def test_equal_pictures_are_rendered_once(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    line = simulate(bundle, scene, "clovrd", every=0.01, duration=3600.0)
    # Three rings, and the truth.
    assert line.renders == 4
    x, y, z = bundle.center
    path = [[0.0, x, y, z], [1.0, x, y, z], [2.0, x + 1.0, y, z]]
    walked = simulate(bundle, scene, "clovrd", head_path=path, every=0.5)
    assert walked.pictures["time"][-1] == 2.0
    assert walked.pictures["continuity"][-1] < 1.0


def test_measures_are_written(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    found = simulate(bundle, scene, "vis0").to_dict()
    assert found["renders"] == 2
    assert len(found["pictures"]["ovc"]) == 2


def test_faces_without_objects_are_refused(bundle: nf.stream.Bundle) -> None:
    loose = nf.Scene.from_arrays(np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, 1]]), np.array([[0, 1, 2]]), face_object=[-1])
    with pytest.raises(ValueError, match="scene: expected faces that all belong to objects"):
        simulate(bundle, loose, "clovr")


def test_a_user_outside_the_region_has_valid_measures(bundle: nf.stream.Bundle, scene: nf.Scene) -> None:
    x, y, z = bundle.center
    far = (x + 10.0, y, z)
    with pytest.warns(UserWarning, match="the picture folds") as told:
        bundle.at(2).render(nf.Camera.look_at(far, (0, 1, 0), fov=nf.Fov.symmetric(90), size=(8, 8)))
    with pytest.warns(UserWarning, match="the picture folds") as simulated:
        simulate(bundle, scene, "clovrd", head_path=far)
    assert str(simulated[-1].message) == str(told[-1].message)
