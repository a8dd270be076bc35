"""Tests of stores: damage, stores behind URLs, and errors that end a build."""

from __future__ import annotations

import json
import shutil
import warnings
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._base.errors import UnusableError
from nearfar.orthoview import _files
from nearfar.orthoview._files import ByteRange, Local, join_ranges
from nearfar.orthoview._index import ABSENT, unpack_index
from nearfar.orthoview._layout import Layout
from nearfar.orthoview._presence import pack
from nearfar.orthoview._shard import check_complete
from nearfar.orthoview._store import folder_records
from tests.support import need, valid
from tests.support.orthoview_stores import CELL, SIZE, Counted, box_about, contents, places, world_of
from tests.support.range_server import RangeHandler, Served, serve_folder

need("zarr")


@pytest.fixture
def bare(few_tree: nf.orthoview.OrthoTree, tmp_path: Path) -> Path:
    """A copy of a store's documents without its shards and its geometry."""
    hidden = shutil.ignore_patterns("[pn][xyz]*", "geometry")
    return Path(shutil.copytree(few_tree.path, tmp_path / "bare.zarr", ignore=hidden))


@pytest.mark.parametrize("content", ["null", '{"nearfar": null}', '{"nearfar": {"format": "nearfar.orthoview"}}', "[]"])
def test_damaged_attributes_are_named(bare: Path, content: str) -> None:
    (bare / "zarr.json").write_text(f'{{"zarr_format": 3, "node_type": "group", "attributes": {content}}}')
    with pytest.raises(nf.FormatError, match="zarr"):
        nf.orthoview.open(bare)


@pytest.mark.parametrize(("version", "message"), [(99, "which reads up to version 2"), (1, "build it again")])
def test_stores_of_other_versions_are_refused(bare: Path, version: int, message: str) -> None:
    document = (bare / "zarr.json").read_text().replace('"version": 2', f'"version": {version}')
    (bare / "zarr.json").write_text(document)
    with pytest.raises(nf.FormatError, match=message):
        nf.orthoview.open(bare)


def test_documents_fit_their_schemas(few_tree: nf.orthoview.OrthoTree, copied_few: Path) -> None:
    attributes = json.loads((copied_few / "zarr.json").read_text())["attributes"]["nearfar"]
    assert valid(attributes, "orthoview")
    assert not valid(attributes | {"complete": "yes"}, "orthoview")
    assert attributes["held"] == few_tree.held
    nf.orthoview.open(copied_few).update(few_tree.box(0, (3, 1, 3)), world_of(range(9)))
    documents = {
        "orthoview_records": [copied_few / "nearfar" / "records.json"],
        "orthoview_subtree": list((copied_few / "nearfar" / "done").glob("*.json")),
        "orthoview_generation": list((copied_few / "nearfar" / "generations").rglob("generation.json")),
    }
    for name, paths in documents.items():
        assert paths
        for path in paths:
            document = json.loads(path.read_text())
            assert valid(document, name)
            for key in ("shards" if name != "orthoview_records" else "records", "geometry"):
                assert not valid({other: value for other, value in document.items() if other != key}, name)


def largest(folder: Path) -> Path:
    return max((path for path in folder.rglob("0") if path.is_file()), key=lambda path: path.stat().st_size)


