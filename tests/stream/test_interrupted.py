"""Interrupted exports, killed, stopped or without space: the older bundle remains, and the next one completes."""

from __future__ import annotations

import errno
import os
import shutil
import signal
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NoReturn

import pytest

import nearfar as nf
from nearfar._base import files
from nearfar.stream import _encode, _map_files, _stages
from tests.support import bundle_cases, need, printed_by_threads
from tests.support.bundle_cases import content, use

pytestmark = pytest.mark.filterwarnings("ignore:.*fork.*:DeprecationWarning")

OLD, NEW = {"height": 3.0}, {"height": 2.0}
URL = "memory://interrupted/village"


@pytest.fixture(scope="module")
def versions(tmp_path_factory: pytest.TempPathFactory) -> tuple[dict[str, bytes], dict[str, bytes]]:
    """Files of two versions, some of them shared."""
    folder = tmp_path_factory.mktemp("versions")
    for name, height in (("old", OLD), ("new", NEW)):
        bundle_cases.write(folder / name, **height)
    old, new = content(folder / "old"), content(folder / "new")
    assert old != new
    assert len(old.keys() & new.keys()) > 3
    return old, new


def forked(act: Callable[[], object]) -> int:
    """Run a function in a forked process; returns the signal that ended it, or 0."""
    child = os.fork()
    if not child:
        try:
            act()
        finally:
            os._exit(0)
    return os.WTERMSIG(os.waitpid(child, 0)[1])


def kill_at(folder: Path, event: int) -> None:
    """Kill this process at the n-th change of the file system at or beside a folder."""
    seen = [0]

    def hook(name: str, given: tuple[Any, ...]) -> None:
        is_change = name in ("os.mkdir", "os.rename", "os.remove", "os.rmdir", "os.chmod", "open")
        if is_change and str(given[0]).startswith(str(folder.parent)):
            seen[0] += 1
            if seen[0] == event:
                os.kill(os.getpid(), signal.SIGKILL)

    sys.addaudithook(hook)


@pytest.mark.slow
@pytest.mark.parametrize("stands", [False, pytest.param(True, marks=pytest.mark.stress)])
def test_killed_exports_leave_the_old_or_the_new_bundle(
    tmp_path: Path, versions: tuple[dict[str, bytes], dict[str, bytes]], stands: bool
) -> None:
    need("fork")
    old, new = versions
    folder = tmp_path / "village"
    outcomes = set()
    for event in range(1, 500, 1 if stands else 3):
        if stands:
            bundle_cases.write(folder, **OLD)

        def act(event: int = event) -> None:
            kill_at(folder, event)
            bundle_cases.write(folder, **NEW)

        ended = forked(act)
        if not ended:
            break
        assert ended == signal.SIGKILL
        found = content(folder)
        assert found in ([old, new] if stands else [{}, new]), event
        outcomes.add(found == new)
        if found:
            bundle = nf.stream.open(folder)
            bundle.verify()
        bundle_cases.write(folder, **NEW)
        assert content(folder) == new
        assert [path.name for path in tmp_path.iterdir()] == ["village"]
        if not stands:
            shutil.rmtree(folder)
    else:
        pytest.fail("the export has no end")
    assert event > 20
    assert outcomes == {False, True}


class Stop:
    """Calls a function, but replaces its n-th call by another action first."""

    def __init__(self, function: Callable[..., Any], call: int, deed: Callable[[], NoReturn]) -> None:
        self._function, self._left, self._deed = function, call, deed

    def __call__(self, *given: Any, **named: Any) -> Any:
        self._left -= 1
        if self._left == 0:
            self._deed()
        return self._function(*given, **named)


def no_space() -> NoReturn:
    raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))


def press() -> NoReturn:
    signal.raise_signal(signal.SIGINT)
    raise AssertionError("the signal was lost")


@pytest.mark.parametrize(("stands", "call"), [(True, 1), (True, 2), (True, 13), (False, 5)])
def test_a_full_disk_keeps_the_old_bundle(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, versions: Any, stands: bool, call: int
) -> None:
    folder = tmp_path / "village"
    if stands:
        bundle_cases.write(folder, **OLD)
    with monkeypatch.context() as patch:
        patch.setattr(files, "write", Stop(files.write, call, no_space))
        with pytest.raises(OSError, match="No space left on device"):
            bundle_cases.write(folder, **NEW)
    assert content(folder) == (versions[0] if stands else {})
    assert [path.name for path in tmp_path.iterdir()] == ["village"] * stands
    bundle_cases.write(folder, **NEW)
    assert content(folder) == versions[1]


@pytest.mark.parametrize("size", [0, 700, 3900])
def test_a_file_size_limit_keeps_the_old_bundle(tmp_path: Path, versions: Any, size: int) -> None:
    """A system limit simulates a disk that is full after so many bytes of a file."""
    need("linux")
    import resource

    bundle_cases.write(tmp_path / "village", **OLD)
    before = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, before[1]))
    try:
        with pytest.raises(OSError, match="File too large"):
            bundle_cases.write(tmp_path / "village", **NEW)
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, before)
    assert content(tmp_path / "village") == versions[0]
    assert [path.name for path in tmp_path.iterdir()] == ["village"]


