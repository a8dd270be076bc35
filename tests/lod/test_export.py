"""Files of levels: engines find `MSFT_lod` and the switching distances, and everything is restored."""

from __future__ import annotations

import itertools
import json
import math
from dataclasses import replace
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from nearfar._base import glb as glb_file
from tests.support import valid
from tests.support.leveled_cases import RED, bytes_of, checkers, frames, model_from, model_of, same_triangles, view

Array = NDArray[np.float64]
FOV = nf.Fov(-1.2, 0.9, -1.1, 1.0)
AREA = 2.1 * 2.1

# Schema from KhronosGroup/glTF, extensions/2.0/Vendor/MSFT_lod/schema/glTF.MSFT_lod.schema.json.
MSFT_LOD = {
    "type": "object",
    "properties": {"ids": {"type": "array", "items": {"type": "integer"}, "minItems": 1}},
    "required": ["ids"],
}


def document_of(path: Path) -> dict[str, Any]:
    return glb_file.Reader(path.read_bytes()).document


@pytest.fixture(scope="module")
def model() -> nf.lod.LodModel:
    return model_of((3, 2, 1, 0), name="ball", texture=checkers())


@pytest.fixture
def glb(model: nf.lod.LodModel, tmp_path: Path) -> Path:
    model.export(tmp_path / "ball.glb", view=FOV)
    return tmp_path / "ball.glb"


def geometry(model: nf.lod.LodModel) -> nf.lod.Levels:
    assert model.levels is not None
    return model.levels


