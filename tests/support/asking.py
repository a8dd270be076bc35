"""HTTP requests to servers with a timeout for busy machines."""

from __future__ import annotations

from typing import Any

import httpx

HANGS = 120.0
"""Timeout of a request in seconds; httpx itself uses 5 s."""


def get(url: str, **settings: Any) -> httpx.Response:
    """The response to GET, with the settings of httpx."""
    return request("GET", url, **settings)


def request(method: str, url: str, **settings: Any) -> httpx.Response:
    """The response to a method, with the settings of httpx."""
    return httpx.request(method, url, **{"timeout": HANGS, **settings})
