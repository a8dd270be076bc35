"""A server that makes regions of a scene on request."""

from __future__ import annotations

import http.client
import json
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest

import nearfar as nf
from nearfar.serve._server import Server
from nearfar.serve._site import LoadedScene, Site
from tests.support.asking import ask

SETTINGS: dict[str, Any] = {"grid": 2.0, "radii": (10.0, 22.0), "face_size": 576, "samples": 1}

QUICK = SETTINGS | {"face_size": 64}


@pytest.fixture(scope="module")
def scene() -> nf.Scene:
    return nf.datasets.city(blocks=3, detail=0)


@pytest.fixture(scope="module")
def server(scene: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Server]:
    cache = tmp_path_factory.mktemp("regions")
    with Server({"city": Site.of_scene(LoadedScene(lambda: scene, **SETTINGS), cache)}) as running:
        yield running


def parts(server: Server, place: str, source: str = "127.0.0.1") -> list[dict[str, Any]]:
    status, _, content = ask(server, f"/city/at/{place}/parts", source=source)
    assert status == 200
    return [json.loads(line) for line in content.splitlines()]


def test_announced_parts_have_files(server: Server) -> None:
    told = [line for line in parts(server, "3.3,1.7,-2.2") if line["event"] != "waiting"]
    assert [(line["event"], line.get("ring")) for line in told] == [
        *[("begin", None), ("ring", 0), ("ring", 1), ("ring", 2)] * 2,
        ("end", None),
    ]
    whole = json.loads(ask(server, "/city/at/4,1.75,-2/manifest.json")[2])
    # Coarse maps remain available for slow clients even when full ones exist.
    coarse = {name: entry for line in told if line.get("stage") == 0 for name, entry in line["files"].items()}
    assert coarse.keys() - whole["files"].keys()
    for name, described in {**coarse, **whole["files"]}.items():
        status, _, content = ask(server, f"/city/{name}")
        assert (status, len(content)) == (200, described["bytes"])


def test_a_place_is_a_bundle(server: Server, scene: nf.Scene, tmp_path: Path) -> None:
    still = scene.subset(objects=[name for name in scene.object_names if name not in scene.poses])
    with Server({"": Site.of_scene(LoadedScene(lambda: still, **QUICK), None)}) as alone:
        found = nf.stream.open(f"{alone.url}at/3.3,1.75,-2.2")
        found.verify()
        expected = nf.stream.export(still, tmp_path / "out", center=(3.3, 1.75, -2.2), **QUICK)
        assert found.files == expected.files
        # Requested again, from memory; the page shows it from the same address.
        assert nf.stream.open(f"{alone.url}at/4,1.7,-2").files == expected.files
        assert ask(alone, "/")[0] == 200
    with Server({"": Site.of_scene(LoadedScene(lambda: still, **QUICK), tmp_path / "cache")}) as alone:
        # The first response while it is made, then from disk.
        for _ in range(2):
            nf.stream.open(f"{alone.url}at/4,1.75,-2").verify()


def test_complete_regions_are_kept_on_disk(scene: nf.Scene, tmp_path: Path) -> None:
    site = Site.of_scene(LoadedScene(lambda: scene, **QUICK), tmp_path / "cache")
    with Server({"city": site}) as server:
        assert parts(server, "0,1.75,0")[-1]["event"] == "end"
        (whole,) = parts(server, "0.4,1.75,0.3")
    with Server({"city": site}) as server:
        assert parts(server, "0,1.75,0") == [whole]
        assert whole["event"] == "whole"
        name = next(iter(whole["manifest"]["files"]))
        # One byte of it changes while the server is stopped.
    path = tmp_path / "cache" / name
    path.write_bytes(bytes([path.read_bytes()[0] ^ 1]) + path.read_bytes()[1:])
    with Server({"city": site}) as server:
        again = parts(server, "0,1.75,0")
        assert again[-1]["event"] == "end"
        assert parts(server, "0,1.75,0") == [whole]


def test_concurrent_clients_receive_the_same(server: Server) -> None:
    found: list[list[dict[str, Any]]] = []
    threads = [
        threading.Thread(target=lambda name=name: found.append(parts(server, "-6,1.75,8", f"127.0.0.{name}")))
        for name in (1, 2, 3)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    lines = [[line for line in each if line["event"] != "waiting"] for each in found]
    assert len(lines) == 3
    assert {each[-1]["event"] for each in lines} <= {"end", "whole"}
    assert all(each == lines[0] for each in lines if each[-1]["event"] == "end")


@pytest.mark.parametrize(
    ("path", "status"),
    [
        ("/city/at/nan,0,0/parts", 400),
        ("/city/at/1,2/manifest.json", 400),
        ("/city/at/1,2,3/secret", 404),
        ("/city/at/../../etc/passwd", 400),
        ("/city/files/../at/4,1.75,-2.json", 404),
        ("/city/files/%2e%2e%2fat", 404),
        ("/city/files/x%00.glb", 404),
        ("/other/at/1,2,3/parts", 404),
    ],
)
def test_other_paths_are_refused(server: Server, path: str, status: int) -> None:
    assert ask(server, path)[0] == status


def test_a_place_that_cannot_be_made_is_reported_in_a_sentence(scene: nf.Scene) -> None:
    settings = {name: value for name, value in QUICK.items() if name != "radii"}
    with Server({"": Site.of_scene(LoadedScene(lambda: scene, **settings), None)}) as server:
        status, _, content = ask(server, "/at/90000,1.75,0/parts")
        assert status == 200
        told = [json.loads(line) for line in content.splitlines()][-1]
        assert told["event"] == "failed"
        assert told["reason"].startswith("center: expected a place with objects around it")
        assert ask(server, "/at/90000,1.75,0/manifest.json")[0] == 422
        assert ask(server, "/at/0,1.75,0/manifest.json")[0] == 200


def test_a_client_may_wait_for_a_few_places_only(scene: nf.Scene) -> None:
    loaded = LoadedScene(lambda: scene, **{**SETTINGS, "face_size": 4096, "samples": 64})
    with Server({"": Site.of_scene(loaded, None)}) as server:
        lines = [http.client.HTTPConnection(urlsplit(server.url).netloc, timeout=300) for _ in range(6)]
        for number, line in enumerate(lines):
            line.request("GET", f"/at/{10 * number},1.75,0/parts")
        # Connections are served concurrently.
        assert sorted(line.getresponse().status for line in lines) == [200] * 4 + [429] * 2
        # Other clients are served meanwhile.
        assert ask(server, "/", source="127.0.0.2")[0] == 200
        for line in lines:
            line.close()