def test_engines_find_each_level_once_and_where_it_ends(model: nf.lod.LodModel, glb: Path) -> None:
    document = document_of(glb)
    assert document["extensionsUsed"] == ["MSFT_lod"]
    (root,) = document["scenes"][0]["nodes"]
    node = document["nodes"][root]
    jsonschema.validate(node["extensions"]["MSFT_lod"], MSFT_LOD)
    ids = node["extensions"]["MSFT_lod"]["ids"]
    chain = [node, *(document["nodes"][number] for number in ids)]
    assert len({root, *ids}) == len(model)
    assert all("children" not in other for other in document["nodes"])
    indices = [document["meshes"][n["mesh"]]["primitives"][0]["indices"] for n in chain]
    assert [document["accessors"][number]["count"] // 3 for number in indices] == model.triangles.tolist()
    coverages = node["extras"]["MSFT_screencoverage"]
    found = nf.lod.switches(model, view=FOV)
    assert len(coverages) == len(chain)
    assert coverages[-1] == 0
    assert coverages[:-1] == found.screen_coverage[1:].tolist()
    assert all(1 > finer > coarser for finer, coarser in itertools.pairwise(coverages))
    assert len(document["images"]) == len(document["materials"]) == 1


def test_other_programs_show_level_0(model: nf.lod.LodModel, glb: Path) -> None:
    loaded = trimesh.load(glb, force="mesh")
    assert len(loaded.faces) == model.triangles[0]
    scene = nf.Scene.load(glb)
    assert scene.object_names == ("ball",)
    base = geometry(model)[0].scene
    assert same_triangles(scene, base)
    here, there = (nf.render(s, view((0, 0, 4)), channels=("color",), backend="cpu") for s in (scene, base))
    # The loader reads 1 − v, which is not exact, and textures upside down: positions in the texture differ by rounding.
    assert np.abs(here.to_image().astype(int) - there.to_image()).max() <= 2


def test_loaded_models_equal_saved_ones_bit_for_bit(model: nf.lod.LodModel, glb: Path, tmp_path: Path) -> None:
    back = nf.lod.LodModel.load(glb)
    assert back.name == model.name
    assert back.measured == model.measured
    assert back.sigma == model.sigma
    assert (back.radius, back.center.tolist()) == (model.radius, model.center.tolist())
    assert back.errors.tolist() == model.errors.tolist()
    for one, other in zip(back.curves, model.curves, strict=True):
        assert one.tolist() == other.tolist()
    for level, was in zip(geometry(back), geometry(model), strict=True):
        assert (level.ratio, level.error, level.mean_error, level.note) == (
            was.ratio,
            was.error,
            was.mean_error,
            was.note,
        )
        assert level.scene.triangles().tobytes() == was.scene.triangles().tobytes()
        pictures = [nf.render(scene, view((0, 0, 3)), backend="cpu") for scene in (level.scene, was.scene)]
        assert bytes_of(pictures[0]) == bytes_of(pictures[1])
    back.export(tmp_path / "again.glb", view=FOV)
    assert (tmp_path / "again.glb").read_bytes() == glb.read_bytes()


def test_levels_of_many_materials_keep_the_order_of_their_faces(tmp_path: Path) -> None:
    two = nf.Scene.from_trimesh(
        trimesh.Scene({"a": trimesh.creation.icosphere(1), "b": trimesh.creation.box((3, 0.5, 3))})
    )
    model = model_from([two, model_of((0,), color=RED).levels[0].scene])  # type: ignore[index]
    model.export(tmp_path / "two.glb", view=FOV)
    back = nf.lod.LodModel.load(tmp_path / "two.glb")
    for level, was in zip(geometry(back), geometry(model), strict=True):
        assert level.scene.triangles().tobytes() == was.scene.triangles().tobytes()


def test_unfittable_and_lone_levels_are_written(tmp_path: Path) -> None:
    model = model_of((2, 1, 0))
    nan = np.array([model.curves.a[0], np.nan])
    bad = replace(model.curves, a=nan, b=nan, c=nan, d=nan, rms=nan, status=np.array(["fitted", "unfittable"]))
    model = replace(model, curves=bad)
    model.export(tmp_path / "bad.glb", view=FOV, all_levels=True)
    back = nf.lod.LodModel.load(tmp_path / "bad.glb")
    assert back.curves.status.tolist() == ["fitted", "unfittable"]
    assert np.isnan(back.curves.a[1])
    node = document_of(tmp_path / "bad.glb")["nodes"][0]
    assert node["extras"]["MSFT_screencoverage"][1:] == [0, 0]
    assert node["extras"]["nearfar"]["switches"][2]["distance_per_radius"] is None
    lone = model_of((1,))
    lone.export(tmp_path / "lone.glb", view=FOV)
    document = document_of(tmp_path / "lone.glb")
    assert "extensionsUsed" not in document
    assert len(nf.lod.LodModel.load(tmp_path / "lone.glb")) == 1


def test_json_gives_the_switches_in_each_engines_terms(model: nf.lod.LodModel, tmp_path: Path) -> None:
    model.export(tmp_path / "ball.json", view=FOV)
    document = json.loads((tmp_path / "ball.json").read_text(encoding="utf-8"))
    assert valid(document, "lod")
    assert nf.lod.LodModel.load(tmp_path / "ball.json").levels is None
    assert [level["triangles"] for level in document["switches"]] == model.triangles.tolist()
    for level in document["switches"][1:]:
        sine = 1 / level["distance_per_radius"]
        assert level["solid_angle"] == pytest.approx(2 * math.pi * (1 - math.sqrt(1 - sine**2)), rel=1e-9)
        assert level["screen_coverage"] == pytest.approx(math.pi * sine**2 / AREA, rel=1e-12)
        assert level["screen_height"] == pytest.approx(2 * sine / 2.1, rel=1e-12)


def switched(model: nf.lod.LodModel, away: Array, found: nf.lod.Switches) -> list[int]:
    """Return the level that engines show of a sphere at distances in radii: the coarsest whose range has begun."""
    return [max((i for i in range(1, len(model)) if z >= found.distance[i]), default=0) for z in away]


def distances(found: nf.lod.Switches) -> Array:
    """Return distances in radii, some of them just before and after switching distances."""
    ends = found.distance[1:][np.isfinite(found.distance[1:])]
    return np.unique(np.concatenate([np.geomspace(1.01, 500, 300), ends * 0.999999, ends * 1.000001]))


THRESHOLDS = pytest.mark.parametrize("threshold", ["anchored", "literal", "normalized"])
NUMBERS = pytest.mark.parametrize(("k", "d"), [(0.27, 0.9), (0.24, 0.8), (0.0, 0.95), (0.27, 2.0), (0.1, 0.0)])


@THRESHOLDS
@NUMBERS
def test_switches_equal_the_formulas(model: nf.lod.LodModel, threshold: Any, k: float, d: float) -> None:
    fov = nf.Fov.symmetric(87, 87 / 90)
    found = nf.lod.switches(model, view=fov, k=k, d=d, threshold=threshold)
    reference = 2 * math.pi * (1 - math.cos(math.asin(math.tan(math.radians(87 / 2)) / 4)))
    away = distances(found)
    sigma = 2 * math.pi * (1 - np.sqrt(1 - 1 / away**2))
    if threshold == "literal":
        line = k * sigma + d
    else:
        line = d + k * (sigma - 0.209 if threshold == "anchored" else sigma / reference - 1)
    scores = model.curves(np.maximum(sigma, model.sigma[0]))
    enough = (scores >= line) & (sigma <= min(reference, model.sigma[1]))
    expected = [max((i + 1 for i in np.flatnonzero(column)), default=0) for column in enough.T]
    assert switched(model, away, found) == expected


@THRESHOLDS
@NUMBERS
def test_switches_equal_select(model: nf.lod.LodModel, threshold: Any, k: float, d: float) -> None:
    # Straight ahead in a symmetric view the sizes of engines and `select` are equal.
    fov = nf.Fov.symmetric(87, 87 / 90)
    found = nf.lod.switches(model, view=fov, k=k, d=d, threshold=threshold)
    away = distances(found)
    centers = np.zeros((len(away), 3))
    centers[:, 2] = -away * model.radius
    levels = nf.lod.select(
        [model], np.zeros(len(away), int), centers, np.full(len(away), model.radius),
        camera=nf.Camera((0, 0, 0), fov=fov, size=(64, 64)), k=k, d=d, threshold=threshold, mode="depth",
    )  # fmt: skip
    assert levels.tolist() == switched(model, away, found)


def test_coverage_equals_a_spheres_share_of_the_picture() -> None:
    """For small spheres on the axis the share of pixels equals the formula, up to the pixels at the rim."""
    model = model_of((5, 0))
    fov = nf.Fov.symmetric(60, 1.0)
    sigma = nf.lod.switches(model, view=fov, k=0.0, d=0.9).solid_angle[1]
    found = nf.lod.switches(model, view=fov, k=0.0, d=0.9)
    eye = (0.0, 0.0, model.radius * float(found.distance[1]))
    camera = nf.Camera(eye, fov=fov, size=(600, 600))
    frame = nf.render(geometry(model)[0].scene, camera, channels=("range",), backend="cpu")
    share = np.isfinite(frame.require("range")).mean()
    assert nf.solid_angle(np.zeros((1, 3)), np.array([model.radius]), eye=eye)[0] == pytest.approx(sigma, rel=1e-9)
    # Engines use the disc at the sphere's centre, smaller than the outline by cos²μ; facets lose 0.3 %.
    cosine = 1 - 1 / found.distance[1] ** 2
    assert share == pytest.approx(found.screen_coverage[1] / cosine, rel=0.01)


def test_scenes_are_written_with_every_objects_levels(model: nf.lod.LodModel, tmp_path: Path) -> None:
    other = model_of((2, 0), name="stone", color=RED)
    transforms = frames(5, seed=20, mirrored=True)
    transforms[:, :3, 3] += (1e5, 0, 0)
    placed = nf.lod.place([model, other], [0, 1, 0, 1, 1], transforms)
    nf.lod.export(placed, tmp_path / "scene.glb", view=FOV)
    document = document_of(tmp_path / "scene.glb")
    nodes = document["nodes"]
    roots = document["scenes"][0]["nodes"]
    assert [nodes[root]["name"] for root in roots] == list(placed.object_names)
    claimed = list(itertools.chain.from_iterable(nodes[root]["extensions"]["MSFT_lod"]["ids"] for root in roots))
    assert len(set(claimed)) == len(claimed) == 2 * 3 + 3 * 1
    assert not set(claimed) & set(roots)
    for root in roots:
        for number in nodes[root]["extensions"]["MSFT_lod"]["ids"]:
            assert nodes[number]["matrix"] == nodes[root]["matrix"]
    # Meshes are shared: four levels, two, and mirrored twins of those that are placed so.
    assert len(document["meshes"]) == 2 + 4 + 2
    back = nf.Scene.load(tmp_path / "scene.glb")
    assert back.triangle_count == placed.triangle_count
    np.testing.assert_allclose(back.bounds, placed.bounds, atol=0.01)
    camera = view((1e5, 0, 0))
    here, there = (nf.render(scene, camera, channels=("object_id",), backend="cpu") for scene in (placed, back))
    assert (here.require("object_id") == there.require("object_id")).mean() > 0.999


def test_scenes_and_objects_without_levels_are_written(model: nf.lod.LodModel, tmp_path: Path) -> None:
    box = nf.Scene.from_trimesh(trimesh.Scene({"a": trimesh.creation.box(), "b": trimesh.creation.icosphere(2)}))
    nf.lod.export(box, tmp_path / "plain.glb", view=FOV)
    assert same_triangles(nf.Scene.load(tmp_path / "plain.glb"), box)
    mixed = box.with_levels({"b": model})
    nf.lod.export(mixed, tmp_path / "mixed.glb", view=FOV)
    assert same_triangles(nf.Scene.load(tmp_path / "mixed.glb"), mixed)


@pytest.mark.parametrize(
    ("name", "error"), [("ball.gltf", ValueError), ("ball", ValueError), ("no/ball.glb", FileNotFoundError)]
)
def test_unwritable_file_names_are_refused(model: nf.lod.LodModel, tmp_path: Path, name: str, error: Any) -> None:
    with pytest.raises(error):
        model.export(tmp_path / name, view=FOV)
    assert list(tmp_path.iterdir()) == []


def test_models_without_geometry_have_no_glb(model: nf.lod.LodModel, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="geometry"):
        replace(model, levels=None).export(tmp_path / "ball.glb", view=FOV)
    replace(model, levels=None).export(tmp_path / "ball.json", view=FOV)


def test_damaged_files_are_format_errors(glb: Path, tmp_path: Path) -> None:
    data = glb.read_bytes()
    nf.Scene.from_arrays([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]])
    damaged = {
        "short": data[:100],
        "cut": data[:-10],
        "other": b"glTF" + bytes(40),
        "fewer levels": data.replace(b'"ids": [1, 2, 3]', b'"ids": [1, 2]   '),
        "no extras": data.replace(b'"nearfar": {"format"', b'"farnear": {"format"'),
        "newer": data.replace(b'"version": 2,', b'"version": 9,'),
        "wrong ids": data.replace(b'"ids": [1, 2, 3]', b'"ids": [1, 2, 9]'),
    }
    for name, content in damaged.items():
        assert content != data, name
        path = tmp_path / f"{name}.glb"
        path.write_bytes(content)
        with pytest.raises(nf.FormatError, match=name):
            nf.lod.LodModel.load(path)


def test_models_and_switches_are_shown_as_tables(model: nf.lod.LodModel) -> None:
    found = nf.lod.switches(model, view=FOV)
    head, titles, base, *rows = str(model).splitlines()
    assert head.startswith("ball, radius ")
    assert titles.split()[-1] == "curve"
    assert base.split() == ["0", f"{model.triangles[0]:,}", "0", "1.0000", "1.0000"]
    ends = model.curves(np.array(model.sigma[::-1]))
    for n, row in enumerate(rows):
        number, triangles, _, large, small, status = row.split()
        assert (int(number), triangles, status) == (n + 1, f"{model.triangles[n + 1]:,}", model.curves.status[n])
        assert [float(large), float(small)] == pytest.approx(ends[n], abs=5e-5)
    _, *rows = str(found).splitlines()
    assert [float(row.split()[2]) for row in rows] == pytest.approx(found.distance, rel=1e-3)
    assert [float(row.split()[3].rstrip("%")) for row in rows] == pytest.approx(100 * found.screen_coverage, abs=5e-3)
