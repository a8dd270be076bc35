"""Run time against error of structural similarity (peers: scikit-image, OpenCV), pixel errors and discontinuity."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import cv2
import numpy as np
from numpy.typing import NDArray
from skimage.metrics import peak_signal_noise_ratio, structural_similarity

import nearfar as nf
from benchmarks.harness.compare import OURS, Case, Work, compare, comparisons, draw, greatest_error, print_limits
from benchmarks.harness.report import start

Image = NDArray[Any]
Blur = Callable[[Image], Image]

LEVEL = "Map of SSIM, gaussian, float32 at a level of 10⁴"


def pictures(height: int, width: int, dtype: Any = np.float32) -> tuple[Image, Image, float]:
    """Clouds, the same clouds with noise, and their range of values."""
    random = np.random.default_rng(0)
    extent = 255.0 if dtype == np.uint8 else 1.0
    clouds = cv2.GaussianBlur(random.normal(size=(height, width)), (0, 0), 3.0)
    clouds = (clouds - clouds.min()) / np.ptp(clouds)
    noisy = np.clip(clouds + 0.05 * random.normal(size=clouds.shape), 0.0, 1.0)
    scaled = [(extent * picture).round() if dtype == np.uint8 else picture for picture in (clouds, noisy)]
    return scaled[0].astype(dtype), scaled[1].astype(dtype), extent


def five_blurs(a: Image, b: Image, extent: float, blur: Blur, border: int) -> tuple[float, Image]:
    """Structural similarity as it is often written with OpenCV."""
    a, b = (picture if picture.dtype.kind == "f" else picture.astype(np.float32) for picture in (a, b))
    c1, c2 = (0.01 * extent) ** 2, (0.03 * extent) ** 2
    ma, mb = blur(a), blur(b)
    va, vb, cov = blur(a * a) - ma * ma, blur(b * b) - mb * mb, blur(a * b) - ma * mb
    result = (2 * ma * mb + c1) * (2 * cov + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2))
    return float(result[border:-border, border:-border].mean()), result


def gaussian(image: Image) -> Image:
    return np.asarray(cv2.GaussianBlur(image, (11, 11), 1.5))


def box(image: Image) -> Image:
    return np.asarray(cv2.boxFilter(image, -1, (7, 7)))


def similarity(label: str, a: Image, b: Image, extent: float, *, window: str = "gaussian", repeat: int = 7) -> str:
    """Table of means by every peer; the truth is scikit-image's in float64, of the same values."""
    size, ours = (11, {}) if window == "gaussian" else (7, {"window": "uniform", "size": 7})
    theirs: dict[str, Any] = {"gaussian_weights": True} if window == "gaussian" else {"win_size": 7}
    theirs |= {"data_range": extent, "use_sample_covariance": False, "channel_axis": -1 if a.ndim == 3 else None}

    def scikit(a: Image, b: Image) -> float:
        return float(structural_similarity(a, b, **theirs))

    def opencv() -> float:
        return five_blurs(a, b, extent, gaussian if window == "gaussian" else box, size // 2)[0]

    error = greatest_error(scikit(a.astype(np.float64), b.astype(np.float64)))
    # Five moments, along rows and columns: the separable form that every implementation here uses.
    work = Work(multiply_adds=5 * 2 * size * a.size, bytes=2 * a.nbytes, double=a.dtype == np.float64)
    cases = [
        Case(OURS, lambda: nf.ssim(a, b, data_range=extent, **ours), error),  # type: ignore[arg-type]
        Case("OpenCV, five blurs", opencv, error),
        Case("scikit-image", lambda: scikit(a, b), error),
    ]
    return compare(f"SSIM, {window}, {label}", cases, work=work, repeat=repeat)


def scikit_map(a: Image, b: Image) -> Image:
    options: dict[str, Any] = {"gaussian_weights": True, "use_sample_covariance": False, "full": True}
    return np.asarray(structural_similarity(a, b, data_range=1, **options)[1])


def maps_at_a_level() -> str:
    """Table of maps of float32 pictures whose mean is 10⁴ times their contrast; the truth is float64 without it."""
    a, b = (picture + np.float32(1e4) for picture in pictures(1080, 1920)[:2])
    doubles = a.astype(np.float64), b.astype(np.float64)
    error = greatest_error(nf.ssim(*doubles, data_range=1, full=True).map, np.s_[5:-5, 5:-5])
    cases = [
        Case(OURS, lambda: nf.ssim(a, b, data_range=1, full=True).map, error),
        Case("OpenCV, five blurs", lambda: five_blurs(a, b, 1.0, gaussian, 5)[1], error),
        Case("scikit-image", partial(scikit_map, a, b), error),
        Case("scikit-image, float64", lambda: scikit_map(a.astype(np.float64), b.astype(np.float64)), error),
    ]
    return compare(LEVEL, cases, repeat=4)


def pairs() -> str:
    """Table for 144 views of ten levels, each in the silhouette of a box."""
    random = np.random.default_rng(0)
    views = np.float32(0.9) * random.random((144, 1, 96, 96), dtype=np.float32)
    levels = views + np.float32(0.1) * random.random((144, 10, 96, 96), dtype=np.float32)
    y, x = np.mgrid[:96, :96]
    disc = np.broadcast_to(np.hypot(y - 48, x - 48) < 36, (144, 1, 96, 96))

    def scikit() -> Image:
        result = np.empty((144, 10))
        for i, j in np.ndindex(144, 10):
            result[i, j] = scikit_map(views[i, 0], levels[i, j])[disc[i, 0]].mean()
        return result

    exact = nf.metrics.ssim_pairs(views.astype(np.float64), levels.astype(np.float64), data_range=1, masks=disc)
    error = greatest_error(exact)
    ours = partial(nf.metrics.ssim_pairs, views, levels, data_range=1, masks=disc)
    cases = [
        Case(OURS, ours, error),
        Case("scikit-image, one by one", scikit, error),
        Case(f"{OURS}, windows that see only the mask", partial(ours, masking="windows")),
    ]
    return compare("SSIM of 1,440 pairs of 96² in a silhouette", cases, repeat=4)


def errors(dtype: Any) -> str:
    a, b, extent = pictures(1080, 1920, dtype)
    double = [picture.astype(np.longdouble) for picture in (a, b)]
    exact = float(10 * np.log10(extent**2 / np.mean((double[0] - double[1]) ** 2)))

    def numpy() -> float:
        return float(10 * np.log10(extent**2 / np.mean((a.astype(np.float64) - b.astype(np.float64)) ** 2)))

    error = greatest_error(exact)
    cases = [
        Case(OURS, lambda: nf.psnr(a, b, data_range=extent), error),
        Case("OpenCV", lambda: cv2.PSNR(a, b, R=extent), error),
        Case("NumPy, float64", numpy, error),
        Case("scikit-image", lambda: float(peak_signal_noise_ratio(a, b, data_range=extent)), error),
    ]
    return compare(f"PSNR, 1080p, {np.dtype(dtype)}", cases, work=Work(bytes=2 * a.nbytes), repeat=30, unit="dB")


def scales_and_sequences() -> str:
    a, b, _ = pictures(1080, 1920)
    mask = np.zeros(a.shape, bool)
    mask[300:700, 500:1200] = True
    ssim = partial(nf.ssim, a, b, data_range=1)
    cases = [
        Case("ssim", ssim),
        Case("ssim, global window", partial(ssim, window="global")),
        Case("ssim, mask of 14 %", partial(ssim, mask=mask)),
        Case("the same, windows see only the mask", partial(ssim, mask=mask, masking="windows")),
        Case("ssim, wang-downsampled", partial(ssim, convention="wang-downsampled")),
        Case("ms_ssim", partial(nf.metrics.ms_ssim, a, b, data_range=1)),
    ]
    return compare("Other similarities, 1080p, float32", cases)


def frames() -> str:
    """Table of discontinuity and object completion of frames of the procedural city, of a headset eye's size."""
    center = np.array((0.0, 1.7, 0.0))
    scene = nf.datasets.city()
    reduced = nf.reduce(scene, center=center, r1=30, r2=50, face_size=512, channels=("color", "range"))
    view = nf.Camera.look_at((0, 1.9, 7), (10, 1.4, 7), fov=nf.Fov.symmetric(90, 16 / 9), size=(1920, 1080))
    torn = reduced.render(view, channels=("position",))
    ids = [nf.render(scene, camera, channels=("object_id",)).require("object_id") for camera in (view, view)]
    ids[1] = np.roll(ids[1], 5, axis=1)

    def unique() -> tuple[float, float]:
        expected, result = (dict(zip(*np.unique(i[i >= 0], return_counts=True), strict=True)) for i in ids)
        shares = [min(result.get(number, 0), pixels) / pixels for number, pixels in expected.items()]
        return float(np.mean([share > 0 for share in shares])), float(np.mean(shares))

    error = greatest_error(unique())
    # Each pair of neighbours within 17 pixels is processed once, hence half; about 25 multiply-adds per pair.
    pairs = 1920 * 1080 * np.pi * 17**2 / 2
    work, cases = Work(multiply_adds=25 * pairs), [Case(OURS, lambda: nf.metrics.discontinuity(torn))]
    breaks = compare("Discontinuity, 1080p, ε = 17 px", cases, work=work, repeat=3)
    cases = [
        Case(OURS, lambda: nf.metrics.object_completion(ids[0], ids[1]), error),
        Case("NumPy's unique", unique, error),
        Case("reading the numbers (NumPy's max)", lambda: [i.max() for i in ids]),
    ]
    work = Work(bytes=sum(i.nbytes for i in ids))
    return f"{breaks}\n{compare('Object completion, 1080p', cases, work=work, repeat=20)}"


def main() -> None:
    start(__doc__)
    print_limits()
    for dtype in (np.float32, np.float64, np.uint8):
        print(similarity(f"1080p, {np.dtype(dtype)}", *pictures(1080, 1920, dtype)), flush=True)
    print(similarity("4K, float32", *pictures(2160, 3840), repeat=4), flush=True)
    a, b, extent = pictures(1080, 1920, np.uint8)
    colors = np.stack([a, b, a], -1), np.stack([b, a, a], -1)
    print(similarity("1080p, RGB, uint8", *colors, extent, repeat=4), flush=True)
    print(similarity("1080p, float32", *pictures(1080, 1920), window="uniform"), flush=True)
    for text in (maps_at_a_level(), pairs(), scales_and_sequences(), errors(np.uint8), errors(np.float32)):
        print(text, flush=True)
    print(frames())
    draw([comparisons[title] for title in ["SSIM, gaussian, 1080p, float32", LEVEL]], "ssim error and time")


if __name__ == "__main__":
    main()
