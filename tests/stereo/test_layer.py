"""Tests of the shared picture as a rectangle in space, and of view vectors for shading."""

from __future__ import annotations

import json
import math
import os
import re
import subprocess
import sys

import numpy as np
import pytest
from numpy.typing import NDArray

import nearfar as nf
from nearfar.hmd import Eye
from nearfar.stereo import HybridRig
from nearfar.stereo._view_vectors import view_vectors
from tests.support import need

HEAD = (4.0, 1.7, -3.0)
AHEAD = nf.Camera.look_at(HEAD, (9.0, 2.5, -9.0), fov=nf.Fov.symmetric(90), size=(1, 1)).orientation


def rotate(v: NDArray[np.float64]) -> NDArray[np.float64]:
    u, w = np.array(AHEAD[:3]), AHEAD[3]
    return np.asarray(v + 2.0 * np.cross(u, np.cross(u, v) + w * v))


def rig(cant: float = 0.0, mono_plane: float = 6.0) -> HybridRig:
    half = math.radians(cant) / 2.0

    def eye(fov: nf.Fov, x: float, side: float) -> Eye:
        return Eye(fov, (x, 0.01, -0.05), (0.0, side * math.sin(half), 0.0, math.cos(half)))

    left, right = eye(nf.Fov(-1.2, 0.9, -1.0, 1.1), -0.03, 1.0), eye(nf.Fov(-0.9, 1.2, -1.0, 1.1), 0.033, -1.0)
    return HybridRig(left=left, right=right, mono_plane=mono_plane, size=(200, 160))


@pytest.mark.parametrize("cant", [0.0, 5.0])
def test_a_compositor_places_the_rectangle_by_the_homography(cant: float) -> None:
    made = rig(cant)
    layer, (width, height) = made.quad_layer, made.center_size
    for side, camera in zip(("left", "right"), made.cameras(HEAD, AHEAD), strict=False):
        for u, v in [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0), (1.0, 1.0), (0.3, 0.6)]:
            at = np.add(layer.position, (layer.size[0] * (u - 0.5), layer.size[1] * (0.5 - v), 0.0))
            shown = camera.project([np.array(HEAD) + rotate(at)])[0, :2]
            x, y, w = made.homography(side) @ (u * width, v * height, 1.0)
            np.testing.assert_allclose(shown, (x / w, y / w), atol=1e-9)


