"""The view in a running JupyterLab: its picture, its camera in both directions, and clean-up."""

from __future__ import annotations

import json
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import nearfar as nf
from tests.support import need
from tests.support.browser import LOOKS, open_page
from tests.support.page_pictures import of_one_face, off

pytestmark = pytest.mark.slow

CENTER = (3.0, 1.7, -2.0)
SIZE = (320, 200)
ROOM = (1000, 1600)
"""Size of a page that shows all cells: off-screen views are not drawn, and do not load."""
CANVAS = ".nearfar-view canvas"
VIEWER = "document.querySelector('.nearfar-view')?.nearfar?.viewer"

CELLS = (
    """
import json
import nearfar as nf
bundle = nf.stream.open("bundle")
view = bundle.show(size=(320, 200), strategy="clovrd")
view
""",
    "view.camera = nf.Camera.look_at((3.5, 1.7, -2.5), (0, 2, -9), fov=nf.Fov.symmetric(90, 1.6), size=(320, 200))",
    "print(json.dumps([view.position, view.yaw, view.pitch, view.angle, view.ring, view.radius, view.problem]))",
    "nf.ReducedScene.load('light').show(size=(160, 100))",
    "view",
)


@pytest.fixture(scope="module")
def folder(city: nf.Scene, tmp_path_factory: pytest.TempPathFactory) -> Path:
    for part in ("browser", "anywidget", "jupyterlab"):
        need(part)
    folder = tmp_path_factory.mktemp("lab")
    settings: dict[str, Any] = {"face_size": 256, "quality": None, "pixels_per_degree": None}
    nf.stream.export(city, folder / "bundle", center=CENTER, radii=(10.0, 22.0), **settings)
    nf.reduce(city, center=CENTER, r1=6.0, r2=15.0, face_size=128).save(folder / "light")
    return folder


@pytest.fixture(scope="module")
def notebook(chromium: Any, folder: Path) -> Iterator[Any]:
    from tests.support.lab import Notebook, server

    with server(folder) as url, open_page(chromium, *ROOM) as page:
        notebook = Notebook(page, url, folder, CELLS)
        notebook.run(0)
        notebook.until(f"() => {VIEWER}?.facts.arrived === 2")
        yield notebook


def state(notebook: Any) -> tuple[tuple[float, ...], float, float, float, int, float, str]:
    """The state of the view in Python."""
    position, *others = json.loads(notebook.run(2))
    return (tuple(position), *others)


def until_python_has(notebook: Any, condition: Any) -> Any:
    for _ in range(LOOKS):
        if condition(found := state(notebook)):
            return found
        time.sleep(0.2)
    raise AssertionError(f"Python does not have it: {found}")


def test_the_picture_is_rendered_by_the_camera_set_in_python(notebook: Any, folder: Path) -> None:
    before = notebook.photo()
    notebook.run(1)
    notebook.until(f"() => {VIEWER}.camera.rotation.y > 0.4")
    found = notebook.photo()
    assert (before != found).any(axis=-1).mean() > 0.3
    camera = nf.Camera.look_at((3.5, 1.7, -2.5), (0, 2, -9), fov=nf.Fov.symmetric(90, 1.6), size=SIZE)
    bundle = nf.stream.open(folder / "bundle")
    frame = bundle.at(2).render(camera, channels=("color", "face_id"))
    worst, inner = off(frame, found), of_one_face(frame.require("face_id"))
    assert inner.mean() > 0.3
    assert (worst[inner] <= 2).mean() >= 0.98
    position, yaw, pitch, angle, _, radius, problem = until_python_has(notebook, lambda found: found[4] == 2)
    assert position == (3.5, 1.7, -2.5)
    assert (yaw, pitch) == pytest.approx((0.4939, 0.0406), abs=1e-3)
    assert angle == pytest.approx(2 * np.degrees(np.arctan(1 / 1.6)))
    assert (radius, problem) == (22.0, "")


def test_python_reads_the_users_position(notebook: Any) -> None:
    page, before = notebook.page, state(notebook)
    box = page.locator(CANVAS).first.bounding_box()
    x, y = box["x"] + 150, box["y"] + 100
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x + 50, y, steps=5)
    page.mouse.up()
    turned = until_python_has(notebook, lambda found: found[1] != before[1])
    # Dragging over the height of the picture turns by 1.6 radians.
    turned = until_python_has(notebook, lambda found: found[1] == pytest.approx(before[1] + 1.6 * 50 / 200, abs=0.01))
    assert turned[0] == before[0]
    page.locator(CANVAS).first.click()
    page.keyboard.down("w")
    # Running a cell would move the keyboard focus.
    x, _, z = np.subtract(before[0], CENTER)
    notebook.until(f"() => Math.hypot({VIEWER}.rig.position.x - {x}, {VIEWER}.rig.position.z - {z}) > 0.1")
    page.keyboard.up("w")
    walked = until_python_has(notebook, lambda found: np.hypot(*np.subtract(found[0], before[0])[[0, 2]]) > 0.1)
    assert walked[0][1] == pytest.approx(1.7)
    # Keys go only to the view: no cell was added or removed.
    assert page.evaluate("() => window.jupyterapp.shell.currentWidget.content.widgets.length") == len(CELLS)


def test_a_reduced_scene_is_shown_beside_it(notebook: Any) -> None:
    notebook.run(3)
    second = "document.querySelectorAll('.nearfar-view')[1]?.nearfar?.viewer"
    notebook.until(f"() => {second}?.facts.arrived === 1")
    assert len(np.unique(notebook.photo(1).reshape(-1, 3), axis=0)) > 100
    assert notebook.page.evaluate(f"() => {VIEWER}.renderer.getContext().isContextLost()") is False


def test_all_views_of_a_widget_show_the_same_user(notebook: Any) -> None:
    notebook.run(4)
    third = "document.querySelectorAll('.nearfar-view')[2]?.nearfar?.viewer"
    notebook.until(f"() => {third}?.facts.arrived === 2")
    page = notebook.page
    canvas = page.locator(CANVAS).nth(2)
    canvas.scroll_into_view_if_needed()
    box = canvas.bounding_box()
    x, y = box["x"] + 150, box["y"] + 100
    before = page.evaluate(f"() => {third}.camera.rotation.y")
    page.mouse.move(x, y)
    page.mouse.down()
    page.mouse.move(x - 50, y, steps=5)
    page.mouse.up()
    notebook.until(f"() => {third}.camera.rotation.y < {before} - 0.39")
    page.locator(CANVAS).first.scroll_into_view_if_needed()
    notebook.until(f"() => Math.abs({VIEWER}.camera.rotation.y - {third}.camera.rotation.y) < 1e-9")
    page.evaluate("() => { window.jupyterapp.shell.currentWidget.content.widgets[4].model.clearExecution(); }")


@pytest.mark.stress
def test_replaced_views_release_their_contexts(notebook: Any) -> None:
    """Browsers keep 16 contexts; beyond that the oldest is lost, with a warning."""
    notebook.run(3)
    kept = "document.querySelectorAll('.nearfar-view')[1].nearfar.viewer"
    for _ in range(20):
        notebook.run(0)
        notebook.until(f"() => {VIEWER}?.facts.arrived >= 0")
    assert notebook.page.evaluate("() => document.querySelectorAll('.nearfar-view').length") == 2
    assert notebook.page.evaluate(f"() => {kept}.renderer.getContext().isContextLost()") is False
    assert not [line for line in notebook.page.printed if "WebGL" in line or "rror" in line]
