"""The experiment on materials: its shading against pyrender, its scores, and the factor fitted to them."""

from __future__ import annotations

import warnings
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
import trimesh
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.lod import _appearance, _correction, _material, appearance
from benchmarks.lod._appearance import QUICK
from benchmarks.lod._material import AMBIENT, BASE, FINER, LIGHTS, NEUTRAL, Material, Shape
from tests.support import need
from tests.support.render_oracle import rotate

Array = NDArray[np.float64]
FINISHES = [Material(metallic, roughness) for metallic in (0.0, 0.5, 1.0) for roughness in (0.25, 0.5, 1.0)]


def camera() -> nf.Camera:
    return list(_appearance.cameras(1 / 16, 6))[8]


def ball(detail: int) -> Shape:
    mesh = trimesh.creation.icosphere(subdivisions=detail)
    return Shape(np.asarray(mesh.vertices, np.float32), np.asarray(mesh.faces, np.int64))


# shading --------------------------------------------------------------------------------------------------------------
def by_pyrender(shape: Shape, view: nf.Camera, materials: list[Material]) -> list[Array]:
    """Return linear colour (H, W) of each material."""
    with warnings.catch_warnings(), pytest.MonkeyPatch.context() as patch:
        warnings.simplefilter("ignore")
        patch.setattr(np, "infty", np.inf, raising=False)  # pyrender 0.1.45 was written for NumPy 1.
        import pyrender

        turned = rotate(view.orientation, np.eye(3)).T
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = turned, view.position
        assert isinstance(view.fov, nf.Fov)
        scene = pyrender.Scene(bg_color=(0.0, 0.0, 0.0, 0.0), ambient_light=(AMBIENT,) * 3)
        scene.add(pyrender.PerspectiveCamera(2 * np.arctan(view.fov.up), znear=0.5, zfar=60.0), pose=pose)
        for direction, bright in LIGHTS:
            towards = turned @ (np.asarray(direction) / np.linalg.norm(direction))
            side = np.cross(towards, (0.3, 0.5, -0.8))
            side /= np.linalg.norm(side)
            lamp = np.eye(4)
            lamp[:3, :3] = np.stack([side, np.cross(towards, side), towards], axis=1)
            scene.add(pyrender.DirectionalLight(color=np.ones(3), intensity=bright), pose=lamp)
        paint = pyrender.MetallicRoughnessMaterial(baseColorFactor=(BASE, BASE, BASE, 1.0))
        parts = {"positions": shape.vertices, "normals": shape.normals, "indices": shape.faces}
        scene.add(pyrender.Mesh([pyrender.Primitive(**parts, material=paint)]))
        renderer = pyrender.OffscreenRenderer(*view.size)
        pictures = []
        try:
            for material in materials:
                paint.metallicFactor, paint.roughnessFactor = material.metallic, material.roughness
                color, _ = renderer.render(scene, pyrender.RenderFlags.SKIP_CULL_FACES)
                pictures.append((color[:, :, 1] / 255.0) ** 2.2)
        finally:
            renderer.delete()
    return pictures


@pytest.mark.slow
def test_shading_equals_pyrender() -> None:
    need("pyrender")
    shape, view = _appearance.knot(), camera()
    surface = _material.look(shape, view)
    light = _material._light(surface, {one.roughness for one in FINISHES})
    # Multisampling shades edge pixels at other positions.
    inside = surface.hit.copy()
    for shift in ((0, 1), (0, -1), (1, 0), (-1, 0)):
        inside &= np.roll(surface.hit, shift, (0, 1))
    for material, theirs in zip(FINISHES, by_pyrender(shape, view, FINISHES), strict=True):
        linear = _material.colors(light[material.roughness], np.float32(BASE), material.metallic)
        ours = np.zeros(surface.hit.shape)
        ours[surface.hit] = np.minimum(linear, 1.0)
        codes = 255 * np.abs(ours[inside] ** (1 / 2.2) - theirs[inside] ** (1 / 2.2))
        assert inside.sum() > 5_000
        assert np.ptp(theirs[inside]) > 0.05, material
        # Values round to a code. At the border of a highlight or of a part of the knot, sample positions matter.
        assert np.median(codes) < 0.51, material
        assert np.percentile(codes, 97) < 1.5, material


def test_normals_and_positions_of_a_ball_are_its_points() -> None:
    surface = _material.look(ball(5), camera())
    outward = surface.position / np.linalg.norm(surface.position, axis=1, keepdims=True)
    # A triangle is 0.03 wide: between its vertices normals bend by a tenth of that at most.
    np.testing.assert_allclose(surface.normal, outward, atol=3.5e-3)
    np.testing.assert_allclose(surface.mapped, surface.position, atol=1e-5)
    towards = camera().position - surface.position
    np.testing.assert_allclose(surface.view, towards / np.linalg.norm(towards, axis=1, keepdims=True), atol=1e-5)


