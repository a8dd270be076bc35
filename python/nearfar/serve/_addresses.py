"""Addresses at which a server listens, and host names of its clients."""

from __future__ import annotations

import ipaddress
import re
import socket
from collections.abc import Sequence

from nearfar._base import check

LOCAL = "127.0.0.1"
NAMES = (LOCAL, "localhost", "[::1]")
"""Host names accepted by a server that only local programs reach; other names may be a DNS rebinding attack."""


HOST = re.compile(r"[\w.-]+|\[[0-9a-f:.]+\]", re.ASCII)
"""Pattern of a host name without a port, in lower case as browsers send it."""

ORIGIN = re.compile(rf"[a-z][a-z0-9+.-]*://(?:{HOST.pattern})(?::\d+)?", re.ASCII)
"""Pattern of a page's origin, as browsers send it."""

PAGE = re.compile(rf"https?://(?:{HOST.pattern})(?::\d+)?(?:/[^\s?#]*)?", re.ASCII | re.IGNORECASE)
"""Pattern of a page's address without a query."""


def parse_host(host: str) -> str:
    """Parse the address to listen at; ValueError if it is invalid."""
    text = check.text("host", host)
    if text == "localhost":
        return LOCAL
    try:
        return str(ipaddress.ip_address(text))
    except ValueError:
        expected = f"an address of this machine such as {LOCAL}, or 0.0.0.0 for all of them"
        raise ValueError(f"host: expected {expected}, got {check.shortened(host)}") from None


def is_local(host_address: str) -> bool:
    """Return whether an address is reachable only from this machine."""
    return ipaddress.ip_address(host_address).is_loopback


def hosts_of(host_address: str) -> list[str]:
    """Return addresses and names at which clients reach a server, the most useful first."""
    address = ipaddress.ip_address(host_address)
    if not address.is_unspecified:
        return ["localhost", host_address] if address.is_loopback else [host_address]
    name = socket.gethostname()
    hosts = [_network_address(), f"{name}.local" if "." not in name else name, "localhost", LOCAL]
    return list(dict.fromkeys(host for host in hosts if host))


def parse_names(names: Sequence[str]) -> list[str]:
    """Check host names and return them in lower case; ValueError for invalid names."""
    expected = "names of hosts without a port, such as example.org"
    return [_check_pattern("names", name.lower(), HOST, expected) for name in check.texts("names", names)]


def check_origin(origin: str) -> str:
    """Check the origin whose pages may read the files; ValueError for an invalid origin."""
    expected = "one such as https://example.org without a slash at its end, or *"
    return origin if origin == "*" else _check_pattern("origin", origin, ORIGIN, expected)


def _network_address() -> str | None:
    """Return the address of this machine in its network, without sending anything; None without a network."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        try:
            # An address for documentation (RFC 5737); connecting a UDP socket only looks up the route.
            probe.connect(("192.0.2.1", 9))
            return str(probe.getsockname()[0])
        except OSError:
            return None


def host_in_url(host: str) -> str:
    """Return a host as it is written in a URL."""
    return f"[{host}]" if ":" in host and not host.startswith("[") else host


def check_page(url: str) -> str:
    """Check the address of a page or a server, without a query; ValueError for an invalid address."""
    return _check_pattern("url", url, PAGE, "an address such as https://example.org/town/ without a query")


def _check_pattern(name: str, value: str, pattern: re.Pattern[str], expected: str) -> str:
    if not pattern.fullmatch(check.text(name, value)):
        raise ValueError(f"{name}: expected {expected}, got {check.shortened(value)}")
    return value
