"""Server of sites, implemented in Rust with its own threads, and its certificate, which WebXR sessions require."""

from __future__ import annotations

import errno
import html
import os
import time
import weakref
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from urllib.parse import quote

from nearfar import _core
from nearfar._base import check, files
from nearfar._base.settings import set_fields
from nearfar.serve import _addresses
from nearfar.serve._addresses import LOCAL
from nearfar.serve._limits import Limits, Rooms
from nearfar.serve._site import Site
from nearfar.view._page import POLICY

_MIN_DAYS = 30
"""Remaining days below which an own certificate is replaced."""

RESERVED = ("healthz", "metrics", "index.html", "index.css")
"""Names that the server itself uses."""

ROOMS = "rooms"
"""First segment of the paths of rooms."""

HEADERS = {
    "content-security-policy": POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "xr-spatial-tracking=(self)",
}
"""Headers of all responses."""

_STYLE = """
:root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif }
body { max-width: 44rem; margin: 0 auto; padding: 2rem 1rem }
h1 { font-size: 1.4rem; font-weight: 600 }
ul { list-style: none; padding: 0; display: grid; gap: .75rem }
a { display: block; padding: .9rem 1.1rem; border: 1px solid color-mix(in srgb, currentcolor 25%, transparent);
    border-radius: .6rem; color: inherit; text-decoration: none; overflow-wrap: anywhere }
a:hover, a:focus-visible { border-color: #3b7ddd; outline: 2px solid #3b7ddd; outline-offset: 1px }
strong { display: block }
span { opacity: .75 }
"""
"""Style of the index page."""


@dataclass(frozen=True)
class Certificate:
    """A certificate and its key, both in PEM files.

    The chain of certificates begins with the server's. ValueError if a file cannot be read, the key does not match the
    certificate, or the certificate is not valid today; TypeError if an argument is not a path.
    """

    certificate: Path
    key: Path
    fingerprint: str = field(init=False)
    """SHA-256 of the certificate, formatted as in browsers."""
    ends: int = field(init=False)
    """Expiry time, in seconds since 1970."""
    names: tuple[str, ...] = field(init=False)
    """Host names and addresses in the certificate."""

    def __post_init__(self) -> None:
        set_fields(self, certificate=check.path("certificate", self.certificate), key=check.path("key", self.key))
        fingerprint, ends, names = _core.certificate(*self.files)
        set_fields(self, fingerprint=fingerprint, ends=ends, names=tuple(names))

    @property
    def files(self) -> tuple[str, str]:
        """Paths of the certificate and of its key."""
        return os.fspath(self.certificate), os.fspath(self.key)

    @property
    def days(self) -> int:
        """Days until the certificate expires."""
        return int((self.ends - time.time()) / 86_400.0)

    @classmethod
    def self_signed(cls, folder: str | os.PathLike[str], names: list[str]) -> Certificate:
        """Load the self-signed certificate of a folder, or generate one that lasts 13 months.

        The certificate is reused as long as it is valid and has the host names and addresses `names`, so that a headset
        must accept it only once. The folder has `certificate.pem` and `key.pem`; only its owner can read the key.
        OSError if the folder cannot be written, ValueError if a name is not a valid host name.
        """
        path, names = check.path("folder", folder), list(check.texts("names", names))
        certificate, key = path / "certificate.pem", path / "key.pem"
        with suppress(ValueError):
            stored = cls(certificate, key)
            if stored.days >= _MIN_DAYS and set(names) <= set(stored.names):
                return stored
        certificate_pem, key_pem = _core.self_signed(names)
        path.mkdir(parents=True, exist_ok=True)
        files.write_with_mode(key, key_pem.encode(), 0o600)
        files.write_with_mode(certificate, certificate_pem.encode(), 0o644)
        return cls(certificate, key)