def test_patterns_equal_their_formula() -> None:
    """A pattern multiplies reflectance, and shows equally on materials without mirror reflection."""
    surface = _material.look(ball(3), camera())
    (light,) = _material._light(surface, [1.0]).values()
    waves = _material._pattern(surface.position, 4.0)
    directions = _material._WAVES.astype(np.float64)
    np.testing.assert_allclose(directions @ directions.T, np.eye(3), atol=1e-6)
    at = surface.position.astype(np.float64) @ directions.T
    np.testing.assert_allclose(waves, np.sin(4 * np.pi * at).mean(axis=1), atol=1e-5)
    assert -1 <= waves.min() < -0.8 < 0.8 < waves.max() <= 1
    plain, patterned = (_material.colors(light, base, 0.0) for base in (np.float32(BASE), BASE * (1 + waves)))
    mirrored = _material.colors(light, np.float32(0), 0.0)
    np.testing.assert_allclose(patterned - mirrored, (1 + waves) * (plain - mirrored), atol=1e-5)


def test_only_mapped_patterns_slide_over_coarse_triangles() -> None:
    off = {}
    for detail in (5, 1):
        egg = replace(ball(detail), vertices=ball(detail).vertices * np.array([1, 0.5, 0.3], np.float32))
        surface = _material.look(egg, camera())
        length = np.linalg.norm(surface.position, axis=1, keepdims=True)
        off[detail] = np.abs(surface.mapped - surface.position / length).max()
        materials = [Material(frequency=8.0, contrast=1.0, mapped=mapped) for mapped in (False, True)]
        solid, mapped = _material.shade(surface, materials)
        assert np.abs(solid.astype(int) - mapped).max() > 100
    assert off[5] < 0.01
    assert off[1] > 0.1
    # On the unit ball both patterns are equal, regardless of its triangles.
    solid, mapped = _material.shade(_material.look(ball(1), camera()), materials)
    assert np.abs(solid.astype(int) - mapped).max() <= 1


def test_codes_equal_srgb() -> None:
    linear = np.linspace(0, 1, 1001)
    exact = np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)
    codes = _material._CODES[np.round(linear * 65535).astype(int)]
    assert np.abs(codes - 255 * exact).max() < 0.51


# objects and scores ---------------------------------------------------------------------------------------------------
@pytest.mark.parametrize("name", _appearance.PROCEDURAL)
def test_objects_are_closed_face_outwards_and_fill_the_unit_sphere(name: str) -> None:
    shape = _appearance.PROCEDURAL[name]()
    mesh = trimesh.Trimesh(shape.vertices, shape.faces, process=False)
    assert mesh.is_watertight
    assert mesh.volume > 0.1
    assert np.linalg.norm(shape.vertices, axis=1).max() == pytest.approx(1, abs=1e-5)


def test_views_are_rotations_about_four_axes_at_the_requested_size() -> None:
    every = list(_appearance.cameras(0.25, 6))
    assert len(every) == 24
    places = np.array([view.position for view in every])
    sigma = nf.solid_angle(np.zeros((1, 3)), 1.0, eye=places[0])[0]
    assert sigma == pytest.approx(0.25 * 2 * np.pi * (1 - np.cos(np.arcsin(nf.hmd.RIFT_S.tan_half_angle / 4))))
    for turn, axis in zip(places.reshape(4, 6, 3), (*np.eye(3), np.full(3, 3**-0.5)), strict=True):
        np.testing.assert_allclose(turn @ axis, 0, atol=1e-9)
        assert len(np.unique(np.round(turn, 6), axis=0)) == 6
    surface = _material.look(ball(4), every[5])
    edge = np.concatenate([surface.hit[0], surface.hit[-1], surface.hit[:, 0], surface.hit[:, -1]])
    assert not edge.any()
    # At one headset's pixel density: the silhouette has its width there.
    headset = nf.hmd.RIFT_S
    focal = headset.render_size[0] / (headset.left.fov.right - headset.left.fov.left)
    sine = 1 / np.linalg.norm(places[5])
    assert surface.hit.any(axis=0).sum() / FINER == pytest.approx(2 * focal * sine / np.sqrt(1 - sine**2), abs=1.5)


@pytest.fixture(scope="module")
def quick() -> dict[str, Array]:
    return appearance.run(replace(QUICK, steps=1), appearance.objects(quick=True))


def test_scores_fall_only_with_fewer_triangles(quick: dict[str, Array]) -> None:
    for found in quick.values():
        assert found.shape == (len(QUICK.ratios), len(QUICK.sizes), len(QUICK.materials))
        assert (found[0] > found[1]).all()
        assert (found < 1).all()
    same = _appearance._view([ball(3), ball(3)], camera(), QUICK.materials)
    assert (same == 1).all()


