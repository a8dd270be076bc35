"""Bundles behind a web server: read file by file, from any path, with server failures."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import nearfar as nf
from tests.support import bundle_cases, need
from tests.support.range_server import RangeHandler, serve_folder

NAMES = ("city", "ein Dörfchen 50 %")


class Failing(RangeHandler):
    """Serves a folder, with failures on request."""

    def do_GET(self) -> None:  # noqa: N802 - the base class's name
        if self.path.startswith("/busy/"):
            self.send_error(503)
        elif self.path.startswith("/short/"):
            self.send_response(200)
            self.send_header("Content-Length", "1000")
            self.end_headers()
            self.wfile.write(b'{"format": ')
            self.close_connection = True
        else:
            super().do_GET()


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("web")
    for name in NAMES:
        bundle_cases.write(path / name)
    return path


@pytest.fixture
def url(folder: Path) -> Iterator[str]:
    need("fsspec")
    need("aiohttp")
    with serve_folder(folder, Failing) as server:
        yield server.url.rstrip("/")


@pytest.mark.parametrize("place", ["city", "ein Dörfchen 50 %/", "ein%20D%C3%B6rfchen%2050%20%25/manifest.json"])
def test_served_bundles_equal_written_ones(url: str, folder: Path, place: str) -> None:
    bundle, local = nf.stream.open(f"{url}/{place}"), nf.stream.open(folder / NAMES[0])
    assert bundle.files == local.files
    bundle.verify()
    np.testing.assert_array_equal(bundle.map(2).color, local.map(2).color)
    assert bundle.at(2).triangle_count == local.at(2).triangle_count


def test_a_server_that_fails_is_an_error_that_names_the_file(url: str, folder: Path) -> None:
    with pytest.raises(FileNotFoundError, match=f"{url}/none/manifest.json"):
        nf.stream.open(f"{url}/none")
    for place, text in (("busy", "503"), ("short", "cannot be read")):
        with pytest.raises(OSError, match=f"{text}.*{url}/{place}/manifest.json"):
            nf.stream.open(f"{url}/{place}")
    (folder / "cut" / "files").mkdir(parents=True)
    for path in (folder / NAMES[0]).rglob("*.*"):
        data = path.read_bytes()
        (folder / "cut" / path.relative_to(folder / NAMES[0])).write_bytes(data[:-1] if path.suffix == ".glb" else data)
    cut = nf.stream.open(f"{url}/cut")
    for use in (cut.verify, lambda: cut.at(1)):
        with pytest.raises(nf.FormatError, match=rf"{url}/cut/files/\w+\.glb: expected bytes = \d+"):
            use()
    with serve_folder(folder) as gone:
        pass
    with pytest.raises(ConnectionRefusedError, match=f"cannot be read.*{gone.url}{NAMES[0]}/manifest.json"):
        nf.stream.open(f"{gone.url}{NAMES[0]}")
