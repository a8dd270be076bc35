"""Dynamic objects of bundles: compressed like rings, and posed relative to their original transforms bit for bit."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._scene import glb
from nearfar._scene.moving_rows import rows_of
from nearfar.stream import _encode
from nearfar.stream._store import Files

SETTINGS: dict[str, Any] = {"center": (0, 1.7, 0), "radii": [5.0, 20.0], "face_size": 64, "samples": 1}
SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], np.float32)
FACES = np.array([[0, 1, 2], [0, 2, 3]], np.uint32)


def similarity(
    angle: float, place: tuple[float, float, float], *, scale: tuple[float, float, float] = (1, 1, 1)
) -> Any:
    matrix = np.eye(4)
    matrix[:3, :3] = np.array(
        [[np.cos(angle), 0, np.sin(angle)], [0, 1, 0], [-np.sin(angle), 0, np.cos(angle)]]
    ) @ np.diag(scale)
    matrix[:3, 3] = place
    return matrix


def mixed(offset: tuple[float, float, float] = (0, 0, 0)) -> nf.Scene:
    """A wall, and moving squares: two that share a mesh, one of them mirrored; one of two materials; one too small."""
    builder = nf.SceneBuilder()
    red, blue = builder.material((1, 0, 0, 1)), builder.material((0, 0, 1, 1))
    moved = np.eye(4)
    moved[:3, 3] = offset

    def place(name: str, mesh: int, matrix: Any) -> None:
        builder.instance(mesh, moved @ matrix, name=name)

    square = builder.mesh(SQUARE, FACES, material=red)
    place("wall", builder.mesh(SQUARE, FACES), similarity(0.0, (-20, 0, -30), scale=(40, 20, 1)))
    place("left", square, similarity(0.3, (-2.1, 0.2, -4.7)))
    place("tiny", builder.mesh(SQUARE * 1e-5, FACES), similarity(0.1, (0, 0, -3)))
    place("right", square, similarity(1.1, (1.3, 0.1, -3.9), scale=(1, 1, -2)))
    place("both", builder.mesh(SQUARE, FACES, material=[red, blue]), similarity(-0.4, (0.1, 2.0, -5.3)))
    place("both", builder.mesh(SQUARE, FACES, material=blue), similarity(-0.4, (0.1, 3.1, -5.3)))
    return builder.build(dynamic=["left", "right", "both", "tiny"])


@pytest.mark.parametrize("compression", ["meshopt", None])
@pytest.mark.parametrize("offset", [(0, 0, 0), (123_456.7, 10.3, -98_765.4)])
def test_transforms_keep_their_bits(tmp_path: Path, offset: Any, compression: str | None) -> None:
    posed = mixed(offset).at({"left": similarity(0.7, tuple(np.add(offset, (1.7, 0.4, -6.1))))})
    given = {**SETTINGS, "center": np.add(offset, SETTINGS["center"]), "compression": compression}
    bundle = nf.stream.export(posed, tmp_path / "b", **given)
    found = bundle._moving
    kept = ("left", "right", "both")
    assert tuple(found.poses) == kept
    assert found.origin.tolist() == posed.origin.tolist()
    # Instances are in the scene's order; "tiny" has no area after rounding, and the bundle omits it.
    rows = [n for n, owner in enumerate(posed._core.moving_objects()) if posed.object_names[owner] in kept]
    np.testing.assert_array_equal(found._core.moving_placements(), posed._core.moving_placements()[rows])
    np.testing.assert_array_equal(found._load_placements, posed._load_placements[rows])
    for name in kept:
        np.testing.assert_array_equal(found.poses[name], posed.poses[name])
        np.testing.assert_array_equal(found.transform(name), posed.transform(name))
    ids = found._core.mesh_ids()
    assert len(np.unique(ids)) == len(ids)  # Mirrored objects have separate meshes.
    assert found.triangle_count == posed.triangle_count - 2 - 2


def test_moving_objects_are_drawn_at_their_poses(tmp_path: Path) -> None:
    scene = mixed()
    bundle = nf.stream.export(scene, tmp_path / "b", **SETTINGS, quality=None, step=2.0**-14)
    view = nf.Camera.look_at((0.2, 1.6, 0.1), (0, 1.5, -5), fov=nf.Fov.symmetric(70), size=(96, 64))
    poses = {"left": similarity(0.9, (-1.0, 1.2, -4.0)), "both": similarity(0.2, (0.4, 0.5, -3.0))}
    for given in ({}, poses):
        reduced = nf.reduce(
            scene, center=(0, 1.7, 0), r1=3.5, r2=5.0, unit="object", morph="cylinder", face_size=64, samples=1,
            channels=("color", "range"),
        )  # fmt: skip
        expected = reduced.at(given).render(view, samples=1).to_image().astype(int)
        shown = bundle.at(1).at(given).render(view, samples=1).to_image().astype(int)
        assert (np.abs(shown - expected).max(axis=-1) > 2).mean() < 5e-3
    assert np.any(shown != bundle.at(1).render(view, samples=1).to_image())


def test_moving_objects_are_smaller_than_plain_files(tmp_path: Path) -> None:
    room = nf.datasets.room()
    bundle = nf.stream.export(room, tmp_path / "b", **SETTINGS)
    manifest = json.loads((tmp_path / "b" / "manifest.json").read_text())
    names = [manifest["dynamic"]["geometry"], *manifest["dynamic"]["parts"]]
    moving = room.subset(objects=list(room.poses))
    plain = len(glb.encode(moving._core, moving.object_names, moving._undrawn))
    # Quantised and compressed arrays; the document takes most of the rest.
    assert sum(len(bundle.read(name)) for name in names) < 0.5 * plain
    assert 0 < manifest["dynamic"]["error"] <= 2.0**-11
    assert manifest["dynamic"]["triangles"] == moving.triangle_count


def test_a_mesh_that_is_also_static_is_stored_once(tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    noise = np.random.default_rng(3).normal(size=(3000, 3)).astype(np.float32)
    mesh = builder.mesh(noise, np.arange(3000).reshape(-1, 3))
    for name, place in (("first", (4, 0, -4)), ("second", (-4, 0, -4)), ("mover", (0, 0, -8))):
        builder.instance(mesh, similarity(0.0, place), name=name)
    bundle = nf.stream.export(builder.build(dynamic=["mover"]), tmp_path / "b", **SETTINGS)
    manifest = json.loads((tmp_path / "b" / "manifest.json").read_text())
    assert manifest["dynamic"]["parts"] == [name for name in bundle.files if name.endswith(".bin")]
    assert manifest["regions"][0]["rings"][1]["parts"] == manifest["dynamic"]["parts"]
    assert bundle.at(2).scene.triangle_count == 3000
    bundle.verify()


def test_faces_that_lose_their_area_produce_no_file_and_no_tile(tmp_path: Path) -> None:
    builder = nf.SceneBuilder()
    builder.instance(builder.mesh(SQUARE, FACES), similarity(0.0, (-0.5, 1.0, -9)), name="wall")
    for name, place in (("speck", (0, 1.7, -3)), ("mover", (0, 1.7, -4))):
        builder.instance(builder.mesh(SQUARE * 1e-5, FACES), similarity(0.0, place), name=name)
    bundle = nf.stream.export(builder.build(dynamic=["mover"]), tmp_path / "b", **SETTINGS)
    manifest = json.loads((tmp_path / "b" / "manifest.json").read_text())
    assert manifest["dynamic"] is None
    assert manifest["regions"][0]["rings"][1]["geometry"] is None
    tileset = json.loads((tmp_path / "b" / "tileset.json").read_text())
    assert [tile["extras"].get("ring") for tile in tileset["root"]["children"]] == [2]
    assert bundle.at(2).scene.triangle_count == 2


def test_damaged_descriptions_name_the_file(tmp_path: Path) -> None:
    bundle = nf.stream.export(mixed(), tmp_path / "b", **SETTINGS)
    path = tmp_path / "b" / "manifest.json"
    manifest = json.loads(path.read_text())
    rows = manifest["dynamic"]["instances"]
    wrong: list[Any] = [rows[:-1], [*rows, rows[0]], [*rows[:-1], {}], [*rows[:-1], 3], None, {}]
    wrong += [[*rows[:-1], rows[-1] | {key: value}] for key in ("rest", "transform") for value in (1, [[0.0]], "x")]
    for instances in wrong:
        path.write_text(json.dumps(manifest | {"dynamic": manifest["dynamic"] | {"instances": instances}}))
        with pytest.raises(nf.FormatError, match=Path(manifest["dynamic"]["geometry"]).name + "|manifest.json"):
            nf.stream.open(tmp_path / "b").at(0)
    assert bundle.at(0).scene.triangle_count == 8


def test_nodes_without_faces_are_omitted() -> None:
    scene = mixed()
    rings = nf.stream.assign(scene, center=(0, 0, 0), radii=[5.0])
    files = Files()
    moving = _encode.Geometry(rings, files, [], nf.stream.ExportSettings()).moving()
    assert moving is not None
    rows = rows_of(scene, files.content[moving["geometry"]])
    assert [row["object"] for row in rows] == ["left", "right", "both", "both"]
    assert rows == moving["instances"]
