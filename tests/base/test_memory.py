"""Results that exceed memory: errors before work begins."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from nearfar._base import memory
from nearfar._render.backend import Backend


def test_results_that_exceed_memory_are_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    system, group = tmp_path / "meminfo", tmp_path
    monkeypatch.setattr(memory, "_SYSTEM", system)
    monkeypatch.setattr(memory, "_GROUP", group)
    memory.check_room("size", "a result", 1 << 60)  # The system does not report its memory.
    system.write_text("MemTotal: 99 kB\nMemAvailable:    2000000 kB\nSwapFree: 1000000 kB\n", encoding="ascii")
    memory.check_room("size", "a result", 3_000_000_000)
    with pytest.raises(MemoryError, match=r"size: a result takes 4\.0 GB of memory, and 3\.1 GB"):
        memory.check_room("size", "a result", 4_000_000_000)
    (group / "memory.max").write_text("max\n", encoding="ascii")
    (group / "memory.current").write_text("7000000000\n", encoding="ascii")
    (group / "memory.stat").write_text("anon 6000000000\ninactive_file 500000000\n", encoding="ascii")
    memory.check_room("size", "a result", 3_000_000_000)
    (group / "memory.max").write_text("8000000000\n", encoding="ascii")
    memory.check_room("size", "a result", 1_500_000_000)
    with pytest.raises(MemoryError, match=r"1\.5 GB are free"):
        memory.check_room("size", "a result", 3_000_000_000)
    memory.check_room("size", "a result", 1 << 28)


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no such limit")
def test_the_limit_of_the_address_space_counts(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import resource

    process = tmp_path / "statm"
    monkeypatch.setattr(memory, "_PROCESS", process)
    monkeypatch.setattr(memory, "_SYSTEM", tmp_path / "meminfo")
    monkeypatch.setattr(memory, "_GROUP", tmp_path)
    monkeypatch.setattr(resource, "getrlimit", lambda _: (3_000_000_000, resource.RLIM_INFINITY))
    monkeypatch.setattr(resource, "getpagesize", lambda: 1000)
    memory.check_room("size", "a result", 2_900_000_000)  # The system does not report the size of processes.
    process.write_text("2000000 99 9 1 0 9 0\n", encoding="ascii")
    memory.check_room("size", "a result", 1_000_000_000)
    with pytest.raises(MemoryError, match=r"1\.1 GB of memory, and 1\.0 GB are free"):
        memory.check_room("size", "a result", 1_100_000_000)
    monkeypatch.setattr(resource, "getrlimit", lambda _: (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    memory.check_room("size", "a result", 1 << 60)


@pytest.mark.parametrize("backend", ["cpu", None])
def test_pictures_that_exceed_memory_are_refused(backend: Backend | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(memory, "_free_bytes", lambda: 1 << 30)
    scene = nf.Scene.from_arrays(np.eye(3, dtype=np.float32), np.array([[0, 1, 2]], np.uint32))
    large = nf.Camera((0, 0, 0), fov=nf.Fov.symmetric(60), size=(20_000, 20_000))
    with pytest.raises(MemoryError, match="camera: a picture of 20000 × 20000 pixels takes"):
        nf.render(scene, large, backend=backend)
