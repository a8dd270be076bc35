"""Requests to servers, which wait for a busy machine as long as a test may."""

from __future__ import annotations

from typing import Any

import httpx

HANGS = 120.0
"""Seconds after which a request has failed; httpx itself waits for 5 s."""


def get(url: str, **settings: Any) -> httpx.Response:
    """The answer to GET, with the settings of httpx."""
    return request("GET", url, **settings)


def request(method: str, url: str, **settings: Any) -> httpx.Response:
    """The answer to a method, with the settings of httpx."""
    return httpx.request(method, url, **{"timeout": HANGS, **settings})
