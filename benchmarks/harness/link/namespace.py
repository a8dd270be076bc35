"""Network namespaces without names, which end with the processes that hold them, and TUN devices in them."""

from __future__ import annotations

import ctypes
import fcntl
import os
import shutil
import struct
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ADDRESSES = ("10.91.0.1", "10.91.0.2")
"""Addresses of the server and of the client; they exist only within the two namespaces."""
DEVICE = "shaped0"
"""Name of the device on both sides. Chromium does not count devices beginning with "tun" as connections."""
TUN = "/dev/net/tun"
_CLONE_NEWNET = 0x40000000
_TUNSETIFF, _IFF_TUN, _IFF_NO_PI = 0x400454CA, 0x0001, 0x1000
_SELF = "/proc/thread-self/ns/net"


def no_link() -> str:
    """Return why links cannot be shaped here, or "" if they can."""
    if sys.platform != "linux":
        return "a shaped link needs Linux"
    missing = [name for name in ("ip", "nsenter") if not shutil.which(name)]
    if missing:
        return f"a shaped link needs the program {missing[0]}"
    try:
        namespace = new_namespace()
    except OSError as error:
        return f"a shaped link needs a network namespace, which takes root: {error.strerror}"
    try:
        os.close(_device(namespace))
    except OSError as error:
        return f"a shaped link needs a TUN device ({TUN}): {error.strerror}"
    finally:
        os.close(namespace)
    return ""


def new_namespace() -> int:
    """Create a network namespace and return the descriptor that holds it."""
    own_namespace = os.open(_SELF, os.O_RDONLY)
    try:
        _call("unshare", _CLONE_NEWNET)
        try:
            namespace = os.open(_SELF, os.O_RDONLY)
        finally:
            _call("setns", own_namespace, _CLONE_NEWNET)
    finally:
        os.close(own_namespace)
    return namespace


@contextmanager
def enter_namespace(namespace: int) -> Iterator[None]:
    """Move this thread, and processes that it starts, into the namespace; existing sockets stay where they are."""
    own_namespace = os.open(_SELF, os.O_RDONLY)
    try:
        _call("setns", namespace, _CLONE_NEWNET)
        try:
            yield
        finally:
            _call("setns", own_namespace, _CLONE_NEWNET)
    finally:
        os.close(own_namespace)


def open_device(namespace: int, address: str, *, mtu: int, congestion: str) -> int:
    """Create the link's end in a namespace: an active TUN device with an address and TCP's settings."""
    device = _device(namespace)
    os.set_blocking(device, False)
    with enter_namespace(namespace):
        for name, value in (
            # Only packets of a test cross the link.
            ("ipv6/conf/all/disable_ipv6", "1"),
            # A connection does not use metrics of previous ones.
            ("ipv4/tcp_no_metrics_save", "1"),
        ):
            setting = Path("/proc/sys/net", name)
            if setting.exists():
                setting.write_text(value)
        _ip("link", "set", "lo", "up")
        _ip("address", "add", f"{address}/32", "dev", DEVICE)
        _ip("link", "set", DEVICE, "mtu", str(mtu), "txqueuelen", "5000", "up")
        # Set per route, because a namespace may not make every congestion control its default.
        peer_address = ADDRESSES[1 - ADDRESSES.index(address)]
        _ip("route", "add", peer_address, "dev", DEVICE, "src", address, "congctl", congestion)
    return device


def _device(namespace: int) -> int:
    """Create a TUN device without packet headers: the kernel fragments packets larger than the MTU itself."""
    with enter_namespace(namespace):
        device = os.open(TUN, os.O_RDWR | os.O_CLOEXEC)
        try:
            fcntl.ioctl(device, _TUNSETIFF, struct.pack("16sH22x", DEVICE.encode(), _IFF_TUN | _IFF_NO_PI))
        except OSError:
            os.close(device)
            raise
    return device


def _ip(*arguments: str) -> None:
    process = subprocess.run(["ip", *arguments], capture_output=True, text=True, check=False)
    if process.returncode:
        raise OSError(f"ip {' '.join(arguments)}: {process.stderr.strip()}")


def _call(name: str, *arguments: int) -> None:
    library = ctypes.CDLL(None, use_errno=True)
    if getattr(library, name)(*arguments):
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number), name)
