"""Regions made on demand: parts arrive in order, and together they equal an exported bundle."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.stream import _on_demand, _store
from nearfar.stream._on_demand import OnDemand, Part, next_part

PLACE = (3.3, 1.7, -2.2)
SETTINGS: dict[str, Any] = {"grid": 2.0, "radii": (10.0, 22.0, 63.0), "face_size": 128, "samples": 2}
COARSE = 64
"""Texels along a face of the first maps, fewer than in the others."""


@pytest.fixture(scope="module", autouse=True)
def _coarse() -> Iterator[None]:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(_on_demand, "COARSE_FACE_SIZE", COARSE)
        yield


def make_parts(maker: OnDemand, place: tuple[float, float, float] = PLACE) -> list[Part]:
    parts, found = maker.parts(place), []
    while (part := next_part(parts, lambda: None)) is not None:
        found.append(part)
    return found


def write_bundle(folder: Path, parts: list[Part]) -> nf.stream.Bundle:
    (folder / _store.FOLDER).mkdir(parents=True)
    for part in parts:
        for name, data in part.files.items():
            (folder / name).write_bytes(data)
    return nf.stream.open(folder)


@pytest.fixture(scope="module")
def parts(city: nf.Scene) -> list[Part]:
    return make_parts(OnDemand(city, **SETTINGS))


def test_the_whole_equals_an_export(city: nf.Scene, parts: list[Part], tmp_path: Path) -> None:
    still = city.subset(objects=[name for name in city.object_names if name not in city.poses])
    found = write_bundle(tmp_path / "found", make_parts(OnDemand(still, **SETTINGS)))
    nf.stream.export(still, tmp_path / "expected", center=PLACE, **SETTINGS)
    for name in (_store.MANIFEST, _store.TILESET):
        assert (tmp_path / "found" / name).read_bytes() == (tmp_path / "expected" / name).read_bytes()
    found.verify()


def test_dynamic_objects_equal_an_export(city: nf.Scene, parts: list[Part], tmp_path: Path) -> None:
    assert city.poses
    found = write_bundle(tmp_path / "found", parts)
    expected = nf.stream.export(city, tmp_path / "expected", center=PLACE, **SETTINGS)
    view = nf.Camera.look_at((2.6, 1.5, -1.4), (30, 3, -20), fov=nf.Fov.symmetric(90, 1.6), size=(160, 100))
    pictures = [bundle.at(3).render(view, samples=1, method="vertex").to_image() for bundle in (found, expected)]
    np.testing.assert_array_equal(pictures[0], pictures[1])
    found.verify()


def test_rings_arrive_in_order_with_their_files(parts: list[Part]) -> None:
    told = [json.loads(part.line) for part in parts]
    rings = [("begin", None), *(("ring", ring) for ring in range(4))]
    assert [(line["event"], line.get("ring")) for line in told] == [*rings, *rings, ("end", None)]
    assert [part.stage for part in parts] == [0] * 5 + [1] * 6
    assert [part.next for part in parts] == [0] * 4 + [1] * 6 + [None]
    have: set[str] = set()
    for line, part in zip(told[:-1], parts, strict=False):
        assert line["files"] == {name: _store.file_entry(data) for name, data in part.files.items()}
        assert not have & part.files.keys()
        have |= part.files.keys()
        if line["event"] == "ring":
            entry = line["entry"]
            needed = [*entry["parts"], entry["geometry"], entry["map"]["color"], entry["map"].get("range")]
            flat = [name for item in needed if item for name in ([item] if isinstance(item, str) else item)]
            assert have.issuperset(flat)


def test_coarse_maps_arrive_first_and_are_not_part_of_the_whole(parts: list[Part]) -> None:
    begins = [json.loads(part.line)["manifest"] for part in parts if b'"begin"' in part.line]
    assert [manifest["map"]["face_size"] for manifest in begins] == [COARSE, 128]
    # All that a client needs to begin; entries of rings contain the rest.
    for manifest in begins:
        (region,) = manifest["regions"]
        assert [ring["radius"] for ring in region["rings"]] == [0.0, *SETTINGS["radii"]]
        assert all(ring["map"] is None and ring["geometry"] is None for ring in region["rings"])
    whole = json.loads(parts[-1].files[_store.MANIFEST])["files"]
    coarse = {name for part in parts if part.stage == 0 for name in part.files if name.endswith((".webp", ".range"))}
    assert not coarse & whole.keys()
    # Geometry is sent once.
    assert not any(name.endswith((".glb", ".bin")) for part in parts if part.stage == 1 for name in part.files)


def test_nearby_places_share_a_region(city: nf.Scene) -> None:
    maker = OnDemand(city, **SETTINGS)
    snapped = [nf.stream.snap(center, maker.grid) for center in ((3.3, 1.7, -2.2), (4.4, 1.7, -1.7))]
    assert snapped == [(4.0, 1.7, -2.0)] * 2


def test_work_ends_when_all_clients_have_left(city: nf.Scene) -> None:
    class GoneError(Exception):
        pass

    def leave() -> None:
        raise GoneError

    parts = OnDemand(city, **{**SETTINGS, "face_size": 4096, "samples": 1024}).parts(PLACE)
    assert next_part(parts, lambda: None) is not None
    with pytest.raises(GoneError):
        while next_part(parts, leave) is not None:
            pass
    # It cannot continue, and the next request is served independently.
    assert next_part(parts, lambda: None) is None


def test_places_without_surroundings_are_refused(city: nf.Scene) -> None:
    with pytest.raises(ValueError, match="center: expected a place with objects around it"):
        make_parts(OnDemand(city), (90_000.0, 1.7, 0.0))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"grid": 0.0}, "grid: expected"),
        ({"radii": (10.0, 5.0)}, "radii: expected"),
        ({"face_size": 100}, "face_size: expected a multiple of 64"),
        ({"speed": 0.0}, "speed: expected"),
        ({"lod": "depth"}, "lod: expected a scene whose objects have levels"),
    ],
)
def test_arguments_are_checked_before_work_begins(city: nf.Scene, change: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        OnDemand(city, **{**SETTINGS, **change})
