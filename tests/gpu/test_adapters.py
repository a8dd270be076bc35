"""Tests of adapter selection, messages without one, the command line, and memory and bytes of frames."""

from __future__ import annotations

import json
import os
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import nearfar as nf
from nearfar._render import backend as backends
from nearfar.cli._app import run
from tests.support import load_schema, need
from tests.support.gpu_cases import adapter, both, crowd, program, view

NO_DRIVERS = dict.fromkeys(("VK_ICD_FILENAMES", "VK_DRIVER_FILES", "__EGL_VENDOR_LIBRARY_FILENAMES"), "/nonexistent")
"""An environment in which neither Vulkan nor EGL finds a driver."""


# choosing ------------------------------------------------------------------------------------------------------------
def test_adapters_describe_themselves() -> None:
    need("vulkan")
    found = nf.gpu.adapters()
    assert [one for one in found if one.backend == "vulkan" and one.usable]
    for one in found:
        assert one.label == f"{one.name} ({one.backend})"
        assert one.usable == (not one.refused)
        assert bool(one.note) == (not one.usable or one.kind == "software")
        assert one.largest_binding >= 1 << 27
        assert one.largest_image >= 4096


def test_an_adapter_is_selected_by_interface_or_a_part_of_its_name(backend: str) -> None:
    assert nf.gpu.selected().backend == backend
    part = nf.gpu.selected().label[3:].upper()
    nf.gpu.select(part)
    assert nf.gpu.selected().backend == backend
    with pytest.raises(nf.DeviceError, match=r"no graphics adapter 'abacus' can be used, found .*\(vulkan|gl\)"):
        nf.gpu.select("abacus")
    assert nf.gpu.selected().backend == backend


def test_the_environment_selects_too(monkeypatch: pytest.MonkeyPatch) -> None:
    need("gl")
    monkeypatch.setenv("NEARFAR_ADAPTER", "gl")
    assert nf.gpu.selected().backend == "gl"
    with adapter("vulkan"):
        assert nf.gpu.selected().backend == "vulkan"
    monkeypatch.setenv("NEARFAR_ADAPTER", " ")
    assert backends.selected() is None


def test_auto_selects_a_software_adapter_only_after_measurement() -> None:
    need("vulkan")
    if backends.is_hardware(None):
        pytest.skip("there is an adapter that auto takes")
    camera, scene = view((0, 0, 1), (0, 0, -6), size=(64, 48)), crowd()
    work = (("color",), 1)
    with adapter("vulkan"):
        assert backends.device_for("auto", scene, work) is None
        before = len(backends._faster)
        seconds = nf.gpu.measure(scene, camera, channels=["color"])
        assert set(seconds) == {"cpu", "gpu"}
        assert min(seconds.values()) > 0.0
        assert len(backends._faster) == before + 1
        for faster in (True, False):
            backends.remember(scene, work, nf.gpu.selected().label, faster)
            assert (backends.device_for("auto", scene, work) is not None) == faster
            # Other tasks and other scenes have no measurements.
            assert backends.device_for("auto", scene, (("range",), 1)) is None
            assert backends.device_for("auto", crowd(), work) is None


def test_measurements_are_freed_with_their_scene() -> None:
    before = len(backends._faster)
    scene = crowd()
    backends.remember(scene, (("color",), 1), "one", True)
    assert len(backends._faster) == before + 1
    del scene
    assert len(backends._faster) == before


