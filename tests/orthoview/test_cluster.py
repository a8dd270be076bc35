"""Tests of builds on a Dask cluster of processes: same bytes, lost workers and schedulers, and errors."""

from __future__ import annotations

import threading
from collections import Counter
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.orthoview import _build
from tests.support import need
from tests.support.orthoview_stores import CELL, SIZE, Counted, Deadly, Waiting, contents
from tests.support.waiting import wait_until

need("zarr")
need("distributed")

pytestmark = pytest.mark.slow

FULL = (5, 1, 7)
"""A non-empty leaf in the middle of a subtree."""


@contextmanager
def workers(count: int) -> Iterator[Any]:
    from distributed import Client, LocalCluster

    settings = {"NEARFAR_NUM_THREADS": "1"}
    with (
        LocalCluster(n_workers=count, threads_per_worker=1, dashboard_address=":0", env=settings) as cluster,
        Client(cluster) as client,
    ):
        yield client


@pytest.fixture(scope="module")
def client() -> Iterator[Any]:
    """Two workers, shared by the tests of this file; a killed one is replaced."""
    with workers(2) as client:
        yield client


def built(source: Any, path: Path, cluster: Any) -> nf.orthoview.OrthoTree:
    return nf.orthoview.build(source, path, cell=CELL, size=SIZE, directions=5, cluster=cluster)


@pytest.fixture
def work(monkeypatch: pytest.MonkeyPatch) -> list[Counter[str]]:
    """Counts of the work of each build in the test, also of work that was repeated."""
    counts: list[Counter[str]] = []
    build = _build._build

    def build_counted(*arguments: Any) -> Any:
        outcome = build(*arguments)
        counts.append(outcome.counts)
        return outcome

    monkeypatch.setattr(_build, "_build", build_counted)
    return counts


def test_workers_write_the_same_bytes(
    few: nf.Scene, few_tree: nf.orthoview.OrthoTree, client: Any, tmp_path: Path, work: list[Counter[str]]
) -> None:
    tree, spread = few_tree, built(few, tmp_path / "world.zarr", client)
    assert spread.is_complete
    assert contents(Path(spread.path)) == contents(Path(tree.path))
    assert spread.held == tree.held
    assert spread.done == tree.done
    # The views of each subtree of leaves are sent once, and none is read back.
    at_top = [place for place in np.ndindex(tree.cells(3)) if tree.view(3, place, 4) is not None]
    assert len(at_top) * 3 <= work[0]["sent"] <= len(at_top) * 15
    assert work[0]["reloaded"] == 0
    assert not list(Path(spread.path).glob("nearfar/locks/*"))
    assert not list(Path(spread.path).glob("nearfar/source*"))
    again = built(few, Path(spread.path), client)
    assert again.done == spread.done


def test_leaves_whose_query_fails_on_workers_are_named(few: nf.Scene, client: Any, tmp_path: Path) -> None:
    part = built(Counted(few, {40}), tmp_path / "world.zarr", client)
    assert set(part.failed.values()) == {"OSError: the disk is gone"}
    whole = built(few, tmp_path / "world.zarr", client)
    assert whole.is_complete


def test_a_killed_worker_loses_only_its_cell(
    few: nf.Scene, few_tree: nf.orthoview.OrthoTree, client: Any, tmp_path: Path, work: list[Counter[str]]
) -> None:
    sign = tmp_path / "killed"
    source = Deadly(few, few_tree.box(0, FULL).mean(axis=0), sign)
    spread = built(source, tmp_path / "world.zarr", client)
    assert sign.exists()
    assert spread.is_complete
    assert contents(Path(spread.path)) == contents(Path(few_tree.path))
    # Finished leaves are not drawn again: their subtree resumes from its journal.
    assert work[0]["drawn"] < few_tree.done["drawn"]
    assert work[0]["reloaded"] > 0
    # A source without `touches` is queried for every leaf.
    leaves = np.prod(few_tree.cells(0))
    assert spread.done == few_tree.done | {"empty": leaves - few_tree.done["drawn"]}


def test_a_local_cluster_is_started_by_name(few: nf.Scene, tmp_path: Path) -> None:
    """Uses lossy colours, which are not encoded again on their way."""
    settings: dict[str, Any] = {"cell": CELL, "size": SIZE, "directions": 5, "color": "webp", "quality": 70}
    spread = nf.orthoview.build(few, tmp_path / "a.zarr", **settings, cluster="local")
    alone = nf.orthoview.build(few, tmp_path / "b.zarr", **settings)
    assert contents(Path(spread.path)) == contents(Path(alone.path))


@pytest.mark.stress
def test_a_lost_scheduler_ends_a_build_which_resumes_later(
    few: nf.Scene, few_tree: nf.orthoview.OrthoTree, tmp_path: Path
) -> None:
    path = tmp_path / "world.zarr"
    with workers(1) as client:

        def lose() -> None:
            wait_until(lambda: (tmp_path / "asked").exists())
            client.cluster.loop.add_callback(client.cluster.scheduler.close)

        losing = threading.Thread(target=lose)
        losing.start()
        with pytest.raises(ConnectionError, match="cluster: the scheduler is lost"):
            built(Waiting(few, tmp_path), path, client)
        losing.join()
        (tmp_path / "go").touch()
    later = built(few, path, None)
    assert later.is_complete
    assert contents(path) == contents(Path(few_tree.path))


def test_invalid_clusters_are_named(few: nf.Scene, client: Any, tmp_path: Path) -> None:
    class Local:
        bounds = few.bounds

        def query(self, aabb: Any, detail: Any = 0.0) -> nf.Scene:
            return few.query(aabb, detail)

    with pytest.raises(TypeError, match="source: expected one that can be pickled"):
        built(Local(), tmp_path / "world.zarr", client)
