"""Tests of footprint files as sources."""

from __future__ import annotations

import json
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._source.open import FootprintFile
from tests.support import PEAK, data, need
from tests.support.query_cases import touching

GRID = 12
"""Rows and columns of buildings, 30 m apart."""
FAR = 5_000_000.0
"""Offset in metres, as in coordinates of national grids."""


def outline(x: float, y: float, wide: float) -> list[list[list[float]]]:
    return [[[x, y], [x + wide, y], [x + wide, y + wide], [x, y + wide / 2], [x, y]]]


@pytest.fixture
def town(tmp_path: Path) -> Path:
    """Buildings in a projected coordinate system, one of which names its height differently."""
    features = [
        {
            "type": "Feature",
            "id": f"house {i} {j}",
            "properties": {"height": 3 + (7 * i + 11 * j) % 20, "ridge": 50},
            "geometry": {"type": "Polygon", "coordinates": outline(FAR + 30 * i, FAR + 30 * j, 20)},
        }
        for i in range(GRID)
        for j in range(GRID)
    ]
    crs = {"type": "name", "properties": {"name": "urn:ogc:def:crs:EPSG::28992"}}
    path = tmp_path / "town.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "crs": crs, "features": features}))
    return path


def open_footprints(path: Path, **how: Any) -> FootprintFile:
    source = nf.open_source(path, **how)
    assert isinstance(source, FootprintFile)
    return source


def rows_of(triangles: NDArray[Any]) -> NDArray[Any]:
    """Triangles (T, 3, 3) as sorted rows (T, 9)."""
    rows = triangles.reshape(-1, 9)
    return rows[np.lexsort(rows.T)]


def test_queries_return_touching_triangles_of_the_whole(town: Path) -> None:
    source, whole = open_footprints(town), nf.Scene.load(town)
    np.testing.assert_array_equal(source.bounds, whole.bounds)
    assert isinstance(source, nf.SceneSource)
    middle = source.bounds.mean(axis=0)
    for reach in ([5, 2, 5], [40, 100, 3], [1e9, 1e9, 1e9]):
        box = np.stack([middle - reach, middle + reach])
        part = source.query(box)
        np.testing.assert_array_equal(part.origin, whole.origin)
        wanted = whole.triangles()[touching(whole, box)]
        np.testing.assert_array_equal(rows_of(part.triangles()), rows_of(wanted))
        assert set(part.object_names) <= set(whole.object_names)


def test_cells_together_equal_the_whole_bit_for_bit(town: Path) -> None:
    source, whole = open_footprints(town), nf.Scene.load(town)
    low, high = source.bounds
    parts = []
    for x in np.arange(low[0], high[0], 80):
        for z in np.arange(low[2], high[2], 80):
            cell = source.query([[x, -np.inf, z], [x + 80, np.inf, z + 80]])
            middle = cell.triangles().astype(np.float64).mean(axis=1) + cell.origin
            mine = ((middle[:, ::2] >= (x, z)) & (middle[:, ::2] < (x + 80, z + 80))).all(axis=1)
            parts.append(cell.triangles()[mine])
    np.testing.assert_array_equal(rows_of(np.concatenate(parts)), rows_of(whole.triangles()))


def test_the_height_property_can_be_chosen(town: Path) -> None:
    assert open_footprints(town, height="ridge").bounds[1, 1] == 50
    assert open_footprints(town).bounds[1, 1] == 22


def test_empty_boxes_give_empty_scenes_in_the_same_frame(town: Path) -> None:
    source = open_footprints(town)
    empty = source.query([[0, 0, 0], [1, 1, 1]])
    assert empty.triangle_count == 0
    assert not source.touches([[0, 0, 0], [1, 1, 1]])
    assert source.touches(source.bounds)
    np.testing.assert_array_equal(empty.origin, source.query([[-np.inf] * 3, [np.inf] * 3]).origin)


@pytest.mark.parametrize(("name", "value"), [("up", "z"), ("scale", 2.0), ("lod", 1), ("blend", "cutout")])
def test_arguments_without_a_meaning_are_refused(town: Path, name: str, value: object) -> None:
    how: dict[str, Any] = {name: value}
    with pytest.raises(ValueError, match=f"{name}: expected none with footprints"):
        nf.open_source(town, **how)


def test_a_damaged_file_is_named(town: Path) -> None:
    town.write_text(town.read_text()[:-40])
    with pytest.raises(nf.SceneError, match=r"town\.geojson"):
        nf.open_source(town)


CELLS = """
import sys
import numpy as np
import nearfar as nf
source = nf.open_source(sys.argv[1])
before = peak()
low, high = source.bounds
count = largest = 0
for x in np.arange(low[0], high[0] + 1.0, 1000.0):
    for z in np.arange(low[2], high[2] + 1.0, 1000.0):
        cell = source.query([[x, -np.inf, z], [x + 1000.0, np.inf, z + 1000.0]])
        middle = cell.triangles().mean(axis=1, dtype=np.float64) + cell.origin
        count += int(((middle[:, ::2] >= (x, z)) & (middle[:, ::2] < (x + 1000.0, z + 1000.0))).all(axis=1).sum())
        largest = max(largest, cell.triangle_count)
print(count, largest, peak() - before)
"""


@pytest.mark.stress
def test_the_whole_of_tokyo_takes_the_memory_of_a_cell(tmp_path: Path) -> None:
    need("linux")
    script = Path(__file__).resolve().parents[2] / "scripts" / "tokyo_geoparquet.py"
    outlines = data("city/tokyo23/tokyo23_buildings.parquet")
    subprocess.run([sys.executable, str(script), str(outlines), str(tmp_path / "tokyo.parquet")], check=True)
    command = [sys.executable, "-c", PEAK + CELLS, str(tmp_path / "tokyo.parquet")]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    count, largest, growth = map(int, done.stdout.split())
    assert count == 29_824_563
    # As arrays the whole takes 1.2 GB. A cell's vertices, faces and tests of centroids take some 300 bytes a triangle.
    assert growth < 1_000 * largest < 300e6


def test_footprints_can_be_pickled_for_other_processes(town: Path) -> None:
    source = open_footprints(town)
    again, box = pickle.loads(pickle.dumps(source)), [[-np.inf] * 3, [np.inf] * 3]
    found = source.query(box).triangles()
    assert len(found) > GRID * GRID
    np.testing.assert_array_equal(again.query(box).triangles(), found)
