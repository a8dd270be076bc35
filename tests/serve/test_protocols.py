"""HTTP/1.1 and 2, certificates, compression, CORS, several sites, metrics and the log."""

from __future__ import annotations

import gzip
import json
import ssl
import stat
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

import nearfar as nf
from nearfar.serve._limits import Limits
from nearfar.serve._server import Certificate, Server
from nearfar.serve._site import Site
from tests.support.asking import get, request


@pytest.fixture(scope="module")
def certificate(tmp_path_factory: pytest.TempPathFactory) -> Certificate:
    return Certificate.self_signed(tmp_path_factory.mktemp("tls"), ["localhost", "127.0.0.1"])


@pytest.fixture(scope="module")
def encrypted(place: Path, certificate: Certificate) -> Iterator[Server]:
    with Server({"": Site.of_bundle(place)}, certificate=certificate) as server:
        yield server


def client(certificate: Certificate, **settings: Any) -> httpx.Client:
    """A client that trusts only the given certificate."""
    trusted = ssl.create_default_context(cafile=str(certificate.certificate))
    return httpx.Client(verify=trusted, timeout=60, **settings)


@pytest.mark.parametrize("version", ["HTTP/1.1", "HTTP/2"])
def test_encrypted_connections_serve_all_files(
    encrypted: Server, certificate: Certificate, place: Path, version: str
) -> None:
    with client(certificate, http2=version == "HTTP/2") as asking:
        for name in (*nf.stream.open(place).files, "tileset.json"):
            answer = asking.get(encrypted.url + name)
            assert (answer.status_code, answer.http_version) == (200, version)
            assert answer.content == (place / name).read_bytes()
        part = asking.get(encrypted.url + "page.js", headers={"Range": "bytes=5-9", "Accept-Encoding": "identity"})
        assert (part.status_code, len(part.content)) == (206, 5)
        assert asking.head(encrypted.url).status_code == 200
        assert asking.get(encrypted.url, headers={"Host": "evil.example"}).status_code == 403


@pytest.mark.parametrize("http2", [False, True])
def test_headers_beyond_the_limit_are_refused(encrypted: Server, certificate: Certificate, http2: bool) -> None:
    with client(certificate, http2=http2) as asking:
        # Other headers of the client take less than 1 kB.
        for count, code in ((31_000, 200), (32_768, 431), (40_000, 431), (60_000, 431)):
            answer = asking.get(f"{encrypted.url}healthz", headers={"x": "y" * count})
            assert (answer.status_code, answer.http_version) == (code, "HTTP/2" if http2 else "HTTP/1.1")


def test_a_client_that_does_not_trust_it_receives_nothing(encrypted: Server) -> None:
    with pytest.raises(httpx.ConnectError, match="certificate verify failed"):
        get(encrypted.url)
    assert get(encrypted.url, verify=False).status_code == 200


def test_plain_http_is_redirected_to_the_encrypted_address(encrypted: Server) -> None:
    plain = encrypted.url.replace("https:", "http:")
    answer = get(f"{plain}manifest.json?x=1")
    assert (answer.status_code, answer.headers["location"]) == (308, f"{encrypted.url}manifest.json?x=1")
    for host, code in (("evil.example", 403), ("a b", 400), ("", 403)):
        answer = get(plain, headers={"Host": host})
        assert answer.status_code == code
        assert "location" not in answer.headers


def test_a_certificate_is_made_once_and_its_key_is_private(tmp_path: Path) -> None:
    first = Certificate.self_signed(tmp_path / "tls", ["localhost", "192.168.1.7"])
    assert first.names == ("localhost", "192.168.1.7")
    assert 390 <= first.days < 397
    assert stat.S_IMODE(first.key.stat().st_mode) == 0o600
    again = Certificate.self_signed(tmp_path / "tls", ["localhost"])
    assert again.fingerprint == first.fingerprint
    assert Certificate.self_signed(tmp_path / "tls", ["other.example"]).fingerprint != first.fingerprint
    with pytest.raises(ValueError, match=r"names: expected names of hosts"):
        Certificate.self_signed(tmp_path / "wrong", ["ä ö"])