def test_altered_chunks_and_damaged_shards_are_detected_when_read(copied_few: Path) -> None:
    """Alters a byte of each chunk in turn; Zstandard's content checksum detects it."""
    shard = largest(copied_few / "0" / "py")
    whole, first = (
        bytearray(shard.read_bytes()),
        [8 * int(number) for number in shard.relative_to(copied_few).parts[3:6]],
    )
    index = np.frombuffer(whole[-4 - 8**3 * 16 : -4], "<u8").reshape(8, 8, 8, 2)
    there = [place for place in places((8, 8, 8)) if index[(*place, 1)] < 2**63]
    assert len(there) > 20
    for place in there[:20]:
        start, length = index[place].tolist()
        altered = bytearray(whole)
        altered[start + length // 2] ^= 16
        shard.write_bytes(altered)
        x, y, z = (a + b for a, b in zip(first, place, strict=True))
        with pytest.raises(nf.FormatError, match="damaged orthoviews"):
            nf.orthoview.open(copied_few).view(0, (x, y, z), 4)
    x, y, z = (a + b for a, b in zip(first, max(there, key=lambda place: index[(*place, 0)]), strict=True))
    for damaged, message in ((whole[: len(whole) // 2], "expected [0-9]+ bytes at"), (None, "the shard is gone")):
        shard.unlink()
        if damaged is not None:
            shard.write_bytes(damaged)
        with pytest.raises(nf.FormatError, match=f"damaged orthoviews: .*{message}"):
            nf.orthoview.open(copied_few).view(0, (x, y, z), 4)


def test_a_truncated_chunk_is_refused() -> None:
    with pytest.raises(UnusableError, match="world: expected 8 bytes at 64, got 7"):
        check_complete(bytes(7), ByteRange("world", 64, 8))


def test_verify_names_damaged_files(copied_few: Path) -> None:
    tree = nf.orthoview.open(copied_few).update(box_about([2]), world_of(range(9)))
    shards = sum(path.is_file() and path.name == "0" for path in copied_few.rglob("0"))
    others = sum(path.is_file() for path in copied_few.rglob("geometry/**/*"))
    assert others > 50
    count = shards + others
    assert tree.verify() == count
    overlay = copied_few / "nearfar" / "generations" / "1"
    for folder in (copied_few / "1" / "px", overlay / "0"):
        shard = largest(folder)
        whole = shard.read_bytes()
        for damaged, text in (
            (whole[:-1], f"expected {len(whole)} bytes, got {len(whole) - 1}"),
            (whole[:9] + bytes([whole[9] ^ 1]) + whole[10:], "its SHA-256 is not"),
            (None, "the file is gone"),
        ):
            shard.unlink()
            if damaged is not None:
                shard.write_bytes(damaged)
            with pytest.raises(nf.FormatError, match=f"{shard}: damaged orthoviews: {text}"):
                tree.verify()
            shard.write_bytes(whole)
    assert tree.verify() == count
    record = next((copied_few / "nearfar" / "done").glob("0_*.json"))
    record.write_text(record.read_text() + " ")
    with pytest.raises(nf.FormatError, match=f"{record}: damaged: its SHA-256 is not"):
        tree.verify()
    record.unlink()
    with pytest.raises(nf.FormatError, match=f"{record}: expected a file that the store refers to, found none"):
        tree.verify()
    (overlay / "generation.json").unlink()
    with pytest.raises(nf.FormatError, match=r"generation.json: expected a file that the store refers to"):
        nf.orthoview.open(copied_few)


class Whole(RangeHandler):
    """Ignores ranges in paths that begin with /whole."""

    def translate_path(self, path: str) -> str:
        return super().translate_path(path.removeprefix("/whole"))

    def do_GET(self) -> None:  # noqa: N802 - the base class's name
        if self.path.startswith("/whole"):
            del self.headers["Range"]
        super().do_GET()


@pytest.fixture
def served(copied_few: Path) -> Iterator[Served]:
    need("fsspec")
    need("aiohttp")
    with serve_folder(copied_few.parent, Whole) as server:
        yield server


def assert_same_views(one: nf.orthoview.OrthoTree, other: nf.orthoview.OrthoTree, step: int) -> None:
    seen = 0
    for level in range(one.levels):
        for place in places(one.cells(level))[::step]:
            left, right = (opened.view(level, place, 4) for opened in (one, other))
            assert (left is None) == (right is None)
            if left is not None and right is not None:
                np.testing.assert_array_equal(left.color, right.color)
                np.testing.assert_array_equal(left.depth, right.depth)
                seen += 1
    assert seen > 5


def test_records_list_the_chunks_of_shards(copied_few: Path) -> None:
    """They equal the indexes at the ends of the files, also in updates, which mark removed chunks by length 0."""
    tree = nf.orthoview.open(copied_few)
    tree.update(np.array([tree.bounds[0], tree.bounds.mean(axis=0)]), world_of([]))
    count = removed = 0
    for record in folder_records(Local(copied_few), 1):
        for path, listed in record.shards.items():
            content = (copied_few / record.folder / path).read_bytes()
            side = 1 << (3 - int(path.partition("/")[0]) % 3)
            expected = np.frombuffer(content[-4 - side**3 * 16 : -4], "<u8").reshape(side, side, side, 2)
            np.testing.assert_array_equal(unpack_index(path, listed.chunks, side), expected)
            lengths = expected[..., 1]
            count, removed = count + int((lengths != ABSENT).sum()), removed + int((lengths == 0).sum())
    assert count > 100
    assert removed > 10
    for words in ([0, 1], [8, 1], [0, 0, 1, 1], [1, 2**32 - 2, 1, 1], [1], [0] * 18):
        packed = pack(np.array(words, "<u4").view(np.uint8).reshape(-1, 4).T.tobytes())
        if words == [0, 1]:
            assert unpack_index("it", packed, 2)[0, 0, 0].tolist() == [0, 1]
            continue
        with pytest.raises(UnusableError, match="it: expected"):
            unpack_index("it", packed, 2)


def test_parts_that_touch_are_one_request() -> None:
    rng = np.random.default_rng(1)
    parts = [ByteRange(str(file), int(8 * first), int(8 * n)) for file, first, n in rng.integers(1, 9, (40, 3))]
    joined = join_ranges(parts)
    assert len(joined) < len(parts) / 2
    for file in "12345678":
        wanted, requested = (
            sorted(byte for name, first, n in each if name == file for byte in range(first, first + n))
            for each in (parts, joined)
        )
        assert requested == sorted(set(wanted))
        ends = {first + n for name, first, n in joined if name == file}
        assert not ends & {first for name, first, _ in joined if name == file}


@pytest.mark.parametrize("place", ["", "whole/"])
def test_a_store_behind_a_web_server_is_read_in_part(
    copied_few: Path, served: Served, place: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    local = nf.orthoview.open(copied_few).update(box_about([2]), world_of(range(9)))
    remote = nf.orthoview.open(f"{served.url}{place}copy.zarr/")
    assert remote.generation == 1
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        assert_same_views(remote, local, 11)
    messages = [str(each.message) for each in caught if "sends whole files" in str(each.message)]
    assert len(messages) == (1 if place else 0)
    if place:
        sent = Counter(path for path, _ in served.sent if "/c/" in path)
        assert max(sent.values()) == 1 < len(sent)
        monkeypatch.setattr(_files, "MAX_WHOLE_BYTES", 1)
        again = nf.orthoview.open(remote.path)
        with pytest.warns(RuntimeWarning, match="sends whole files"):
            assert_same_views(again, local, 23)
        assert isinstance(again._files, _files.Remote)
        assert len(again._files._whole.values) == 0
    else:
        chunks = sum(size for path, size in served.sent if "/c/" in path)
        whole = sum(path.stat().st_size for path in copied_few.rglob("0") if path.is_file())
        assert chunks < whole / 4
        asked = len(served.sent)
        remote.view(0, (3, 1, 3), 4)
        remote.view(0, (3, 1, 3), 4)
        assert len(served.sent) <= asked + 3  # Records are cached.
    assert remote.verify() == local.verify()


def test_a_store_behind_a_web_server_is_read_only(copied_few: Path, served: Served, tmp_path: Path) -> None:
    remote = nf.orthoview.open(f"{served.url}copy.zarr")
    with pytest.raises(ValueError, match="path: expected a local folder to update, got 'http"):
        remote.update(remote.bounds, world_of([]))
    assert contents(Path(remote.compact(tmp_path / "local.zarr").path)) == contents(copied_few)
    with pytest.raises(FileNotFoundError, match=f"{served.url}none"):
        nf.orthoview.open(f"{served.url}none")
    with pytest.raises(ValueError, match="path: expected a URL that fsspec can open"):
        nf.orthoview.open("nowhere://store")


def test_object_stores_are_read(copied_few: Path) -> None:
    """fsspec's store in memory represents all that have keys and no folders."""
    need("fsspec")
    import fsspec

    memory = fsspec.filesystem("memory")
    memory.put(str(copied_few), "/bucket/world.zarr", recursive=True)
    try:
        assert_same_views(nf.orthoview.open("memory://bucket/world.zarr"), nf.orthoview.open(copied_few), 11)
    finally:
        memory.rm("/bucket", recursive=True)


def test_a_missing_shard_is_named_when_a_build_resumes(copied_few: Path, few: nf.Scene) -> None:
    document = json.loads((copied_few / "zarr.json").read_text())
    document["attributes"]["nearfar"]["complete"] = False
    (copied_few / "zarr.json").write_text(json.dumps(document))
    for record in (copied_few / "nearfar" / "done").glob("1_*.json"):
        record.unlink()
    shutil.rmtree(copied_few / "2" / "py")
    with pytest.raises(nf.FormatError, match="damaged orthoviews: the shard is gone"):
        nf.orthoview.build(few, copied_few, cell=CELL, size=SIZE, directions=5)


def test_lost_shards_are_detected(copied_few: Path, tmp_path: Path) -> None:
    """Copies check the previous files; readers of a generation know its files."""
    first = nf.orthoview.open(copied_few)
    updated = first.update(box_about([2]), world_of(range(9)))
    overlay = copied_few / "nearfar" / "generations" / "1"
    lost = largest(overlay / "0")
    content = lost.read_bytes()
    lost.unlink()
    _, name, _, *shard = lost.relative_to(overlay).parts[:6]
    index = np.frombuffer(content[-4 - 8**3 * 16 : -4], "<u8").reshape(8, 8, 8, 2)
    held = next(place for place in places((8, 8, 8)) if 0 < index[(*place, 1)] < 2**63)
    x, y, z = (8 * int(number) + at for number, at in zip(shard, held, strict=True))
    again = nf.orthoview.open(copied_few)
    direction = again._layout.names.index(name)
    with pytest.raises(nf.FormatError, match="the shard is gone"):
        again.view(0, (x, y, z), direction)
    lost.write_bytes(content)
    shutil.rmtree(copied_few / "0" / "py")
    with pytest.raises(nf.FormatError, match="is gone"):
        updated.compact(tmp_path / "compact.zarr")
    assert not (tmp_path / "compact.zarr").exists()


@pytest.mark.parametrize("path", ["geometry/images/../../../x.webp", "0/py/c/0/../0/0", "/elsewhere/x"])
def test_records_cannot_refer_outside_the_store(bare: Path, tmp_path: Path, path: str) -> None:
    records = bare / "nearfar" / "records.json"
    document = json.loads(records.read_text())
    document["geometry"][path] = [1, "0" * 64]
    records.write_text(json.dumps(document))
    tree = nf.orthoview.open(bare)
    for call in (tree.verify, lambda: tree.compact(tmp_path / "compact.zarr")):
        with pytest.raises(nf.FormatError, match="does not belong in a store"):
            call()
    assert not (tmp_path / "compact.zarr").exists()


def test_copies_replace_nothing(few_tree: nf.orthoview.OrthoTree, copied_few: Path, tmp_path: Path) -> None:
    with pytest.raises(FileExistsError, match="holds a Zarr store"):
        few_tree.compact(copied_few)
    (tmp_path / "other").mkdir()
    (tmp_path / "other" / "mine").touch()
    with pytest.raises(FileExistsError, match="holds other files"):
        few_tree.compact(tmp_path / "other")
    (tmp_path / "empty").mkdir()
    compacted = few_tree.compact(tmp_path / "empty")
    assert contents(Path(compacted.path)) == contents(Path(few_tree.path))
    shard = largest(Path(few_tree.path) / "0")
    assert (Path(compacted.path) / shard.relative_to(few_tree.path)).samefile(shard)


def test_a_store_created_meanwhile_is_not_replaced(
    few: nf.Scene, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two builds begin at the same time: the later one finds the other's store."""
    path, create = tmp_path / "world.zarr", Layout.create
    settings: dict[str, Any] = {"cell": 40.0, "size": SIZE, "directions": 5}

    def slow(self: Layout, folder: Path, attributes: dict[str, Any]) -> None:
        create(self, folder, attributes)
        monkeypatch.setattr(Layout, "create", create)
        nf.orthoview.build(few, path, **settings)

    monkeypatch.setattr(Layout, "create", slow)
    source = Counted(few)
    assert nf.orthoview.build(source, path, **settings).is_complete
    assert source.queries == 0


IMPOSSIBLE: dict[str, tuple[Any, ...]] = {
    "counts": ([1.5, 1, 1], [0, 0, 0]),
    "origin": ([None, 0, 0],),
    "cell": ("1", -1),
    "directions": ([[1, 2, 3]],),
    "layers": (7,),
    "color": ("jpg",),
    "size": (30,),
    "names": ([],),
    "subtree": (None,),
}


@pytest.mark.parametrize(("name", "value"), [(name, value) for name in IMPOSSIBLE for value in IMPOSSIBLE[name]])
def test_impossible_layouts_are_refused(bare: Path, few: nf.Scene, name: str, value: Any) -> None:
    document = json.loads((bare / "zarr.json").read_text())
    document["attributes"]["nearfar"]["layout"][name] = value
    (bare / "zarr.json").write_text(json.dumps(document))
    with pytest.raises(nf.FormatError, match=r"zarr\.json"):
        nf.orthoview.open(bare)
    with pytest.raises(nf.FormatError, match=r"zarr\.json"):
        nf.orthoview.build(few, bare, cell=CELL, size=SIZE, directions="auto")
