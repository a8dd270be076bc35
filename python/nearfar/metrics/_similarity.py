"""Structural similarity of two pictures, of many pairs at once, on several scales, and along a sequence."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from nearfar import _core
from nearfar._base import check, progress
from nearfar._base.settings import gather
from nearfar._render.frame import Frame
from nearfar.metrics import _inputs as inputs
from nearfar.metrics._inputs import Pair
from nearfar.metrics._window import Similarity, SsimKeywords, SsimSettings

NAMES = ("references", "tests")
"""Argument names of `ssim_pairs` for error messages."""
SCALE_WEIGHTS = (0.0448, 0.2856, 0.3001, 0.2363, 0.1333)
"""Exponents of the scales, fine to coarse, of Wang, Simoncelli, Bovik (2003), for images of some hundred pixels."""
_MANY_PIXELS = 1 << 26
"""Least number of pixels for which a progress bar is shown and Ctrl-C is checked."""


def ssim(
    reference: ArrayLike | Frame,
    test: ArrayLike | Frame,
    *,
    data_range: float | None = None,
    mask: ArrayLike | None = None,
    channel_axis: int | None = None,
    full: bool = False,
    settings: SsimSettings | None = None,
    **keywords: Unpack[SsimKeywords],
) -> Similarity:
    """Compute the structural similarity (SSIM) of two pictures.

    Errors as in `psnr`, and for windows, sizes and masks out of range, windows larger than the pictures, and, without
    `channel_axis`, three axes whose last is neither 1 nor 3 long. In masked pictures only pixels within windows must be
    within `data_range`. Sources: Wang, Bovik, Sheikh, Simoncelli (2004), Eq. 13; masked windows: Knutsson, Westin
    (1993).

    Parameters
    ----------
    reference, test
        (H, W), (H, W, 1) or (H, W, 3) of one shape, or with `channel_axis` three axes of any lengths; channels are
        compared one by one and averaged. uint8, uint16, float32 and float64 are read without a copy. Or two frames or
        Pillow images, as in `rmse`.
    data_range
        As in `psnr`.
    mask
        (H, W), true for the pixels that count; None counts all.
    channel_axis
        Axis of the channels, however many there are, -3 to 2; by default the last one if its length is 1 or 3.
    full
        Whether to return the similarity around each pixel as well.
    settings
        Windows, constants and conventions, as `SsimSettings`.
    keywords
        Fields of `settings`, which they replace: `window`, `size`, `sigma`, `k1`, `k2`, `masking`, `convention`.

    Returns
    -------
    Similarity
        The mean, a float of at most 1; exactly 1 for equal pictures, and the same for exchanged arguments. With `full`
        its `map`, in the picture's shape (smaller if downsampled), float64 for float64 and float32 for other types; for
        the map, pictures are mirrored at their borders. The map is NaN where a window contains no pixel of the mask. In
        float64, mean and map differ from scikit-image's by less than 1e-12 and 1e-10. Other types are computed in
        float32 about local means and differ from float64's results by less than 1e-6 and 1e-5. Parts of pictures whose
        range of values would lose digits are computed in float64, or window by window.
    """
    settings = gather(SsimSettings, settings, keywords)
    settings._require_mask(mask)
    full = check.flag("full", full)
    pair = inputs.pair(reference, test, data_range)
    axis = inputs.channel_axis(pair, channel_axis)
    channels = pair.channels_first(axis)
    masks = None if mask is None else _masks(mask, channels.reference.shape, settings)
    sums, ranges, maps = _compare(channels, settings, masks, full=full)
    if not np.isfinite(sums).all():
        raise pair.non_finite_error()
    if not sums[..., 1].all():
        raise ValueError("mask: expected at least one pixel whose window lies within the picture, got none")
    one_mask = None if masks is None else masks.reshape(-1, *masks.shape[-2:])[0]
    _check_values(channels, settings, np.array([ranges[..., 0].min(), ranges[..., 1].max()]), one_mask)
    mean = float((sums[..., 0] / sums[..., 1]).mean())
    return Similarity(mean, maps if maps is None or axis is None else np.moveaxis(maps, 0, axis))


def ssim_pairs(
    references: ArrayLike,
    tests: ArrayLike,
    *,
    data_range: float,
    masks: ArrayLike | None = None,
    settings: SsimSettings | None = None,
    **keywords: Unpack[SsimKeywords],
) -> NDArray[np.float64]:
    """Compute the structural similarity of many pairs of small pictures at once.

    Returns (...) float64, equal to `ssim` of each pair; NaN if no pixel of a mask counts. Errors as in `ssim`, and for
    axes that do not broadcast.

    Parameters
    ----------
    references, tests
        (..., H, W), one channel each. The axes before the last two are broadcast as in NumPy, without copies: one
        reference (H, W) with many tests (N, H, W), or views (V, 1, H, W) with their levels (V, L, H, W). With three or
        more axes W may not be 3 or 4, which is taken for colours in the last axis.
    data_range, settings, keywords
        As in `ssim`.
    masks
        (..., H, W), broadcast as well, such as the silhouette of each view (V, 1, H, W). Only the surroundings of the
        mask's pixels are computed.
    """
    settings = gather(SsimSettings, settings, keywords)
    settings._require_mask(masks)
    first, second = inputs.stack(references, tests, NAMES)
    for name, array in zip(NAMES, (first, second), strict=True):
        if array.ndim < 2 or 0 in array.shape[-2:]:
            raise ValueError(f"{name}: expected shape (..., H, W) with at least one pixel, got {array.shape}")
        if array.ndim > 2 and array.shape[-1] in (3, 4):
            raise ValueError(
                f"{name}: expected shape (..., H, W), one channel each, got {array.shape}, whose last axis seems to be "
                f"that of colours; move it forward by np.moveaxis({name}, -1, -3), and leave alpha out"
            )
    if first.shape[-2:] != second.shape[-2:]:
        raise ValueError(f"tests: expected pictures of {first.shape[-2:]} pixels, got {second.shape[-2:]}")
    factor = settings._shrink(*first.shape[-2:])
    arrays = [first, second]
    if masks is not None:
        mask = inputs.mask_of(masks, "masks")
        if mask.shape[-2:] != first.shape[-2:]:
            raise ValueError(f"masks: expected pictures of {first.shape[-2:]} pixels, got shape {mask.shape}")
        arrays.append(mask[..., ::factor, ::factor])
    try:
        outer = np.broadcast_shapes(*(array.shape[:-2] for array in arrays))
    except ValueError:
        shapes = ", ".join(str(array.shape[:-2]) for array in arrays)
        raise ValueError(f"tests, masks: expected axes that broadcast with the references', got {shapes}") from None
    spread = [np.broadcast_to(array, outer + array.shape[-2:]) for array in arrays]
    pair, spread_masks = Pair(spread[0], spread[1], data_range), spread[2] if masks is not None else None
    if not math.prod(outer):
        pair.extent()
        return np.empty(outer)
    sums, ranges, _ = _compare(pair, settings, spread_masks)
    if not np.isfinite(sums).all():
        raise Pair(first, second, data_range).non_finite_error(NAMES)
    for index in map(tuple, np.argwhere(ranges[..., 1] - ranges[..., 0] > pair.extent())):
        pictures = Pair(pair.reference[index], pair.test[index], data_range)
        _check_values(pictures, settings, ranges[index], None if spread_masks is None else spread_masks[index])
    no_pixels = np.full(outer, np.nan)
    return np.asarray(np.divide(sums[..., 0], sums[..., 1], out=no_pixels, where=sums[..., 1] > 0))


def ms_ssim(
    reference: ArrayLike | Frame,
    test: ArrayLike | Frame,
    *,
    data_range: float | None = None,
    weights: Sequence[float] = SCALE_WEIGHTS,
    channel_axis: int | None = None,
    settings: SsimSettings | None = None,
    **keywords: Unpack[SsimKeywords],
) -> float:
    """Compute the structural similarity at several scales (MS-SSIM), each half as large as the previous one.

    Errors as in `ssim`, and for pictures that are too small. Source: Wang, Simoncelli, Bovik (2003), Eq. 7.

    Parameters
    ----------
    reference, test, data_range, channel_axis, settings, keywords
        As in `ssim`, with the convention "wang". The window must lie within the picture at every scale, which for five
        scales needs 176 × 176 pixels.
    weights
        Exponents of the scales, from the finest to the coarsest.

    Returns
    -------
    float
        Product over the scales of mean^weight. The mean is that of contrast times structure, and at the coarsest scale
        that of the whole similarity; negative means count as 0. Channels are averaged. Exactly 1 for equal pictures.
    """
    settings = gather(SsimSettings, settings, keywords)
    settings._require_mask(None)
    if settings.convention != "wang":
        raise ValueError(f"convention: expected 'wang' for several scales, got {settings.convention!r}")
    exponents = check.array("weights", weights, columns=None, dtype=np.float64, finite=True)
    if exponents.ndim != 1 or not len(exponents) or (exponents < 0.0).any():
        wrong = check.value_or_type(exponents.tolist())
        raise ValueError(f"weights: expected numbers of at least 0, one for each scale, got {wrong}")
    pair = inputs.pair(reference, test, data_range)
    channels = pair.channels_first(inputs.channel_axis(pair, channel_axis))
    kernel_settings = settings._for_kernel(channels)
    results = _core.multiscale(channels.reference, channels.test, settings=kernel_settings, scales=len(exponents))
    of_channels, least, greatest = zip(*results, strict=True)
    means = np.array(of_channels)
    if not np.isfinite(means).all():
        raise pair.non_finite_error()
    pair.check_values(min(least), max(greatest))
    factors = np.concatenate([means[:, :-1, 1], means[:, -1:, 0]], axis=1)
    return float((np.maximum(factors, 0.0) ** exponents).prod(axis=1).mean())


def visual_continuity(
    frames: Iterable[ArrayLike | Frame], *, data_range: float | None = None, channel_axis: int | None = None
) -> Iterator[float]:
    """Compute the similarity of each picture of a sequence to the next one; 1 means that nothing changes.

    Yields for each picture except the first its SSIM with the previous picture, in one window over the whole picture.
    Errors as in `ssim`. Source: CloVR (2024): visual continuity.

    Parameters
    ----------
    frames
        Frames, or arrays of one shape. A generator is read step by step, and only one picture is stored.
    data_range
        As in `psnr`.
    channel_axis
        As in `ssim`.
    """
    last: NDArray[Any] | None = None
    for frame in check.iterable("frames", frames, "Frames or arrays of one shape"):
        # An array is copied, because its producer may write the next picture into the same memory.
        if isinstance(frame, Frame):
            current: NDArray[Any] = inputs.luma(frame)
            extent: float | None = inputs.frame_extent(data_range)
        else:
            current, extent = np.array(inputs.numbers("frames", frame)), data_range
        if last is not None:
            yield _continuity(last, current, extent, channel_axis)
        last = current


def _continuity(last: NDArray[Any], current: NDArray[Any], data_range: float | None, channel_axis: int | None) -> float:
    """Return the similarity of two pictures of a sequence; error messages name `frames`."""
    try:
        return ssim(last, current, data_range=data_range, window="global", channel_axis=channel_axis)
    except (TypeError, ValueError) as error:
        if str(error).startswith(("reference", "test")):
            kind = TypeError if isinstance(error, TypeError) else ValueError
            raise kind(f"frames: {error}") from None
        raise


def _check_values(
    pair: Pair, settings: SsimSettings, limits: NDArray[np.float64], mask: NDArray[np.uint8] | None
) -> None:
    """Raise ValueError for values within windows beyond `data_range`; `limits` enclose these values."""
    least, greatest = limits.tolist()
    if mask is not None and pair.is_beyond(least, greatest):
        covered = settings._covered_pixels(mask, *pair.reference.shape[-2:])
        if not covered.any():
            return
        values = [picture[..., covered] for picture in (pair.reference, pair.test)]
        least, greatest = (float(f([f(part) for part in values])) for f in (np.nanmin, np.nanmax))
    pair.check_values(least, greatest)


def _masks(mask: ArrayLike, shape: tuple[int, ...], settings: SsimSettings) -> NDArray[np.uint8]:
    """Check a mask, downsample it like the pictures, and repeat it for all channels without a copy."""
    pixels = inputs.mask_of(mask)
    if pixels.shape != shape[-2:]:
        raise ValueError(f"mask: expected shape {shape[-2:]}, got {pixels.shape}")
    factor = settings._shrink(*pixels.shape)
    smaller = pixels[::factor, ::factor]
    return np.broadcast_to(smaller, shape[:-2] + smaller.shape)


def _compare(
    pair: Pair, settings: SsimSettings, masks: NDArray[np.uint8] | None, *, full: bool = False
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[Any] | None]:
    """Return sums of similarity and pixel weight (..., 2), extreme values (..., 2), and with `full` the maps."""
    shape = pair.reference.shape
    factor = settings._shrink(*shape[-2:])
    map_shape = (*shape[:-2], -(-shape[-2] // factor), -(-shape[-1] // factor)) if full else None
    kernel_settings = settings._for_kernel(pair)

    def run(report: Any) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[Any] | None]:
        sums, maps = _core.similarity(
            pair.reference, pair.test, settings=kernel_settings, masks=masks, map_shape=map_shape, report=report
        )
        results = np.array(sums).reshape(*shape[:-2], 4)
        return results[..., :2], results[..., 2:], maps

    if pair.reference.size < _MANY_PIXELS:
        return run(None)
    with progress.bar("comparing pictures") as report:
        return run(report)
