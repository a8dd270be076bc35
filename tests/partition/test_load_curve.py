"""Load curves against partitions: counts, radii of budgets, plots, and scenes without triangles."""

from __future__ import annotations

import math
import sys
import time

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from tests.support import need
from tests.support.partition_cases import soup, town


@given(st.integers(0, 20), st.lists(st.floats(0, 200), min_size=1, max_size=20))
def test_counts_equal_partitions(seed: int, radii: list[float]) -> None:
    scene = soup(town(seed))
    curve = nf.load_curve(scene, center=(1, 2, 3))
    counts = curve.count(radii)
    for r2, count in zip(radii, np.atleast_1d(counts), strict=True):
        assert curve.count(r2) == count
        if r2 > 0:
            assert nf.partition(scene, center=(1, 2, 3), r1=0, r2=r2).summary()["nsf"] == count


def test_radius_is_the_greatest_one_within_the_budget() -> None:
    curve = nf.load_curve(soup(town()), center=(0, 0, 0))
    at_axis = curve.count(0.0)
    budgets = np.arange(at_axis, curve.triangle_count)
    radii = np.asarray(curve.radius(budgets))
    assert (np.diff(radii) >= 0).all()
    assert (np.asarray(curve.count(radii)) <= budgets).all()
    assert (np.asarray(curve.count(np.nextafter(radii, np.inf))) > budgets).all()
    assert curve.radius(curve.triangle_count) == math.inf
    assert np.array_equal(np.asarray(curve.radius(budgets.astype(float))), radii)
    assert np.asarray(curve.radius(np.array([[at_axis, 10**9]]))).shape == (1, 2)
    assert curve.count(math.inf) == curve.triangle_count


def test_a_thousand_budgets_take_less_than_a_millisecond() -> None:
    random = np.random.default_rng(0)
    curve = nf.load_curve(soup(random.normal(0, 300, (300_000, 3, 3)).astype(np.float32)), center=(0, 0, 0))
    budgets = random.integers(curve.count(0.0), curve.triangle_count, 1000)
    times = []
    for _ in range(20):
        start = time.thread_time()
        curve.radius(budgets)
        times.append(time.thread_time() - start)
    # Twenty binary-search steps each, some tens of microseconds of this thread's CPU time; the minimum of many runs.
    assert min(times) < 1e-3


def test_plot_draws_the_curve() -> None:
    need("matplotlib")
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    curve = nf.load_curve(soup(town()), center=(0, 0, 0))
    axes = curve.plot()
    x, y = axes.lines[0].get_data()
    np.testing.assert_array_equal(y, curve.count(np.asarray(x)))
    assert np.asarray(y)[-1] == curve.triangle_count
    assert (axes.get_xscale(), axes.get_yscale(), len(axes.lines)) == ("log", "log", 3)
    assert curve.plot(axes, published=False) is axes
    assert len(axes.lines) == 5
    pyplot.close("all")
    nothing = nf.Scene.from_arrays(np.zeros((3, 3)), np.empty((0, 3), np.uint32))
    with pytest.raises(ValueError, match="expected a scene with static triangles"):
        nf.load_curve(nothing, center=(0, 0, 0)).plot()


def test_plot_without_matplotlib_names_the_package_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(ImportError, match="plots need matplotlib: pip install"):
        nf.load_curve(soup(town()), center=(0, 0, 0)).plot()


def test_a_scene_without_triangles_has_a_curve() -> None:
    empty = nf.Scene.from_arrays(np.zeros((3, 3)), np.empty((0, 3), np.uint32))
    partition = nf.partition(empty, center=(0, 0, 0), r1=1, r2=2)
    partition.validate()
    assert partition.nsf.size == partition.sf.size == 0
    curve = nf.load_curve(empty, center=(0, 0, 0))
    assert (curve.count(5.0), curve.radius(0)) == (0, math.inf)
