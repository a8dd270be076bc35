"""Certificates for encrypted connections, which immersive WebXR sessions require."""

from __future__ import annotations

import os
import time
from dataclasses import dataclass, field
from pathlib import Path

from nearfar import _core
from nearfar._base import check, files

_DAYS_LEFT = 30
"""Remaining days below which an own certificate is replaced."""

_DAY = 86400.0


@dataclass(frozen=True)
class Certificate:
    """A certificate and its key, both in PEM files.

    Parameters
    ----------
    certificate, key
        PEM files of the certificate chain, with the server's certificate first, and of its key.

    Raises
    ------
    ValueError
        If a file cannot be read, the key does not match the certificate, or the certificate is not valid today.
    TypeError
        If an argument is not a path.
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
        """Days until the certificate expires."""
        return int((self.ends - time.time()) / _DAY)

    @classmethod
    def self_signed(cls, folder: str | os.PathLike[str], names: list[str]) -> Certificate:
        """Load the self-signed certificate of a folder, or generate one that lasts 13 months.

        It is kept as long as it is valid and has the names, so that a headset must accept it only once.

        Parameters
        ----------
        folder
            Folder of `certificate.pem` and `key.pem`; only its owner can read the key.
        names
            Host names and addresses that the certificate must include.

        Raises
        ------
        OSError
            If the folder cannot be written.
        ValueError
            If a name is not a valid host name.
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