def test_certificates_that_cannot_be_used_are_named(tmp_path: Path, place: Path) -> None:
    made = Certificate.self_signed(tmp_path / "one", ["localhost"])
    other = Certificate.self_signed(tmp_path / "two", ["localhost"])
    with pytest.raises(ValueError, match=r"key\.pem: expected the key of"):
        Certificate(made.certificate, other.key)
    with pytest.raises(ValueError, match=r"nothing: expected a certificate in PEM"):
        Certificate(tmp_path / "nothing", made.key)
    made.certificate.write_text("half a certificate")
    with pytest.raises(ValueError, match=r"certificate\.pem: expected a certificate in PEM"):
        Server({"": Site.of_bundle(place)}, certificate=made)


def test_uncompressed_files_are_sent_uncompressed(place: Path) -> None:
    with Server({"": Site.of_bundle(place)}) as server, httpx.Client(timeout=60) as asking:
        plain = {"Accept-Encoding": "identity"}
        for name in ("page.js", "manifest.json", next(n for n in nf.stream.open(place).files if n.endswith(".glb"))):
            packed, whole = asking.get(server.url + name), asking.get(server.url + name, headers=plain)
            assert packed.content == whole.content
            assert packed.headers["content-encoding"] == "gzip"
            assert "content-encoding" not in whole.headers
            assert int(packed.headers["content-length"]) < int(whole.headers["content-length"])
            assert packed.headers["vary"] == whole.headers["vary"] == "accept-encoding"
            tags = [answer.headers["etag"] for answer in (packed, whole)]
            assert tags[0] != tags[1]
            for tag in tags:
                known = asking.get(server.url + name, headers={"If-None-Match": tag})
                assert (known.status_code, known.headers["etag"]) == (304, tag)
            part = asking.get(server.url + name, headers={"Range": "bytes=-5", "If-Range": tags[1]})
            assert (part.status_code, part.content) == (206, whole.content[-5:])
            changed = asking.get(server.url + name, headers={"Range": "bytes=-5", "If-Range": tags[0]})
            assert (changed.status_code, changed.content) == (200, whole.content)
        picture = next(name for name in nf.stream.open(place).files if name.endswith(".webp"))
        assert "content-encoding" not in asking.get(server.url + picture).headers


def test_compressed_responses_are_valid_gzip(place: Path) -> None:
    with Server({"": Site.of_bundle(place)}) as server, httpx.Client(timeout=60) as asking:
        with asking.stream("GET", server.url + "page.js", headers={"Accept-Encoding": "gzip"}) as answer:
            raw = b"".join(answer.iter_raw())
        assert gzip.decompress(raw) == asking.get(server.url + "page.js").content


def test_allowed_origins_may_read_files(place: Path) -> None:
    with Server({"": Site.of_bundle(place)}, origin="https://example.org") as server:
        answer = get(f"{server.url}manifest.json")
        assert answer.headers["access-control-allow-origin"] == "https://example.org"
        assert answer.headers["cross-origin-resource-policy"] == "cross-origin"
        before = request("OPTIONS", f"{server.url}manifest.json")
        assert (before.status_code, before.headers["access-control-allow-methods"]) == (204, "GET, HEAD")
    with Server({"": Site.of_bundle(place)}) as server:
        assert "access-control-allow-origin" not in get(server.url).headers
        assert request("OPTIONS", server.url).status_code == 405
    with pytest.raises(ValueError, match="origin: expected"):
        Server({"": Site.of_bundle(place)}, origin="a\nb")


