"""The page of a store: served by nearfar's own server, and written for other servers."""

from __future__ import annotations

import gzip
import urllib.error
import urllib.request
from pathlib import Path

import pytest

import nearfar as nf
from nearfar.serve._server import Server
from nearfar.view._tree import tree_page
from tests.support.cli_cases import command


def get(url: str, **headers: str) -> tuple[int, bytes]:
    with urllib.request.urlopen(urllib.request.Request(url, headers=headers), timeout=60) as answer:
        content = answer.read()
        is_packed = answer.headers.get("content-encoding") == "gzip"
        return answer.status, gzip.decompress(content) if is_packed else content


def test_all_files_that_the_page_reads_are_served(copied_few: Path) -> None:
    tree = nf.orthoview.open(copied_few)
    tree.update(tree.bounds - [[0, 0, 0], tree.bounds[1] - tree.bounds[0] - 5], nf.datasets.city(blocks=1, detail=0))
    shards = [path for path in copied_few.rglob("*") if path.is_file() and "c" in path.relative_to(copied_few).parts]
    patterns = ("zarr.json", "nearfar/records.json", "nearfar/done/*.json", "nearfar/generations/1/generation.json")
    documents = [path for pattern in patterns for path in copied_few.glob(pattern)]
    assert len(documents) > len(patterns)
    leaves = [path for path in copied_few.rglob("*.glb") if path.stat().st_size > 0]
    assert len(leaves) > 3
    with Server.of_bundle(copied_few) as server:
        for path in (*documents, *shards):
            name = path.relative_to(copied_few).as_posix()
            # Compressed copies belong to the right file, although all shards have the same file name.
            assert get(server.url + name, **{"Accept-Encoding": "gzip"}) == (200, path.read_bytes())
        for path in leaves:
            # Requests like the page's.
            part = f"bytes=0-{path.stat().st_size - 1}"
            assert get(server.url + path.relative_to(copied_few).as_posix(), Range=part) == (206, path.read_bytes())
        name = shards[0].relative_to(copied_few).as_posix()
        assert get(f"{server.url}{name}?v=1", Range="bytes=3-9") == (206, shards[0].read_bytes()[3:10])
        for name, content in tree_page().items():
            assert get(server.url + name) == (200, content)
        assert get(server.url) == (200, tree_page()["index.html"])
        with pytest.raises(urllib.error.HTTPError, match="404"):
            get(f"{server.url}geometry/tileset.json")
    assert any("generations" in path.parts for path in shards)


def test_the_page_is_written_into_a_store(copied_few: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = nf.orthoview.open(copied_few).verify()
    assert command(capsys, "view", copied_few, "--write")[0] == 0
    assert {name: (copied_few / name).read_bytes() for name in tree_page()} == tree_page()
    assert nf.orthoview.open(copied_few).verify() == before


def test_stores_that_cannot_be_shown_are_refused(copied_few: Path, tmp_path: Path) -> None:
    (tmp_path / "zarr.json").write_text('{"node_type": "group", "attributes": {}}')
    with pytest.raises(FileNotFoundError, match="store of orthoviews"):
        Server.of_bundle(tmp_path)
    record = next((copied_few / "nearfar" / "done").glob("*.json"))
    record.write_text(record.read_text() + " ")
    with pytest.raises(nf.FormatError, match=record.name):
        Server.of_bundle(copied_few)
