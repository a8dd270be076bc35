"""Tests of pixel errors and object completion against their definitions."""

from __future__ import annotations

import math
import subprocess
import sys

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from tests.support import PEAK, need, printed_by_threads
from tests.support.reduce_cases import CENTER, camera, street
from tests.support.similarity_oracle import pictures


def test_errors_equal_their_definition() -> None:
    a, b = pictures()
    assert nf.psnr(a, a, data_range=1) == math.inf
    assert nf.metrics.rmse(a, a) == 0.0
    assert nf.metrics.rmse(a, b) == pytest.approx(np.sqrt(np.mean((a - b) ** 2)), rel=1e-13)
    assert nf.metrics.rmse(np.float64(1), 4) == 3.0
    assert nf.metrics.rmse([[[1.0]], [[5.0]]], [[[1.0]], [[2.0]]]) == math.sqrt(4.5)


@given(st.integers(0, 2**32 - 1), st.integers(1, 9), st.integers(1, 40_000), st.sampled_from([np.uint8, np.uint16]))
def test_integers_are_summed_without_rounding(seed: int, height: int, width: int, kind: type) -> None:
    random = np.random.default_rng(seed)
    a, b = random.integers(0, np.iinfo(kind).max, (2, height, width), endpoint=True).astype(kind)
    if seed % 3 == 0:
        a[:], b[:] = 0, np.iinfo(kind).max
    exact = int(((a.astype(np.int64) - b.astype(np.int64)) ** 2).sum())
    assert nf.metrics.rmse(a, b) == math.sqrt(exact / a.size)


def test_pictures_that_are_tall_and_narrow_need_no_memory() -> None:
    tall = np.broadcast_to(np.float32(0.25), (1 << 22, 1))
    assert nf.metrics.rmse(tall, tall) == 0.0
    assert nf.ssim(tall, tall, data_range=1, window="global") == 1.0


def test_psnr_equals_scikit_image() -> None:
    need("skimage")
    from skimage.metrics import peak_signal_noise_ratio

    a, b = pictures()
    assert nf.psnr(a, b, data_range=1) == pytest.approx(peak_signal_noise_ratio(a, b, data_range=1), abs=1e-10)
    small = [p.astype(np.float32) for p in (a, b)]
    assert nf.psnr(*small, data_range=1) == pytest.approx(nf.psnr(a, b, data_range=1), abs=1e-4)


def test_8_bit_pictures_and_frames_are_compared_directly() -> None:
    a, b = (np.round(255 * p).astype(np.uint8) for p in pictures())
    assert nf.psnr(a, b, data_range=255) == pytest.approx(nf.psnr(a / 255, b / 255, data_range=1), abs=1e-10)
    view = camera(CENTER, (1, 0, 0))
    frame = nf.render(street(), view, channels=("color",))
    other = nf.render(street(), camera(CENTER, (1, 0.02, 0)), channels=("color",))
    assert nf.ssim(frame, frame) == 1.0
    assert nf.psnr(frame, frame) == math.inf
    jump = nf.ssim(frame, other, window="global")
    assert list(nf.metrics.visual_continuity([frame, frame, other])) == [1.0, jump]
    with pytest.raises(TypeError, match="two frames or two arrays"):
        nf.metrics.rmse(frame, a)


@given(st.lists(st.tuples(st.integers(-1, 5), st.integers(-1, 5)), min_size=1, max_size=60))
def test_object_completion_equals_its_definition(pairs: list[tuple[int, int]]) -> None:
    reference, test = (np.array(ids, np.int32) for ids in zip(*pairs, strict=True))
    objects = [o for o in range(6) if (reference == o).any()]
    found = nf.metrics.object_completion(reference, test)
    if not objects:
        assert all(math.isnan(value) for value in found)
        return
    counts = [(int((reference == o).sum()), int((test == o).sum())) for o in objects]
    assert found[0] == pytest.approx(np.mean([here > 0 for _, here in counts]))
    assert found[1] == pytest.approx(np.mean([min(here, there) / there for there, here in counts]))


def test_object_numbers_may_be_large_and_sparse() -> None:
    reference = np.array([2**31 - 1, 2**31 - 1, 2**30, -1, 0, 0, 0, 0], np.int32)
    test = np.array([2**31 - 1, 5, 6, 7, 0, 0, -(2**31), 0], np.int32)
    assert nf.metrics.object_completion(reference, test) == pytest.approx((2 / 3, (0.5 + 0.75) / 3))
    large = np.repeat(np.arange(3000, dtype=np.int32), 701)
    assert nf.metrics.object_completion(large, large[::-1]) == (1.0, 1.0)
    shifted = np.roll(large, 350)
    shifted[:350] = -1
    assert nf.metrics.object_completion(large, shifted) == pytest.approx((1.0, (2999 + 351 / 701) / 3000))


BITS = """
import hashlib
import numpy as np
import nearfar as nf
from tests.support.similarity_oracle import pictures
from tests.support.reduce_cases import CENTER, camera, street
a, b = pictures(301, 203)
frame = nf.render(street(), camera(CENTER, (1, -0.1, 0.2), (320, 200)), channels=("position",))
mask = a > 0.5
parts = [nf.metrics.rmse(a, b), nf.metrics.ms_ssim(a, b, data_range=1), nf.metrics.discontinuity(frame).tobytes()]
for window in ("gaussian", "uniform", "global"):
    for kind in (np.float32, np.float64):
        x, y = a.astype(kind), b.astype(kind)
        mean, found = nf.ssim(x, y, data_range=1, window=window, full=True)
        parts += [mean, found.tobytes(), nf.ssim(x, y, data_range=1, window=window, mask=mask, masking="windows")]
parts += [nf.metrics.ssim_pairs(a[:64, :64], [b[:64, :64], b[64:128, 64:128]], data_range=1).tobytes()]
print(hashlib.sha256(repr(parts).encode()).hexdigest())
"""


@pytest.mark.slow
def test_bits_do_not_depend_on_the_number_of_threads() -> None:
    assert len(set(printed_by_threads(BITS))) == 1


MEMORY = f"""{PEAK}
import numpy as np
import nearfar as nf
random = np.random.default_rng(0)
# In place: what was used and given back already would hide what is used later.
a = np.empty((2160, 3840), np.float32)
random.random(out=a, dtype=np.float32)
b = a.copy()
b[::3] *= np.float32(0.9)
nf.ssim(a[:64, :64], b[:64, :64], data_range=1)
before = peak()
nf.ssim(a, b, data_range=1)
nf.ssim(a, b, data_range=1, mask=a > 0.5)
nf.metrics.rmse(a, b)
print((peak() - before) / a.nbytes)
"""


def test_similarity_needs_less_memory_than_an_image() -> None:
    need("linux")
    grown = subprocess.run([sys.executable, "-c", MEMORY], capture_output=True, text=True, check=True).stdout
    # The mask itself is a quarter of an image.
    assert float(grown) < 0.6