def test_gloss_and_sliding_patterns_lower_scores(quick: dict[str, Array]) -> None:
    far = 1 - np.array(list(quick.values()))
    column = {material: far[..., n] for n, material in enumerate(QUICK.materials)}
    assert column[Material(0.0, 0.25)].mean() > column[NEUTRAL].mean()
    assert column[Material(1.0, 0.5)].mean() > column[Material(0.5, 0.5)].mean() > column[Material(0.0, 0.5)].mean()
    solid, mapped = (Material(frequency=8.0, contrast=1.0, mapped=mapped) for mapped in (False, True))
    assert (column[solid].mean(axis=(1, 2)) < column[NEUTRAL].mean(axis=(1, 2))).all()
    # Seen from the middle, the surfaces of the other objects are nearly balls, on which both patterns are equal.
    knot = [*quick].index("knot")
    # Losses grow by 1.3 at least, where a level of a fifth of the triangles is nearly the knot, and by 2 in sum.
    assert (column[mapped][knot] > 1.2 * column[NEUTRAL][knot]).all()
    assert column[mapped][knot].sum() > 1.8 * column[NEUTRAL][knot].sum()


# the factor -----------------------------------------------------------------------------------------------------------
def planted(coefficients: Array, own: float = 0.0, objects: int = 6) -> dict[str, Array]:
    """Return scores with known factors, times exp(`own` × pseudo-random numbers) for each object and material."""
    materials = _appearance.Plan().materials
    logs = _correction.features(materials) @ coefficients
    far = np.array([0.02, 0.05, 0.1, 0.15])[:, None, None] * np.array([1.0, 0.7])[:, None]
    scores = {}
    for number in range(objects):
        other = own * np.sin(7.7 * number + 3.1 * np.arange(len(materials)) ** 1.5)
        other[materials.index(NEUTRAL)] = 0
        scores[f"object_{number}"] = 1 - far * np.exp(logs + other)
    return scores


KNOWN = np.array([0.2, 0.6, 0.3, -0.2, -0.4, -0.1, 0.5, 0.15])


def test_a_planted_factor_is_recovered() -> None:
    samples = _correction.collect(planted(KNOWN), _appearance.Plan().materials)
    np.testing.assert_allclose(_correction.fit(samples), KNOWN, atol=1e-9)
    _, low, high = _correction.intervals(samples)
    np.testing.assert_allclose(high - low, 0, atol=1e-9)
    assert all(samples.is_kind(kind).any() for kind in _correction.KINDS)
    for name in ("coefficients", "a number for each material"):
        found = _correction.validity(samples, _correction.cross_validate(samples, name))
        assert (found.log, found.ssim, found.explained) == pytest.approx((0, 0, 1), abs=1e-9)
    none = _correction.validity(samples, _correction.cross_validate(samples, "no correction"))
    assert none.explained == 0
    assert none.log == pytest.approx(np.sqrt((samples.logarithm**2).mean()))
    assert appearance.verdict(samples).count(": yes") == len(_correction.KINDS)


def test_intervals_cover_a_planted_factor_of_varied_objects() -> None:
    samples = _correction.collect(planted(KNOWN, own=0.2, objects=9), _appearance.Plan().materials)
    value, low, high = _correction.intervals(samples)
    assert ((low < KNOWN) & (high > KNOWN)).sum() >= len(KNOWN) - 1
    assert (low < value).all()
    found = _correction.validity(samples, _correction.cross_validate(samples, "coefficients"))
    assert 0.1 < found.log < 0.25


def test_unrelated_objects_are_reported_as_such() -> None:
    samples = _correction.collect(planted(np.zeros(len(KNOWN)), own=0.5), _appearance.Plan().materials)
    found = _correction.validity(samples, _correction.cross_validate(samples, "coefficients"))
    assert found.explained < 0.1
    assert appearance.verdict(samples).count(": no.") >= 3


def test_the_neutral_material_has_the_factor_one(quick: dict[str, Array]) -> None:
    samples = _correction.collect(quick, QUICK.materials)
    assert _correction.factor(_correction.fit(samples), NEUTRAL) == 1.0
    assert NEUTRAL not in {samples.materials[n] for n in np.unique(samples.material)}
    with pytest.raises(ValueError, match="neutral"):
        _correction.collect({"same": np.ones((1, 1, len(QUICK.materials)))}, QUICK.materials)


def test_everything_is_printed(
    quick: dict[str, Array], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("sys.argv", ["lod_appearance.py", "--quick"])

    def fail_after_quick(plan: object, shapes: Any) -> dict[str, Array]:
        assert plan is QUICK
        assert [*shapes] == [*quick]
        return quick

    monkeypatch.setattr(appearance, "run", fail_after_quick)
    appearance.main()
    printed = capsys.readouterr().out
    assert printed.count("### ") == 3
    assert "nan" not in printed
    assert printed.count(": yes") + printed.count(": no.") == len(_correction.KINDS)
