"""Server of sites, exported by `nearfar._core`; there is no such module at run time."""

from collections.abc import Callable
from typing import final

# serve --------------------------------------------------------------------------------------------------------------
@final
class Server:
    def __new__(
        cls,
        sites: list[
            tuple[
                str,
                list[tuple[str, str, bool, bytes | tuple[str, int] | Callable[[], bytes]]],
                tuple[Callable[[list[float]], object], Callable[..., object], float, str | None, int] | None,
            ]
        ],
        *,
        host: str,
        port: int,
        hosts: list[str] | None,
        headers: list[tuple[str, str]],
        origin: str | None,
        certificate: tuple[str, str] | None,
        limits: object,
        rooms: object | None = None,
    ) -> Server: ...
    @property
    def port(self) -> int: ...
    def close(self) -> None: ...

def certificate(certificate: str, key: str) -> tuple[str, int, list[str]]: ...
def self_signed(names: list[str]) -> tuple[str, str]: ...
def room_token(room: str, ends: int, number: bytes, key: bytes) -> str: ...
def begin_log(level: str, as_json: bool) -> bool: ...
