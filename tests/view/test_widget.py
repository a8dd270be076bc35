"""The view in notebooks without a browser: its camera, its messages, and its refusals."""

from __future__ import annotations

import base64
import importlib.util
import io
import json
import math
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support import need

need("anywidget")

CENTER = (0.3, 1.6, 0.2)
FOV = nf.Fov.symmetric(90, 1.6)
SIZE = (64, 40)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory: pytest.TempPathFactory) -> nf.stream.Bundle:
    folder = tmp_path_factory.mktemp("view") / "bundle"
    centers = [CENTER, (1.3, 1.6, 0.2)]
    return nf.stream.export(nf.datasets.room(), folder, center=centers, radii=[1.5, 3.0], face_size=64, samples=1)


@pytest.fixture
def view(bundle: nf.stream.Bundle) -> Any:
    """A view, whose messages to the browser are in its list `sent`."""
    view: Any = bundle.show(size=SIZE)
    view.sent = []
    view.send = lambda content, buffers=(): view.sent.append((content, list(buffers)))
    return view


def ask(view: Any, **message: Any) -> tuple[dict[str, Any], list[bytes]]:
    view._answer(view, {"kind": "read", "id": "7", **message}, [])
    answer: tuple[dict[str, Any], list[bytes]] = view.sent.pop()
    return answer


@pytest.mark.parametrize("target", [(3, 2, -4), (-3, 1, 5), (0.3, 1.6, 9), (8, 9, 0), (-2, -9, 0.2)])
def test_cameras_are_restored(view: Any, target: tuple[float, ...]) -> None:
    camera = nf.Camera.look_at((0.3, 1.6, 0.2), target, fov=FOV, size=(640, 400))
    view.camera = camera
    found = view.camera
    assert found.position == camera.position
    # A quaternion and its negative are one rotation.
    sign = math.copysign(1.0, np.dot(found.orientation, camera.orientation))
    assert np.multiply(found.orientation, sign) == pytest.approx(camera.orientation, abs=1e-12)
    assert found.fov.up == pytest.approx(FOV.up)
    assert found.fov.right == pytest.approx(FOV.up * SIZE[0] / SIZE[1])
    assert found.size == SIZE


def test_a_view_begins_at_its_regions_centre_or_a_given_position(bundle: nf.stream.Bundle) -> None:
    for number in (0, 1):
        region = bundle.region(number)
        view = region.show()
        assert view.camera.position == region.center
        assert (view.region, view.ring, view.problem) == (number, -1, "")
    camera = nf.Camera.look_at((0.5, 1.5, 0), (0.5, 1.5, -1), fov=FOV, size=SIZE)
    assert bundle.show(camera=camera).position == (0.5, 1.5, 0)


def test_a_camera_is_sent_in_one_message(view: Any) -> None:
    states: list[dict[str, Any]] = []
    view.send_state = lambda key=None: states.append({name: getattr(view, name) for name in key})
    view.camera = nf.Camera.look_at((0.5, 1.5, 0), (2, 1, -3), fov=FOV, size=SIZE)
    assert len(states) == 1
    assert set(states[0]) == {"position", "yaw", "pitch", "angle"}


def test_messages_of_the_browser_are_read(view: Any) -> None:
    view.set_state(
        {"position": [1.0, 1.6, 0.5], "yaw": 0.5, "ring": 2, "radius": 1.5, "strength": 0.25, "problem": "!"}
    )
    assert view.camera.position == (1.0, 1.6, 0.5)
    assert (view.yaw, view.ring, view.radius, view.strength, view.problem) == (0.5, 2, 1.5, 0.25, "!")


def test_files_are_sent_in_pieces(view: Any, bundle: nf.stream.Bundle, monkeypatch: pytest.MonkeyPatch) -> None:
    answer, (manifest,) = ask(view, name="manifest.json", start=0)
    assert answer == {"id": "7", "bytes": len(manifest)}
    assert set(json.loads(manifest)["files"]) == set(bundle.files)
    monkeypatch.setattr("nearfar.view._widget.PIECE_BYTES", 1000)
    for name in bundle.files[:5]:
        got = b""
        while True:
            answer, (piece,) = ask(view, name=name, start=len(got))
            got += piece
            assert 0 < len(piece) <= 1000
            if len(got) == answer["bytes"]:
                break
        assert got == bundle.read(name)


@pytest.mark.parametrize(
    "message",
    [{"name": "../manifest.json"}, {"name": "/etc/passwd"}, {"name": ["manifest.json"]}, {"start": 3}, {"name": None}]
    + [{"name": "manifest.json", "start": start} for start in (-1, 10**9, "0", None, 1.5)],
)
def test_other_files_are_refused(view: Any, message: dict[str, Any]) -> None:
    answer, buffers = ask(view, **message)
    assert set(answer) == {"id", "problem"}
    assert "expected" in answer["problem"]
    assert buffers == []


def test_unknown_messages_are_ignored(view: Any) -> None:
    contents: tuple[Any, ...] = (None, 1, "read", [], {}, {"kind": "write", "name": "manifest.json"})
    for content in contents:
        view._answer(view, content, [])
    assert view.sent == []


