"""`nearfar serve`: it serves bundles and scenes until it is stopped, and names unusable arguments."""

from __future__ import annotations

import json
import signal
from pathlib import Path

import pytest
from typer.testing import CliRunner

from nearfar.cli._app import app
from tests.support.asking import get
from tests.support.serving import rest_of, serving


@pytest.fixture(autouse=True)
def _cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))


@pytest.mark.parametrize("ends", [signal.SIGINT, signal.SIGTERM])
def test_it_serves_until_it_receives_a_signal(place: Path, ends: signal.Signals) -> None:
    with serving(place, "--log", "json") as (running, url):
        assert get(f"{url}manifest.json").json() == json.loads((place / "manifest.json").read_text())
        running.send_signal(ends)
        _, log = rest_of(running)
        assert running.wait() == 0
        assert [json.loads(line)["code"] for line in log.splitlines()] == [200]


def test_it_encrypts_for_headsets(place: Path) -> None:
    with serving(f"one={place}", f"two={place}", "--self-signed", "--log", "off") as (running, url):
        assert url.startswith("https://")
        assert "two/" in get(url, verify=False).text
        assert get(f"{url}two/manifest.json", verify=False).status_code == 200
        running.terminate()
        told, log = rest_of(running)
    assert ", 396 days left, SHA-256:" in told or ", 395 days left, SHA-256:" in told
    assert log == ""


def test_regions_of_scenes_are_made_on_request(place: Path, tmp_path: Path) -> None:
    settings = ("--radii", "4,8", "--face-size", "64", "--samples", "1", "--log", "off")
    with serving("room", f"files={place}", *settings) as (running, url):
        region = get(f"{url}room/at/0.3,1.6,0.2/manifest.json").json()
        assert [ring["radius"] for ring in region["regions"][0]["rings"][1:]] == [4, 8]
        name = next(iter(region["files"]))
        assert get(f"{url}room/{name}").status_code == 200
        assert get(f"{url}files/{name}").status_code == 404
        running.terminate()
        told, _ = rest_of(running)
    assert "room is loaded: " in told
    kept = list((tmp_path / "cache" / "regions").glob("*/at/*.json"))
    assert len(kept) == 1


def test_a_scene_that_cannot_be_loaded_is_reported_and_others_are_served(place: Path, tmp_path: Path) -> None:
    broken = tmp_path / "broken.glb"
    broken.write_bytes(b"glTF but not much more")
    with serving(broken, f"files={place}", "--log", "off") as (running, url):
        assert get(f"{url}files/manifest.json").status_code == 200
        answer = get(f"{url}broken/at/0,1.7,0/manifest.json")
        assert answer.status_code == 422
        assert "broken.glb: the scene cannot be loaded: " in answer.text
        running.terminate()
        _, log = rest_of(running)
    assert "broken.glb: the scene cannot be loaded: " in log
    told = CliRunner().invoke(app, ["serve", str(broken), "--check", "--port", "0"])
    assert told.exit_code == 1


def test_served_sites_are_listed(place: Path) -> None:
    told = CliRunner().invoke(app, ["serve", f"files={place}", "room", "--check", "--port", "0"])
    assert told.exit_code == 0
    bundle, scene, loaded = told.stdout.splitlines()
    assert "/files/ can be served: 1 region, " in bundle
    assert scene.endswith("/room/ can be served: regions are made where you go")
    assert loaded.startswith("room is loaded: ")


def test_host_names_are_printed_as_addresses(place: Path) -> None:
    names = ("--name", "Example.org", "--name", "[::1]")
    with serving(place, *names, "--log", "off") as (running, url):
        port = url.rstrip("/").rpartition(":")[2]
        assert url == f"http://example.org:{port}/"
        for host, code in [("example.org", 200), ("[::1]", 200), ("localhost", 403)]:
            here = f"http://127.0.0.1:{port}/healthz"
            assert get(here, headers={"host": f"{host}:{port}"}).status_code == code
        running.terminate()
        told, _ = rest_of(running)
    assert told == f"  also http://[::1]:{port}/\n"


def test_a_folder_with_nothing_to_show_is_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    from nearfar.cli._app import run

    for command in (["serve", str(tmp_path), "--check"], ["view", str(tmp_path), "--no-browser"]):
        assert run(command) == 1
        assert f"{tmp_path}: expected a folder that `nearfar export` or" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("arguments", "reason"),
    [
        (("--up", "z"), "--up: expected none for bundles and reduced scenes"),
        (("--radii", "5,9"), "--radii: expected none for bundles and reduced scenes"),
        (("--key", "k.pem"), "--certificate: expected --certificate and --key together"),
        (("--self-signed", "--key", "k.pem"), "--self-signed: expected no"),
        (("--certificate", "c.pem", "--key", "k.pem"), "c.pem: expected a certificate in PEM"),
        (("room",), "expected different names, got 'room' twice"),
        (("nothing",), "nothing"),
        (("healthz=room",), "sites: expected names without a slash, but not healthz, metrics, "),
        (("--origin", "https://example.org/"), "origin: expected one such as https://example.org"),
        (("--name", "example.org:443"), "names: expected names of hosts"),
    ],
)
def test_unusable_arguments_are_named(
    place: Path,
    arguments: tuple[str, ...],
    reason: str,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    from nearfar.cli._app import run

    monkeypatch.chdir(place.parent)
    assert run(["serve", str(place), *arguments, "--check", "--port", "0"]) == 1
    assert reason in capsys.readouterr().err
