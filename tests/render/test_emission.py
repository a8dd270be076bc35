"""Pictures of emissive and unlit surfaces by all renderers, compared with brute force in float64."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support import render_oracle as oracle
from tests.support.gpu_cases import ADAPTERS, adapter, agree, backend_of, both, codes_apart, srgb
from tests.support.hybrid_cases import AHEAD, HEAD, rig
from tests.support.reduce_cases import box
from tests.support.render_cases import QUAD, build, noise, quad
from tests.support.render_oracle import Surface

CENTER = (0.0, 1.7, 0.0)
BACKENDS = ("cpu", *ADAPTERS)
VIEW = nf.Camera.look_at(CENTER, (3, 2, -20), fov=nf.Fov.symmetric(80), size=(160, 120))


def lamps(dynamic: tuple[str, ...] = ()) -> nf.Scene:
    """A ground, and boxes near and far: plain, unlit with a texture, and with a bright emission texture."""
    builder = nf.SceneBuilder()
    image, glow = noise(32, 32, 4, seed=8), noise(16, 64, 4, seed=9)
    plain = builder.material((0.4, 0.6, 0.5, 1))
    unlit = builder.material((1, 0.8, 0.9, 1), image, unlit=True)
    bright = builder.material((0.5, 0.5, 0.5, 1), image, emission=(6.0, 2.0, 0.5), emission_texture=glow)
    red = builder.material((0.2, 0.2, 0.2, 1), emission=(2.5, 0.0, 0.1))
    corners, faces = box((-60, -0.5, -60), (60, 0, 60))
    builder.instance(builder.mesh(corners, faces, material=plain), name="ground")
    for name, material, x, z in [
        ("near unlit", unlit, -5, -8),
        ("near bright", bright, 4, -9),
        ("near red", red, 0, -12),
        ("far unlit", unlit, -12, -40),
        ("far bright", bright, 14, -38),
        ("far red", red, 1, -45),
    ]:
        corners, faces = box((x - 2, 0, z - 2), (x + 2, 5, z + 2))
        uvs = corners[:, [0, 1]] / 3 + corners[:, [2, 2]] / 5
        builder.instance(builder.mesh(corners, faces, material=material, uvs=uvs), name=name)
    return builder.build(dynamic)


@pytest.mark.parametrize("backend", BACKENDS)
def test_emission_is_added_and_unlit_shows_the_base_colour(backend: str) -> None:
    glow = Surface(quad((-1, 0, -2), (1, 0, 0), (0, 1, 0)), QUAD, (0.5, 0.25, 1, 1), emission=(1.5, 0.0, 0.25))
    bare = Surface(quad((1, 0, -2), (1, 0, 0), (0, 1, 0)), QUAD, (0.5, 0.25, 1, 1), unlit=True)
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(80, 2.0), size=(20, 10))
    with backend_of(backend) as chosen:
        frame = nf.render(build([glow, bare]), camera, channels=("color", "albedo", "object_id"), backend=chosen)
    color, ids = frame.require("color"), frame.require("object_id")
    light = oracle.irradiance(np.array([[0.0, 0.0, 1.0]]))[0]
    base = np.array([0.5, 0.25, 1.0])
    assert np.abs(color[ids == 0] - (base * light + (1.5, 0, 0.25))).max() <= 1e-6
    assert (color[ids == 1] == base).all()
    assert (frame.require("albedo")[ids >= 0] == base).all()
    # Frames can exceed white, 8-bit pictures clip it.
    assert color[ids == 0].max() > 1.5
    assert (frame.to_image()[ids == 0][:, 0] == 255).all()


def test_saved_frames_keep_light_beyond_white(tmp_path: Path) -> None:
    frame = nf.render(lamps(), VIEW, channels=("color",))
    frame.save(tmp_path / "a.exr")
    np.testing.assert_allclose(nf.Frame.load(tmp_path / "a.exr").require("color"), frame.require("color"), rtol=2e-3)
    assert frame.require("color").max() > 2.0


@pytest.mark.parametrize("name", ADAPTERS)
@pytest.mark.parametrize("samples", [1, 4])
def test_adapters_agree_on_emission(name: str, samples: int) -> None:
    with adapter(name):
        settings: dict[str, Any] = {"samples": samples}
        if samples == 1:
            agree(*both(lamps(), VIEW, **settings))
            return
        cpu, gpu = both(lamps(), VIEW, channels=("color",), **settings)
    # Edges and textures of a pixel that is shaded once differ; surfaces without texture do not.
    assert np.median(codes_apart(cpu, gpu)) <= 1
    assert np.abs(cpu.require("color").mean((0, 1)) - gpu.require("color").mean((0, 1))).max() < 0.02


@pytest.mark.parametrize("backend", BACKENDS)
def test_the_conventional_picture_at_the_centre_equals_the_truth(backend: str) -> None:
    """Near geometry and the map have the same light; texels are smaller than pixels."""
    with backend_of(backend) as chosen:
        reduced = nf.reduce(
            lamps(), center=CENTER, r1=15, r2=25, morph="none", face_size=512, samples=1, backend=chosen
        )
        truth = nf.render(lamps(), VIEW, channels=("color", "face_id"))
        seen = reduced.render(VIEW, channels=("color",), backend=chosen)
    assert reduced.env is not None
    assert reduced.env.color.max() > 3.0
    codes = np.abs(srgb(seen.require("color")) - srgb(truth.require("color"))).max(-1)
    near = reduced.render(VIEW, channels=("face_id",)).require("face_id") >= 0
    assert np.percentile(codes[near], 99) <= 2
    # Textures and edges in the map are filtered twice.
    assert np.percentile(codes[~near], 80) <= 6


def test_saved_maps_keep_bright_light(tmp_path: Path) -> None:
    reduced = nf.reduce(lamps(), center=CENTER, r1=15, r2=25, face_size=64)
    reduced.save(tmp_path)
    back = nf.ReducedScene.load(tmp_path)
    assert back.env is not None
    assert reduced.env is not None
    assert back.env.color.max() > 2.0
    np.testing.assert_allclose(back.env.color, reduced.env.color, rtol=2**-10)
    np.testing.assert_array_equal(
        back.render(VIEW, channels=("albedo",)).require("albedo"),
        reduced.render(VIEW, channels=("albedo",)).require("albedo"),
    )


@pytest.mark.parametrize("moving", [(), ("near bright",)])
def test_a_bundle_shows_emission_in_its_map_and_in_its_rings(tmp_path: Path, moving: tuple[str, ...]) -> None:
    scene = lamps(moving)
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None, "samples": 1}
    bundle = nf.stream.export(scene, tmp_path / "out", center=CENTER, radii=(15.0, 25.0), **settings)
    truth = nf.render(scene, VIEW, channels=("color",)).require("color")
    all_far, all_near = (bundle.at(ring).render(VIEW, channels=("color",)).require("color") for ring in (0, 2))
    for seen in (all_far, all_near):
        # Maps of bundles are limited to white.
        codes = np.abs(srgb(seen) - srgb(truth)).max(-1)
        assert np.percentile(codes, 75) <= 4
    assert all_far.max() <= 1.0 or moving
    assert all_near.max() > 2.0


def test_emission_textures_are_files_of_a_bundle(tmp_path: Path) -> None:
    """Texture sizes follow their visible detail, and materials with equal emission are merged."""
    bundle = nf.stream.export(lamps(), tmp_path / "out", center=CENTER, radii=(15.0, 25.0), face_size=64, samples=1)
    near = bundle.at(2).scene
    parts = nf._core.scene_parts(near._core)
    kinds = {
        (tuple(np.round(color, 3)), unlit)
        for color, unlit in zip(parts["material_emissions"].tolist(), parts["material_unlit"].tolist(), strict=True)
    }
    assert kinds == {((0, 0, 0), False), ((0, 0, 0), True), ((6, 2, 0.5), False), ((2.5, 0, 0.1), False)}
    assert (parts["material_emission_textures"] >= 0).sum() == 1


@pytest.mark.parametrize("backend", BACKENDS)
def test_stereo_pictures_have_the_same_light(backend: str) -> None:
    scene = lamps()
    with backend_of(backend) as chosen:
        shown = rig().render(scene, HEAD, AHEAD, channels=("color",), backend=chosen)
        for side, camera in zip(("left", "right"), rig().cameras(HEAD, AHEAD)[:2], strict=True):
            truth = nf.render(scene, camera, channels=("color",)).require("color")
            seen = getattr(shown, side).require("color")
            assert np.percentile(np.abs(srgb(seen) - srgb(truth)).max(-1), 85) <= 3
            assert seen.max() > 2.0
