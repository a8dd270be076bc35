"""The command-line application: its commands, and the conversion of errors to messages and exit statuses."""

from __future__ import annotations

import signal
import sys
import warnings
from collections.abc import Sequence
from typing import Annotated

import typer

import nearfar as nf
from nearfar._base import check, progress
from nearfar._base.files import reason_of
from nearfar.cli import (
    _bake,
    _compare,
    _cut,
    _export,
    _info,
    _lod,
    _orthoview,
    _partition,
    _reduce,
    _render,
    _serve,
    _stereo,
)
from nearfar.cli._groups import Command, expand

INTERRUPT_STATUS = 128 + signal.SIGINT
"""Exit status after Ctrl-C, as in shells."""

app = typer.Typer(
    name="nearfar",
    help="Reduces 3D scenes that are too heavy for a thin VR device, and measures the loss in image quality.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)
orthoview = typer.Typer(
    help="Worlds of any size as an octree of orthographic depth images.", no_args_is_help=True, add_completion=False
)


def _add_commands(target: typer.Typer, *commands: Command) -> None:
    for command in commands:
        target.command(command.__name__)(expand(command))


_DEMO = "Reduce the procedural city or another scene: `nearfar reduce` with defaults for scene and folder."
app.command("demo", help=_DEMO)(expand(_reduce.reduce, **_reduce.DEMO))
_add_commands(
    app,
    _info.info,
    _cut.cut,
    _partition.partition,
    _bake.bake,
    _reduce.reduce,
    _render.render,
    _compare.compare,
    _lod.lod,
    _stereo.stereo,
    _export.export,
)
app.add_typer(orthoview, name="orthoview")
_add_commands(orthoview, _orthoview.build, _orthoview.info, _orthoview.update, _orthoview.verify, _orthoview.export)
_add_commands(app, _serve.serve, _serve.invite, _serve.view)


def _print_version(requested: bool) -> None:
    if requested:
        typer.echo(f"nearfar {nf.__version__}")
        raise typer.Exit


@app.callback()
def _top(
    version: Annotated[
        bool, typer.Option("--version", callback=_print_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    pass


def run(arguments: Sequence[str]) -> int:
    """Run a command line, print errors to standard error, and return the exit status."""
    try:
        with progress.lines(), warnings.catch_warnings():
            # Reports contain this warning themselves.
            warnings.filterwarnings("ignore", "the picture folds")
            app(list(arguments), prog_name="nearfar")
    except SystemExit as exit_error:
        interrupt = _interrupt_before(exit_error)
        if interrupt is not None:
            return _print_error("; ".join(("interrupted", *getattr(interrupt, "__notes__", ()))), INTERRUPT_STATUS)
        return exit_error.code if isinstance(exit_error.code, int) else int(exit_error.code is not None)
    except MemoryError as error:
        return _print_error(f"there is not enough memory{f': {error}' if str(error) else ''}", 1)
    except OSError as error:
        return _print_error(f"{error.filename}: {reason_of(error)}" if error.filename else str(error), 1)
    except (nf.Error, ValueError, ImportError) as error:
        return _print_error(str(error), 1)
    return 0


def _interrupt_before(exit_error: SystemExit) -> KeyboardInterrupt | None:
    """Return the KeyboardInterrupt that typer turned into an exit, if any."""
    error: BaseException | None = exit_error
    while error is not None and not isinstance(error, KeyboardInterrupt):
        error = error.__cause__ or error.__context__
    return error


def _print_error(message: str, status: int) -> int:
    # File names may contain bytes that are not valid text.
    print(f"nearfar: {check.one_line(message)}", file=sys.stderr)
    return status
