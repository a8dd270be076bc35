"""Tests of `nearfar lod`, from a mesh to files for engines."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from nearfar.lod._measure import score_table, scores as level_scores
from tests.support.cli_cases import command, document

QUICK = ("--views", "4", "--distances", "2", "--ratios", "0.3,0.05", "--method", "meshopt", "--backend", "cpu")


@pytest.fixture
def mesh(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))
    ball = trimesh.creation.icosphere(2)
    ball.vertices *= 1 + 0.05 * np.sin(9 * ball.vertices[:, :1])
    ball.export(tmp_path / "stone.ply")
    return tmp_path / "stone.ply"


def test_a_mesh_becomes_a_model(mesh: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / "stone.glb"
    status, out, err = command(capsys, "lod", "-i", mesh, "-o", target, "--hmd", "rift_s", *QUICK, "--json")
    assert (status, err) == (0, "")
    report = document(out, "levels")
    model = nf.lod.LodModel.load(target)
    assert report["name"] == model.name == "stone"
    assert model.measured["directions"] == "even"
    assert [level["triangles"] for level in report["levels"] if level["written"]] == model.triangles.tolist()
    assert report["bytes"] == target.stat().st_size
    found = nf.lod.switches(model, view=nf.hmd.RIFT_S)
    assert report["screen_coverage"] == found.coverages()
    assert nf.Scene.load(target).triangle_count == 320
    status, out, _ = command(
        capsys, "lod", "-i", mesh, "-o", tmp_path / "stone.json", "--directions", "published", *QUICK,
        "--percentile", "mean", "--samples", "1", "--step", "0.2", "--distances", "1",
    )  # fmt: skip
    assert status == 0
    assert re.search(r"320 triangles +\n.*\d+ triangles \([\d.]+ %\), off by up to", out)
    assert "became one object" not in out
    # The content tells the kind, not the name.
    for name, kept in (("stone.glb", "b.bin"), ("stone.json", "a.txt")):
        path = (tmp_path / name).rename(tmp_path / kept)
        status, out, err = command(capsys, "info", "-i", path, "--json")
        assert (status, err) == (0, "")
        described, model = document(out, "info"), nf.lod.LodModel.load(path)
        assert (described["kind"], "triangles" in described) == ("levels", model.levels is not None)
        levels = described["levels"]
        assert (levels["bytes"], levels["has_geometry"]) == (path.stat().st_size, model.levels is not None)
        assert [level["triangles"] for level in levels["levels"]] == model.triangles.tolist()
        assert levels["measured"] == model.measured
        assert "from" in command(capsys, "info", "-i", path)[1]
    coverages = [level["screen_coverage"] for level in levels["levels"]]
    assert coverages == nf.lod.switches(model, view=nf.hmd.QUEST_2).screen_coverage.tolist()
    status, _, err = command(capsys, "info", "-i", path, "--preview", tmp_path / "small.png")
    assert (status, "preview: expected a file with geometry" in err) == (1, True)
    assert (model.levels, model.measured["directions"]) == (None, "published")
    assert [model.measured[name] for name in ("percentile", "samples", "step")] == ["mean", 1, 0.2]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["-o", "OUT/stone.gltf"], "expected a name ending in .glb or .json"),
        (["-o", "OUT/stone.glb", "--ratios", "2"], "--ratios\\[0\\]: expected a number above 0"),
        (["-o", "OUT/none/stone.glb"], "cannot be written|No such file"),
    ],
)
def test_mistakes_are_one_sentence(
    mesh: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], message: str
) -> None:
    given = [argument.replace("OUT", str(tmp_path)) for argument in arguments]
    status, out, err = command(capsys, "lod", "-i", mesh, *given)
    assert (status, out) == (1, "")
    assert err.count("\n") == 1
    assert re.search(message, err)
    assert not list(tmp_path.glob("*.glb"))


def test_ctrl_c_reports_what_is_kept(
    mesh: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    done: list[int] = []

    def interrupted(*given: Any) -> Any:
        for found in level_scores.scores(*given):
            if done:
                raise KeyboardInterrupt
            done.append(len(found))
            yield found

    monkeypatch.setattr(score_table, "scores", interrupted)
    status, out, err = command(capsys, "lod", "-i", mesh, "-o", tmp_path / "stone.glb", *QUICK)
    assert (status, out) == (130, "")
    assert err.startswith(f"nearfar: interrupted; measure: {done[0]} of at most ")
    assert str(tmp_path / "cache") in err