def test_a_removed_file_is_reported(tmp_path: Path) -> None:
    settings: dict[str, Any] = {"center": CENTER, "radii": [1.5], "face_size": 64, "samples": 1}
    bundle = nf.stream.export(nf.datasets.room(), tmp_path / "bundle", **settings)
    view: Any = bundle.show(size=SIZE)
    view.sent = []
    view.send = lambda content, buffers=(): view.sent.append((content, list(buffers)))
    (tmp_path / "bundle" / bundle.files[0]).unlink()
    answer, _ = ask(view, name=bundle.files[0], start=0)
    assert bundle.files[0] in answer["problem"]


def test_invalid_values_of_a_view_are_refused(view: Any) -> None:
    before = view.camera
    for name, value in [("pitch", 1.6), ("angle", 5), ("yaw", math.inf), ("position", (0, math.nan, 0))]:
        with pytest.raises(ValueError, match=f"^{name}: expected"):
            setattr(view, name, value)
    for name, value in [("yaw", "left"), ("position", (1, 2)), ("ring", 1), ("width", 5)]:
        with pytest.raises(Exception, match=name):
            setattr(view, name, value)
    look_at: dict[str, Any] = {"eye": (0, 1, 0), "target": (0, 1, -1), "size": SIZE}
    rolled = nf.Camera((0, 1, 0), (0, 0, math.sin(0.05), math.cos(0.05)), fov=FOV, size=SIZE)
    for camera, error, message in [
        (rolled, ValueError, "without roll, got 5.73 degrees"),
        (nf.Camera.look_at(**look_at, fov=nf.Fov(-1, 0.5, -1, 1)), ValueError, "same field of view to both sides"),
        (nf.Camera.look_at(**look_at, fov=nf.Fov.symmetric(175, 1)), ValueError, "field of view: expected"),
        (nf.Camera.look_at(**look_at, fov=nf.Orthographic(-1, 1, -1, 1)), TypeError, "perspective"),
        (nf.Camera.look_at(**{**look_at, "target": (0, 9, -1e-3)}, fov=FOV), ValueError, "pitch"),
        ("camera", TypeError, "camera: expected"),
    ]:
        with pytest.raises(error, match=message):
            view.camera = camera
    assert view.camera == before


def test_invalid_settings_of_a_view_are_refused(bundle: nf.stream.Bundle) -> None:
    cases: list[tuple[dict[str, Any], str]] = [
        ({"size": (4, 400)}, r"^size\[0\]: expected"),
        ({"strategy": "vis0"}, r"^strategy: .* export\(by_footprint=True\)"),
        ({"camera": nf.Camera(CENTER, fov=nf.CubeFace(0), size=(8, 8))}, "^camera: expected"),
    ]
    for settings, message in cases:
        with pytest.raises((ValueError, TypeError), match=message):
            bundle.show(**settings)


def test_reduced_scenes_are_shown(tmp_path: Path) -> None:
    reduced = nf.reduce(nf.datasets.room(), center=CENTER, r1=1.2, r2=2.0, face_size=64)
    view: Any = reduced.show(size=SIZE)
    view.sent = []
    view.send = lambda content, buffers=(): view.sent.append((content, list(buffers)))
    _, (manifest,) = ask(view, name="manifest.json", start=0)
    assert json.loads(manifest)["unit"] == "triangle"
    assert view.camera.position == CENTER
    with pytest.raises(ValueError, match="with_morph"):
        reduced.with_morph("none").show()


def test_environments_without_widgets_show_a_picture(view: Any) -> None:
    from PIL import Image

    data, *_ = view._repr_mimebundle_()
    assert "application/vnd.jupyter.widget-view+json" in data
    picture = data["image/png"]
    image = Image.open(io.BytesIO(base64.b64decode(picture) if isinstance(picture, str) else picture))
    assert image.width / image.height == SIZE[0] / SIZE[1]
    assert len(np.unique(np.asarray(image.convert("RGB")).reshape(-1, 3), axis=0)) > 20


def test_the_script_brings_what_it_imports() -> None:
    from nearfar.view import _widget

    head, _, loader = _widget._script().partition("\n")
    scripts = json.loads(head.removeprefix("const SCRIPTS = ").removesuffix(";"))
    known: set[str] = set()
    for name, text in scripts:
        imported = set(re.findall(r'\b(?:from|import)"\.\.?/([\w.-]+)"', text))
        assert imported <= known, f"{name} imports what comes later"
        known.add(name)
    assert set(re.findall(r'"([\w-]+\.js)"', loader)) == {"widget.js", "worker.js"} <= known


def test_a_missing_anywidget_is_named(bundle: nf.stream.Bundle, monkeypatch: pytest.MonkeyPatch) -> None:
    found = importlib.util.find_spec
    monkeypatch.setattr(importlib.util, "find_spec", lambda name: None if name == "anywidget" else found(name))
    with pytest.raises(ImportError, match=r"^show needs anywidget: pip install anywidget$"):
        bundle.show()
