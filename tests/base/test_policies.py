"""Tests of argument checks, errors, threads, progress and random numbers."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, strategies as st

import nearfar as nf
from nearfar import _core
from nearfar._base import check, progress, random
from tests.support import need

WORD = st.integers(0, 2**64 - 1)


# arguments -----------------------------------------------------------------------------------------------------------
def test_array_keeps_float_types_and_does_not_copy_unnecessarily() -> None:
    for dtype in (np.float32, np.float64):
        points = np.zeros((4, 3), dtype)
        assert check.array("points", points) is points
    assert check.array("points", [[1, 2, 3]]).dtype == np.float64
    assert check.array("points", np.zeros((2, 3), ">f4")).dtype == np.dtype("=f4")
    assert check.array("points", np.zeros((2, 3), np.float16)).dtype == np.float64


def test_array_makes_strided_and_unaligned_input_contiguous() -> None:
    columns = np.asfortranarray(np.arange(12.0).reshape(4, 3))
    straight = check.array("points", columns)
    assert straight.flags.c_contiguous
    np.testing.assert_array_equal(straight, columns)
    crooked = np.zeros(4 * 3 * 4 + 1, np.uint8)[1:].view(np.float32).reshape(4, 3)
    assert check.array("points", crooked).flags.aligned


@pytest.mark.parametrize(
    ("error", "words", "call"),
    [
        (
            ValueError,
            r"got 2 that are not, the first at \(0, 1\)",
            lambda: check.array("points", [[0, np.nan, np.inf]], finite=True),
        ),
        (
            ValueError,
            "faces: expected whole numbers from 0 to 4294967295, got -1 to 2",
            lambda: check.array("faces", [[-1, 1, 2]], dtype=np.uint32),
        ),
        (TypeError, r"cells: expected two whole numbers, got \(1,\)", lambda: check.pair("cells", (1,), 1, 9)),  # type: ignore[arg-type]
        (TypeError, r"cells\[1\]: expected a whole number", lambda: check.pair("cells", (1, 2.5), 1, 9)),  # type: ignore[arg-type]
        (ValueError, r"cells\[0\]: .* number from 1 to 9, got 0", lambda: check.pair("cells", (0, 2), 1, 9)),
    ],
)
def test_wrong_arguments_are_named(error: type[Exception], words: str, call: Callable[[], Any]) -> None:
    with pytest.raises(error, match=words):
        call()


def test_copies_that_exceed_memory_are_refused_with_their_size(monkeypatch: pytest.MonkeyPatch) -> None:
    """A view that repeats its memory, and a conversion for which NumPy finds too little."""
    endless = np.broadcast_to(np.float32(1), (1 << 45, 3))
    with pytest.raises(MemoryError, match=f"points: a copy of float32 of shape .* needs {12 << 45} bytes"):
        check.array("points", endless)

    def require(*_: Any) -> None:
        raise MemoryError

    monkeypatch.setattr(np, "require", require)
    with pytest.raises(MemoryError, match=r"points: a copy of float16 of shape \(4, 3\) as float64 needs 96 bytes"):
        check.array("points", np.zeros((4, 3), np.float16))


def test_right_arguments_pass() -> None:
    assert check.vector("center", np.array([1, 2, 3])) == (1.0, 2.0, 3.0)
    assert check.radii(0, np.float32(0.5)) == (0.0, 0.5)
    assert check.integer("samples", np.int64(3), 1, 9) == 3
    assert check.pair("cells", np.array([1, 9]), 1, 9) == (1, 9)  # type: ignore[arg-type]
    assert check.array("faces", np.array([[0, 1, 2]]), dtype=np.uint32).dtype == np.uint32
    assert check.array("faces", [], columns=None, dtype=np.uint32).shape == (0,)


def masked(values: Any) -> Any:
    """Return values with the first one masked."""
    mask = np.zeros(np.shape(values), bool)
    mask.flat[0] = True
    return np.ma.array(values, mask=mask)


@pytest.mark.parametrize(
    ("name", "call"),
    [
        ("points", lambda m: check.array("points", m(np.zeros((4, 3))))),
        ("center", lambda m: check.vector("center", m([0.0, 1.0, 2.0]))),
        ("faces", lambda m: nf.cube_lookup(m(np.zeros((6, 4, 4), np.uint8)), [[1.0, 0, 0]])),
    ],
)
def test_masked_values_are_refused(name: str, call: Callable[[Any], Any]) -> None:
    with pytest.raises(TypeError, match=f"^{name}: expected an array without masked values"):
        call(masked)
    call(np.ma.asarray)


# errors --------------------------------------------------------------------------------------------------------------
def test_own_errors_share_a_base_class() -> None:
    for kind in (nf.SceneError, nf.FormatError, nf.DeviceError):
        assert issubclass(kind, nf.Error)
        assert not issubclass(kind, ValueError | OSError)


def test_a_panic_is_an_ordinary_exception_and_the_pool_survives() -> None:
    with pytest.raises(RuntimeError, match="internal error in nearfar, please report it: asked"):
        _core.probe("panic")
    assert _core.uniform(1, 2, np.arange(3, dtype=np.uint64)).shape == (3,)


def test_a_kernels_refusal_is_a_value_error() -> None:
    with pytest.raises(ValueError, match="behaviour: expected 'wait' or 'panic', got 'nonsense'"):
        _core.probe("nonsense")


# threads, progress, interruption -------------------------------------------------------------------------------------
def run(code: str, **environment: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-c", code], env=os.environ | environment, capture_output=True, text=True, timeout=600
    )


@pytest.mark.parametrize("count", ["1", "3"])
def test_thread_count_follows_the_variable(count: str) -> None:
    process = run("from nearfar import _core; print(_core.thread_count())", NEARFAR_NUM_THREADS=count)
    assert process.stdout.strip() == count, process.stderr


@pytest.mark.parametrize("wrong", ["0", "-2", "two", "1.5"])
def test_a_wrong_thread_count_is_a_value_error(wrong: str) -> None:
    process = run("from nearfar import _core; _core.thread_count()", NEARFAR_NUM_THREADS=wrong)
    words = f"ValueError: NEARFAR_NUM_THREADS: expected a whole number from 1 to 1024, got '{wrong}'"
    assert words in process.stderr


PICTURE = """
import nearfar as nf
scene = nf.Scene.from_arrays([[-9, -9, -5], [9, -9, -5], [0, 9, -5]], [[0, 1, 2]])
camera = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(90), size=(4096, 4096))
print("ready", flush=True)
nf.render(scene, camera, samples=1024, channels=("color",))
"""


@pytest.mark.parametrize(
    "code",
    ["from nearfar import _core; print('ready', flush=True); _core.probe('wait')", PICTURE],
    ids=["probe", "render"],
)
def test_ctrl_c_stops_a_long_kernel(code: str) -> None:
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline().strip() == b"ready"
        # Usually the kernel has begun by then; the interrupt must take effect either way.
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        # Left alone, the probe waits for ever, and the picture takes hours.
        _, errors = process.communicate(timeout=300)
    assert b"KeyboardInterrupt" in errors


def test_other_threads_run_while_a_kernel_works() -> None:
    finished = threading.Event()

    def stop(_done: int, _total: int) -> None:
        if finished.is_set():
            raise InterruptedError

    worker = threading.Thread(target=finished.set)
    timer = threading.Timer(0.05, worker.start)
    timer.start()
    with pytest.raises(InterruptedError):
        _core.probe("wait", stop)
    worker.join()


def test_an_exception_from_report_stops_the_kernel_and_is_raised() -> None:
    def report(_done: int, _total: int) -> None:
        raise LookupError("enough")

    with pytest.raises(LookupError, match="enough"):
        _core.probe("wait", report)


# Python warns of forking in a process with threads, which this test does on purpose.
@pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")
def test_a_forked_child_computes() -> None:
    need("fork")
    index = np.arange(1000, dtype=np.uint64)
    parent = _core.uniform(1, 2, index)
    child = os.fork()
    if child == 0:
        same = np.array_equal(_core.uniform(1, 2, index), parent)
        os._exit(0 if same else 1)
    for _ in range(1200):
        ended, status = os.waitpid(child, os.WNOHANG)
        if ended:
            break
        time.sleep(0.05)
    else:
        os.kill(child, signal.SIGKILL)
        os.waitpid(child, 0)
        pytest.fail("the child hung for a minute")
    assert os.waitstatus_to_exitcode(status) == 0


def test_bars_are_silent_off_a_terminal(capfd: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NEARFAR_PROGRESS", raising=False)
    monkeypatch.setattr(progress, "DELAY", 0.0)
    with progress.bar("work") as report:
        report(1, 2)
    assert capfd.readouterr() == ("", "")


class Terminal:
    """A standard error stream that reports to be a terminal and stores its text."""

    encoding = "utf-8"

    def __init__(self) -> None:
        self.text = ""

    def isatty(self) -> bool:
        return True

    def write(self, text: str) -> int:
        self.text += text
        return len(text)

    def flush(self) -> None:
        pass


@pytest.mark.parametrize(("delay", "switch", "shown"), [(0.0, "", True), (60.0, "", False), (0.0, "0", False)])
def test_bars_appear_on_a_terminal_only_after_a_while(
    delay: float, switch: str, shown: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    terminal = Terminal()
    monkeypatch.setattr(sys, "stderr", terminal)
    monkeypatch.setattr(progress, "DELAY", delay)
    monkeypatch.setenv("NEARFAR_PROGRESS", switch)
    monkeypatch.setenv("TERM", "xterm")
    with progress.bar("baking") as outer:
        outer(1, 4)
        with progress.bar("inner") as inner:
            inner(1, 2)
        outer(4, 4)
    assert ("baking" in terminal.text) == shown
    assert "inner" not in terminal.text


# random numbers ------------------------------------------------------------------------------------------------------
def mix(z: int) -> int:
    """SplitMix64's finaliser in Python integers, the oracle."""
    mask = 2**64 - 1
    z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & mask
    z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & mask
    return z ^ (z >> 31)


