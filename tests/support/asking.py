"""HTTP requests to servers with a timeout for busy machines."""

from __future__ import annotations

from contextlib import closing
from http.client import HTTPConnection
from typing import Any
from urllib.parse import urlsplit

import httpx

from nearfar.serve._server import Server

HANGS = 120.0
"""Timeout of a request in seconds; httpx itself uses 5 s."""


def get(url: str, **settings: Any) -> httpx.Response:
    """The response to GET, with the settings of httpx."""
    return request("GET", url, **settings)


def request(method: str, url: str, **settings: Any) -> httpx.Response:
    """The response to a method, with the settings of httpx."""
    return httpx.request(method, url, **{"timeout": HANGS, **settings})


def ask(
    server: Server, path: str, method: str = "GET", source: str = "127.0.0.1", **headers: str
) -> tuple[int, dict[str, str], bytes]:
    """Status, headers and content of a response; the path is sent unchanged."""
    host = urlsplit(server.url).netloc
    with closing(HTTPConnection(host, timeout=HANGS, source_address=(source, 0))) as connection:
        connection.request(method, path, headers=headers)
        answer = connection.getresponse()
        return answer.status, {name.lower(): value for name, value in answer.getheaders()}, answer.read()
