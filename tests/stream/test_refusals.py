"""Paths that cannot store a bundle are refused before work begins, by the argument's name."""

from __future__ import annotations

import importlib.util
import json
import os
from pathlib import Path
from typing import Any

import pytest

import nearfar as nf
from nearfar.stream import _stages
from tests.support import bundle_cases, need
from tests.support.bundle_cases import content


@pytest.fixture(autouse=True)
def _no_work(monkeypatch: pytest.MonkeyPatch) -> None:
    def work(*given: Any, **named: Any) -> None:
        raise AssertionError("the work began")

    for name in ("choose_radii", "assign", "TextureFiles", "Geometry"):
        monkeypatch.setattr(_stages, name, work)


def check_refused(path: Any, kind: type[Exception], text: str) -> None:
    with pytest.raises(kind, match=text):
        nf.stream.export(bundle_cases.village(), path, **{**bundle_cases.SETTINGS, "radii": None})


def test_a_folder_without_a_parent(tmp_path: Path) -> None:
    for path in (tmp_path / "none" / "b", f"file://{tmp_path}/none/b", f"local://{tmp_path}/none/b"):
        check_refused(path, FileNotFoundError, "path: expected a path whose parent is a folder.*none/b")
    (tmp_path / "file").write_text("mine")
    check_refused(tmp_path / "file" / "b", FileNotFoundError, "path: expected a path whose parent is a folder.*file/b")
    check_refused(tmp_path / "file", NotADirectoryError, "is a file, expected a folder path.*file")
    assert content(tmp_path) == {"file": b"mine"}


@pytest.mark.parametrize("text", ['{"name": "a web page", "icons": []}', "[]", '{"format": "nearfar.reduced"}'])
def test_a_folder_with_other_files(tmp_path: Path, text: str) -> None:
    (tmp_path / "mine.txt").write_text("mine")
    check_refused(tmp_path, FileExistsError, r"holds other files \(no manifest.json\)")
    (tmp_path / "manifest.json").write_text(text)
    check_refused(tmp_path, FileExistsError, r"path: holds a manifest\.json of another program")
    assert content(tmp_path) == {"mine.txt": b"mine", "manifest.json": text.encode()}


@pytest.mark.skipif(os.name == "nt" or os.geteuid() == 0, reason="root may write everywhere")
def test_a_read_only_folder_is_refused(tmp_path: Path) -> None:
    tmp_path.chmod(0o500)
    try:
        check_refused(tmp_path / "b", PermissionError, "cannot be written")
    finally:
        tmp_path.chmod(0o700)


@pytest.mark.parametrize("path", ["", 3, None, b"x", "a\0b", "memory://\udcff", "memory://", "file://"])
def test_no_path_at_all(path: Any) -> None:
    need("fsspec")
    check_refused(path, (ValueError, TypeError), "^path: expected")  # type: ignore[arg-type]


@pytest.mark.parametrize("url", ["nothing-known://a/b", "https://example.org/b", "http://example.org/b"])
def test_unwritable_urls_are_refused(url: str) -> None:
    need("fsspec")
    check_refused(url, ValueError, "^path: expected a (URL that fsspec can open|URL that can be written), got")
    if url.startswith("nothing"):
        with pytest.raises(ValueError, match="expected a URL that fsspec can open"):
            nf.stream.open(url)


def test_a_missing_fsspec_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None)
    check_refused("memory://a/b", ValueError, r"path: expected a folder, or fsspec installed \(pip install fsspec\)")
    with pytest.raises(ValueError, match=r"fsspec installed \(pip install 'fsspec\[http\]'\), got 'http://a/b'"):
        nf.stream.open("http://a/b")
    with pytest.raises(ValueError, match=r"path: expected a folder, or fsspec installed"):
        nf.stream.open("memory://a/b")


@pytest.mark.parametrize(
    ("url", "text"),
    [("http://a/b", r"pip install 'fsspec\[http\]'"), ("s3://a/b", "Install s3fs"), ("memory://a/b", "needs more")],
)
def test_packages_that_a_file_system_needs_are_named(url: str, text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    need("fsspec")
    import fsspec

    def missing(*given: Any) -> None:
        raise ImportError("Install s3fs to access S3" if url.startswith("s3") else "it needs more")

    monkeypatch.setattr(fsspec.core, "url_to_fs", missing)
    with pytest.raises(
        ValueError, match=rf"path: expected the package that fsspec needs for this URL \(.*{text}.*\), got '{url}'"
    ):
        nf.stream.open(url)


def test_local_urls_are_paths_and_bundles_are_replaced(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.undo()
    first = bundle_cases.write(f"file://{tmp_path}/b")
    assert content(tmp_path / "b").keys() == {"manifest.json", "tileset.json", *first.files}
    bundle_cases.write(tmp_path / "b", height=1.0)
    assert nf.stream.open(f"file://{tmp_path}/b").nbytes == nf.stream.open(tmp_path / "b").nbytes
    place = tmp_path / "50 % größer"
    assert bundle_cases.write(place.as_uri()).nbytes == first.nbytes
    assert content(place).keys() == {"manifest.json", "tileset.json", *first.files}
    assert nf.stream.open(f"local://{place}").files == first.files
    # A damaged manifest may be ours: the rest of a bundle can be overwritten.
    (tmp_path / "b" / "manifest.json").write_text(json.dumps({"format": "nearfar.bundle"})[:-3])
    bundle_cases.write(tmp_path / "b")
    assert nf.stream.open(tmp_path / "b").files == first.files
