"""The server of the page: it serves the page and one bundle, and nothing else."""

from __future__ import annotations

import hashlib
import json
import shutil
import socket
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support.asking import ask


@pytest.fixture(scope="module")
def server(place: Path) -> Iterator[Server]:
    with Server.of_bundle(place) as running:
        yield running


def test_the_page_and_all_files_of_the_bundle_are_served(server: Server, place: Path) -> None:
    for path, kind in [("/", "text/html"), ("/index.html", "text/html"), ("/page.js", "text/javascript")]:
        status, headers, content = ask(server, path)
        assert (status, headers["content-type"].split(";")[0]) == (200, kind)
        assert content
        assert "script-src 'self'" in headers["content-security-policy"]
    manifest = json.loads(ask(server, "/manifest.json")[2])
    assert manifest == json.loads((place / "manifest.json").read_text())
    for name, described in manifest["files"].items():
        status, headers, content = ask(server, f"/{name}")
        assert status == 200
        assert hashlib.sha256(content).hexdigest() == described["sha256"]
        assert "immutable" in headers["cache-control"]


def test_cached_files_are_not_sent_again(server: Server) -> None:
    _, headers, _ = ask(server, "/page.js")
    status, again, content = ask(server, "/page.js", **{"If-None-Match": headers["etag"]})
    assert (status, content, again["etag"]) == (304, b"", headers["etag"])
    status, head, content = ask(server, "/page.js", "HEAD")
    assert (status, content, head["content-length"]) == (200, b"", headers["content-length"])


def test_other_methods_and_other_names_of_this_machine_are_refused(server: Server) -> None:
    status, headers, _ = ask(server, "/", "POST")
    assert (status, headers["allow"]) == (405, "GET, HEAD")
    for host in ("evil.example:80", "evil.example", "127.0.0.1.evil.example", ""):
        assert ask(server, "/", Host=host)[0] == 403
    assert ask(server, "/", Host="localhost:1")[0] == 200


@pytest.mark.parametrize(
    ("asked", "part"),
    [("bytes=0-9", (0, 10)), ("bytes=-7", (-7, None)), ("bytes=5-", (5, None)), ("bytes=0-1,4-5", None)],
)
def test_byte_ranges_are_sent(server: Server, place: Path, asked: str, part: tuple[int, int | None] | None) -> None:
    name = next(name for name in nf.stream.open(place).files if name.endswith(".glb"))
    whole = (place / name).read_bytes()
    status, headers, content = ask(server, f"/{name}", Range=asked)
    if part is None:
        assert (status, content) == (200, whole)
        return
    expected = whole[slice(*part)]
    first = range(len(whole))[slice(*part)][0]
    assert (status, content) == (206, expected)
    assert headers["content-range"] == f"bytes {first}-{first + len(expected) - 1}/{len(whole)}"


def test_ranges_beyond_the_end_and_of_another_version(server: Server, place: Path) -> None:
    name = next(name for name in nf.stream.open(place).files if name.endswith(".glb"))
    whole = (place / name).read_bytes()
    status, headers, _ = ask(server, f"/{name}", Range=f"bytes={len(whole)}-")
    assert (status, headers["content-range"]) == (416, f"bytes */{len(whole)}")
    tag = ask(server, f"/{name}")[1]["etag"]
    assert ask(server, f"/{name}", **{"Range": "bytes=0-3", "If-Range": tag})[0] == 206
    for other in ('"other"', f"W/{tag}", "*", f'"other", {tag}'):
        assert ask(server, f"/{name}", **{"Range": "bytes=0-3", "If-Range": other})[0] == 200


def test_vanished_or_malformed_clients_do_not_disturb_others(server: Server) -> None:
    port = urlsplit(server.url).port or 0
    nonsense = [
        b"",
        b"GET",
        b"GET / HTTP/1.1\r\nHost: ",
        b"\x00\xff" * 50,
        b"GET /%zz%00 HTTP/1.1\r\nHost: localhost\r\n\r\n",
    ]
    for text in [*nonsense, b"GET / HTTP/1.1\r\n" + b"X: y\r\n" * 10_000]:
        with socket.create_connection(("127.0.0.1", port), timeout=60) as line, suppress(OSError):
            line.sendall(text)
    assert ask(server, "/")[0] == 200


def test_a_removed_file_is_missing(place: Path, tmp_path: Path) -> None:
    folder = tmp_path / "copy"
    folder.mkdir()
    (folder / "files").mkdir()
    for file in place.rglob("*.*"):
        (folder / file.relative_to(place)).write_bytes(file.read_bytes())
    with Server.of_bundle(folder) as server:
        name = next(iter(nf.stream.open(folder).files))
        (folder / name).unlink()
        assert ask(server, f"/{name}")[0] == 404
        assert ask(server, "/")[0] == 200


def test_links_and_files_of_another_size_are_not_served(place: Path, tmp_path: Path) -> None:
    folder = tmp_path / "copy"
    shutil.copytree(place, folder)
    linked, longer = sorted(nf.stream.open(folder).files)[:2]
    outside = tmp_path / "outside"
    outside.write_bytes((folder / linked).read_bytes())
    with Server.of_bundle(folder) as server:
        (folder / linked).unlink()
        (folder / linked).symlink_to(outside)
        (folder / longer).write_bytes((folder / longer).read_bytes() + b"more")
        assert [ask(server, f"/{name}")[0] for name in (linked, longer)] == [404, 404]
    linked_folder = tmp_path / "linked"
    linked_folder.mkdir()
    for name in ("manifest.json", "tileset.json"):
        shutil.copy(place / name, linked_folder)
    (linked_folder / "files").symlink_to(place / "files")
    with pytest.raises(ValueError, match="expected a folder of the bundle, got a link"):
        Server.of_bundle(linked_folder)


def test_a_port_in_use_is_named(server: Server, place: Path) -> None:
    port = urlsplit(server.url).port
    with pytest.raises(OSError, match="choose another port") as caught:
        Server.of_bundle(place, port=port or 0)
    assert str(port) in str(caught.value)
    with pytest.raises(OSError, match="manifest"):
        Server.of_bundle(place.parent / "nothing")


def test_the_page_beside_a_bundle_works_with_any_server(place: Path, tmp_path: Path) -> None:
    scene, folder = nf.datasets.room(), tmp_path / "bundle"
    settings: dict[str, Any] = {"center": (0.3, 1.6, 0.2), "radii": [1.5, 3.0], "face_size": 64, "samples": 1}
    nf.stream.export(scene, folder, **settings)
    nf.view.write_page(folder)
    index = (folder / "index.html").read_text()
    for name in ("page.js", "page.css"):
        assert name in index
        assert (folder / name).stat().st_size > 0
    nf.stream.open(folder).verify()
    # The page does not prevent a later export into its folder.
    nf.stream.export(scene, folder, **settings)
    with pytest.raises(FileNotFoundError):
        nf.view.write_page(tmp_path)
