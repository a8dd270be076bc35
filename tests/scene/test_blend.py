"""Materials with blending: drawn opaque, or cut out where alpha is below one half."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from PIL import Image

import nearfar as nf
from nearfar._scene.options import Blend
from tests.support.cli_cases import command
from tests.support.gltf_cases import decode
from tests.support.ktx2_cases import glb

BLENDS: tuple[Blend, ...] = ("opaque", "cutout")
FOV = nf.Fov(-1.2, 0.9, -1.1, 1.0)
VIEW = nf.Camera.look_at((0.5, 0.5, 1), (0.5, 0.5, 0), fov=nf.Fov.symmetric(50, 1), size=(32, 32))


def pane(alphas: list[int], mode: str | None = "BLEND", **changes: Any) -> bytes:
    """A square whose texture has columns of these alphas."""
    texels = np.full((4, len(alphas), 4), 200, np.uint8)
    texels[..., 3] = alphas
    file = io.BytesIO()
    Image.fromarray(texels).save(file, "png")
    surface = {"metallicFactor": 0, "baseColorTexture": {"index": 0}}
    material = {"pbrMetallicRoughness": surface, "doubleSided": True} | ({} if mode is None else {"alphaMode": mode})
    return glb(
        file.getvalue(), materials=[material | changes], textures=[{"source": 0}], extensionsRequired=[]
    )  # fmt: skip


def coverage(scene: nf.Scene) -> float:
    """Share of the picture that shows a surface."""
    found = nf.render(scene, VIEW).range
    assert found is not None
    return float(np.isfinite(found).mean())


@pytest.mark.parametrize(
    ("alphas", "part"), [([255] * 4, 1.0), ([255, 255, 0, 0], 0.5), ([128] * 4, 1.0), ([127] * 4, 0.0)]
)
def test_half_transparent_texels_are_cut_out(tmp_path: Path, alphas: list[int], part: float) -> None:
    (tmp_path / "a.glb").write_bytes(pane(alphas))
    opaque, cut = (nf.Scene.load(tmp_path / "a.glb", blend=blend) for blend in BLENDS)
    assert coverage(opaque) > 0.5
    # The square has four columns of texels; filtering moves its edges by less than one.
    assert (
        abs(coverage(cut) / coverage(opaque) - part) < 0.26
        if 0 < part < 1
        else coverage(cut) == part * coverage(opaque)
    )
    assert opaque.report.notes == nf.Scene.load(tmp_path / "a.glb").report.notes
    assert "1 material with blending drawn opaque" in opaque.report.notes
    assert "1 material with blending drawn where alpha is at least 1/2" in cut.report.notes


@pytest.mark.parametrize(("mode", "changes"), [(None, {}), ("OPAQUE", {}), ("MASK", {"alphaCutoff": 0.2})])
def test_other_materials_are_drawn_opaque(tmp_path: Path, mode: str | None, changes: dict[str, Any]) -> None:
    (tmp_path / "a.glb").write_bytes(pane([90] * 4, mode, **changes))
    opaque, cut = (nf.Scene.load(tmp_path / "a.glb", blend=blend) for blend in BLENDS)
    assert coverage(opaque) == coverage(cut) > 0.5
    assert opaque.report.notes == cut.report.notes
    assert not any("alpha" in note or "blending" in note for note in cut.report.notes)


def test_written_files_describe_what_is_drawn(tmp_path: Path) -> None:
    (tmp_path / "a.glb").write_bytes(pane([255, 0, 255, 0]))
    for blend, mode in zip(BLENDS, ("BLEND", "MASK"), strict=True):
        nf.lod.export(nf.Scene.load(tmp_path / "a.glb", blend=blend), tmp_path / "written.glb", view=FOV)
        (material,) = decode(tmp_path / "written.glb")[0]["materials"]
        assert (material["alphaMode"], material.get("alphaCutoff", 0.5)) == (mode, 0.5)


@pytest.mark.parametrize(("opacity", "is_drawn"), [(0.4, False), (0.6, True)])
def test_wavefront_materials_are_cut_out_as_a_whole(tmp_path: Path, opacity: float, is_drawn: bool) -> None:
    (tmp_path / "a.mtl").write_text(f"newmtl m\nKd 0.5 0.4 0.3\nd {opacity}\n")
    (tmp_path / "a.obj").write_text("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n")
    scene = nf.Scene.load(tmp_path / "a.obj", blend="cutout")
    assert (coverage(scene) > 0) == is_drawn
    assert scene.report.notes == ("1 material with transparency drawn where alpha is at least 1/2",)


def test_trimesh_objects_are_cut_out_too() -> None:
    box = trimesh.creation.box()
    color = [255, 255, 255, 100]
    material = trimesh.visual.material.PBRMaterial(baseColorFactor=color, alphaMode="BLEND", doubleSided=True)
    box.visual = trimesh.visual.TextureVisuals(uv=np.zeros((8, 2)), material=material)
    far = nf.Camera.look_at((0, 0, 3), (0, 0, 0), fov=nf.Fov.symmetric(50, 1), size=(16, 16))
    for blend, is_seen in zip(BLENDS, (True, False), strict=True):
        found = nf.render(nf.Scene.from_trimesh(box, blend=blend), far).range
        assert found is not None
        assert bool(np.isfinite(found).any()) == is_seen


def test_commands_pass_the_cutoff_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "a.glb").write_bytes(pane([255, 0, 255, 0]))
    status, out, _ = command(capsys, "info", "-i", tmp_path / "a.glb", "--blend", "cutout", "--json")
    assert status == 0
    assert "with blending drawn where alpha is at least 1/2" in out
    status, _, said = command(capsys, "info", "-i", tmp_path / "a.glb", "--blend", "glass")
    assert status != 0
    assert "blend: expected one of 'opaque', 'cutout', got 'glass'" in said
