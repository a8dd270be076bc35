"""Tests of the morph for engines: its files compile and, in a browser, compute the vectors; its how-tos work.

The test of rust/gpu/tests/engines.rs compares the files with the translation of the kernels.
"""

from __future__ import annotations

import re
import subprocess
import textwrap
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh

import nearfar as nf
from tests.support import need
from tests.support.reader_cases import answer_of
from tests.support.vectors import cases, check

CHECKOUT = Path(__file__).resolve().parents[2]
ENGINES = CHECKOUT / "docs" / "engines"


def code(language: str) -> list[str]:
    """Code blocks of a language in the page of how-tos."""
    page = (CHECKOUT / "docs" / "engines.md").read_text(encoding="utf-8")
    return re.findall(rf"```{language}\n(.*?)```", page, re.DOTALL)


def test_the_how_to_splits_large_triangles(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    nf.reduce(nf.datasets.city(blocks=2, detail=0), center=(0, 1.7, 0), r1=30, r2=50, face_size=16).save(
        tmp_path / "light"
    )
    monkeypatch.chdir(tmp_path)
    found: dict[str, Any] = {}
    exec(textwrap.dedent(code("python")[0]), found)
    written = trimesh.load("light/split.glb", force="mesh")
    assert len(written.faces) == len(found["split"].faces) > len(found["mesh"].faces)


# Compilation ----------------------------------------------------------------------------------------------------------

CALLS = """
    vec3 q = nearfar_morph(p, p, p, 1.0, 2.0, 1.0) + nearfar_morph_cylinder(p, p, p, 1.0, 2.0, 0.5);
    gl_Position = vec4(q, nearfar_range_cylinder(p, 1.0, p, p));
"""
UNITY = """
float3 _WorldSpaceCameraPos;
float3 TransformObjectToWorld(float3 p) { return p; }
float4 TransformWorldToHClip(float3 p) { return float4(p, 1.0); }
"""


def compiled(text: str, folder: Path, stage: str, *options: str) -> None:
    """Compile a file; fails if glslang reports errors or warnings."""
    need("glslang")
    path = folder / f"shader.{stage}"
    path.write_text(text)
    command = ["glslangValidator", "-S", stage, f"-I{ENGINES}", *options, str(path)]
    process = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=60, check=False)
    found = process.stdout + process.stderr
    assert process.returncode == 0, found
    assert "WARNING" not in found, found


@pytest.mark.parametrize("version", ["300 es", "330", "450"])
def test_glsl_compiles(version: str, tmp_path: Path) -> None:
    precision = "precision highp float;" if "es" in version else ""
    text = (ENGINES / "morph.glsl").read_text(encoding="utf-8")
    compiled(f"#version {version}\n{precision}\n{text}\nin vec3 p;\nvoid main() {{{CALLS}}}\n", tmp_path, "vert")


def test_hlsl_compiles(tmp_path: Path) -> None:
    calls = CALLS.replace("vec", "float").replace("gl_Position =", "return")
    text = f'#include "morph.hlsl"\n#include "morph.hlsl"\nfloat4 main(float3 p : POSITION) : SV_Position {{{calls}}}\n'
    compiled(text, tmp_path, "vert", "-D", "-V", "-e", "main")


def test_how_tos_in_hlsl_compile(tmp_path: Path) -> None:
    unity, unreal = code("hlsl")
    compiled(UNITY + unity, tmp_path, "vert", "-D", "-V", "-e", "Vertex")
    compiled(UNITY + unity, tmp_path, "frag", "-D", "-V", "-e", "Fragment")
    node = f"float3 Custom(float3 P, float3 U, float R1, float R2) {{\n{unreal}}}\n"
    main = "float4 main(float3 p : POSITION) : SV_Position { return float4(Custom(p, p, 1.0, 2.0), 1.0); }\n"
    compiled(f'#include "morph.hlsl"\n{node}{main}', tmp_path, "vert", "-D", "-V", "-e", "main")


# Numbers --------------------------------------------------------------------------------------------------------------

KINDS = {"blend": "nearfar_morph", "cylinder": "nearfar_morph_cylinder"}
SIZE = 256


