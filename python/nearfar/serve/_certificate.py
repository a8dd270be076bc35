"""Certificates for encrypted connections, without which headsets show nothing immersively."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass, field
from pathlib import Path

from nearfar import _core
from nearfar._base import check, files

_DAYS_LEFT = 30
"""A certificate of our own that ends sooner is made anew."""

_DAY = 86400.0


@dataclass(frozen=True)
class Certificate:
    """A certificate and its key, both in PEM files.

    Parameters
    ----------
    certificate, key
        Files of the chain of certificates, the server's first, and of its key.

    Raises
    ------
    ValueError
        If a file cannot be read, the key is that of another certificate, or the certificate is not valid today.
    TypeError
        If a path is no path.
    """

    certificate: Path
    key: Path
    fingerprint: str = field(init=False)
    """SHA-256 of the certificate, as browsers show it."""
    ends: int = field(init=False)
    """When it ends, in seconds since 1970."""
    names: tuple[str, ...] = field(init=False)
    """Names and addresses of hosts that it is for."""

    def __post_init__(self) -> None:
        for name in ("certificate", "key"):
            object.__setattr__(self, name, check.path(name, getattr(self, name)))
        fingerprint, ends, names = _core.certificate(*self.files)
        for name, value in (("fingerprint", fingerprint), ("ends", ends), ("names", tuple(names))):
            object.__setattr__(self, name, value)

    @property
    def files(self) -> tuple[str, str]:
        """Paths of the certificate and of its key."""
        return os.fspath(self.certificate), os.fspath(self.key)

    @property
    def days(self) -> int:
        """Days until it ends."""
        return int((self.ends - time.time()) / _DAY)

    @classmethod
    def self_signed(cls, folder: str | os.PathLike[str], names: list[str]) -> Certificate:
        """Take the certificate that signs itself from a folder, or make one that lasts 13 months.

        It stays the same as long as it is valid and has the names, so that a headset need be told once to trust it.

        Parameters
        ----------
        folder
            Folder of `certificate.pem` and `key.pem`; only its owner can read the key.
        names
            Names and addresses of hosts that it must be for.

        Raises
        ------
        OSError
            If the folder cannot be written.
        ValueError
            If a name is none of a host.
        """
        place, wanted = check.path("folder", folder), check.texts("names", names)
        certificate, key = place / "certificate.pem", place / "key.pem"
        try:
            found = cls(certificate, key)
            if found.days >= _DAYS_LEFT and set(wanted) <= set(found.names):
                return found
        except ValueError:
            pass
        made = _core.self_signed(wanted)
        place.mkdir(parents=True, exist_ok=True)
        for path, text, mode in zip((key, certificate), reversed(made), (0o600, 0o644), strict=True):
            files.write_with_mode(path, text.encode(), mode)
        return cls(certificate, key)