class Server:
    """Serves sites over HTTP from construction on; use it in a `with` block, or `close` it.

    OSError if the port is taken, the address does not belong to this machine, or a cache cannot be opened.

    Parameters
    ----------
    sites
        Sites by the first segment of their paths; the site with the empty name serves all other paths. Several sites
        without an empty name get an index page.
    host
        Address to listen at: 127.0.0.1 for programs on this machine only, 0.0.0.0 for all networks.
    port
        Port to listen at; 0 for any free one.
    names
        Accepted host names, without a port; requests for other hosts are refused. By default the names of this machine
        if only local programs reach the server, else any.
    certificate
        Certificate for encrypted connections (TLS 1.2 and 1.3, HTTP/1.1 and HTTP/2); None for plain HTTP/1.1. Its files
        are reloaded when they change.
    origin
        Origin whose pages may read the files, such as `https://example.org`, or `*` for all; None for the server's own.
    limits
        Limits on connections, times and regions.
    rooms
        Limits and key of rooms, in which users see each other, at `rooms/NAME`; None for no rooms.
    """

    def __init__(
        self,
        sites: Mapping[str, Site],
        *,
        host: str = LOCAL,
        port: int = 0,
        names: Sequence[str] | None = None,
        certificate: Certificate | None = None,
        origin: str | None = None,
        limits: Limits | None = None,
        rooms: Rooms | None = None,
    ) -> None:
        if rooms is not None:
            check.instance("rooms", rooms, Rooms)
        sites = _check_sites(sites, RESERVED if rooms is None else (*RESERVED, ROOMS))
        self._host, number = _addresses.parse_host(host), check.integer("port", port, 0, 65535)
        if certificate is not None:
            check.instance("certificate", certificate, Certificate)
        limits = Limits() if limits is None else check.instance("limits", limits, Limits)
        self._certificate = certificate
        self._names = None if names is None else _addresses.parse_names(names)
        local_names = list(_addresses.NAMES) if _addresses.is_local(self._host) else None
        headers = HEADERS
        if origin is not None:
            headers = HEADERS | {"cross-origin-resource-policy": "cross-origin"}
            _addresses.check_origin(origin)
        try:
            self._server = _core.Server(
                [(name, site.documents(), site.demand) for name, site in sites.items()],
                {
                    "address": (self._host, number),
                    "hosts": local_names if self._names is None else self._names,
                    "headers": list(headers.items()),
                    "origin": origin,
                    "certificate": None if certificate is None else certificate.files,
                    "limits": limits,
                    "rooms": rooms,
                },
            )
        except OSError as error:
            if error.errno not in (errno.EADDRINUSE, errno.EADDRNOTAVAIL, errno.EACCES):
                raise
            what = "address of this machine" if error.errno == errno.EADDRNOTAVAIL else "port"
            reason = f"{os.strerror(error.errno)}: choose another {what}"
            raise OSError(error.errno, reason, f"{_addresses.host_in_url(self._host)}:{number}") from None
        # Region threads need the interpreter, so the server is closed before the interpreter exits.
        self._end = weakref.finalize(self, self._server.close)

    @classmethod
    def of_bundle(cls, path: str | os.PathLike[str], *, port: int = 0) -> Server:
        """Serve one bundle, reduced scene or tree of orthoviews; errors also as for the functions that open them."""
        return cls({"": Site.of_bundle(path)}, port=port)

    @property
    def url(self) -> str:
        """Address of the server for programs on this machine, or in its network."""
        return self._address({"0.0.0.0": LOCAL, "::": "::1"}.get(self._host, self._host))

    @property
    def urls(self) -> list[str]:
        """Addresses at which clients reach the server, the most useful first; with `names` only those."""
        return [self._address(host) for host in self._names or _addresses.hosts_of(self._host)]

    @property
    def port(self) -> int:
        """Port at which the server listens."""
        return self._server.port

    def _address(self, host: str) -> str:
        scheme = "http" if self._certificate is None else "https"
        return f"{scheme}://{_addresses.host_in_url(host)}:{self.port}/"

    def close(self) -> None:
        """Stop the server; open responses get a few seconds to finish."""
        self._end()

    def __enter__(self) -> Server:
        return self

    def __exit__(self, *error: object) -> None:
        self.close()

    def __repr__(self) -> str:
        return f"Server({self.url!r})"


def _check_sites(sites: Mapping[str, Site], reserved: Sequence[str]) -> dict[str, Site]:
    checked = dict(check.mapping("sites", sites, "a mapping of names to sites"))
    for name, site in checked.items():
        check.instance("sites", site, Site)
        if name in reserved or "/" in name or name in (".", ".."):
            reserved_names = ", ".join(reserved)
            raise ValueError(f"sites: expected names without a slash, but not {reserved_names}, . or .., got {name!r}")
    if not checked:
        raise ValueError("sites: expected one or more, got none")
    if len(checked) > 1 and "" not in checked:
        titles = {name: site.title for name, site in checked.items()}
        checked[""] = Site(_index_page(titles), has_page=False)
    return checked


def _index_page(titles: Mapping[str, str]) -> dict[str, bytes]:
    """Return the documents of the index page: links to the sites with their titles."""
    items = "\n".join(
        f'<li><a href="{html.escape(quote(name, safe=""))}/"><strong>{html.escape(name)}</strong>'
        f"<span>{html.escape(title)}</span></a></li>"
        for name, title in sorted(titles.items())
    )
    page = (
        '<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>Scenes</title>\n'
        '<link rel="icon" href="data:,">\n<link rel="stylesheet" href="index.css">\n'
        f"<h1>Scenes</h1>\n<ul>\n{items}\n</ul>\n</html>\n"
    )
    return {"index.html": page.encode(), "index.css": _STYLE.strip().encode()}


def begin_log(*, as_json: bool = False, level: str = "info") -> bool:
    """Start writing the log of all servers of this process to standard error, as text or as a JSON object per line.

    The least logged level is `error`, `warn`, `info` (each response) or `debug` (broken connections); ValueError for
    other levels. Returns False if logging was started already; then it continues unchanged.
    """
    check.choice("level", level, ("error", "warn", "info", "debug"))
    return _core.begin_log(level, check.flag("as_json", as_json))
