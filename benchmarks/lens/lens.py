"""Run time against error of lenses: inverses, warped pictures and sizes seen through them, compared with peers."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, Work, compare, greatest_error, print_limits
from benchmarks.harness.report import save_figure, start, subplots

Array = NDArray[np.float64]

RIFT_S = nf.RadialLens((0.22, 0.24))
"""Lens of the Rift S, from Liebisch (2021)."""

COUNT = 1_000_000


def inverse(title: str, max_radius: float) -> str:
    """Table for radii spread evenly up to `max_radius`; the error is the difference after the way back."""
    radii = np.random.default_rng(0).random(COUNT) * max_radius
    distorted = RIFT_S.distort(radii)
    points = np.zeros((COUNT, 1, 2))
    points[:, 0, 0] = distorted
    k1, k2 = RIFT_S.k
    coefficients = np.array([k1, k2, 0.0, 0.0])

    def opencv() -> Array:
        return np.asarray(cv2.undistortPoints(points, np.eye(3), coefficients), np.float64)[:, 0, 0]

    def newton() -> Array:
        square = distorted * distorted
        r = distorted / np.cbrt(1 + k1 * square + k2 * square * square)
        for _ in range(4):
            square = r * r
            slope = 1 + square * (3 * k1 + 5 * k2 * square)
            r = r - (r * (1 + square * (k1 + k2 * square)) - distorted) / slope
        return np.asarray(r)

    nodes = np.linspace(0, max_radius, 4096)
    images = RIFT_S.distort(nodes)
    error, undistort = greatest_error(radii), functools.partial(RIFT_S.undistort, distorted)
    cases = [
        Case(f"{OURS}, newton", undistort, error),
        Case(f"{OURS}, lut", functools.partial(undistort, method="lut"), error),
        Case(f"{OURS}, fixed_point, 5 steps", functools.partial(undistort, method="fixed_point"), error),
        Case(f"{OURS}, newton, points", lambda: RIFT_S.undistort_points(points[:, 0])[:, 0], error),
        Case("OpenCV, undistortPoints", opencv, error),
        Case("NumPy, 4 steps of Newton", newton, error),
        Case("NumPy, interp over 4,096", lambda: np.interp(distorted, images, nodes), error),
    ]
    return compare(title, cases, work=Work(bytes=distorted.nbytes * 2))


def warps() -> str:
    """Table for a colour picture of an eye, warped for the lens; errors in 8-bit codes against cubics in float64."""
    width, height = 1832, 1920
    x, y = np.meshgrid(np.linspace(0, 40, width), np.linspace(0, 42, height))
    waves = [np.sin(x + 0.3 * y), np.cos(y - 0.2 * x), np.sin(0.7 * x * y / 40)]
    exact = 127.5 + 100 * np.stack(waves, axis=-1)
    image = exact.astype(np.uint8)
    fov = nf.Fov(-1.0, 1.0, -height / width, height / width)
    tangents = (np.stack(np.meshgrid(np.arange(width), np.arange(height)), axis=-1) + 0.5) / width * 2 - 1
    tangents[..., 1] -= height / width - 1
    exact_warp = RIFT_S.warp(exact, True, fov=fov, filter="cubic")

    def error(result: NDArray[np.uint8]) -> float:
        # Filters treat the picture's edge differently.
        is_inside = np.hypot(tangents[..., 0], tangents[..., 1]) < 0.7
        return float(np.sqrt(np.mean((result[is_inside].astype(np.float64) - exact_warp[is_inside]) ** 2)))

    def maps() -> list[NDArray[np.float32]]:
        r = np.hypot(tangents[..., 0], tangents[..., 1])
        scale = RIFT_S.distort(r) / r
        pixels = ((tangents * scale[..., None] + (1, height / width)) * width / 2 - 0.5).astype(np.float32)
        return [np.ascontiguousarray(pixels[..., 0]), np.ascontiguousarray(pixels[..., 1])]

    def opencv(code: int, prepared: list[NDArray[np.float32]] | None) -> NDArray[np.uint8]:
        columns, rows = prepared or maps()
        return np.asarray(cv2.remap(image, columns, rows, code), np.uint8)

    prepared = maps()
    cases = []
    codes: dict[Any, int] = {"linear": cv2.INTER_LINEAR, "cubic": cv2.INTER_CUBIC}
    for name, code in codes.items():
        warp = functools.partial(RIFT_S.warp, image, True, fov=fov, filter=name)
        cases += [Case(f"{OURS}, {name}", warp, error)]
        cases += [Case(f"OpenCV, {name}, maps at hand", functools.partial(opencv, code, prepared), error)]
        cases += [Case(f"OpenCV, {name}, maps by NumPy", functools.partial(opencv, code, None), error)]
    return compare("A picture of 1832 × 1920 warped", cases, repeat=3, unit="levels, rms")


def sizes() -> str:
    """Table for spheres in front of a headset; errors are relative to the published size computed by NumPy."""
    random = np.random.default_rng(0)
    centers = random.normal(size=(COUNT // 10, 3)) * 20 - (0, 0, 40)
    radii = random.random(len(centers)) + 0.1
    view = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(92), size=(1648, 1776))
    scale = view.fov.right if isinstance(view.fov, nf.Fov) else 1.0
    is_ahead = -centers[:, 2] > 2 * np.linalg.norm(centers, axis=1) * 0.3

    def numpy() -> Array:
        distance = np.linalg.norm(centers, axis=1)
        mu = np.arcsin(radii / distance)
        alpha = np.arccos(-centers[:, 2] / distance)
        sigma = 4 * np.pi * np.sin(mu / 2) ** 2
        angles = [np.arctan(scale * RIFT_S.undistort(np.tan(angle) / scale)) for angle in (alpha + mu, alpha - mu)]
        return np.asarray(np.where(alpha + mu < np.pi / 2, sigma * (angles[0] - angles[1]) / (2 * mu), sigma))

    expected = numpy()

    def error(result: Array) -> float:
        return float(np.abs(result / expected - 1)[is_ahead].max())

    solid_angle = functools.partial(nf.corrected_solid_angle, centers, radii, camera=view, lens=RIFT_S)
    cases = [
        Case(f"{OURS}, as published", solid_angle, error),
        Case("NumPy, as published (with our inverse)", numpy),
        Case(f"{OURS}, exact area", functools.partial(solid_angle, exact=True)),
        Case(f"{OURS}, no lens", lambda: nf.solid_angle(centers, radii, eye=(0, 0, 0))),
    ]
    return compare("Solid angles of 10⁵ spheres through a lens", cases)


def draw_lens(lens: nf.RadialLens, frame: nf.Frame, path: Path) -> None:
    """Draw errors of inverses, sizes seen through the lens, and a picture corrected with its mesh."""
    figure, axes = subplots(1, 3, figsize=(15, 4.6), width_ratios=(1.2, 1, 1))
    _draw_inverses(lens, axes[0])
    _draw_sizes(lens, axes[1])
    picture, fov = frame.to_image(), frame.camera.fov
    assert isinstance(fov, nf.Fov)
    height, width = picture.shape[:2]
    mesh = lens.warp_mesh(frame, tolerance_px=0.5)
    axes[2].imshow(lens.warp(picture, True, fov=fov), extent=(-1, 1, -1, 1), aspect=height / width)
    axes[2].triplot(*mesh.positions.T, mesh.faces, color="white", linewidth=0.35, alpha=0.7)
    cells = len(mesh.faces) // 2
    axes[2].set(xticks=[], yticks=[], title=f"warped for it; a mesh of {cells} cells: {mesh.error_px:.2f} px")
    save_figure(figure, path, dpi=90)


def _draw_inverses(lens: nf.RadialLens, axis: Any) -> None:
    """Draw the residual between a radius and the image of its root."""
    r = np.linspace(0.01, 1.6, 800)
    images = lens.distort(r)
    inverses: tuple[tuple[str, Any, int, str], ...] = (
        ("published iteration, 5 steps (OpenCV's default)", "fixed_point", 5, "#999999"),
        ("published iteration, 50 steps", "fixed_point", 50, "#555555"),
        ("look-up table", "lut", 0, "#e08a1e"),
        ("Newton (0)", "newton", 0, "#c8102e"),
    )
    for label, method, steps, color in inverses:
        residual = np.abs(lens.distort(lens.undistort(images, method=method, iterations=steps)) - images)
        axis.semilogy(r, np.maximum(residual, 1e-17), label=label, color=color)
    axis.axvline(1.0, linestyle=":", color="black")
    axis.set(xlabel="r (the screen's edge is 1)", ylabel="residual |f(r̂) − f(r)|", title="inverses of a strong lens")
    axis.set_ylim(5e-18, 1e6)
    axis.legend(fontsize=8, loc="upper left")
    axis.grid(alpha=0.3)


def _draw_sizes(lens: nf.RadialLens, axis: Any) -> None:
    """Draw sizes of small spheres seen through the lens."""
    camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(87), size=(1000, 1000))
    angles = np.radians(np.linspace(0, 50, 200))
    centers = np.column_stack([np.sin(angles), np.zeros_like(angles), -np.cos(angles)]) * 10
    plain = nf.solid_angle(centers, 0.05, eye=camera.position)
    for exact, label, color in (
        (False, "as published: along the radius only", "#555555"),
        (True, "its area", "#c8102e"),
    ):
        corrected = nf.corrected_solid_angle(centers, 0.05, camera=camera, lens=lens, exact=exact)
        axis.plot(np.degrees(angles), corrected / plain, label=label, color=color)
    axis.set(xlabel="degrees from the axis", ylabel="solid angle seen / solid angle", title="sizes through the lens")
    axis.legend(fontsize=8)
    axis.grid(alpha=0.3)


def main() -> None:
    options = start(__doc__, "--plots")
    print_limits()
    print(inverse("Lens inverse, 10⁶ radii up to the screen's edge", 1.0), flush=True)
    print(inverse("Lens inverse, 10⁶ radii up to twice the edge", 2.0), flush=True)
    print(warps(), flush=True)
    print(sizes())
    if options.plots is not None:
        eye, _ = nf.datasets.street_view()
        view = nf.Camera.look_at(
            eye, (eye[0], eye[1] + 4, eye[2] - 40), fov=nf.Fov.symmetric(90, 1832 / 1920), size=(458, 480)
        )
        draw_lens(RIFT_S, nf.render(nf.datasets.city(), view, samples=4), options.plots / "lens.png")


if __name__ == "__main__":
    main()
