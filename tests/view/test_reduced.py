"""Reduced scenes as bundles: their files and pictures."""

from __future__ import annotations

import json
import urllib.request
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar.serve._server import Server
from nearfar.stream import _map_files as codec
from nearfar.stream._decode import Layout, decode_map
from nearfar.view import _content
from tests.support import valid

CENTER = (0.3, 1.6, 0.2)
PLACE: dict[str, Any] = {"center": CENTER, "r1": 1.2, "r2": 2.0}


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return nf.datasets.room(detail=0)


def reduced_room(scene: nf.Scene, **settings: Any) -> nf.ReducedScene:
    return nf.reduce(scene, far="map", **{**PLACE, "face_size": 64, **settings})


def manifest_of(files: dict[str, bytes]) -> dict[str, Any]:
    manifest: dict[str, Any] = json.loads(files["manifest.json"])
    return manifest


def maps_of(files: dict[str, bytes], ring: int) -> tuple[Any, Any]:
    """Colour and range of the map of a ring."""
    manifest = manifest_of(files)
    region = manifest["regions"][0]
    maps = [entry["map"] for entry in region["rings"]]
    layout = Layout.parse({**manifest["map"], "range": region["range"]})
    return decode_map(maps[: ring + 1], layout, lambda name, decode: decode(files[name]))


@pytest.mark.parametrize("morph", ["blend", "cylinder"])
def test_files_form_a_bundle(scene: nf.Scene, morph: str) -> None:
    reduced = reduced_room(scene, morph=morph)
    files = _content.files_of(reduced)
    manifest = manifest_of(files)
    assert valid(manifest, "bundle")
    assert manifest["morph"] == {"kind": morph, "near_share": 0.6}
    assert manifest["unit"] == "triangle"
    (region,) = manifest["regions"]
    assert [ring["radius"] for ring in region["rings"]] == [0.0, 2.0]
    drawn = region["rings"][1]["triangles"] + (manifest["dynamic"] or {"triangles": 0})["triangles"]
    assert drawn == reduced.triangle_count
    margin = nf.fold_margin(CENTER, center=CENTER, r1=1.2, r2=2.0, kind=morph)
    assert region["fold_margin"] == pytest.approx(margin, rel=1e-3)
    assert files == _content.files_of(reduced)


def test_map_0_is_the_view_from_the_centre_and_map_1_the_scenes_map(scene: nf.Scene) -> None:
    reduced = reduced_room(scene, channels=("color", "range"))
    files = _content.files_of(reduced)
    color, ranges = maps_of(files, 1)
    assert reduced.env is not None
    assert reduced.env.range is not None
    # Colours have the 8 bits of sRGB, ranges a relative error of 2^-11.
    assert (
        np.abs(
            codec.decode_color(codec.encode_color(reduced.env.color[0].astype(np.float32), None), (64, 64)) - color[0]
        ).max()
        == 0
    )
    is_hit = np.isfinite(reduced.env.range)
    assert np.array_equal(np.isfinite(ranges), is_hit)
    assert np.abs(ranges[is_hit] / reduced.env.range[is_hit] - 1).max() < 2**-10
    first, _ = maps_of(files, 0)
    still = scene.subset(triangles=np.arange(scene._core.standing_triangle_count))
    for face in range(6):
        camera = nf.Camera(CENTER, fov=nf.CubeFace(face), size=(64, 64))
        truth = nf.render(still, camera, samples=4, channels=("color",)).require("color")
        assert np.abs(first[face] - np.clip(truth, 0, 1)).mean() < 0.01


def test_maps_of_any_size_or_none_are_accepted(scene: nf.Scene) -> None:
    for size, stored in ((8, 64), (100, 128)):
        files = _content.files_of(reduced_room(scene, face_size=size))
        assert manifest_of(files)["map"]["face_size"] == stored
    corners = np.array([[0, 0, -3], [1, 0, -3], [0, 1, -3]], np.float32)
    everything = nf.reduce(nf.Scene.from_arrays(corners, np.array([[0, 1, 2]])), center=(0, 0, 0), r1=5, r2=9)
    assert everything.env is None
    files = _content.files_of(everything)
    assert not np.isfinite(maps_of(files, 1)[1]).any()
    assert manifest_of(files)["regions"][0]["rings"][1]["triangles"] == 1


def test_moving_objects_are_dynamic(scene: nf.Scene) -> None:
    names = list(scene.object_names[:2])
    files = _content.files_of(reduced_room(scene.with_dynamic(names)))
    dynamic = manifest_of(files)["dynamic"]
    assert set(names) <= {entry["object"] for entry in dynamic["instances"]}


def test_scenes_without_a_morph_are_refused(scene: nf.Scene, tmp_path: Path) -> None:
    plain = reduced_room(scene, morph="none", boundary="r1")
    with pytest.raises(ValueError, match=r"^morph: expected 'blend' or 'cylinder' to show, got 'none'"):
        _content.files_of(plain)
    plain.save(tmp_path / "light")
    with pytest.raises(ValueError, match="with_morph"):
        nf.view.write_page(tmp_path / "light")


def test_a_saved_scene_has_the_files_of_the_scene(scene: nf.Scene, tmp_path: Path) -> None:
    reduced = reduced_room(scene)
    reduced.save(tmp_path / "light", half=False)
    expected = manifest_of(_content.files_of(reduced))
    for place in ("light", "light/reduced.json"):
        folder = _content.reduced_folder(tmp_path / place)
        assert folder is not None
        manifest = json.loads(_content.reduced_files(folder)["manifest.json"])
        for name in ("morph", "triangles", "map"):
            assert manifest[name] == expected[name]
        assert manifest["regions"][0]["rings"][1]["map"] == expected["regions"][0]["rings"][1]["map"]
    nf.view.write_page(tmp_path / "light")
    nf.view.write_page(tmp_path / "light")
    for name, described in json.loads((tmp_path / "light" / "manifest.json").read_text())["files"].items():
        assert (tmp_path / "light" / name).stat().st_size == described["bytes"]
    with pytest.raises(nf.FormatError, match=r"read it with nearfar\.ReducedScene\.load"):
        nf.stream.open(tmp_path / "light")
    # The folder remains that of the reduced scene.
    assert nf.ReducedScene.load(tmp_path / "light").r2 == reduced.r2
    with (
        Server.of_bundle(tmp_path / "light") as server,
        urllib.request.urlopen(f"{server.url}manifest.json", timeout=60) as answer,
    ):
        assert json.loads(answer.read())["unit"] == "triangle"
    reduced.save(tmp_path / "light")
    assert not (tmp_path / "light" / "index.html").exists()


def test_damaged_folders_are_named(scene: nf.Scene, tmp_path: Path) -> None:
    reduced_room(scene).save(tmp_path / "light")
    (tmp_path / "light" / "near.glb").write_bytes(b"no")
    with pytest.raises(nf.FormatError, match=r"near\.glb"):
        Server.of_bundle(tmp_path / "light")
    (tmp_path / "light" / "near.glb").unlink()
    with pytest.raises(OSError, match=r"near\.glb"):
        Server.of_bundle(tmp_path / "light")
