"""`nearfar view`: shows a bundle, a reduced scene or a tree of orthoviews in the browser."""

from __future__ import annotations

import contextlib
import threading
import webbrowser
from typing import Annotated

import typer

import nearfar as nf
from nearfar.cli._groups import flag, option
from nearfar.serve._server import Server


def view(
    folder: Annotated[
        str,
        typer.Argument(
            help="Folder that `nearfar export`, `reduce` or `orthoview build` wrote, or a bundle's URL.",
            show_default=False,
        ),
    ],
    port: int = option(0, "NUMBER", "Port on 127.0.0.1; 0 for any that is free."),
    browser: Annotated[bool, typer.Option(help="Open the page in the browser.")] = True,
    write: bool = flag("--write", "Write the page into the folder for any web server instead, and serve nothing."),
) -> None:
    """Show a bundle, a reduced scene or a tree of orthoviews in the browser. Ctrl-C ends it."""
    if write:
        nf.view.write_page(folder)
        typer.echo(f"{folder}/index.html shows it from any web server.")
        return
    # Ctrl-C ends the server from its start on.
    with Server.of_bundle(folder, port=port) as server, contextlib.suppress(KeyboardInterrupt):
        typer.echo(f"{server.url} shows {folder}; Ctrl-C ends it.")
        if browser:
            webbrowser.open(server.url)
        threading.Event().wait()
