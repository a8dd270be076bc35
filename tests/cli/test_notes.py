"""Every command lists parts of a scene's file that are not drawn as specified."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import nearfar as nf
from tests.support.cli_cases import command, document
from tests.support.gltf_cases import gltf

SMALL = ("--size", "32x20", "--samples", "1", "--face-size", "16", "--center", "3,0.5,3", "--backend", "cpu")
COMMANDS: dict[str, tuple[str, ...]] = {
    "info": (),
    "partition": ("--center", "3,0.5,3"),
    "render": ("-o", "OUT/a.png", "--eye", "3,0.5,3", "--target", "3,0.5,0", *SMALL[:4], *SMALL[8:]),
    "bake": ("-o", "OUT/a.exr", "--r1", "1", "--r2", "2", *SMALL[2:]),
    "reduce": ("-o", "OUT/reduced", "--r2", "2", *SMALL),
    "compare": ("-o", "OUT/compared", "--r1", "1", "--r2", "2", "--user", "3.1,0.5,3", "--fov", "10", *SMALL),
    "stereo": ("-o", "OUT/stereo", "--eye", "3,0.5,3", "--target", "3,0.5,0", *SMALL[:4], *SMALL[8:]),
    "export": ("-o", "OUT/bundle", "--radii", "1,2", "--samples", "1", "--face-size", "64", "--center", "3,0.5,3"),
    "lod": ("-o", "OUT/a.glb", "--views", "4", "--distances", "5", "--ratios", "0.5", "--backend", "cpu"),
}
SCHEMAS = {"reduce": "report", "lod": "levels"}


@pytest.fixture
def source(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))
    (tmp_path / "squares.glb").write_bytes(gltf())
    return tmp_path / "squares.glb"


@pytest.mark.parametrize("name", COMMANDS)
def test_every_command_lists_what_is_not_drawn(
    name: str, source: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    notes = list(nf.Scene.load(source).report.notes)
    assert "1 material with an occlusion map drawn without it" in notes
    arguments = [argument.replace("OUT", str(tmp_path)) for argument in COMMANDS[name]]
    status, out, err = command(capsys, name, "-i", source, *arguments, "--json")
    assert status == 0, err
    found = document(out, SCHEMAS.get(name, name))
    assert (found["report"]["notes"] if name == "info" else found["notes"]) == notes
    status, out, _ = command(capsys, name, "-i", source, *arguments)
    assert status == 0
    assert "an occlusion map drawn without it" in " ".join(out.split())
    for report in ("reduced/report.md", "compared/report.md", "compared/report.html", "stereo/report.html"):
        if (tmp_path / report).exists():
            assert all(note in (tmp_path / report).read_text(encoding="utf-8") for note in notes)
    if name == "reduce":
        assert json.loads((tmp_path / "reduced" / "reduced.json").read_text())["notes"] == notes
