"""Replacing files and folders: long names, links, permissions, kills, and leftovers of dead processes."""

from __future__ import annotations

import errno
import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

import nearfar as nf
from nearfar import _core
from nearfar._base import files, locks
from tests.support import need


def save(target: Path, content: str) -> None:
    with files.atomic_folder(target) as folder:
        (folder / "manifest.json").write_text(content)


def content_of(target: Path) -> str:
    return (target / "manifest.json").read_text()


def run_killed(code: str, *arguments: object) -> None:
    """Run code whose process ends at once, as by kill −9."""
    head = "import os, sys; from nearfar import _core; from nearfar._base import files\n"
    process = subprocess.run([sys.executable, "-c", head + code, *map(str, arguments)], timeout=600, check=False)
    assert process.returncode == 9


@pytest.mark.parametrize(
    "name", ["a" * 249, "a" * 240 + ".scene", "b" * 255, "é" * 124, "名" * 83 + ".名", "." + "x" * 248]
)
def test_names_may_have_the_maximum_length(name: str, tmp_path: Path) -> None:
    for content in (b"first", b"second"):
        with files.atomic_file(tmp_path / name) as temporary:
            temporary.write_bytes(content)
    assert (tmp_path / name).read_bytes() == b"second"
    for text in ("first", "second"):
        save(tmp_path / name[1:], text)
    assert content_of(tmp_path / name[1:]) == "second"
    assert len(list(tmp_path.iterdir())) == 2


def test_links_and_permissions_are_kept(tmp_path: Path) -> None:
    need("linux")
    real, link = tmp_path / "real.bin", tmp_path / "link.bin"
    real.write_bytes(b"old")
    real.chmod(0o640)
    link.symlink_to("real.bin")
    with files.atomic_file(link) as temporary:
        temporary.write_bytes(b"new")
    assert link.is_symlink()
    assert real.read_bytes() == b"new"
    assert stat.S_IMODE(real.stat().st_mode) == 0o640
    save(tmp_path / "folder", "old")
    (tmp_path / "folder").chmod(0o750)
    (tmp_path / "way").symlink_to("folder")
    save(tmp_path / "way", "new")
    assert (tmp_path / "way").is_symlink()
    assert content_of(tmp_path / "folder") == "new"
    assert stat.S_IMODE((tmp_path / "folder").stat().st_mode) == 0o750


def test_two_folders_are_exchanged_at_once(tmp_path: Path) -> None:
    need("linux")
    for name in "ab":
        (tmp_path / name).mkdir()
        (tmp_path / name / "content").write_text(name)
    assert _core.exchange_paths(str(tmp_path / "a"), str(tmp_path / "b"))
    assert [(tmp_path / name / "content").read_text() for name in "ab"] == ["b", "a"]
    with pytest.raises(FileNotFoundError):
        _core.exchange_paths(str(tmp_path / "a"), str(tmp_path / "missing"))


@pytest.mark.parametrize("error", [OSError, KeyboardInterrupt, MemoryError])
@pytest.mark.parametrize("call", [1, 2])
def test_a_failed_replacement_restores_the_old_file(
    error: type[BaseException], call: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "scene"
    save(target, "old")
    monkeypatch.setattr(_core, "exchange_paths", lambda *_: False)
    rename, calls = os.rename, [0]

    def interrupted(*paths: Path) -> None:
        calls[0] += 1
        if calls[0] == call:
            raise error
        rename(*paths)

    monkeypatch.setattr(os, "rename", interrupted)
    with pytest.raises(error):
        save(target, "new")
    monkeypatch.undo()
    assert content_of(target) == "old"
    assert list(tmp_path.iterdir()) == [target]
    monkeypatch.setattr(_core, "exchange_paths", lambda *_: False)
    save(target, "new")
    assert content_of(target) == "new"
    assert list(tmp_path.iterdir()) == [target]


@pytest.mark.parametrize(
    ("error", "reason"),
    [(OSError(errno.EROFS, None), os.strerror(errno.EROFS)), (OSError("no locks"), "no locks"), (OSError(), "OSError")],
)
def test_errors_name_the_path_and_the_reason(
    error: OSError, reason: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(_: Path) -> None:
        raise error

    monkeypatch.setattr(locks, "try_hold", fail)
    for writing in (files.atomic_file, files.atomic_folder):
        with pytest.raises(OSError, match=f"cannot be written: {reason}") as raised:
            files.check_writable(writing(tmp_path / "target"))
        assert raised.value.filename == str(tmp_path / "target")


def test_a_folder_survives_a_kill_at_any_step(tmp_path: Path) -> None:
    target = tmp_path / "scene"
    save(target, "old")
    write = "with files.atomic_folder(sys.argv[1]) as f: (f / 'manifest.json').write_text('new')"
    for step in ("os.rename", "files.shutil.rmtree", "_core.exchange_paths", "os.fsync"):
        for exchange in ("", "_core.exchange_paths = lambda *_: False\n"):
            die = f"{step} = lambda *_, **__: os._exit(9)\n"
            if exchange and step == "_core.exchange_paths":
                continue
            if not exchange and step == "os.rename":
                continue  # not called
            run_killed(f"{exchange}{die}{write}", target)
            files.restore(target)
            assert content_of(target) in ("old", "new"), (step, exchange)
            save(target, "old")
            assert list(tmp_path.iterdir()) == [target], (step, exchange)


def test_loading_restores_a_scene_that_was_set_aside(tmp_path: Path) -> None:
    reduced = nf.reduce(nf.datasets.room(), center=(-1.9, 1.55, 2.25), r1=1.7, r2=3.4, face_size=16)
    target = tmp_path / "light"
    reduced.save(target)
    run_killed("os.rename(sys.argv[1], files.replaced_path(files.Path(sys.argv[1]))); os._exit(9)", target)
    assert not target.exists()
    assert nf.ReducedScene.load(target).stats["near"] == reduced.stats["near"]
    assert list(tmp_path.iterdir()) == [target]


def test_only_leftovers_of_dead_processes_are_removed(tmp_path: Path) -> None:
    need("linux")
    target, other = tmp_path / "a.bin", tmp_path / ".a.notours.bin"
    other.write_bytes(b"")
    for _ in range(3):
        run_killed("with files.atomic_file(sys.argv[1]): os._exit(9)", target)
    left = set(tmp_path.iterdir()) - {other}
    assert len(left) == 2  # A file and its lock: each process removes those that the previous one left.
    with files.atomic_file(target) as living, files.atomic_file(target) as second:
        assert not left & set(tmp_path.iterdir())
        assert living.exists()
        second.write_bytes(b"second")
        living.write_bytes(b"first")
    assert target.read_bytes() == b"first"
    assert set(tmp_path.iterdir()) == {target, other}


def test_pipes_and_devices_are_not_replaced(tmp_path: Path) -> None:
    need("linux")
    pipe = tmp_path / "pipe.json"
    os.mkfifo(pipe)
    with pytest.raises(OSError, match="is a pipe, a socket or a device, expected a file path") as raised:
        nf.hmd.VIVE_PRO.save(pipe)
    assert raised.value.filename == str(pipe)
    assert stat.S_ISFIFO(pipe.stat().st_mode)


def test_an_interrupt_before_writing_leaves_no_temporary_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    touch = Path.touch

    def interrupted(path: Path, **settings: bool) -> None:
        touch(path, **settings)
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "touch", interrupted)
    with pytest.raises(KeyboardInterrupt):
        nf.hmd.VIVE_PRO.save(tmp_path / "it.json")
    assert list(tmp_path.iterdir()) == []