def test_several_sites_are_listed_and_separate(place: Path, tmp_path: Path) -> None:
    other = tmp_path / "b"
    nf.stream.export(nf.datasets.room(), other, center=(1.0, 1.6, 0.2), radii=[1.5], face_size=64, samples=1)
    sites = {"one & two": Site.of_bundle(place), "b": Site.of_bundle(other)}
    with Server(sites) as server, httpx.Client(base_url=server.url, timeout=60) as asking:
        index = asking.get("/").text
        assert 'href="one%20%26%20two/"' in index
        assert "<strong>one &amp; two</strong>" in index
        assert "1 region" in index
        for name, folder in (("one%20%26%20two", place), ("b", other)):
            assert asking.get(f"/{name}/manifest.json").json() == json.loads((folder / "manifest.json").read_text())
            assert asking.get(f"/{name}/page.js").status_code == 200
            moved = asking.get(f"/{name}")
            assert (moved.status_code, moved.headers["location"]) == (308, f"/{name}/")
        own = {*nf.stream.open(other).files} - {*nf.stream.open(place).files}
        assert [asking.get(f"/one%20%26%20two/{name}").status_code for name in own] == [404] * len(own)
        assert asking.get("/c/manifest.json").status_code == 404
    for name in ("metrics", "a/b", ".."):
        with pytest.raises(ValueError, match=r"^sites: expected names"):
            Server({name: Site.of_bundle(place), "b": Site.of_bundle(other)})
    with pytest.raises(ValueError, match="one or more"):
        Server({})


def test_metrics_count_responses(place: Path) -> None:
    with Server({"": Site.of_bundle(place)}) as server, httpx.Client(base_url=server.url, timeout=60) as asking:
        for path in ("/", "/nothing", "/nothing"):
            asking.get(path)
        size = len(asking.get("/page.js", headers={"Accept-Encoding": "identity"}).content)
        counts = metrics(asking)
        assert counts['nearfar_answers_total{code="200"}'] == 2
        assert counts['nearfar_answers_total{code="404"}'] == 2
        assert counts["nearfar_answer_seconds_count"] == 4
        assert counts["nearfar_sent_bytes_total"] > size
        assert counts["nearfar_connections"] == 1
        assert asking.get("/healthz").status_code == 200


def metrics(asking: httpx.Client) -> dict[str, float]:
    answer = asking.get("/metrics")
    assert answer.headers["content-type"].startswith("application/openmetrics-text")
    # Each text differs, so no compressed copy is cached.
    assert "content-encoding" not in answer.headers
    assert answer.text.endswith("# EOF\n")
    lines = (line.rsplit(" ", 1) for line in answer.text.splitlines() if not line.startswith("#"))
    return {name: float(value) for name, value in lines}


@pytest.mark.parametrize("as_json", [True, False])
def test_the_log_records_responses(place: Path, as_json: bool) -> None:
    script = (
        "import sys, urllib.request\n"
        "from nearfar.serve._server import Server, begin_log\n"
        f"assert begin_log(as_json={as_json}) and not begin_log()\n"
        "with Server.of_bundle(sys.argv[1]) as server:\n"
        "    urllib.request.urlopen(server.url + 'tileset.json').read()\n"
        "    try: urllib.request.urlopen(server.url + '%0A%22x')\n"
        "    except OSError: pass\n"
    )
    ran = subprocess.run([sys.executable, "-c", script, place], capture_output=True, text=True, check=True)
    # Two connections are served concurrently, so their records may be in either order.
    lines = sorted((line for line in ran.stderr.splitlines() if "answered" in line), key=lambda line: "%0A" in line)
    assert len(lines) == 2
    if as_json:
        first, second = map(json.loads, lines)
        assert (first["path"], first["code"], first["method"]) == ("/tileset.json", 200, "GET")
        assert first["bytes"] == (place / "tileset.json").stat().st_size
        assert first["whole"] is True
        assert (second["path"], second["code"]) == ("/%0A%22x", 404)
    else:
        assert "tileset.json" in lines[0]
        assert "code=200" in lines[0]


def test_limits_are_checked() -> None:
    for wrong in ({"connections": 0}, {"header_seconds": 0}, {"header_bytes": 10}, {"grace_seconds": float("nan")}):
        with pytest.raises(ValueError, match=rf"^{next(iter(wrong))}: expected"):
            Limits(**wrong)
    for host in ("nowhere.example", "1.2.3", ""):
        with pytest.raises(ValueError, match=r"^host: expected"):
            Server({"": Site({}, has_page=True)}, host=host)
    with pytest.raises(OSError, match="choose another address"):
        Server({"": Site({}, has_page=True)}, host="192.0.2.77")
