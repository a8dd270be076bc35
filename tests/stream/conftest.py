"""A city and a server with rooms, shared by tests of streams; tests of users are coroutines."""

from __future__ import annotations

import inspect
from collections.abc import Iterator

import pytest

import nearfar as nf
from nearfar.serve._server import Server
from tests.support import need
from tests.support.room_cases import run, server as served


@pytest.fixture(scope="session")
def city() -> nf.Scene:
    return nf.datasets.city(blocks=3, detail=0)


@pytest.fixture(scope="session")
def server() -> Iterator[Server]:
    need("aiohttp")
    with served() as running:
        yield running


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """Run a test that is a coroutine in an event loop; TimeoutError if it hangs."""
    if not inspect.iscoroutinefunction(pyfuncitem.obj):
        return None
    run(pyfuncitem.obj(**{name: pyfuncitem.funcargs[name] for name in inspect.signature(pyfuncitem.obj).parameters}))
    return True
