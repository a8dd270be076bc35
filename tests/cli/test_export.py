"""`nearfar export`."""

from __future__ import annotations

from pathlib import Path

import pytest

import nearfar as nf
from tests.support import need
from tests.support.cli_cases import city as city, command, document

FAST = ("--center", "0,1.7,0", "--face-size", "64", "--samples", "1")


def test_a_bundle_is_written_and_counted(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "bundle"
    status, printed, err = command(capsys, "export", "-i", city, "-o", out, "--radii", "10,22", *FAST, "--json")
    assert status == 0, err
    found = document(printed, "export")
    bundle = nf.stream.open(out)
    assert found["bytes"] == bundle.nbytes
    assert found["regions"][0]["rings"] == bundle.summary()
    assert bundle.radii == (10.0, 22.0)
    assert bundle.center == (0.0, 1.7, 0.0)
    status, _, err = command(capsys, "partition", "-i", out)
    assert (status, "got a folder with a bundle, which nearfar.stream.open reads" in err) == (1, True)
    status, printed, err = command(capsys, "info", "-i", out, "--json", "--preview", tmp_path / "small.png")
    assert status == 0, err
    described = document(printed, "info")
    assert described["kind"] == "bundle"
    assert described["bundle"].items() >= {name: found[name] for name in ("triangles", "bytes", "regions")}.items()
    assert (described["bundle"]["face_size"], described["bundle"]["losses"]) == (64, list(bundle.losses))
    assert (tmp_path / "small.png").is_file()
    status, printed, err = command(capsys, "info", "-i", out / "manifest.json")
    assert (status, "ring 2, to 22 m" in printed, "bundle of 1,212 triangles" in printed) == (0, True, True)
    status, _, err = command(capsys, "info", "-i", out, "--scale", "2")
    assert (status, "scale: expected none with a file of nearfar, which is in metres" in err) == (1, True)
    more = ("--lossless", "--pixels-per-degree", "0")
    status, printed, err = command(capsys, "export", "-i", city, "-o", out, *FAST, *more)
    assert status == 0, err
    for text in ("first picture", "ring 1, to", "triangles", "exported in"):
        assert text in printed


def test_dynamic_objects_are_counted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    given = ("-i", "city:blocks=2,detail=0", "-o", tmp_path / "bundle", "--radii", "5", *FAST)
    status, printed, err = command(capsys, "export", *given)
    assert status == 0, err
    assert "dynamic objects" in printed


def test_large_triangles_are_split(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    def triangles(*more: str) -> int:
        given: tuple[str | Path, ...] = ("-i", city, "-o", tmp_path / "bundle", "--radii", "10,22", *FAST, *more)
        status, printed, err = command(capsys, "export", *given, "--json")
        assert status == 0, err
        return sum(int(row["triangles"]) for row in document(printed, "export")["regions"][0]["rings"])

    assert triangles("--split", "20") > 2 * triangles()


def test_a_bundle_may_be_written_to_a_url(city: Path, capsys: pytest.CaptureFixture[str]) -> None:
    need("fsspec")
    url = "memory://cli/city"
    status, printed, err = command(capsys, "export", "-i", city, "-o", url, "--radii", "10", *FAST, "--json")
    assert status == 0, err
    assert document(printed, "export")["folder"] == url
    assert nf.stream.open(url).radii == (10.0,)
    status, printed, err = command(capsys, "info", "-i", url, "--json")
    assert (status, document(printed, "info")["bundle"]["bytes"]) == (0, nf.stream.open(url).nbytes), err
    status, _, err = command(capsys, "export", "-i", city, "-o", "http://127.0.0.1/city", "--radii", "10", *FAST)
    assert status == 1
    assert "path: expected" in err


def test_several_centres_are_moved_to_a_grid(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out, more = tmp_path / "bundle", ("--center", "9,1.7,8.6", "--center", "-0.3,1.7,0.2", "--grid", "2")
    status, printed, err = command(capsys, "export", "-i", city, "-o", out, "--radii", "10", *FAST, *more, "--json")
    assert status == 0, err
    found = document(printed, "export")
    assert [region["center"] for region in found["regions"]] == [[0.0, 1.7, 0.0], [8.0, 1.7, 8.0]]
    assert [region["neighbours"] for region in found["regions"]] == [[1], [0]]
    # The second centre is in the middle of a box of 8 m.
    assert sum("seems to lie inside" in finding for finding in found["findings"]) == 1
    status, printed, err = command(capsys, "export", "-i", city, "-o", out, "--radii", "10", *FAST, *more)
    assert status == 0, err
    assert printed.count("centre") >= 2
    assert "seems to lie inside" in " ".join(printed.split())


@pytest.mark.parametrize(
    ("arguments", "text"),
    [
        (("--face-size", "65"), "--face-size: expected a multiple of 64"),
        (("--lossless", "--quality", "50"), "--quality: expected none with --lossless, got 50"),
        (("-o", "none/out"), "path: expected a path whose parent is a folder"),
        (("-o", "full"), "holds other files (no manifest.json)"),
        (("-o", "web"), "path: holds a manifest.json of another program"),
        (("--center", "0,1.7,0"), "center: expected centres at least 0.001 m apart"),
    ],
)
def test_export_errors_are_named(
    arguments: tuple[str, str],
    text: str,
    city: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.chdir(tmp_path)
    for name, file in (("full", "mine.txt"), ("web", "manifest.json")):
        (tmp_path / name).mkdir()
        (tmp_path / name / file).write_text('{"name": "a web page"}')
    status, _, err = command(capsys, "export", "-i", city, "-o", tmp_path / "out", *FAST, *arguments)
    assert status == 1
    assert text in err
    assert not (tmp_path / "out").exists()


def test_probable_mistakes_are_noted(city: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    given = ("--radii", "4,4.5,9", "--face-size", "64", "--samples", "1")
    for center, text in (("0,-40,0", "below the scene's lowest point"), ("90000,1.7,0", "all rings are empty")):
        out = tmp_path / "bundle"
        status, printed, err = command(capsys, "export", "-i", city, "-o", out, "--center", center, *given, "--json")
        assert status == 0, err
        found = document(printed, "export")["findings"]
        assert found == list(nf.stream.open(out).findings)
        assert any(text in sentence for sentence in found)
        status, printed, _ = command(capsys, "export", "-i", city, "-o", out, "--center", center, *given)
        assert status == 0
        assert "note" in printed
        assert text in " ".join(printed.split())
