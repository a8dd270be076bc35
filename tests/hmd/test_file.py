"""Tests of headset files: lossless round trips, and errors that name the damaged key."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from tests.support import valid
from tests.support.hmd_cases import eyes
from tests.support.refused import replace_value


def optional(strategy: Any) -> Any:
    return st.one_of(st.none(), strategy)


sizes = st.tuples(st.integers(1, 9999), st.integers(1, 9999))
hmds = st.builds(
    nf.Hmd,
    name=st.text(st.characters(codec="utf-8"), min_size=1, max_size=20),
    left=eyes,
    right=eyes,
    render_size=sizes,
    panel_size=optional(sizes),
    refresh_hz=optional(st.floats(1, 500)),
    lens=optional(st.lists(st.floats(-1, 1).map(lambda c: round(c, 9)), max_size=5).map(nf.RadialLens)),
    lens_radius=optional(st.floats(0.1, 3)),
    triangle_budget=optional(st.tuples(st.integers(1, 10), st.integers(10, 10**7))),
    hidden_area_percent=optional(st.floats(0, 100)),
    sources=st.lists(st.text(st.characters(codec="utf-8"), max_size=9), max_size=3).map(tuple),
)


@given(hmd=hmds)
def test_files_load_bit_for_bit(tmp_path_factory: pytest.TempPathFactory, hmd: nf.Hmd) -> None:
    path = tmp_path_factory.getbasetemp() / "one.json"
    hmd.save(path)
    assert nf.Hmd.load(path) == hmd
    assert valid(json.loads(path.read_text(encoding="utf-8")), "hmd")


@given(hmd=hmds)
def test_fields_that_hmdq_stores_are_restored(tmp_path_factory: pytest.TempPathFactory, hmd: nf.Hmd) -> None:
    path = tmp_path_factory.getbasetemp() / "one.hmdq.json"
    try:
        hmd.save(path, format="hmdq")
    except ValueError as error:
        assert "the head's" in str(error)  # noqa: PT017
        return
    again = nf.Hmd.load(path)
    assert (again.name, again.render_size, again.refresh_hz) == (hmd.name, hmd.render_size, hmd.refresh_hz)
    for one, other in ((again.left, hmd.left), (again.right, hmd.right)):
        assert (one.fov, one.position) == (other.fov, other.position)
        # hmdq stores a matrix, whose rounding changes the quaternion.
        np.testing.assert_allclose(one.matrix, other.matrix, rtol=0, atol=1e-15)
    assert again.lens is None


def test_a_failed_save_keeps_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "one.json"
    nf.hmd.VIVE.save(path)
    with pytest.raises(ValueError, match="format: expected one of 'nearfar', 'hmdq', got 'xml'"):
        nf.hmd.VIVE_PRO.save(path, format="xml")
    assert nf.Hmd.load(path) == nf.hmd.VIVE
    assert [item.name for item in tmp_path.iterdir()] == ["one.json"]
    with pytest.raises(FileNotFoundError):
        nf.Hmd.load(tmp_path / "none.json")


def check_refused(tmp_path: Path, document: Any, words: str) -> None:
    path = tmp_path / "bad.json"
    path.write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(nf.FormatError, match=rf"bad\.json: .*{words}"):
        nf.Hmd.load(path)


def test_integers_are_accepted_as_numbers(tmp_path: Path) -> None:
    path = tmp_path / "one.json"
    nf.hmd.INDEX.save(path)
    good = json.loads(path.read_text(encoding="utf-8"))
    path.write_text(
        json.dumps(replace_value(replace_value(good, [0, 10**25], "lens"), 144, "refresh_hz")), encoding="utf-8"
    )
    hmd = nf.Hmd.load(path)
    assert hmd.lens == nf.RadialLens((0.0, 1e25))
    assert isinstance(hmd.refresh_hz, float)


def test_a_runtime_is_only_for_files_of_hmdq(tmp_path: Path) -> None:
    path = tmp_path / "one.json"
    nf.hmd.INDEX.save(path)
    with pytest.raises(ValueError, match=r"runtime: expected None for .*one\.json"):
        nf.Hmd.load(path, runtime="oculus")


def test_damaged_headset_files_name_the_key(tmp_path: Path) -> None:
    path = tmp_path / "one.json"
    nf.hmd.INDEX.save(path)
    good = json.loads(path.read_text(encoding="utf-8"))
    for keys in (("name",), ("eyes",), ("eyes", "left"), ("eyes", "right", "fov"), ("eyes", "left", "fov", "up")):
        check_refused(
            tmp_path,
            replace_value(good, ..., *keys),
            rf"{'.'.join(keys)}: expected a value, found none".replace(".", r"\."),
        )
    check_refused(
        tmp_path,
        replace_value(good, "wide", "eyes", "left", "fov", "up"),
        'eyes.left.fov.up: expected a number, got "wide"',
    )
    for value in (10**400, float("nan"), float("inf"), True):
        check_refused(
            tmp_path,
            replace_value(good, value, "eyes", "left", "fov", "up"),
            "eyes.left.fov.up: expected a number, got",
        )
        check_refused(tmp_path, replace_value(good, [0.1, value], "lens"), "lens: expected numbers, got")
        check_refused(
            tmp_path,
            replace_value(good, [0, 0, value], "eyes", "left", "position"),
            "eyes.left.position: expected 3 num",
        )
        check_refused(tmp_path, replace_value(good, value, "refresh_hz"), "refresh_hz: expected a number, got")
        check_refused(tmp_path, replace_value(good, [value, 5], "render_size"), "render_size: expected 2 numbers, got")
    check_refused(tmp_path, replace_value(good, "\ud800", "name"), "name: .*lone surrogate")
    check_refused(
        tmp_path, replace_value(good, [0, 0, 0], "eyes", "right", "orientation"), "eyes.right.orientation: expected 4"
    )
    check_refused(
        tmp_path, replace_value(good, [0, 0, 0, 2], "eyes", "right", "orientation"), "eyes.right: .*unit quaternion"
    )
    check_refused(
        tmp_path, replace_value(good, 9.0, "eyes", "right", "fov", "left"), "eyes.right.fov: .*expected left < right"
    )
    check_refused(tmp_path, replace_value(good, [1, 2.5], "render_size"), "render_size.1.: expected a whole number")
    check_refused(tmp_path, replace_value(good, 2, "version"), "reads up to version 1")
    check_refused(tmp_path, replace_value(good, "nearfar.envmap", "format"), "expected format 'nearfar.hmd'")
    check_refused(tmp_path, [1, 2], "expected a JSON object, got list")
    path.write_bytes(b"\xff\xfe{")
    with pytest.raises(nf.FormatError, match=r"one\.json: expected JSON"):
        nf.Hmd.load(path)
