"""Cached scores are not rendered again: by content, by settings, after damage and after Ctrl-C."""

from __future__ import annotations

import re
import signal
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.lod._measure import score_table, scores as level_scores
from nearfar.lod._measure.score_cache import SUFFIX
from tests.support.lod_cases import SMALL, assert_same, count_renders, levels

pytestmark = pytest.mark.usefixtures("fresh_cache")


def test_cached_scores_are_not_rendered_again(monkeypatch: pytest.MonkeyPatch) -> None:
    counted = count_renders(monkeypatch)
    first = nf.lod.measure(levels(16, 8, 4), **SMALL, step=None)
    assert sum(counted) == first.measured["renders"] > 0
    counted.clear()
    again = nf.lod.measure(levels(16, 8, 4), **SMALL, step=None)
    assert counted == []
    assert_same(first, again)
    assert (again.measured["renders"], again.measured["cached"]) == (0, first.measured["scores"])
    # A new level is measured alone, besides the base.
    more = nf.lod.measure(levels(16, 8, 6, 4), **SMALL, step=None)
    assert sum(counted) == more.measured["renders"] == first.measured["renders"] * 2 // 3
    counted.clear()
    farther = nf.lod.measure(levels(16, 8, 4), **SMALL | {"distances": 6}, step=None)
    assert sum(counted) == 8 * 2 * 3
    nearer = nf.lod.measure(levels(16, 8, 4), **SMALL | {"distances": 5}, step=None)
    assert farther.samples is not None
    assert nearer.samples is not None
    np.testing.assert_array_equal(nearer.samples.score, farther.samples.score[:, :5])
    assert sum(counted) == 8 * 2 * 3
    for other in ({"samples": 2}, {"size": (120, 120)}, {"views": 4}, {"directions": "published"}):
        counted.clear()
        assert nf.lod.measure(levels(16, 8, 4), **SMALL | other, step=None).measured["cached"] == 0
        assert counted


def test_without_a_cache_nothing_is_stored(tmp_path: Path) -> None:
    nf.lod.measure(levels(12, 6), **SMALL, cache=False)
    assert not (tmp_path / "cache").exists()


def test_damaged_scores_are_measured_again(tmp_path: Path) -> None:
    first = nf.lod.measure(levels(12, 6), **SMALL)
    (kept,) = (tmp_path / "cache").glob(f"??/*{SUFFIX}")
    for damage in (b"", b"something else", kept.read_bytes()[:200]):
        kept.write_bytes(damage)
        again = nf.lod.measure(levels(12, 6), **SMALL)
        assert_same(first, again)
        assert again.measured["cached"] == 0


def test_scores_finished_before_ctrl_c_are_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    own = levels(16, 8, 4)
    whole = nf.lod.measure(own, **SMALL, step=None, cache=False)
    monkeypatch.setattr(score_table, "MAX_BLOCK_PIXELS", 4000)
    left = [7]

    def scores(*given: Any) -> Any:
        for found in level_scores.scores(*given):
            left[0] -= 1
            if left[0] == 0:
                signal.raise_signal(signal.SIGINT)
            yield found

    monkeypatch.setattr(score_table, "scores", scores)
    with pytest.raises(KeyboardInterrupt) as interrupted:
        nf.lod.measure(own, **SMALL, step=None)
    (note,) = interrupted.value.__notes__
    resumed = nf.lod.measure(own, **SMALL, step=None)
    assert_same(whole, resumed)
    kept, most = (int(number.replace(",", "")) for number in re.findall(r"[\d,]+(?= (?:of|scores))", note))
    assert resumed.measured["cached"] == kept > 0
    assert most == whole.measured["scores"]
    assert str(tmp_path / "cache") in note
    assert resumed.measured["cached"] + resumed.measured["scores"] == whole.measured["scores"]