# saying --------------------------------------------------------------------------------------------------------------
def test_auto_notes_the_fallback_to_the_cpu_once(tmp_path: Path) -> None:
    need("vulkan")
    if backends.is_hardware(None):
        pytest.skip("there is an adapter that auto takes")
    cache = str(tmp_path / "cache")
    code = """
import os, sys
for _ in range(3):
    nf.render(scene, camera)
nf.render(scene, camera, backend="cpu")
nf.render(scene, camera, backend="gpu")
print("NODEVICE_SELECT" in os.environ)  # it silences Mesa while adapters are searched
print("then", file=sys.stderr, flush=True)
for _ in range(3):
    nf.render(scene, camera, backend="auto")
"""
    process = program(code, NEARFAR_CACHE=cache)
    assert (process.returncode, process.stdout) == (0, "False\n"), process.stderr
    # Mesa prints nothing either, although XDG_RUNTIME_DIR is unset.
    then, note = process.stderr.splitlines()
    assert then == "then"
    assert note.startswith("rendering on the CPU: the processor itself is the only graphics adapter found")
    assert "install the driver of a graphics card" in note
    code = """
import os
nf.render(scene, camera, backend="auto")
nf._render.backend._logged.clear()
os.environ["NEARFAR_ADAPTER"] = "abacus"
nf.render(scene, camera)
"""
    process = program(code, NEARFAR_CACHE=cache)
    assert process.returncode == 0, process.stderr
    # The cache remembers the first note; the unknown name is another one.
    (note,) = process.stderr.splitlines()
    assert "no graphics adapter 'abacus' can be used, found" in note


def test_without_drivers_auto_renders_and_gpu_and_info_name_packages_to_install(tmp_path: Path) -> None:
    need("linux")
    code = """
import sys
import nearfar.gpu
print("logging" in sys.modules, nf._render.backend._searched)  # importing does not search for adapters
frames = [nf.render(scene, camera, backend="auto") for _ in range(2)]
assert nf.gpu.adapters() == []
for call in (lambda: nf.render(scene, camera, backend="gpu"), nf.gpu.stats, lambda: nf.gpu.measure(scene, camera)):
    try:
        call()
    except nf.DeviceError as error:
        print(error)
from nearfar.cli._app import run
raise SystemExit(run(["info", "--gpu", "--json"]))
"""
    process = program(code, NEARFAR_CACHE=str(tmp_path / "cache"), **NO_DRIVERS)
    assert process.returncode == 0, process.stderr
    imported, *sentences, printed = process.stdout.split("\n", 4)
    assert imported == "False set()"
    document = json.loads(printed)
    jsonschema.validate(document, load_schema("adapters"))
    assert (document["adapters"], document["gpu"], document["auto"]) == ([], None, None)
    for sentence in [*sentences, process.stderr, document["why"]]:
        assert "no graphics adapter can be used, found none; install a Vulkan driver, such as" in sentence
        assert "mesa-vulkan-drivers and libvulkan1" in sentence
    assert process.stderr.startswith("rendering on the CPU: ")
    assert process.stderr.count("\n") == 1


# the command line ----------------------------------------------------------------------------------------------------
def test_info_lists_adapters(capsys: pytest.CaptureFixture[str]) -> None:
    need("vulkan")
    assert run(["info", "--gpu", "--json"]) == 0
    alone = json.loads(capsys.readouterr().out)
    for name in ("header", "adapters"):
        jsonschema.validate(alone, load_schema(name))
    assert [one["backend"] for one in alone["adapters"]] == [one.backend for one in nf.gpu.adapters()]
    assert alone["gpu"] == nf.gpu.selected().label
    assert run(["info", "-i", "city:blocks=2,detail=0", "--gpu", "--json"]) == 0
    besides = json.loads(capsys.readouterr().out)
    jsonschema.validate(besides, load_schema("info"))
    assert besides["gpu"] == {name: alone[name] for name in ("adapters", "gpu", "auto", "why")}
    assert run(["info", "--gpu"]) == 0
    assert nf.gpu.selected().name[:8] in capsys.readouterr().out


@pytest.mark.parametrize("backend", ["cpu", "gpu"])
def test_commands_take_a_back_end(backend: str, tmp_path: object, capsys: pytest.CaptureFixture[str]) -> None:
    need("vulkan")
    arguments = [
        "render",
        *["-i", "city:blocks=2,detail=0", "--size", "32x24", "--samples", "1", "-o"],
        f"{tmp_path}/a.png",
    ]
    assert run([*arguments, "--backend", backend]) == 0, capsys.readouterr().err
    assert run([*arguments, "--backend", "cuda"]) == 1
    assert "--backend: expected one of 'auto', 'cpu', 'gpu', got 'cuda'" in capsys.readouterr().err