def oracle(seed: int, cell: int, index: int) -> float:
    golden, mask = 0x9E3779B97F4A7C15, 2**64 - 1
    state = mix((seed + golden) & mask)
    for word in (cell, index):
        state = mix(((state ^ word) + golden) & mask)
    return (state >> 11) / 2**53


@given(seed=WORD, cell=WORD, index=st.lists(WORD, max_size=5))
def test_uniform_equals_the_oracle_exactly(seed: int, cell: int, index: list[int]) -> None:
    drawn = random.uniform(seed, cell, np.array(index, np.uint64))
    assert drawn.tolist() == [oracle(seed, cell, i) for i in index]


def test_random_draws_never_change() -> None:
    # Scenes and studies are identified by their seeds; another mixer would change all of them.
    assert random.integers(0, 0, np.arange(6), 0, 1000).tolist() == [int(oracle(0, 0, i) * 1000) for i in range(6)]
    assert random.uniform(0, 0, [[0, 1], [2, 3]]).shape == (2, 2)


def test_integers_cover_their_range_evenly() -> None:
    count = np.bincount(random.integers(3, 1, np.arange(60_000), -2, 4) + 2)
    # Six classes of 10,000: five standard deviations, √(60,000 · 1/6 · 5/6) = 91.
    assert count.shape == (6,)
    assert np.abs(count - 10_000).max() < 5 * 92


@pytest.mark.parametrize(
    ("words", "call"),
    [
        ("seed: expected a whole number from 0", lambda: random.uniform(-1, 0, [0])),
        ("index: expected whole numbers from 0", lambda: random.uniform(0, 0, [-1])),
        ("high: expected a whole number from 6", lambda: random.integers(0, 0, [0], 5, 5)),
    ],
)
def test_wrong_draws_are_refused(words: str, call: Callable[[], Any]) -> None:
    with pytest.raises(ValueError, match=words):
        call()
