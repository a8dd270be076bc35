"""Tests of notebook output of reduced scenes: the card, and the explorer with its sliders."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from nearfar._base import card
from nearfar._reduce.drawing import Boundary, MorphKind
from nearfar._reduce.explore import Explorer
from tests.support import need
from tests.support.card_cases import Card, decoded
from tests.support.impostor_cases import SETTINGS, yard
from tests.support.reduce_cases import CENTER, R1, R2, street

SIZE = (64, 40)


def small(scene: nf.Scene, *, morph: MorphKind = "blend", boundary: Boundary = "r2") -> nf.ReducedScene:
    return nf.reduce(
        scene, center=CENTER, r1=R1, r2=R2, face_size=32, samples=1, morph=morph, boundary=boundary, backend="cpu"
    )


@pytest.fixture
def explorer(scene: nf.Scene) -> Explorer:
    need("ipywidgets")
    return small(scene).explore(size=SIZE, face_size=32)


def figures(explorer: Explorer) -> dict[str, str]:
    return Card(explorer.figures.value).facts()


def test_the_card_shows_counts_radii_and_the_map(blend: nf.ReducedScene) -> None:
    shown = Card(blend._repr_html_())
    assert shown.facts()["drawn"].startswith(f"{blend.stats['drawn']:,} of {blend.stats['triangles']:,} triangles")
    assert shown.facts()["r₁, r₂"] == "30 m, 50 m"
    assert len(shown.pictures()) == 1


def test_without_a_map_the_card_explains_why(scene: nf.Scene) -> None:
    whole = nf.reduce(scene.subset(objects=["near"]), center=CENTER, r1=30, r2=50, face_size=8, backend="cpu")
    assert "there is no map" in Card(whole._repr_html_()).text


def test_a_damaged_reduced_scene_shows_its_class() -> None:
    broken = nf.ReducedScene.__new__(nf.ReducedScene)
    assert "ReducedScene, damaged" in broken._repr_html_()


def test_without_ipywidgets_the_error_names_the_extra(scene: nf.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "ipywidgets", None)
    with pytest.raises(ImportError, match="pip install ipywidgets"):
        small(scene).explore()


def test_explorer_pictures_equal_render(explorer: Explorer, scene: nf.Scene) -> None:
    explorer.x.value, explorer.heading.value = 6.0, 60.0
    camera = explorer.camera
    assert camera.position == pytest.approx(np.add(CENTER, (6.0, 0.0, 0.0)))
    truth = nf.render(scene, camera, channels=("color",), backend="cpu")
    picture = explorer.reduced.render(camera, channels=("color",), method="exact", backend="cpu")
    for widget, frame in ((explorer.truth, truth), (explorer.picture, picture)):
        assert widget.value == card.png(frame.to_image())
    assert float(figures(explorer)["SSIM"]) == pytest.approx(nf.ssim(truth, picture), abs=1e-4)


@pytest.mark.parametrize("name", ["x", "z", "height", "heading"])
def test_moving_the_user_changes_both_pictures(explorer: Explorer, name: str) -> None:
    before = explorer.truth.value, explorer.picture.value
    control = getattr(explorer, name)
    control.value += 0.5 * control.max
    assert explorer.truth.value != before[0]
    assert explorer.picture.value != before[1]


def test_radii_are_applied_on_release_and_keep_the_truth(explorer: Explorer) -> None:
    explorer.x.value, explorer.heading.value = 8.0, 90.0
    truth, picture, first = explorer.truth.value, explorer.picture.value, explorer.reduced
    assert not explorer.r1.continuous_update
    assert not explorer.r2.continuous_update
    explorer.r2.value = 120.0
    assert (explorer.reduced.r1, explorer.reduced.r2) == (R1, 120.0)
    assert explorer.reduced is not first
    assert explorer.reduced.env is not None
    assert explorer.reduced.env.face_size == 32
    assert explorer.truth.value == truth
    assert explorer.picture.value != picture
    expected = nf.partition(explorer.reduced.scene, center=CENTER, r1=R1, r2=120.0).summary()["nsf"]
    assert figures(explorer)["triangles"].startswith(f"{expected:,} of ")


def test_r1_stays_below_r2_and_the_user_within_r1(explorer: Explorer) -> None:
    explorer.x.value, explorer.z.value = 25.0, -25.0
    assert math.hypot(explorer.x.value, explorer.z.value) <= R1
    explorer.r1.value = 180.0
    assert explorer.r1.value == explorer.reduced.r1 < explorer.reduced.r2 == R2
    explorer.r1.value = 2.0
    assert math.hypot(explorer.x.value, explorer.z.value) <= 2.0
    assert (explorer.x.min, explorer.x.max) == (-2.0, 2.0)
    explorer.r1.value = 0.0
    assert explorer.x.value == explorer.z.value == 0.0
    assert explorer.x.disabled
    explorer.r2.value = 0.0
    assert 0.0 <= explorer.reduced.r1 < explorer.reduced.r2
    explorer.r1.value, explorer.r2.value = 10.0, 60.0
    assert "not drawn" not in figures(explorer)


def test_the_conventional_method_tears_and_the_continuous_one_does_not(explorer: Explorer) -> None:
    # The wall runs from 3 to 117 m along +x, 20 m beside O, so r2 cuts it in this view.
    explorer.x.value, explorer.z.value, explorer.heading.value = 5.0, 15.0, 75.0
    continuous, before = float(figures(explorer)["discontinuity, mean"]), explorer.picture.value
    explorer.morph.value = "none"
    assert explorer.reduced.morph == "none"
    assert explorer.picture.value != before
    assert float(figures(explorer)["discontinuity, mean"]) > continuous


def test_maps_without_range_are_baked_again_at_start(scene: nf.Scene) -> None:
    need("ipywidgets")
    reduced = small(scene)
    assert reduced.env is not None
    assert reduced.env.range is None
    explorer = reduced.explore(size=SIZE, face_size=16)
    assert explorer.reduced.env.face_size == 16
    assert explorer.reduced.env.range is not None


def test_a_loaded_scene_has_no_truth_and_fixed_radii(scene: nf.Scene, tmp_path: Path) -> None:
    need("ipywidgets")
    small(scene).save(tmp_path / "light")
    explorer = nf.ReducedScene.load(tmp_path / "light").explore(size=SIZE)
    assert explorer.r1.disabled
    assert explorer.r2.disabled
    before = explorer.picture.value
    explorer.heading.value = 60.0
    assert explorer.picture.value != before
    assert explorer.truth.value == b""
    assert "SSIM" not in figures(explorer)
    assert "not saved" in figures(explorer)["far geometry"]


def test_a_map_from_r1_supports_the_conventional_method_only(scene: nf.Scene) -> None:
    need("ipywidgets")
    explorer = small(scene, morph="none", boundary="r1").explore(size=SIZE, face_size=16)
    assert explorer.morph.options == ("none",)
    explorer.r1.value = 20.0
    assert explorer.reduced.r1 == 20.0
    assert "SSIM" in figures(explorer)


def test_r2_is_limited_so_that_frames_are_fast(scene: nf.Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    need("ipywidgets")
    assert small(scene).explore(size=SIZE, face_size=8).r2.max == 4 * R2
    monkeypatch.setattr("nearfar._reduce.explore.MAX_TRIANGLES", 1)
    reduced = small(scene)
    explorer = reduced.explore(size=SIZE, face_size=8)
    assert R2 <= explorer.r2.max < 4 * R2
    explorer.r2.value = explorer.r2.max
    assert explorer.reduced.stats["nsf"] == reduced.stats["nsf"]


def test_failures_are_reported_below_the_pictures(explorer: Explorer, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(*_: object, **__: object) -> None:
        raise nf.DeviceError("<lost>")

    monkeypatch.setattr(nf.ReducedScene, "render", fail)
    explorer.heading.value = 10.0
    assert figures(explorer) == {"not drawn": "DeviceError: <lost>"}


def test_moving_objects_keep_their_poses() -> None:
    need("ipywidgets")
    pose = np.eye(4)
    pose[:3, 3] = 3.0, 0.75, -12.0
    explorer = small(street(dynamic=True)).at({"car": pose}).explore(size=SIZE, face_size=16)
    explorer.r2.value = 60.0
    red = decoded(explorer.picture.value).astype(int)
    assert ((red[..., 0] > 120) & (red[..., 1] < 90)).any()


def test_impostors_are_explored_within_their_reach(tmp_path: Path) -> None:
    need("ipywidgets")
    impostors = nf.reduce(yard(), far="impostors", **{**SETTINGS, "face_size": 64, "centers": 2})
    explorer = impostors.explore(size=SIZE)
    explorer.x.value, explorer.z.value, explorer.heading.value = 1.9, 1.9, 60.0
    assert math.hypot(explorer.x.value, explorer.z.value) <= impostors.reach
    truth = nf.render(yard(), explorer.camera, channels=("color",), backend="cpu")
    picture = impostors.render(explorer.camera, channels=("color",), backend="cpu")
    for widget, frame in ((explorer.truth, truth), (explorer.picture, picture)):
        assert widget.value == card.png(frame.to_image())
    assert float(Card(explorer.figures.value).facts()["SSIM"]) == pytest.approx(nf.ssim(truth, picture), abs=1e-4)
    impostors.save(tmp_path / "light")
    facts = Card(nf.Impostors.load(tmp_path / "light").explore(size=SIZE).figures.value).facts()
    assert "not saved" in facts["far geometry"]


def test_a_notebook_gets_the_widget_and_a_text(explorer: Explorer) -> None:
    bundle = explorer._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in bundle
    assert bundle["text/plain"].startswith("Explorer of ReducedScene('blend'")
