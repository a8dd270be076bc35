"""Groups of options: a command has their fields as options, and gets the group."""

from __future__ import annotations

import inspect
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

import pytest
import typer
from typer.testing import CliRunner

import nearfar as nf
from nearfar.cli import _app
from nearfar.cli._groups import Options, expand

MAX_PARAMETERS = 10


@dataclass(frozen=True, kw_only=True)
class Size(Options):
    width: Annotated[int, typer.Option("--width")] = 3
    depth: Annotated[str, typer.Option("--depth")] = "2"

    @cached_property
    def area(self) -> int:
        return self.width * int(self.depth)


areas: list[tuple[str, int, bool]] = []


def measure(*, name: Annotated[str, typer.Option("--name")], size: Size, loud: bool = False) -> None:
    """Measure an area."""
    areas.append((name, size.area, loud))


def test_groups_become_options_in_their_place() -> None:
    command = expand(measure, width=5)
    parameters = inspect.signature(command).parameters
    assert list(parameters) == ["name", "width", "depth", "loud", "context"]
    assert [parameters[name].default for name in ("width", "depth")] == [5, "2"]
    app = typer.Typer()
    app.command()(command)
    assert CliRunner().invoke(app, ["--name", "a", "--width", "4", "--depth", "6", "--loud"]).exit_code == 0
    assert areas == [("a", 24, True)]
    # Whole numbers may be written as floats, as in Python.
    assert CliRunner().invoke(app, ["--name", "b", "--width", "1e6", "--depth", "1"]).exit_code == 0
    assert areas[1:] == [("b", 10**6, False)]
    for wrong in ("1.5", "inf", "nan", "1e", "wide"):
        refused = CliRunner().invoke(app, ["--name", "c", "--width", wrong])
        assert (refused.exit_code, len(areas)) == (2, 2)
        assert f"{wrong!r} is not a valid integer" in " ".join(refused.output.split())
    assert command.__doc__ == "Measure an area."


def test_an_option_with_its_default_as_value_is_given() -> None:
    @dataclass(frozen=True, kw_only=True)
    class Width(Options):
        width: Annotated[int, typer.Option("--width")] = 3

    def measure_width(*, size: Width) -> None:
        size.refuse("here")

    measure_width.__annotations__["size"] = Width
    app = typer.Typer()
    app.command()(expand(measure_width))
    assert CliRunner().invoke(app, []).exit_code == 0
    assert "--width: expected none here" in str(CliRunner().invoke(app, ["--width", "3"]).exception)


def test_the_input_is_also_an_argument(capsys: pytest.CaptureFixture[str]) -> None:
    by_option = command_output(capsys, "partition", "-i", "room:detail=0", "--json")
    assert command_output(capsys, "partition", "room:detail=0", "--json") == by_option
    assert _app.run(["partition"]) == _app.run(["partition", "room", "-i", "city"]) == 2
    errors = capsys.readouterr().err
    assert "expected a file or one of the built-in scenes" in errors
    assert "expected one of room and city" in errors


def command_output(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    assert _app.run(arguments) == 0
    return capsys.readouterr().out


def test_groups_check_what_they_derive_when_they_are_made() -> None:
    with pytest.raises(ValueError, match="invalid literal"):
        Size(depth="two")


def test_commands_have_few_parameters() -> None:
    commands = [*_app.app.registered_commands, *_app.orthoview.registered_commands]
    functions = {inspect.unwrap(command.callback) for command in commands if command.callback is not None}
    many = {f.__name__: n for f in functions if (n := len(inspect.signature(f).parameters)) > MAX_PARAMETERS}
    assert len(functions) > 10
    assert many == {}


@pytest.mark.parametrize(
    ("message", "shown"),
    [
        ("width: expected 1, got 0", "--width: expected 1, got 0"),
        ("width[2]: expected 1", "--width[2]: expected 1"),
        ("a.glb: damaged; depth='drop' leaves it out", "a.glb: damaged; --depth drop leaves it out"),
        ("expected none with depth= (width=0.5, loud=True)", "expected none with --depth (--width 0.5, --loud)"),
        ("http://a/?width=2: other=3, width is 4", "http://a/?width=2: other=3, width is 4"),
        ("a width=2/b.glb: damaged", "a width=2/b.glb: damaged"),
        ("got width=(1, 2) of f(width=1) with loud=False", "got width=(1, 2) of f(width=1) with loud=False"),
        ("width=1.5 with depth=nf.Depth('x'): no", "--width 1.5 with depth=nf.Depth('x'): no"),
    ],
)
def test_errors_name_options_not_parameters(message: str, shown: str) -> None:
    def fail(*, size: Size, loud: bool = False) -> None:
        raise nf.SceneError(message)

    app = typer.Typer()
    app.command()(expand(fail))
    result = CliRunner().invoke(app, [])
    assert (type(result.exception), str(result.exception)) == (nf.SceneError, shown)