@pytest.mark.parametrize(
    ("module", "name", "call"),
    [
        (_stages, "assign", 1),
        (_stages, "bake_maps", 1),
        (_map_files, "encode_color", 4),
        (_encode, "referenced_files", 2),
        (files, "write", 3),
        (files, "_take_place", 1),
    ],
)
def test_control_c_keeps_the_old_bundle(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, versions: Any, module: Any, name: str, call: int
) -> None:
    bundle_cases.write(tmp_path / "village", **OLD)
    with monkeypatch.context() as patch:
        patch.setattr(module, name, Stop(getattr(module, name), call, press))
        with pytest.raises(KeyboardInterrupt):
            bundle_cases.write(tmp_path / "village", **NEW)
    assert content(tmp_path / "village") == versions[0]
    assert [path.name for path in tmp_path.iterdir()] == ["village"]
    bundle_cases.write(tmp_path / "village", **NEW)
    assert content(tmp_path / "village") == versions[1]


@pytest.fixture
def memory() -> Iterator[Any]:
    """An empty file system in memory."""
    need("fsspec")
    import fsspec

    system = fsspec.filesystem("memory")
    system.store.clear()
    system.pseudo_dirs[:] = [""]
    yield system
    system.store.clear()
    system.pseudo_dirs[:] = [""]


class FullAfter:
    """Writes files of a file system, but only half of the n-th one."""

    def __init__(self, system: Any, call: int) -> None:
        self._write, self._left = type(system).pipe_file, call

    def __call__(self, system: Any, path: str, value: bytes, **named: Any) -> None:
        self._left -= 1
        if self._left == 0:
            self._write(system, path, value[: len(value) // 2], **named)
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))
        self._write(system, path, value, **named)


def at_url(system: Any) -> dict[str, bytes]:
    return {path.removeprefix("/interrupted/village/"): system.cat_file(path) for path in system.find("/interrupted")}


def test_behind_a_url_the_older_bundle_remains_until_the_manifest(
    monkeypatch: pytest.MonkeyPatch, memory: Any, versions: tuple[dict[str, bytes], dict[str, bytes]]
) -> None:
    old, new = versions
    written = len(new.keys() - old.keys()) + 2  # Files of the older bundle are not written again.
    for call in (1, 3, written // 2, written - 1, written, written + 1):
        memory.store.clear()
        bundle_cases.write(URL, **OLD)
        full = FullAfter(memory, call)
        with monkeypatch.context() as patch:
            patch.setattr(type(memory), "pipe_file", lambda *given, full=full, **named: full(*given, **named))
            if call > written:
                bundle_cases.write(URL, **NEW)
                break
            with pytest.raises(OSError, match=f"cannot be written: .*No space left on device.*{URL}"):
                bundle_cases.write(URL, **NEW)
        if call < written:
            bundle = nf.stream.open(URL)
            assert memory.cat_file("/interrupted/village/manifest.json") == old["manifest.json"]
            use(bundle)
            if call < written - 1:
                bundle.verify()
            else:  # Its rings exist, but the list of them for other programs does not.
                with pytest.raises(nf.FormatError, match=rf"{URL}/tileset\.json: expected"):
                    bundle.verify()
        else:  # Stores that write half of a file instead of none would lose the manifest.
            with pytest.raises(nf.FormatError, match=rf"{URL}/manifest\.json: damaged"):
                nf.stream.open(URL)
        bundle_cases.write(URL, **NEW)
        nf.stream.open(URL).verify()
        assert at_url(memory) == old | new
    assert call == written + 1


def test_without_a_manifest_nothing_is_read(monkeypatch: pytest.MonkeyPatch, memory: Any, versions: Any) -> None:
    full = FullAfter(memory, 7)
    with monkeypatch.context() as patch:
        patch.setattr(type(memory), "pipe_file", lambda *given, **named: full(*given, **named))
        with pytest.raises(OSError, match="No space left"):
            bundle_cases.write(URL, **NEW)
    with pytest.raises(FileNotFoundError, match=r"manifest\.json"):
        nf.stream.open(URL)
    bundle_cases.write(URL, **NEW)
    assert at_url(memory) == versions[1]


def test_errors_of_file_systems_name_the_url(monkeypatch: pytest.MonkeyPatch, memory: Any) -> None:
    bundle_cases.write(URL, **OLD)
    bundle = nf.stream.open(URL)

    def fail(*given: Any, **named: Any) -> NoReturn:
        raise RuntimeError("the token\nexpired")

    monkeypatch.setattr(type(memory), "cat_file", fail)
    for act in (bundle.verify, lambda: use(bundle), lambda: nf.stream.open(URL)):
        with pytest.raises(OSError, match=f"cannot be read: the token expired.*{URL}"):
            act()
    monkeypatch.setattr(type(memory), "pipe_file", fail)
    with pytest.raises(OSError, match=f"cannot be written: the token expired.*{URL}"):
        bundle_cases.write(URL, **NEW)


CODE = """
import hashlib, tempfile
from pathlib import Path
from tests.support import bundle_cases

with tempfile.TemporaryDirectory() as folder:
    bundle_cases.write(Path(folder) / "b")
    for name, data in sorted(bundle_cases.content(Path(folder)).items()):
        print(name, hashlib.sha256(data).hexdigest())
"""


@pytest.mark.slow
def test_bytes_do_not_depend_on_the_number_of_threads() -> None:
    (printed,) = printed_by_threads(CODE)
    assert printed.count("\n") > 15
