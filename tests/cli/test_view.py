"""`nearfar view`."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import urllib.request
from pathlib import Path

import pytest

import nearfar as nf
from tests.support.cli_cases import command


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("view") / "bundle"
    nf.stream.export(
        nf.datasets.room(detail=0), folder, center=(0.3, 1.6, 0.2), radii=[1.5, 3.0], face_size=64, samples=1
    )
    return folder


def test_a_bundle_is_served_until_ctrl_c(bundle: Path) -> None:
    line = [sys.executable, "-m", "nearfar.cli", "view", str(bundle), "--no-browser"]
    environment = os.environ | {"PYTHONUNBUFFERED": "1"}
    with subprocess.Popen(line, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment) as program:
        try:
            assert program.stdout
            told = program.stdout.readline()
            url = told.split()[0]
            with urllib.request.urlopen(url, timeout=60) as answer:
                assert b"<canvas" in answer.read()
            program.send_signal(signal.SIGINT)
            assert program.wait(timeout=120) == 0
            assert program.stderr
            assert program.stderr.read() == ""
        finally:
            program.kill()


def test_the_page_is_written_beside_a_bundle(bundle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, printed, _ = command(capsys, "view", bundle, "--write")
    assert status == 0
    assert "index.html" in printed
    assert (bundle / "page.js").is_file()


def test_the_page_is_written_beside_a_reduced_scene(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    reduced = nf.reduce(nf.datasets.room(detail=0), center=(0.3, 1.6, 0.2), r1=1.2, r2=2.0, face_size=64)
    reduced.save(tmp_path / "light")
    assert command(capsys, "view", tmp_path / "light", "--write")[0] == 0
    assert {"index.html", "manifest.json", "reduced.json"} <= {path.name for path in (tmp_path / "light").iterdir()}
    reduced.with_morph("none").save(tmp_path / "torn")
    status, _, err = command(capsys, "view", tmp_path / "torn", "--write")
    assert status == 1
    assert "with_morph" in err


def test_scenes_are_refused_with_the_command_that_shows_them(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    model = tmp_path / "my model.glb"
    model.write_bytes(b"glTF")
    for source, quoted in ((str(model), f"'{model}'"), ("city:blocks=2", "city:blocks=2")):
        status, _, errors = command(capsys, "view", source)
        assert status == 1
        assert f"got a scene; `nearfar serve {quoted}` shows it" in errors


def test_folders_that_are_no_bundle_are_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for more in ([], ["--write"]):
        status, _, err = command(capsys, "view", tmp_path / "nothing", *more)
        assert status == 1
        assert "nothing" in err
