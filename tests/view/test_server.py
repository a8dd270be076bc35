"""The server of the page: it answers with the page and one bundle, and with nothing else."""

from __future__ import annotations

import hashlib
import http.client
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

import nearfar as nf
from nearfar.view._server import Server


@pytest.fixture(scope="module")
def place(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("view") / "bundle"
    nf.stream.export(nf.datasets.room(), folder, center=(0.3, 1.6, 0.2), radii=[1.5, 3.0], face_size=64, samples=1)
    return folder


@pytest.fixture(scope="module")
def server(place: Path) -> Iterator[Server]:
    with Server(place) as running:
        yield running


def ask(server: Server, path: str, method: str = "GET", **headers: str) -> tuple[int, dict[str, str], bytes]:
    """Status, headers and content of an answer; the path is sent as it is."""
    connection = http.client.HTTPConnection(urlsplit(server.url).netloc, timeout=60)
    try:
        connection.request(method, path, headers=headers)
        answer = connection.getresponse()
        return answer.status, dict(answer.getheaders()), answer.read()
    finally:
        connection.close()


def test_the_page_and_all_files_of_the_bundle_are_served(server: Server, place: Path) -> None:
    for path, kind in [("/", "text/html"), ("/index.html", "text/html"), ("/page.js", "text/javascript")]:
        status, headers, content = ask(server, path)
        assert (status, headers["Content-Type"].split(";")[0]) == (200, kind)
        assert content
        assert "script-src 'self'" in headers["Content-Security-Policy"]
    manifest = json.loads(ask(server, "/manifest.json")[2])
    assert manifest == json.loads((place / "manifest.json").read_text())
    for name, described in manifest["files"].items():
        status, headers, content = ask(server, f"/{name}")
        assert status == 200
        assert hashlib.sha256(content).hexdigest() == described["sha256"]
        assert "immutable" in headers["Cache-Control"]


def test_what_a_browser_has_is_not_sent_again(server: Server) -> None:
    _, headers, _ = ask(server, "/page.js")
    status, again, content = ask(server, "/page.js", **{"If-None-Match": headers["ETag"]})
    assert (status, content, again["ETag"]) == (304, b"", headers["ETag"])
    status, head, content = ask(server, "/page.js", "HEAD")
    assert (status, content, head["Content-Length"]) == (200, b"", headers["Content-Length"])


@pytest.mark.parametrize(
    "path",
    ["/files/../manifest.json", "/../../etc/passwd", "/files/%2e%2e/%2e%2e/secret", "//etc/passwd", "/files/", "/x"],
)
def test_nothing_else_is_served(server: Server, place: Path, path: str) -> None:
    (place.parent / "secret").write_text("secret")
    status, _, content = ask(server, path)
    assert status == 404
    assert b"secret" not in content


def test_other_methods_and_other_names_of_this_machine_are_refused(server: Server) -> None:
    assert ask(server, "/", "POST")[0] == 501
    status, _, content = ask(server, "/", Host="evil.example:80")
    assert status == 403
    assert server.url.encode() in content


def test_a_file_that_goes_is_missing(place: Path, tmp_path: Path) -> None:
    folder = tmp_path / "copy"
    folder.mkdir()
    (folder / "files").mkdir()
    for file in place.rglob("*.*"):
        (folder / file.relative_to(place)).write_bytes(file.read_bytes())
    with Server(folder) as server:
        name = next(iter(nf.stream.open(folder).files))
        (folder / name).unlink()
        assert ask(server, f"/{name}")[0] == 404
        assert ask(server, "/")[0] == 200


def test_a_port_that_is_taken_is_named(server: Server, place: Path) -> None:
    port = urlsplit(server.url).port
    with pytest.raises(OSError, match="choose another port") as caught:
        Server(place, port=port or 0)
    assert str(port) in str(caught.value)
    with pytest.raises(ValueError, match=r"^port: expected"):
        Server(place, port=70_000)
    with pytest.raises(OSError, match="manifest"):
        Server(place.parent / "nothing")


def test_the_page_beside_a_bundle_needs_no_server_of_ours(place: Path, tmp_path: Path) -> None:
    scene, folder = nf.datasets.room(), tmp_path / "bundle"
    settings: dict[str, Any] = {"center": (0.3, 1.6, 0.2), "radii": [1.5, 3.0], "face_size": 64, "samples": 1}
    nf.stream.export(scene, folder, **settings)
    nf.view.write_page(folder)
    index = (folder / "index.html").read_text()
    for name in ("page.js", "page.css"):
        assert name in index
        assert (folder / name).stat().st_size > 0
    nf.stream.open(folder).verify()
    # The page does not keep a later export from its folder.
    nf.stream.export(scene, folder, **settings)
    with pytest.raises(FileNotFoundError):
        nf.view.write_page(tmp_path)
