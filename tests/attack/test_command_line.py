"""Every option of every command refuses unusable values with one line that names it, never with a traceback."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import trimesh
import typer

import nearfar as nf
from nearfar.cli import _app
from nearfar.cli._app import run
from tests.support import need
from tests.support.verdict import FOREIGN, LONGEST


def commands(group: Any, before: str = "") -> dict[str, Any]:
    """Return commands by their words, such as "orthoview build"."""
    found: dict[str, Any] = {}
    for name, command in group.commands.items():
        is_group = hasattr(command, "commands")
        found |= commands(command, f"{before}{name} ") if is_group else {before + name: command}
    return found


COMMAND = typer.main.get_command(_app.app)
COMMANDS = commands(COMMAND)

PLACE = ("--center", "0,1.7,0", "--r1", "3", "--r2", "8")
SMALL = ("--samples", "1", "--face-size", "8", "--backend", "cpu", "--size", "16x12")
VALID = {
    # A file's name may begin like an option.
    "demo": ("-i", "ball.glb", "-o", "-1", "--far", "map", *PLACE, *SMALL),
    "info": ("-i", "ball.glb"),
    "cut": ("-i", "ball.glb", "-o", "cut.glb", "--box", "-2,-2,2,2"),
    "partition": ("-i", "ball.glb", *PLACE),
    "bake": ("-i", "ball.glb", "-o", "map.exr", *PLACE, *SMALL[:-2]),
    "reduce": ("-i", "ball.glb", "-o", "-2", *PLACE[:2], *PLACE[4:], *SMALL),
    "render": ("-i", "ball.glb", "-o", "view.png", "--eye", "0,1.7,0", "--target", "0,1,-9", *SMALL[:2], *SMALL[4:]),
    "compare": ("-i", "ball.glb", "-o", "compared", *PLACE, *SMALL, "--fov", "20", "--min-ssim", "-1",
                "--min-psnr", "-1"),
    "lod": ("-i", "ball.glb", "-o", "model.json", "--views", "4", "--distances", "1", "--ratios", "1", "--method",
            "meshopt", "--backend", "cpu"),
    "export": ("-i", "ball.glb", "-o", "bundle", "--center", "0,1.7,0", "--radii", "3,8", "--samples", "1",
               "--face-size", "64", "--split", "50", "--by-footprint"),
    # Without the second options these commands would serve until Ctrl-C.
    "view": ("seen", "--write"),
    "serve": ("seen", "--check", "--port", "0", "--log", "off", "--rooms", "--name", "-1"),
    "invite": ("hall", "--rooms-key", "room.key"),
    "stereo": ("-i", "ball.glb", "-o", "stereo", "--eye", "0,1.7,0", "--target", "0,1,-9", *SMALL[:2], *SMALL[4:]),
    "orthoview build": ("-i", "ball.glb", "-o", "tree.zarr", "--cell", "8", "--size", "8", "--directions", "5"),
    "orthoview info": ("seen.zarr", "--preview", "views.png"),
    "orthoview update": ("seen.zarr", "-i", "ball.glb", "--box", "-2,-2,2,2"),
    "orthoview verify": ("seen.zarr",),
    "orthoview export": ("seen.zarr", "-o", "plain.zarr"),
}  # fmt: skip
"""Arguments with which each command works on a small scene."""

VALUES = ("", "abc", "-1", "nan", "1e400", "9" * 5000, "\udcff", "a\0b", "1,2", "2x2x2")
"""Values that almost every option refuses; the others accept them."""

FURTHER = {
    "--cell": "0", "--connections": "0", "--grid": "0", "--mono-plane": "0", "--most-rooms": "0", "--port": "70000",
    "--pixels-per-degree": "600", "--quality": "101",
    "--fov": "180", "--radii": "10,9", "--size": "0x0", "--split": "0", "--triangles": "0",
}  # fmt: skip
"""Out-of-range values of single options."""

TAKEN = dict.fromkeys(("--d", "--k", "--min-psnr", "--min-ssim"), ("-1",)) | {
    "--name": ("abc", "-1", "nan", "1e400", "9" * 5000, "2x2x2")
}
"""Values that single options accept."""

LONG = ("compare", "demo", "reduce")
"""Commands that take seconds: the values that they accept are in their valid calls."""

UNUSED = {
    "serve": ("--blend", "--face-size", "--grid", "--max-bytes", "--on-invalid", "--radii", "--samples", "--scale",
              "--up"),
    "view": ("--port",),
}  # fmt: skip
"""Options that the valid call does not need and may not check: a bundle is served, a page written."""

FILES = ("--input", "--output", "--truth", "--preview", "--equirectangular", "--certificate", "--key", "--rooms-key")
"""Options whose messages name the file instead."""


@pytest.fixture(scope="module", autouse=True)
def _folder(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Make a working folder with a scene: twenty triangles beyond the far radius, and twenty near."""
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("commands"))
        ball = trimesh.creation.icosphere(0)
        far = ball.copy().apply_translation((0.0, 1.0, -20.0))
        trimesh.Scene([ball, far]).export("ball.glb")
        settings: dict[str, Any] = {"center": (0.0, 1.7, 0.0), "radii": [3.0, 8.0], "samples": 1, "face_size": 64}
        nf.stream.export(nf.Scene.load("ball.glb"), "seen", **settings)
        Path("room.key").write_bytes(bytes(32))
        need("zarr")
        nf.orthoview.build(nf.Scene.load("ball.glb"), "seen.zarr", cell=8.0, size=8, directions=5)
        yield


