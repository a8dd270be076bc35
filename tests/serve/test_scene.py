"""The site of a scene: its document for the page while the scene is loading, loaded, or failed."""

from __future__ import annotations

import json
import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from nearfar._trace import viewpoint
from nearfar.serve._server import Server
from nearfar.serve._site import LoadedScene, Site
from tests.support import valid
from tests.support.asking import ask

SETTINGS: dict[str, Any] = {"grid": 2.0, "radii": (4.0, 8.0), "face_size": 64, "samples": 1}


def document(server: Server, site: str = "") -> dict[str, Any]:
    """The document about a scene that the page reads."""
    manifest = json.loads(ask(server, f"{site}/manifest.json")[2])
    assert valid(manifest, "on_demand")
    found: dict[str, Any] = json.loads(ask(server, f"{site}/{manifest['scene']}")[2])
    assert valid(found, "scene")
    return found


def last_line(server: Server, path: str) -> dict[str, Any]:
    """The last line of a region's response."""
    status, _, content = ask(server, path)
    assert status == 200
    return dict(json.loads(content.splitlines()[-1]))


@pytest.fixture(scope="module")
def room() -> nf.Scene:
    return nf.datasets.room()


def test_a_scene_is_described(room: nf.Scene) -> None:
    with Server({"": Site.of_scene(LoadedScene(lambda: room, **SETTINGS), None)}) as server:
        found = document(server)
        assert ask(server, "/")[1]["content-type"].startswith("text/html")
    assert found["triangles"] == room.triangle_count
    assert found["objects"] == len(room.object_names)
    assert np.allclose(found["bounds"], room.bounds)
    chosen = viewpoint.find(room)
    assert found["start"]["position"] == list(chosen.eye)
    yaw = found["start"]["yaw"]
    assert np.allclose((-np.sin(yaw), 0, -np.cos(yaw)), chosen.forward)


def test_requests_before_the_scene_is_loaded_wait(room: nf.Scene) -> None:
    may_load = threading.Event()

    def load() -> nf.Scene:
        assert may_load.wait(60)
        return room

    scene = LoadedScene(load, title="a room", start=lambda _: viewpoint.facing((1, 2, 3), (1, 2, 0)), **SETTINGS)
    answers: list[Any] = []
    with Server(
        {"late": Site.of_scene(scene, None), "there": Site.of_scene(LoadedScene(lambda: room, **SETTINGS), None)}
    ) as server:
        asked = [
            threading.Thread(target=lambda: answers.append(document(server, "/late"))),
            threading.Thread(target=lambda: answers.append(last_line(server, "/late/at/0,1.5,0/parts"))),
        ]
        for thread in asked:
            thread.start()
        # The page and other sites are served meanwhile.
        assert ask(server, "/late/")[0] == 200
        assert last_line(server, "/there/at/0,1.5,0/parts")["event"] == "end"
        assert answers == []
        may_load.set()
        for thread in asked:
            thread.join(60)
    assert {answer.get("event", "described") for answer in answers} == {"end", "described"}
    (found,) = (answer for answer in answers if "start" in answer)
    assert found["start"] == {"position": [1, 2, 3], "yaw": 0}


def test_a_scene_that_cannot_be_loaded_is_reported_in_a_sentence(room: nf.Scene, tmp_path: Path) -> None:
    (tmp_path / "broken.glb").write_bytes(b"glTF, but not really")
    sites = {
        "broken": Site.of_scene(LoadedScene.of_file(tmp_path / "broken.glb", **SETTINGS), None),
        "gone": Site.of_scene(LoadedScene.of_file(tmp_path / "gone.glb", **SETTINGS), None),
        "there": Site.of_scene(LoadedScene(lambda: room, **SETTINGS), None),
    }
    with Server(sites) as server:
        for name in ("broken", "gone"):
            reason = f"{name}.glb: the scene cannot be loaded: "
            assert document(server, f"/{name}")["failed"].startswith(reason)
            last = last_line(server, f"/{name}/at/0,1.5,0/parts")
            assert last["event"] == "failed"
            assert last["reason"].startswith(reason)
            status, _, content = ask(server, f"/{name}/at/0,1.5,0/manifest.json")
            assert status == 422
            assert reason in content.decode()
        assert last_line(server, "/there/at/0,1.5,0/parts")["event"] == "end"


