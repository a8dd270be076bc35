"""Trees exported for splat viewers: tiles, GLB and SPZ files, and interrupted exports."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base.side_by_side import results
from nearfar.orthoview import _spz
from nearfar.orthoview._gaussians import Gaussians, matrices
from nearfar.orthoview._splat_cells import Cell, Cells
from nearfar.orthoview._splat_export import sun_of
from tests.support import need, printed_by_threads
from tests.support.bundle_cases import content
from tests.support.reader_cases import node
from tests.support.splat_files import PACKED, SPLATS, Rows, Tile, glb_parts, glb_rows, spz_rows, tiles
from tests.support.splat_pages import Look, spark


@pytest.fixture(scope="module")
def exported(few_tree: nf.orthoview.OrthoTree, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, dict[str, int]]:
    folder = tmp_path_factory.mktemp("tiles") / "splats"
    return folder, few_tree.export_splats(folder, aabb=box_of(few_tree))


def box_of(tree: nf.orthoview.OrthoTree) -> NDArray[np.float64]:
    """A part of the world, for speed."""
    low, high = tree.bounds
    return np.array([low, [low[0] + 3.4 * tree.cell, *high[1:]]])


def cells(tree: nf.orthoview.OrthoTree, level: int) -> dict[tuple[int, tuple[int, int, int]], Cell]:
    """All cells that have Gaussians, from a level upwards."""
    reader = Cells(tree._files, tree._layout, tree.generation, box_of(tree), sun_of("sun"))
    read = {key: reader.read(*key) for key in reader.cells_down_to(level)}
    return {key: cell for key, cell in read.items() if len(cell.gaussians)}


def key_of(tile: Tile) -> tuple[int, tuple[int, int, int]]:
    level, x, y, z = map(int, tile.path.with_suffix("").parts[-4:])
    return level, (x, y, z)


def check_rows(got: Rows, cell: Cell, step: float, spread: float) -> None:
    """Check the Gaussians of a cell: centres within a step, scales within a share, colours within a code."""
    right: Gaussians = cell.gaussians
    assert len(got.middle) == len(right)
    assert np.abs(got.middle - (right.middle + cell.center)).max() <= step
    assert np.abs(np.log(got.scale / right.scale)).max() <= spread
    assert np.abs(got.color - right.color / 255).max() <= 0.0038
    assert (got.opacity == 1).all()


def test_each_cell_is_a_tile_with_its_gaussians(
    few_tree: nf.orthoview.OrthoTree, exported: tuple[Path, dict[str, int]]
) -> None:
    folder, counts = exported
    wanted, found = cells(few_tree, 0), {key_of(tile): tile for tile in tiles(folder)}
    assert found.keys() == wanted.keys()
    assert sum(1 for _ in tiles(folder)) == len(found)  # Each occurs once.
    assert {path.resolve() for path in folder.rglob("*.glb")} == {tile.path for tile in found.values()}
    for key, cell in wanted.items():
        check_rows(glb_rows(found[key].path.read_bytes()), cell, 1e-5 * np.abs(cell.center).max(), 1e-6)
    assert counts == {
        "tiles": len(wanted),
        "splats": sum(len(cell.gaussians) for cell in wanted.values()),
        "pixels": sum(cell.pixels for cell in wanted.values()),
        "bytes": sum(path.stat().st_size for path in folder.rglob("*.glb")),
        "failed": 0,
        "unbuilt": 0,
    }
    assert counts["pixels"] > counts["splats"]


def test_boxes_hold_three_standard_deviations_and_errors_fall(
    few_tree: nf.orthoview.OrthoTree, exported: tuple[Path, dict[str, int]]
) -> None:
    folder, _ = exported
    for tile in tiles(folder):
        rows = glb_rows(tile.path.read_bytes())
        reach = 3 * np.sqrt(np.array([np.diag(matrix) for matrix in rows.covariances()]))
        assert (tile.box[0] <= (rows.middle - reach).min(axis=0) + 1e-3).all()
        assert ((rows.middle + reach).max(axis=0) <= tile.box[1] + 1e-3).all()
        level, place = key_of(tile)
        # Five directions look along the axes. The 16 screen pixels that viewers allow are two pixels of the view.
        pixel = few_tree.cell * 2**level / few_tree.size
        assert tile.error == (0 if tile.is_leaf else pytest.approx(8 * pixel))
        assert tile.is_leaf == (level == 0)
        assert [key_of(above) for above in tile.above] == [
            (level + up, tuple(number >> up for number in place)) for up in range(few_tree.levels - 1 - level, 0, -1)
        ]


def test_documents_list_a_few_levels_each(
    few_tree: nf.orthoview.OrthoTree, exported: tuple[Path, dict[str, int]]
) -> None:
    folder, _ = exported
    apart = {path.parent.parent.parent.name for path in (folder / "tilesets").rglob("*.json")}
    assert few_tree.levels == 5
    assert apart == {"3"}  # Of levels 0 to 3; the top document lists level 4 and refers to them.
    text = (folder / "tileset.json").read_text()
    assert "content/3/" not in text
    named = json.loads(text)["extensions"]["3DTILES_content_gltf"]
    assert named == {"extensionsUsed": [SPLATS], "extensionsRequired": [SPLATS]}


def test_spz_in_tiles_is_within_its_steps(few_tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    counts = few_tree.export_splats(tmp_path / "splats", level=2, compression="spz", aabb=box_of(few_tree))
    wanted, found = cells(few_tree, 2), list(tiles(tmp_path / "splats"))
    assert {key_of(tile) for tile in found} == wanted.keys()
    for tile in found:
        cell, data = wanted[key_of(tile)], tile.path.read_bytes()
        # A step is at most 1/32 of the smallest standard deviation.
        check_rows(glb_rows(data), cell, cell.gaussians.scale[:, :2].min() / 64 + 1e-4, 1 / 32 + 1e-6)
        document, _ = glb_parts(data)
        assert document["extensionsRequired"] == [SPLATS, PACKED]
    assert counts["bytes"] < 20 * counts["splats"] + 2000 * counts["tiles"]


@pytest.mark.parametrize("name", ["one.spz", "one.glb", "packed.glb"])
def test_one_file_contains_the_cells_of_a_level(few_tree: nf.orthoview.OrthoTree, tmp_path: Path, name: str) -> None:
    path, level = tmp_path / name, 1
    counts = few_tree.export_splats(
        path, level=level, aabb=box_of(few_tree), compression="spz" if name == "packed.glb" else None
    )
    data = path.read_bytes()
    rows = spz_rows(data, 3) if name == "one.spz" else glb_rows(data)
    wanted = {key: cell for key, cell in cells(few_tree, level).items() if key[0] == level}
    assert counts == {
        "cells": len(wanted),
        "splats": len(rows.middle),
        "pixels": sum(cell.pixels for cell in wanted.values()),
        "bytes": len(data),
        "failed": 0,
        "unbuilt": 0,
    }
    at = 0
    for cell in wanted.values():  # In the order of cells.
        part = slice(at, at + len(cell.gaussians))
        own = Rows(rows.middle[part], rows.rotation[part], rows.scale[part], rows.opacity[part], rows.color[part])
        check_rows(own, cell, cell.gaussians.scale[:, :2].min() / 64 + 1e-3, 1 / 32 + 1e-6)
        for quaternion, matrix in zip(own.covariances(), matrices(cell.gaussians.rotation), strict=True):
            # The thin axis is the one with the least spread, within the rotation error of version 2.
            spread = np.diag(matrix.T @ quaternion @ matrix)
            assert spread[2] <= spread.min() * 1.5
        at = part.stop
    assert [path.name for path in tmp_path.iterdir()] == [name]


def test_exports_apply_a_box_and_a_light(few_tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    low, high = few_tree.bounds
    box = np.array([low, [*((low + high) / 2)[:2], high[2]]])
    whole, part = (
        few_tree.export_splats(tmp_path / "a.glb", level=2),
        few_tree.export_splats(tmp_path / "b.glb", level=2, aabb=box, light=None),
    )
    assert 0 < part["splats"] < whole["splats"]
    rows = glb_rows((tmp_path / "b.glb").read_bytes())
    assert ((box[0] - 1e-3 <= rows.middle) & (rows.middle <= box[1] + 1e-3)).all()
    dark = glb_rows((tmp_path / "a.glb").read_bytes()).color.mean()
    assert dark < rows.color.mean()  # Lit surfaces reflect less than all light.
    few_tree.export_splats(tmp_path / "c.glb", level=2, light=(0, 10, 0))
    for name, light in (("a", {"sun": pytest.approx([0.5263, 0.7895, 0.3158], abs=1e-4)}), ("b", "none")):
        assert glb_parts((tmp_path / f"{name}.glb").read_bytes())[0]["asset"]["extras"]["light"] == light
    assert glb_parts((tmp_path / "c.glb").read_bytes())[0]["asset"]["extras"]["light"] == {"sun": [0, 1, 0]}


def test_a_failed_export_keeps_the_older_one(
    few_tree: nf.orthoview.OrthoTree, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def stopped(jobs: Iterator[Any]) -> Iterator[Any]:
        for number, result in enumerate(results(jobs)):
            if number == 3:
                raise KeyboardInterrupt
            yield result

    for name in ("tiles", "one.spz", "one.glb"):
        folder = tmp_path / name.partition(".")[2]
        folder.mkdir(exist_ok=True)
        with monkeypatch.context() as patch:
            patch.setattr("nearfar._base.side_by_side.results", stopped)
            with pytest.raises(KeyboardInterrupt):
                few_tree.export_splats(folder / name, level=2)
        assert list(folder.iterdir()) == []
        few_tree.export_splats(folder / name, level=2)
        before = content(folder)
        with monkeypatch.context() as patch:
            patch.setattr("nearfar._base.side_by_side.results", stopped)
            with pytest.raises(KeyboardInterrupt):
                few_tree.export_splats(folder / name, level=2)
        assert content(folder) == before


def test_invalid_arguments_of_exports_are_refused(
    few_tree: nf.orthoview.OrthoTree, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "out"
    for match, wrong in (
        ("light", {"light": (0, 0, 0)}),
        ("compression", {"format": "spz", "compression": "spz"}),
        ("aabb", {"aabb": [(1e6, 0, 0), (2e6, 1, 1)]}),
    ):
        with pytest.raises(ValueError, match=match):
            few_tree.export_splats(out, **wrong)
        assert list(tmp_path.iterdir()) == []
    with pytest.raises(ValueError, match=r"path.*\.ply"):
        few_tree.export_splats(tmp_path / "out.ply")
    with pytest.raises(FileNotFoundError):
        few_tree.export_splats(tmp_path / "missing" / "out")
    (out / "other").mkdir(parents=True)
    with pytest.raises(FileExistsError):
        few_tree.export_splats(out)
    monkeypatch.setattr(_spz, "MAX", 100)
    with pytest.raises(ValueError, match="level: expected one with at most 100 splats"):
        few_tree.export_splats(tmp_path / "out.spz")
    assert {path.name for path in tmp_path.iterdir()} == {"out"}


def test_bytes_do_not_depend_on_threads(few_tree: nf.orthoview.OrthoTree) -> None:
    code = f"""