def blinn_phong(
    normal: NDArray[np.float64], light: NDArray[np.float64], to_viewer: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Specular reflection of a light in a direction, exponent 200."""
    half = to_viewer + light
    half /= np.linalg.norm(half, axis=1, keepdims=True)
    return np.asarray(np.maximum(half @ normal, 0.0) ** 200)


def test_highlights_do_not_jump_at_the_plane() -> None:
    """Along a floor through the plane, a highlight changes as smoothly as for one viewer."""
    made = rig(mono_plane=2.0)
    depths = np.linspace(1.0, 3.5, 4001)
    ahead = rotate(np.array((0.0, 0.0, -1.0)))
    points = np.array(HEAD) + rotate(np.array((0.0, 0.0, -0.05))) + depths[:, None] * ahead + (0.3, -1.7, 0.0)
    cameras = made.cameras(HEAD, AHEAD)
    normal = np.array((0.0, 1.0, 0.0))
    way = made.view_vectors("left", points, HEAD, AHEAD)
    np.testing.assert_allclose(np.linalg.norm(way, axis=1), 1.0, rtol=1e-12)
    eye, center = (np.array(cameras[n].position) - points for n in (0, 2))
    to_eye, to_center = (v / np.linalg.norm(v, axis=1, keepdims=True) for v in (eye, center))
    real = (points - cameras[2].position) @ ahead - made.center_offset
    np.testing.assert_allclose(way[real < 1.7], to_eye[real < 1.7], atol=1e-12)
    np.testing.assert_allclose(way[real >= 2.0], to_center[real >= 2.0], atol=1e-12)
    halfway = np.abs(real - 1.85).argmin()
    mixed = to_eye[halfway] + to_center[halfway]
    np.testing.assert_allclose(way[halfway], mixed / np.linalg.norm(mixed), atol=1e-3)
    # A light whose highlight lies slightly in front of the plane.
    light = 2.0 * (to_eye[halfway] @ normal) * normal - to_eye[halfway]
    smooth, jump = (
        blinn_phong(normal, light, way),
        np.where(real < 2.0, blinn_phong(normal, light, to_eye), blinn_phong(normal, light, to_center)),
    )
    step = np.abs(np.diff(blinn_phong(normal, light, to_eye))).max()
    assert np.abs(np.diff(jump)).max() > 20.0 * step
    assert np.abs(np.diff(smooth)).max() < 4.0 * step


SHADE = """
import json, os, sys
import numpy as np
import pyrender
from OpenGL.GL import *
from OpenGL.GL.shaders import compileProgram, compileShader

given = json.load(sys.stdin)
count = len(given["points"])
context = pyrender.OffscreenRenderer(count, 1)
context._platform.make_current()
vertex = "#version 330\\nvoid main() { gl_Position ="
vertex += " vec4(4.0 * (gl_VertexID & 1) - 1.0, 2.0 * (gl_VertexID & 2) - 1.0, 0.0, 1.0); }"
fragment = "#version 330\\nuniform vec3 points[64]; uniform vec3 eye, center, ahead, sizes; out vec3 shown;"
fragment += given["text"] + "void main() { shown ="
fragment += " view_vector(points[int(gl_FragCoord.x)], eye, center, ahead, sizes.x, sizes.y, sizes.z); }"
glBindVertexArray(glGenVertexArrays(1))
program = compileProgram(compileShader(vertex, GL_VERTEX_SHADER), compileShader(fragment, GL_FRAGMENT_SHADER))
texture = glGenTextures(1)
glBindTexture(GL_TEXTURE_2D, texture)
glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, count, 1, 0, GL_RGBA, GL_FLOAT, None)
glBindFramebuffer(GL_FRAMEBUFFER, glGenFramebuffers(1))
glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0)
glViewport(0, 0, count, 1)
glUseProgram(program)
glUniform3fv(glGetUniformLocation(program, "points"), count, np.array(given["points"], np.float32))
for name in ("eye", "center", "ahead", "sizes"):
    glUniform3f(glGetUniformLocation(program, name), *given[name])
glDrawArrays(GL_TRIANGLES, 0, 3)
pixels = np.frombuffer(glReadPixels(0, 0, count, 1, GL_RGBA, GL_FLOAT), np.float32).reshape(count, 4)
print(json.dumps(pixels[:, :3].tolist()))
"""


def test_shader_texts_compute_the_same_vectors() -> None:
    """Compares GLSL drawn by OpenGL; WGSL, which the adapters' Rust tests validate, has the same expressions."""
    need("pyrender")
    texts = {name: nf.stereo.view_vector_shader(name) for name in ("wgsl", "glsl")}
    bodies = [re.findall(r"^ +(?:let|float)?\s*(.*;)$", text, re.MULTILINE) for text in texts.values()]
    assert len(bodies[0]) == 3
    assert bodies[0] == bodies[1]
    points = np.random.default_rng(2).uniform((-3.0, -2.0, -8.0), (3.0, 2.0, -4.0), (60, 3))
    eye, center, ahead = (-0.03, 0.01, -0.02), (0.0, 0.0, 0.04), (0.0, 0.0, -1.0)
    sizes = (6.0, 0.04, 0.3)
    given = {"points": points.tolist(), "eye": eye, "center": center, "ahead": ahead, "sizes": sizes}
    found = subprocess.run(
        [sys.executable, "-W", "ignore", "-c", SHADE],
        input=json.dumps(given | {"text": texts["glsl"]}),
        env=os.environ | {"PYOPENGL_PLATFORM": os.environ.get("PYOPENGL_PLATFORM", "egl")},
        capture_output=True,
        text=True,
        check=False,
    )
    assert found.returncode == 0, found.stderr
    plane, setback, blend = sizes
    expected = view_vectors(
        points, *(np.array(v) for v in (eye, center, ahead)), plane=plane, setback=setback, blend=blend
    )
    depths = -points[:, 2]
    assert ((depths > 5.7) & (depths < 6.0)).any()
    np.testing.assert_allclose(json.loads(found.stdout), expected, atol=2e-6)