def test_settings_are_checked_before_the_scene_is_loaded() -> None:
    with pytest.raises(ValueError, match="face_size"):
        LoadedScene(nf.datasets.room, **{**SETTINGS, "face_size": 100})
    with pytest.raises(TypeError, match="title"):
        LoadedScene(nf.datasets.room, title=3, **SETTINGS)  # type: ignore[arg-type]


def boxes(path: Path) -> None:
    """Write a floor with boxes."""
    import trimesh

    made = trimesh.Scene()
    for x, z, size in [(0, 0, 20), (3, -3, 1), (-4, 2, 1), (6, 5, 2)]:
        box = trimesh.creation.box((size, 0.1 if size == 20 else size, size))
        made.add_geometry(box.apply_translation((x, 0 if size == 20 else size / 2, z)))
    made.export(path)


def test_a_file_is_served_and_cached_by_content(tmp_path: Path, monkeypatch: Any) -> None:
    monkeypatch.setenv("NEARFAR_CACHE", str(tmp_path / "cache"))
    path = tmp_path / "boxes.glb"
    boxes(path)
    scene = LoadedScene.of_file(path, **SETTINGS)
    folder = scene.cache_folder()
    assert folder is not None
    assert folder.parent == tmp_path / "cache" / "regions"
    with Server({"": Site.of_scene(scene, folder)}) as server:
        assert json.loads(ask(server, "/manifest.json")[2])["title"] == "boxes.glb"
        assert last_line(server, "/at/0,1.5,0/parts")["event"] == "end"
    with Server({"": Site.of_scene(LoadedScene.of_file(path, **SETTINGS), folder)}) as server:
        assert last_line(server, "/at/0,1.5,0/parts")["event"] == "whole"
    assert LoadedScene.of_file(path, **SETTINGS).cache_folder() == folder
    assert LoadedScene.of_file(path, **{**SETTINGS, "samples": 2}).cache_folder() != folder
    assert LoadedScene.of_file(path, nf.LoadOptions(up="z"), **SETTINGS).cache_folder() != folder
    path.write_bytes(path.read_bytes() + b" ")
    assert LoadedScene.of_file(path, **SETTINGS).cache_folder() != folder
    assert LoadedScene.of_file(tmp_path / "none.glb", **SETTINGS).cache_folder() is None
    assert LoadedScene(nf.datasets.room, **SETTINGS).cache_folder() is None


@pytest.mark.parametrize("kind", ["gltf", "obj"])
def test_referenced_files_are_part_of_the_cache_key(kind: str, tmp_path: Path) -> None:
    path = tmp_path / f"scene.{kind}"
    if kind == "gltf":
        path.write_text(
            json.dumps({"buffers": [{"uri": "a%20b.bin"}], "images": [{"uri": "data:,"}, {"uri": "c.png"}]})
        )
        others = ["a b.bin", "c.png"]
    else:
        path.write_text("# a scene\nmtllib m.mtl\nv 0 0 0\n")
        (tmp_path / "m.mtl").write_text("newmtl one\n  map_Kd -s 1 1 1 c.png\n")
        others = ["m.mtl", "c.png"]
    seen = set()
    for name in others:
        seen.add(LoadedScene.of_file(path, **SETTINGS).cache_folder())
        with (tmp_path / name).open("ab") as file:
            file.write(b"\n# more\n")
    (tmp_path / "another.png").write_bytes(b"not referred to")
    last = LoadedScene.of_file(path, **SETTINGS).cache_folder()
    assert len({*seen, last}) == 3
    (tmp_path / "another.png").write_bytes(b"still not")
    assert LoadedScene.of_file(path, **SETTINGS).cache_folder() == last