import hashlib, tempfile
from pathlib import Path
import nearfar as nf
with tempfile.TemporaryDirectory() as folder:
    nf.orthoview.open({few_tree.path!r}).export_splats(Path(folder) / "out", level=2)
    for path in sorted(Path(folder).rglob("*")):
        if path.is_file():
            print(path.relative_to(folder), hashlib.sha256(path.read_bytes()).hexdigest())
"""
    (printed,) = printed_by_threads(code, "13")
    assert printed.count(".glb") > 5


@pytest.mark.slow
def test_the_validator_of_gltf_finds_no_errors(exported: tuple[Path, dict[str, int]]) -> None:
    need("node")
    folder, _ = exported
    paths = sorted(folder.rglob("*.glb"))[:5]
    for path, report in node("validate.mjs", paths).items():
        errors = [message for message in report["messages"] if message["severity"] == 0]
        # The validator does not know the extension's attribute names.
        unknown = [message for message in errors if f"/attributes/{SPLATS}:" in message["pointer"]]
        assert len(unknown) == 4
        assert errors == unknown, path
        assert report["numWarnings"] == 0


@pytest.mark.slow
def test_spark_loads_and_draws_exported_splats(few_tree: nf.orthoview.OrthoTree, tmp_path: Path) -> None:
    need("browser")
    reader = Cells(
        few_tree._files, few_tree._layout, few_tree.generation, np.array([[-np.inf] * 3, [np.inf] * 3]), sun_of("sun")
    )
    key = max(reader.cells_of_level(1), key=lambda cell: reader.read(*cell).pixels)
    cell, path = reader.read(*key), tmp_path / "cell.spz"
    path.write_bytes(_spz.encode(cell.gaussians))
    (x, y, z), side = cell.center.tolist(), few_tree.cell * 2
    look = Look((x + 0.8 * side, y + 2.1 * side, z + 1.2 * side), (x, y, z), 30.0, (96, 72))
    (loaded,), (picture,) = spark([(path, cell.center)], [(look, [0])], first=50)
    right = spz_rows(path.read_bytes(), 3)
    assert loaded["count"] == len(right.middle)
    first = np.array(loaded["first"])
    # Spark stores numbers as float16 and quaternions in some 20 bits.
    assert np.abs(first[:, :3] - right.middle[:50]).max() < 1e-3 * side
    assert np.abs(np.log(first[:, 3:6] / right.scale[:50])).max() < 0.05
    assert np.abs((first[:, 6:10] * right.rotation[:50]).sum(axis=1)).min() > 0.999
    assert (first[:, 10] == 1).all()
    assert np.abs(first[:, 11:] - right.color[:50]).max() < 0.01
    clip = nf.Clip(box=few_tree.box(*key))
    ours = few_tree.render(
        look.camera, samples=16, geometry=False, error_px=8, clip=clip, channels=("color", "coverage")
    )
    solid, beside = np.asarray(ours.coverage) > 0.999, np.asarray(ours.coverage) == 0
    assert solid.sum() > 300
    assert (picture[..., 3][solid] > 0.5).mean() > 0.97
    assert picture[..., 3][beside].mean() < 0.15
    apart = np.abs(picture[..., :3] - ours.to_image() / 255.0)[solid].mean()
    turned = np.abs(picture[:, ::-1, :3] - ours.to_image() / 255.0)[solid].mean()
    assert apart < 0.12
    assert apart < 0.6 * turned
