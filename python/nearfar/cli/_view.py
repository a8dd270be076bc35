"""`nearfar view`: shows a bundle in the browser."""

from __future__ import annotations

import contextlib
import threading
import webbrowser
from typing import Annotated

import typer

import nearfar as nf
from nearfar.cli._options import option
from nearfar.view._server import Server


def view(
    bundle: Annotated[str, typer.Argument(help="Folder that `nearfar export` wrote, or its URL.", show_default=False)],
    port: Annotated[int, option("--port", "NUMBER", "Port on 127.0.0.1; 0 for any that is free.")] = 0,
    browser: Annotated[bool, typer.Option(help="Open the page in the browser.")] = True,
    write: Annotated[
        bool,
        typer.Option("--write", help="Write the page into the folder for any web server instead, and serve nothing."),
    ] = False,
) -> None:
    """Show a bundle in the browser: at once from its centre, then refined ring by ring. Ctrl-C ends it."""
    if write:
        nf.view.write_page(bundle)
        typer.echo(f"{bundle}/index.html shows the bundle from any web server.")
        return
    with Server(bundle, port=port) as server:
        typer.echo(f"{server.url} shows {bundle}; Ctrl-C ends it.")
        if browser:
            webbrowser.open(server.url)
        _wait()


def _wait() -> None:
    """Return at Ctrl-C."""
    with contextlib.suppress(KeyboardInterrupt):
        threading.Event().wait()