@pytest.fixture
def _made_once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Build commands once: Typer rebuilds all of them in each call, which takes forty times as long as a refusal."""
    monkeypatch.setattr(_app, "app", COMMAND)


def options() -> list[tuple[str, str]]:
    return [
        (name, parameter.opts[-1])
        for name, command in COMMANDS.items()
        for parameter in command.params
        if parameter.param_type_name == "option" and not parameter.is_flag
    ]


def without(arguments: tuple[str, ...], names: list[str]) -> list[str]:
    """Return arguments without some options and their values; flags have none."""
    dropped = {place + step for place, part in enumerate(arguments) if part in names for step in (0, 1)}
    return [part for place, part in enumerate(arguments) if place not in dropped]


def flaw(status: int, printed: str, option: str, *, is_usable: bool) -> str | None:
    """Return why a command's end is wrong; None if it is right."""
    if status in (0, 3):
        return None if is_usable else "accepted"
    if status not in (1, 2):
        return f"status {status}"
    if FOREIGN.search(printed):
        return "a message that is not ours"
    if option in FILES:
        return None
    if status == 1 and (printed.count("\n") != 1 or len(printed) > LONGEST):
        return "not one line"
    if option.strip("-").replace("-", "_") not in printed.replace("-", "_"):
        return "a message that does not name the option"
    return None


@pytest.mark.usefixtures("_made_once")
def test_every_command_has_a_valid_call(capsys: pytest.CaptureFixture[str]) -> None:
    assert VALID.keys() == COMMANDS.keys()
    for name, arguments in VALID.items():
        assert run([*name.split(), *arguments]) == 0, capsys.readouterr().err


@pytest.mark.usefixtures("_made_once")
@pytest.mark.parametrize(("name", "option"), options())
def test_unusable_values_are_named_in_one_line(name: str, option: str, capsys: pytest.CaptureFixture[str]) -> None:
    names = next(list(p.opts) for p in COMMANDS[name].params if option in p.opts)
    flaws = []
    further = (FURTHER[option],) if option in FURTHER else ()
    for value in ("", "-1", "9" * 5000) if option in FILES else (*VALUES, *further):
        is_taken = value in TAKEN.get(option, ())
        if name in LONG and (is_taken or (option, value) == ("--output", "-1")):
            continue
        status = run([*name.split(), *without(VALID[name], names), option, value])
        printed = capsys.readouterr().err
        is_usable = is_taken or option in (*FILES, *UNUSED.get(name, ()))
        found = flaw(status, printed, option, is_usable=is_usable)
        if is_taken and status != 0:
            found = f"refused with status {status}"
        if found is not None:
            flaws.append(f"{value[:20]!r}: {found}: {printed[:200]!a}")
    assert flaws == []