# memory and bytes ----------------------------------------------------------------------------------------------------
@pytest.mark.slow
def test_a_thousand_frames_allocate_nothing(backend: str) -> None:
    need("linux")
    scene = crowd(("one_7",))
    pose = np.eye(4)

    def resident() -> int:
        with open("/proc/self/statm") as statm:
            return int(statm.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    def frames(count: int) -> None:
        for number in range(count):
            pose[0, 3] = 0.01 * number
            eye = (0.001 * number, 1.3, 1.0)
            nf.render(scene.at({"one_7": pose}), view(eye, (0, 0, -6), size=(32, 24)), backend="gpu")

    frames(100)
    before, memory = nf.gpu.stats(), resident()
    frames(1000)
    after = nf.gpu.stats()
    assert after["allocations"] == before["allocations"]
    assert after["allocated_bytes"] == before["allocated_bytes"]
    # A leak of the frame's own 32 × 24 × 24 bytes would be 18 MB.
    assert resident() - memory < 6 << 20


def test_unchanged_data_is_not_uploaded_again(backend: str) -> None:
    scene, camera = crowd(("one_7",)), view((0, 1.3, 1.0), (0, 0, -6), size=(64, 48))
    pose = np.eye(4)
    for number in range(3):
        pose[0, 3] = 0.1 * number
        nf.render(scene.at({"one_7": pose}), camera, backend="gpu")
    sent = nf.gpu.stats()["uploaded_bytes"]
    nf.render(scene.at({"one_7": pose}), camera, backend="gpu")
    assert nf.gpu.stats()["uploaded_bytes"] == sent
    pose[0, 3] = 0.7
    nf.render(scene.at({"one_7": pose}), camera, backend="gpu")
    # Three rows of a matrix, in the record of the batch and that of the draw.
    assert 0 < nf.gpu.stats()["uploaded_bytes"] - sent <= 300


def test_passes_are_timed_where_the_adapter_has_a_clock(backend: str) -> None:
    clocks = ("raster_seconds", "resolve_seconds")
    taken = [nf.gpu.stats()]
    for _ in range(2):
        nf.render(crowd(), view((0, 1.3, 1.0), (0, 0, -6), size=(64, 48)), backend="gpu")
        taken.append(nf.gpu.stats())
    for clock in clocks:
        if backend == "gl":
            assert clock not in taken[0]
        else:
            assert taken[0][clock] < taken[1][clock] < taken[2][clock] < taken[0][clock] + 600.0


@pytest.mark.slow
def test_images_larger_than_a_window_are_complete() -> None:
    """All channels of 3,000 × 2,400 pixels take 346 MB; software adapters allow 128 MiB per binding."""
    need("vulkan")
    need("linux")
    scene, camera = crowd(), view((0, 1.3, 1.0), (0, 0, -6), size=(3000, 2400))
    with adapter("vulkan"):
        assert nf.gpu.selected().largest_binding < 48 * 3000 * 2400 / 2
        cpu, gpu = both(scene, camera, channels=("color", "range", "object_id", "face_id", "position", "normal"))
        same = cpu.require("face_id") == gpu.require("face_id")
        assert same.mean() > 0.9999
        near, far = gpu.require("range")[same], cpu.require("range")[same]
        # Some of seven million pixels see a face nearly edge-on.
        np.testing.assert_allclose(near, far, rtol=5e-5)
        missed = ~np.isfinite(gpu.require("range"))
        assert missed.any()
        assert np.isnan(gpu.require("normal")[missed]).all()
        assert np.isfinite(gpu.require("position")[~missed]).all()
