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
"""Of the server and of the client; they exist within the two namespaces alone."""
DEVICE = "shaped0"
"""Name of the device in either. Chromium takes those that begin with "tun" for no connection."""
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
    """Make a network namespace and return the descriptor that keeps it."""
    here = os.open(_SELF, os.O_RDONLY)
    try:
        _call("unshare", _CLONE_NEWNET)
        try:
            namespace = os.open(_SELF, os.O_RDONLY)
        finally:
            _call("setns", here, _CLONE_NEWNET)
    finally:
        os.close(here)
    return namespace


@contextmanager
def inside(namespace: int) -> Iterator[None]:
    """Put this thread, and what it starts, into the namespace; sockets stay where they were made."""
    here = os.open(_SELF, os.O_RDONLY)
    try:
        _call("setns", namespace, _CLONE_NEWNET)
        try:
            yield
        finally:
            _call("setns", here, _CLONE_NEWNET)
    finally:
        os.close(here)


def open_device(namespace: int, address: str, *, mtu: int, congestion: str) -> int:
    """Make the link's end in a namespace: a TUN device that is up, with an address and TCP's settings."""
    device = _device(namespace)
    os.set_blocking(device, False)
    with inside(namespace):
        for name, value in (
            # Nothing but what a test sends crosses the link.
            ("ipv6/conf/all/disable_ipv6", "1"),
            # A connection learns nothing from those before it.
            ("ipv4/tcp_no_metrics_save", "1"),
        ):
            setting = Path("/proc/sys/net", name)
            if setting.exists():
                setting.write_text(value)
        _ip("link", "set", "lo", "up")
        _ip("address", "add", f"{address}/32", "dev", DEVICE)
        _ip("link", "set", DEVICE, "mtu", str(mtu), "txqueuelen", "5000", "up")
        # By route, because namespaces may not choose among all kinds of congestion control as their default.
        other = ADDRESSES[1 - ADDRESSES.index(address)]
        _ip("route", "add", other, "dev", DEVICE, "src", address, "congctl", congestion)
    return device


def _device(namespace: int) -> int:
    """A TUN device without a header before its packets: the kernel cuts what is larger than the MTU itself."""
    with inside(namespace):
        device = os.open(TUN, os.O_RDWR | os.O_CLOEXEC)
        try:
            fcntl.ioctl(device, _TUNSETIFF, struct.pack("16sH22x", DEVICE.encode(), _IFF_TUN | _IFF_NO_PI))
        except OSError:
            os.close(device)
            raise
    return device


def _ip(*arguments: str) -> None:
    done = subprocess.run(["ip", *arguments], capture_output=True, text=True, check=False)
    if done.returncode:
        raise OSError(f"ip {' '.join(arguments)}: {done.stderr.strip()}")


def _call(name: str, *arguments: int) -> None:
    library = ctypes.CDLL(None, use_errno=True)
    if getattr(library, name)(*arguments):
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number), name)
