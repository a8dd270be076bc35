"""Where a server listens, and how clients call it."""

from __future__ import annotations

import ipaddress
import re
import socket
from collections.abc import Sequence

from nearfar._base import check

LOCAL = "127.0.0.1"
NAMES = (LOCAL, "localhost", "[::1]")
"""Names by which browsers may call a server on this machine alone: another name is another site's that points here."""


HOST = re.compile(r"[\w.-]+|\[[0-9a-f:.]+\]", re.ASCII)
"""Name of a host without a port, as browsers send it in lower case."""

ORIGIN = re.compile(rf"[a-z][a-z0-9+.-]*://(?:{HOST.pattern})(?::\d+)?", re.ASCII)
"""Origin of a page, as browsers send it."""

PAGE = re.compile(rf"https?://(?:{HOST.pattern})(?::\d+)?(?:/[^\s?#]*)?", re.ASCII | re.IGNORECASE)
"""Address of a page without a query."""


def address(host: str) -> str:
    """Parse the address to listen at; ValueError if it is none."""
    text = check.text("host", host)
    if text == "localhost":
        return LOCAL
    try:
        return str(ipaddress.ip_address(text))
    except ValueError:
        got = check.shortened(host)
        raise ValueError(
            f"host: expected an address of this machine such as {LOCAL}, or 0.0.0.0 for all of them, got {got}"
        ) from None


def is_local(listened: str) -> bool:
    """Whether only programs on this machine reach an address."""
    return ipaddress.ip_address(listened).is_loopback


def reached(listened: str) -> list[str]:
    """Addresses and names at which clients reach a server, the likeliest first."""
    where = ipaddress.ip_address(listened)
    if not where.is_unspecified:
        return ["localhost", listened] if where.is_loopback else [listened]
    name = socket.gethostname()
    found = [_outward(), f"{name}.local" if "." not in name else name, "localhost", LOCAL]
    return list(dict.fromkeys(host for host in found if host))


def names(given: Sequence[str]) -> list[str]:
    """Check names of hosts and return them in lower case; ValueError for what no browser sends as one."""
    found = [name.lower() for name in check.texts("names", given)]
    for name in found:
        if not HOST.fullmatch(name):
            got = check.shortened(name)
            raise ValueError(f"names: expected names of hosts without a port, such as example.org, got {got}")
    return found


def origin(given: str) -> str:
    """Check whose pages may read the files; ValueError for what no browser sends as an origin."""
    if check.text("origin", given) != "*" and not ORIGIN.fullmatch(given):
        got = check.shortened(given)
        raise ValueError(
            f"origin: expected one such as https://example.org without a slash at its end, or *, got {got}"
        )
    return given


def _outward() -> str | None:
    """Return the address of this machine in its network; None without a network. Nothing is sent."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            # An address for documentation (RFC 5737): only the route to it is looked up.
            probe.connect(("192.0.2.1", 9))
            return str(probe.getsockname()[0])
        except OSError:
            return None


def in_url(host: str) -> str:
    """Write a host as it stands in an address of the web."""
    return f"[{host}]" if ":" in host and not host.startswith("[") else host


def page(url: str) -> str:
    """Check the address of a page or a server, without a query; ValueError for what leads to none."""
    if not PAGE.fullmatch(check.text("url", url)):
        got = check.shortened(url)
        raise ValueError(f"url: expected an address such as https://example.org/town/ without a query, got {got}")
    return url
