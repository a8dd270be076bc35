"""Where a server listens, and how clients call it."""

from __future__ import annotations

import ipaddress
import socket

from nearfar._base import check

LOCAL = "127.0.0.1"
NAMES = (LOCAL, "localhost", "[::1]")
"""Names by which browsers may call a server on this machine alone: another name is another site's that points here."""


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
    return f"[{host}]" if ":" in host else host
