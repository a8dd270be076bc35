"""Certificates for encrypted connections, which immersive WebXR sessions require."""

from __future__ import annotations

import os
import time
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from nearfar import _core
from nearfar._base import check, files

_MIN_DAYS = 30
"""Remaining days below which an own certificate is replaced."""


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
        return int((self.ends - time.time()) / 86_400.0)

    @classmethod
    def self_signed(cls, folder: str | os.PathLike[str], names: list[str]) -> Certificate:
        """Load the self-signed certificate of a folder, or generate one that lasts 13 months.

        It is kept as long as it is valid and has the host names and addresses `names`, so that a headset must accept it
        only once. The folder has `certificate.pem` and `key.pem`; only its owner can read the key. OSError if the
        folder cannot be written, ValueError if a name is not a valid host name.
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
