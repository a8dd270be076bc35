"""Tests of atomic files, formats, the cache and the data folder."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import jsonschema
import numpy as np
import pytest

import nearfar as nf
from nearfar._base import cache, data, files, formats
from tests.support import SCHEMAS, load_schema


# files ---------------------------------------------------------------------------------------------------------------
def test_a_file_appears_complete(tmp_path: Path) -> None:
    target = tmp_path / "picture.png"
    for content in (b"first", b"second"):
        with files.atomic_file(target) as aside:
            assert aside.suffix == ".png"
            aside.write_bytes(content)
            assert target.exists() == (content == b"second")
        assert target.read_bytes() == content
    assert list(tmp_path.iterdir()) == [target]


@pytest.mark.parametrize("error", [RuntimeError, KeyboardInterrupt, SystemExit])
def test_an_interrupted_write_leaves_the_old_file_and_nothing_else(tmp_path: Path, error: type[BaseException]) -> None:
    target = tmp_path / "data.bin"
    target.write_bytes(b"old")
    with pytest.raises(error), files.atomic_file(target) as aside:
        aside.write_bytes(b"half")
        raise error
    assert target.read_bytes() == b"old"
    assert list(tmp_path.iterdir()) == [target]


def test_a_killed_writer_leaves_no_partial_file(tmp_path: Path) -> None:
    target = tmp_path / "data.bin"
    code = (
        "import os, sys; from nearfar._base import files\n"
        "with files.atomic_file(sys.argv[1]) as aside:\n"
        "    aside.write_bytes(b'half'); os._exit(9)"
    )
    process = subprocess.run([sys.executable, "-c", code, str(target)], timeout=600, check=False)
    assert process.returncode == 9
    assert not target.exists()


def test_new_files_have_ordinary_permissions(tmp_path: Path) -> None:
    (tmp_path / "plain").write_bytes(b"")
    with files.atomic_file(tmp_path / "ours"):
        pass
    assert (tmp_path / "ours").stat().st_mode == (tmp_path / "plain").stat().st_mode


def test_unwritable_paths_are_named_before_work_begins(tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(b"")
    worked = False
    for place in (tmp_path / "missing" / "a.png", tmp_path / "file" / "a.png", tmp_path):
        with pytest.raises(OSError, match=r"cannot be written|is a folder") as caught, files.atomic_file(place):
            worked = True
        assert caught.value.filename == str(place)
        assert not worked


def test_a_folder_appears_complete_and_replaces_only_its_own_kind(tmp_path: Path) -> None:
    target = tmp_path / "scene"
    for content in ("first", "second"):
        with files.atomic_folder(target) as aside:
            (aside / "sub").mkdir()
            (aside / "sub" / "data.txt").write_text(content)
            (aside / "manifest.json").write_text("{}")
        assert (target / "sub" / "data.txt").read_text() == content
    with pytest.raises(RuntimeError), files.atomic_folder(target) as aside:
        (aside / "manifest.json").write_text("half")
        raise RuntimeError
    assert (target / "manifest.json").read_text() == "{}"
    assert list(tmp_path.iterdir()) == [target]


def test_a_folder_may_be_the_working_directory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    target = tmp_path / "scene"
    target.mkdir()
    monkeypatch.chdir(target)
    with files.atomic_folder(".") as aside:
        (aside / "manifest.json").write_text("{}")
    assert [path.name for path in target.iterdir()] == ["manifest.json"]


def test_a_folder_with_other_peoples_files_is_refused(tmp_path: Path) -> None:
    home = tmp_path / "home"
    home.mkdir()
    with files.atomic_folder(home) as aside:
        (aside / "letter.txt").write_text("dear")
    with pytest.raises(FileExistsError, match="holds other files"), files.atomic_folder(home):
        pass
    assert (home / "letter.txt").read_text() == "dear"
    with pytest.raises(NotADirectoryError), files.atomic_folder(home / "letter.txt"):
        pass


# formats -------------------------------------------------------------------------------------------------------------
def test_a_header_is_read_back_and_fits_its_schema() -> None:
    header = formats.header("report", 2, color_space="sRGB", origin=[1.0, 0.0, 2.0])
    jsonschema.validate(header, load_schema("header"))
    assert header["generator"] == f"nearfar {nf.__version__}"
    assert formats.check(header, "report", 2, "a.json") is header


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"version": 3}, "a.json: nearfar.report version 3 was written by nearfar .* reads up to version 2"),
        ({"version": "2"}, "a.json: expected a version of at least 1, got '2'"),
        ({"version": True}, "expected a version"),
        ({"version": 0}, "expected a version"),
        ({"format": "nearfar.bundle"}, "a.json: expected format 'nearfar.report', got 'nearfar.bundle'"),
        ({"format": None}, "expected format"),
    ],
)
def test_foreign_and_newer_documents_are_refused(change: dict[str, Any], words: str) -> None:
    document = formats.header("report", 2) | change
    with pytest.raises(nf.FormatError, match=words):
        formats.check(document, "report", 2, "a.json")


@pytest.mark.parametrize(
    "change", [{"format": [["x" * 9] * 99] * 99}, {"version": "1" * 9999}, {"version": [1] * 9999}]
)
def test_long_values_are_cut(change: dict[str, Any]) -> None:
    with pytest.raises(nf.FormatError) as caught:
        formats.check(formats.header("report", 2) | change, "report", 2, "a.json")
    assert len(str(caught.value)) < 200


@pytest.mark.parametrize("kind", [KeyError, ValueError, TypeError])
def test_long_reasons_are_cut(kind: type[Exception]) -> None:
    with pytest.raises(nf.FormatError, match="damaged model") as caught, formats.guarded("a.json", "model"):
        raise kind("entry\n" * 999)
    assert len(str(caught.value)) < 300
    assert "\n" not in str(caught.value)


def test_long_names_of_programs_are_cut() -> None:
    with pytest.raises(nf.FormatError, match="reads up to version 2") as caught:
        formats.check(formats.header("report", 3) | {"generator": "x\ny" * 999}, "report", 2, "a.json")
    assert len(str(caught.value)) < 250
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("content", [b"", b"[1]", b"{", b"\xff\xfe", b"[" * 100_000])
def test_damaged_documents_are_refused_by_name(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "report.json"
    path.write_bytes(content)
    with pytest.raises(nf.FormatError, match=r"report\.json: expected"):
        formats.read_json(path, "report", 1)


def test_documents_hold_no_nan() -> None:
    with pytest.raises(ValueError, match="JSON"):
        formats.to_json({"value": float("nan")})


def test_every_schema_is_a_schema() -> None:
    for path in SCHEMAS.iterdir():
        jsonschema.Draft202012Validator.check_schema(load_schema(path.name.removesuffix(".schema.json")))


# cache ---------------------------------------------------------------------------------------------------------------
def test_different_values_have_different_keys() -> None:
    parts: list[Any] = [1, 1.0, "1", b"1", True, None, (1,), ((1,),), (1, 1), [], {}, {"a": 1}, {"a": 2}]
    parts += [np.array([1], dtype) for dtype in (np.int32, np.int64, np.float32)] + [np.array([[1]], np.int32)]
    # Lists and tuples have equal keys; everything else differs.
    assert len({cache.key(part) for part in parts}) == len(parts)
    assert cache.key("ab", "c") != cache.key("a", "bc")
    assert cache.key({"a": 1, "b": 2}) == cache.key({"b": 2, "a": 1})
    assert cache.key(np.arange(6).reshape(2, 3).T) == cache.key(np.ascontiguousarray(np.arange(6).reshape(2, 3).T))
    with pytest.raises(TypeError, match="parts: expected"):
        cache.key(object())


def write(size: int) -> Callable[[Path], None]:
    def make(path: Path) -> None:
        path.write_bytes(bytes(size))

    return make


def test_a_result_is_computed_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path))
    made = []

    def make(path: Path) -> None:
        made.append(path)
        path.write_bytes(b"result")

    key = cache.key("algorithm", 1, 0.5)
    for _ in range(2):
        assert cache.get_or_make(key, ".bin", make).read_bytes() == b"result"
    assert len(made) == 1


def test_the_least_recently_used_entry_is_evicted_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path))
    monkeypatch.setenv("NEARFAR_CACHE_MAX_GB", "3e-6")
    keys = [cache.key(i) for i in range(4)]
    paths = []
    for age, key in enumerate(keys[:3]):
        path = cache.get_or_make(key, ".bin", write(1000))
        os.utime(path, (age, age))
        paths.append(path)
    cache.get_or_make(keys[0], ".bin", write(1000))
    newest = cache.get_or_make(keys[3], ".bin", write(1000))
    assert [path.exists() for path in (*paths, newest)] == [True, False, True, True]
    assert cache.get_or_make(cache.key("large"), ".bin", write(9000)).exists()
    assert [path.exists() for path in (*paths, newest)] == [False] * 4


def test_a_failed_result_is_not_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path))

    def fail(path: Path) -> None:
        path.write_bytes(b"half")
        raise RuntimeError

    with pytest.raises(RuntimeError):
        cache.get_or_make(cache.key("fails"), ".bin", fail)
    assert [path for path in tmp_path.rglob("*") if path.is_file()] == []


@pytest.mark.parametrize("wrong", ["-1", "many", "nan", "inf"])
def test_a_wrong_bound_is_a_value_error(wrong: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NEARFAR_CACHE_MAX_GB", wrong)
    with pytest.raises(ValueError, match=f"NEARFAR_CACHE_MAX_GB: expected .* got '{wrong}'"):
        cache.get_or_make(cache.key(0), ".bin", write(1))


def test_an_unwritable_cache_is_named(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_bytes(b"")
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "file"))
    with pytest.raises(OSError, match=str(tmp_path / "file")):
        cache.get_or_make(cache.key(0), ".bin", write(1))


def test_the_platforms_folder_is_the_default(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.delenv("NEARFAR_CACHE")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    monkeypatch.setattr(sys, "platform", "linux")
    assert cache.folder() == tmp_path / "nearfar"


# data ----------------------------------------------------------------------------------------------------------------
def test_the_variable_comes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "city").mkdir()
    (tmp_path / "city" / "a.glb").write_bytes(b"")
    monkeypatch.setenv("NEARFAR_DATA", str(tmp_path))
    assert data.find("city/a.glb") == tmp_path / "city" / "a.glb"
    assert data.find("city/b.glb") is None
    with pytest.raises(FileNotFoundError, match=r"city/b\.glb: expected a data file, but not in"):
        data.require("city/b.glb")


def test_the_nearest_shared_folder_comes_next(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("NEARFAR_DATA", raising=False)
    monkeypatch.setattr(data, "__file__", str(tmp_path / "a" / "b" / "package" / "_data.py"))
    monkeypatch.chdir(tmp_path)
    (tmp_path / "a" / "b").mkdir(parents=True)
    (tmp_path / "shared" / "data").mkdir(parents=True)
    assert data.root() == tmp_path / "shared" / "data"
    (tmp_path / "a" / "shared" / "data").mkdir(parents=True)
    assert data.root() == tmp_path / "a" / "shared" / "data"
