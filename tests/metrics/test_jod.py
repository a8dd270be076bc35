"""ColorVideoVDP, which another project computes: conversions, ranges and errors are ours."""

from __future__ import annotations

import numpy as np
import pytest

import nearfar as nf

pycvvdp = pytest.importorskip("pycvvdp", reason="cvvdp, which needs PyTorch, is not installed")


def test_jod_equals_the_package() -> None:
    random = np.random.default_rng(0)
    one = random.integers(64, 192, (48, 64, 3), np.uint8)
    other = np.clip(one + random.normal(0, 12, one.shape), 0, 255).astype(np.uint8)
    metric = pycvvdp.cvvdp(
        display_photometry=pycvvdp.vvdp_display_photo_eotf(80.0, contrast=1000),
        display_geometry=pycvvdp.vvdp_display_geometry((64, 48), ppd=20.0),
        quiet=True,
    )
    expected = float(metric.predict(other, one, dim_order="HWC")[0])
    found = nf.metrics.jod(one, other, data_range=255, pixels_per_degree=20, luminance=80)
    assert found == pytest.approx(expected, abs=1e-3)
    assert nf.metrics.jod(one / 255, other / 255, data_range=1, pixels_per_degree=20, luminance=80) == pytest.approx(
        found, abs=1e-4
    )
    assert nf.metrics.jod(one, one, data_range=255, pixels_per_degree=20) == pytest.approx(10)
    # Finer pixels hide the noise.
    assert nf.metrics.jod(one, other, data_range=255, pixels_per_degree=80, luminance=80) > found
    grey = [np.repeat(picture[..., :1], 3, axis=2) for picture in (one, other)]
    assert nf.metrics.jod(one[..., 0], other[..., 0], data_range=255, pixels_per_degree=20) == nf.metrics.jod(
        *grey, data_range=255, pixels_per_degree=20
    )
    with pytest.raises(ValueError, match="luminance: expected a number from 1 to 10000, got 0"):
        nf.metrics.jod(one, other, data_range=255, pixels_per_degree=20, luminance=0)
    with pytest.raises(ValueError, match="reference: expected at least 2 × 2 pixels, got 64 × 1"):
        nf.metrics.jod(one[:1], other[:1], data_range=255, pixels_per_degree=20)
