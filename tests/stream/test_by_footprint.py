"""The files of the strategies vis0 and vis1: near objects by their footprints, and the whole map of the last ring."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.stream import _by_footprint
from nearfar.stream._decode import decode_map, ring_scene
from tests.support.bundled_scenes import SCENES, bundled_scenes

CENTER = SCENES["city"]["center"]
RADII = (10.0, 63.0)


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return bundled_scenes()["city"]


@pytest.fixture(scope="module")
def bundle(scene: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("by_footprint") / "b"
    settings: dict[str, Any] = {"face_size": 64, "quality": None}
    return nf.stream.export(scene, folder, center=CENTER, radii=RADII, by_footprint=True, **settings)


def triangles_of(bundle: nf.stream.Bundle, entry: dict[str, Any]) -> int:
    if entry["geometry"] is None:
        return 0
    return int(ring_scene(entry["geometry"], entry["parts"], bundle.read, "b").triangle_count)


def test_portions_have_visible_near_objects_largest_first(scene: nf.Scene) -> None:
    rings = nf.stream.assign(scene, center=CENTER, radii=RADII)
    portions = _by_footprint.Portions.from_rings(rings, scene=scene)
    seen = nf.stream.footprints(scene, center=CENTER)
    is_near = (rings.ring > 0) & (rings.ring <= rings.count)
    assert (portions.portion[rings.ring == 0] == 0).all()
    assert (portions.portion[(rings.ring > rings.count) | (is_near & (seen == 0))] == portions.count + 1).all()
    sent = is_near & (seen > 0)
    assert 5 < sent.sum() < is_near.sum()
    by_portion = [seen[sent & (portions.portion == number)] for number in range(1, portions.count + 1)]
    assert sum(map(len, by_portion)) == sent.sum()
    for before, after in pairwise(by_portion):
        assert before.min() >= after.max()
    # Files with equal numbers of objects.
    assert np.ptp([len(own) for own in by_portion]) <= 1


def test_files_contain_their_objects_and_the_whole_last_map(scene: nf.Scene, bundle: nf.stream.Bundle) -> None:
    region = bundle._manifest["regions"][0]
    entry = region["by_footprint"]
    rows = _by_footprint.Portions.from_rings(nf.stream.assign(scene, center=CENTER, radii=RADII), scene=scene).summary()
    assert [portion["objects"] for portion in entry["portions"]] == [row["objects"] for row in rows[:-1]]
    for portion in entry["portions"]:
        assert triangles_of(bundle, portion) == portion["triangles"]
    maps = [
        {"color": entry["map"]["color"]},
        {"tiles": [], "color": None, "range": entry["map"]["range"]},
    ]
    color, ranges = decode_map(maps, bundle._layout, bundle._decode_file)
    last = bundle.map(bundle.count)
    assert np.array_equal(color, last.color)
    assert ranges is not None
    assert last.range is not None
    assert np.array_equal(ranges, last.range)


def test_files_by_footprint_are_written_only_on_request(
    scene: nf.Scene, bundle: nf.stream.Bundle, tmp_path: Path
) -> None:
    plain = nf.stream.export(scene, tmp_path / "b", center=CENTER, radii=RADII, face_size=64, quality=None)
    assert plain._manifest["regions"][0]["by_footprint"] is None
    assert set(plain.files) < set(bundle.files)
    assert plain.summary() == bundle.summary()


def test_a_centre_without_visible_near_objects(tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    corners = np.array([[0.0, 0, 0], [1, 0, 0], [0, 0, 1]])
    builder.instance(builder.mesh(corners + np.array([0, 5, 0]), [[0, 1, 2]]), name="above")
    # Hidden by the one above.
    builder.instance(builder.mesh(corners * 0.01 + np.array([0.2, 6, 0.2]), [[0, 1, 2]]), name="hidden")
    scene = builder.build()
    bundle = nf.stream.export(scene, tmp_path / "b", center=(50, 1, 0), radii=[10.0], face_size=64, by_footprint=True)
    (portion,) = bundle._manifest["regions"][0]["by_footprint"]["portions"]
    assert (portion["objects"], portion["geometry"]) == (0, None)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"portions": 3}, "portions"),
        ({"portions": [{"objects": -1}]}, "objects"),
        ({"portions": [{"objects": 1, "triangles": 1, "stored": 1, "geometry": "files/x.glb", "parts": []}]}, "files"),
        ({"map": {"color": None, "range": None}}, "manifest"),
        ({"map": {}}, "manifest"),
    ],
)
def test_damage_is_refused(bundle: nf.stream.Bundle, change: dict[str, Any], told: str, tmp_path: Path) -> None:
    place = Path(bundle._reader.location)
    manifest = json.loads((place / "manifest.json").read_text())
    manifest["regions"][0]["by_footprint"] |= change
    copy = tmp_path / "copy"
    copy.mkdir()
    for name in ("files", "tileset.json"):
        (copy / name).symlink_to(place / name)
    (copy / "manifest.json").write_text(json.dumps(manifest))
    with pytest.raises(nf.FormatError, match=told):
        nf.stream.open(copy)


def test_splitting_rings_does_not_affect_files_by_footprint(
    bundle: nf.stream.Bundle, scene: nf.Scene, tmp_path: Path
) -> None:
    settings: dict[str, Any] = {"face_size": 64, "quality": None, "by_footprint": True, "split_px": 20.0}
    split = nf.stream.export(scene, tmp_path / "b", center=CENTER, radii=RADII, **settings)
    regions = [each._manifest["regions"][0] for each in (bundle, split)]
    assert regions[0]["by_footprint"]["portions"] == regions[1]["by_footprint"]["portions"]
    assert split.summary()[1]["geometry"] > bundle.summary()[1]["geometry"]