def job(case: dict[str, Any], program: int) -> dict[str, Any]:
    """A case of the vectors relative to its centre, as the how-to recommends, if float32 cannot hold the centre."""
    center = np.array(case["center"])
    origin = np.zeros(3) if np.array_equal(center, np.float32(center)) else center
    return {
        **{name: case[name] for name in ("r1", "r2", "strength")},
        "program": program,
        "points": (np.array(case["points"]) - origin).tolist(),
        "user": (case["user"] - origin).tolist(),
        "center": (center - origin).tolist(),
        "origin": origin.tolist(),
    }


def scene() -> dict[str, Any]:
    """Coloured triangles about a centre, and their displayed positions for a user 8 m beside it."""
    random = np.random.default_rng(5)
    center, user, radii = np.array([3.0, 1.7, -2.0]), np.array([-3.0, 1.7, 3.3]), (12.0, 50.0)
    middles = random.uniform([-80, -4, -80], [80, 12, 80], (6000, 3))
    rho = np.hypot(middles[:, 0], middles[:, 2])
    # Triangles beyond r2 come last, and are not drawn.
    middles = np.concatenate([middles[rho < 46], middles[rho > 54]])
    corners = middles[:, None] + random.uniform(-2, 2, (len(middles), 3, 3))
    points = (corners.reshape(-1, 3) + center).astype(np.float32)
    within = points[: 3 * np.count_nonzero(rho < 46)]
    moved = nf.morph(within, user=user, center=center, r1=radii[0], r2=radii[1])
    return {
        "positions": points.tolist(),
        "moved": moved.tolist(),
        "colors": np.repeat(random.uniform(0.2, 1, (len(middles), 3)), 3, axis=0).tolist(),
        "user": user.tolist(),
        "center": center.tolist(),
        "r1": radii[0],
        "r2": radii[1],
        "target": [20.0, 2.0, -10.0],
        "size": SIZE,
    }


@pytest.mark.slow
def test_a_browser_computes_the_values_of_the_vectors(tmp_path: Path) -> None:
    need("browser")
    call = "{}(p, user, center, r1, r2, strength)"
    # A map of integers that fit into bytes; a lookup in a direction returns its texel's.
    texels = np.arange(6 * 16).reshape(6, 4, 4)
    directions = np.float32(np.random.default_rng(6).normal(size=(500, 3)))
    look_up = "textureLod(map, p, 0.0).rgb * 255.0"
    distance = "vec3(nearfar_range_cylinder(normalize(p - center), length(p - center), user, center))"
    wanted = [(case.values[0], kind) for kind in KINDS for case in cases(kind) if "wgsl" in case.values[0]["tolerance"]]
    beyond = [case for case, kind in wanted if kind == "cylinder" and not any(case["weight"]) and case["r2"] > 0]
    assert len(wanted) > 40
    assert len(beyond) >= 2
    given_cases = [
        *(job(case, list(KINDS).index(kind)) for case, kind in wanted),
        *(job(case, 2) for case in beyond),
        job(wanted[0][0], 3) | {"points": directions.tolist()},
    ]
    work = {
        "expressions": [*map(call.format, KINDS.values()), distance, look_up],
        "map": {"size": 4, "faces": np.repeat(texels.reshape(6, -1), 4, axis=1).tolist()},
        "cases": given_cases,
        "scene": {**scene(), "code": code("js")[0]},
    }
    answer = answer_of("morph.mjs", work, tmp_path, {"engines": ENGINES})
    found = [np.reshape(values, (-1, 3)) for values in answer["shown"]]
    for (case, _), values, given in zip(wanted, found, given_cases, strict=False):
        check(values + given["origin"], case["shown"], case["tolerance"]["wgsl"])
    for case, values in zip(beyond, found[len(wanted) : -1], strict=True):
        check(values[:, 0], case["distance"], case["tolerance"]["wgsl"])
    np.testing.assert_allclose(found[-1][:, 0], nf.cube_lookup(np.float32(texels), directions), atol=1e-3)

    pictures = {name: np.reshape(values, (SIZE, SIZE, 4)) for name, values in answer["pictures"].items()}
    same = {name: np.abs(picture - pictures["moved"]).max(-1) <= 2 for name, picture in pictures.items()}
    assert (pictures["moved"][..., :3].max(-1) > 0).mean() > 0.3
    assert same["morphed"].mean() > 0.998
    assert same["plain"].mean() < 0.9
