"""`nearfar serve`: serves bundles, reduced scenes, and regions of scenes on demand, to many clients."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Annotated

import typer

from nearfar._base import cache, check
from nearfar.cli._options import option
from nearfar.serve import _addresses, _log
from nearfar.serve._certificate import Certificate
from nearfar.serve._limits import Limits
from nearfar.serve._server import Server
from nearfar.serve._site import Site

_DEFAULT = Limits()


def serve(
    sources: Annotated[
        list[str],
        typer.Argument(
            metavar="[NAME=]SOURCE...",
            help="Folders that `nearfar export` or `nearfar reduce` wrote, or bundles' URLs; a page lists several.",
            show_default=False,
        ),
    ],
    host: Annotated[
        str, option("--host", "ADDRESS", "Address to listen at: 0.0.0.0 for all networks of this machine.")
    ] = _addresses.LOCAL,
    port: Annotated[int, option("--port", "NUMBER", "Port to listen at; 0 for any that is free.")] = 8080,
    name: Annotated[
        list[str] | None,
        option("--name", "HOST", "Name by which clients may call the server; repeat it. By default any of its own."),
    ] = None,
    certificate: Annotated[
        str | None, option("--certificate", "FILE", "Certificate of the server in PEM, with those that signed it.")
    ] = None,
    key: Annotated[str | None, option("--key", "FILE", "Key of the certificate, in PEM.")] = None,
    self_signed: Annotated[
        bool,
        typer.Option("--self-signed", help="Encrypt with a certificate made here; browsers ask before they trust it."),
    ] = False,
    origin: Annotated[
        str | None,
        option("--origin", "ORIGIN", "Whose pages may read the files, such as https://example.org, or * for all."),
    ] = None,
    connections: Annotated[
        int, option("--connections", "NUMBER", "Connections at the same time; others wait.")
    ] = _DEFAULT.connections,
    per_client: Annotated[
        int, option("--per-client", "NUMBER", "Connections of one address of another machine.")
    ] = _DEFAULT.per_client,
    log: Annotated[str, option("--log", "text|json|off", "Log of answers and warnings, on standard error.")] = "text",
    only_check: Annotated[
        bool, typer.Option("--check", help="Open all that would be served, tell it, and end.")
    ] = False,
) -> None:
    """Serve scenes to browsers and headsets, with the page that shows them. Ctrl-C ends it."""
    check.choice("--log", log, ("text", "json", "off"))
    limits = Limits(connections=connections, per_client=per_client)
    used = _certificate(certificate, key, self_signed, host, name)
    sites = _sites(sources)
    if log != "off":
        _log.begin(as_json=log == "json")
    with (
        _ended() as end,
        Server(sites, host=host, port=port, names=name, certificate=used, origin=origin, limits=limits) as server,
    ):
        _tell(server, sources, used)
        if not only_check:
            end.wait()


def _sites(sources: list[str]) -> dict[str, Site]:
    """Sites by their names: a single one has the empty name."""
    named = [_named(source) for source in sources]
    if len(named) == 1:
        return {"": Site.of_bundle(named[0][1])}
    names = [name for name, _ in named]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise ValueError(f"SOURCE: expected different names, got {twice!r} twice: write NAME=SOURCE")
    return {name: Site.of_bundle(path) for name, path in named}


def _named(source: str) -> tuple[str, str]:
    """Split "name=path"; without a name it is that of the folder."""
    name, sign, path = source.partition("=")
    if sign and not Path(source).exists() and "/" not in name:
        return name, path
    return Path(source.rstrip("/")).resolve().name, source


def _certificate(
    certificate: str | None, key: str | None, self_signed: bool, host: str, names: list[str] | None
) -> Certificate | None:
    if self_signed:
        if certificate is not None or key is not None:
            raise ValueError("--self-signed: expected no --certificate and no --key beside it")
        called = names if names is not None else _addresses.reached(_addresses.address(host))
        return Certificate.self_signed(cache.folder() / "certificate", called)
    if (certificate is None) != (key is None):
        raise ValueError("--certificate: expected --certificate and --key together")
    return None if certificate is None or key is None else Certificate(Path(certificate), Path(key))


def _tell(server: Server, sources: list[str], certificate: Certificate | None) -> None:
    first, *others = server.urls
    shown = sources[0] if len(sources) == 1 else f"{len(sources)} scenes"
    typer.echo(f"{first} shows {shown}; Ctrl-C ends it.")
    for url in others:
        typer.echo(f"  also {url}")
    if certificate is not None:
        typer.echo(f"certificate {certificate.certificate}, {certificate.days} days left, SHA-256:")
        typer.echo(f"  {certificate.fingerprint}")


@contextmanager
def _ended() -> Iterator[threading.Event]:
    """Yield an event that Ctrl-C and a request to end set."""
    end = threading.Event()
    before = {number: signal.signal(number, lambda *_: end.set()) for number in (signal.SIGINT, signal.SIGTERM)}
    try:
        yield end
    finally:
        for number, handler in before.items():
            signal.signal(number, handler)
