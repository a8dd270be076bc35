"""Tests of silenced warnings in one thread while other threads work."""

from __future__ import annotations

import logging
import threading
import warnings

import numpy as np
import pytest

from nearfar._scene import quiet

LOGGER = logging.getLogger("trimesh.util")


def test_warnings_of_this_thread_alone_are_hidden(caplog: pytest.LogCaptureFixture) -> None:
    before = list(warnings.filters), logging.getLogger("trimesh").handlers[:]
    messages: dict[str, list[str]] = {}
    silent, told = threading.Event(), threading.Event()

    def read() -> None:
        with quiet.silence() as found:
            warnings.warn("hidden", RuntimeWarning, stacklevel=1)
            np.log(np.zeros(1))
            LOGGER.warning("lost\nand more")
            LOGGER.info("nothing")
            silent.set()
            told.wait()
            messages["reader"] = found

    thread = threading.Thread(target=read)
    with warnings.catch_warnings(record=True) as shown:
        warnings.simplefilter("always")
        thread.start()
        silent.wait()
        warnings.warn("shown", RuntimeWarning, stacklevel=1)
        LOGGER.warning("kept")
        told.set()
        thread.join()
    assert [str(warning.message) for warning in shown] == ["shown"]
    assert messages["reader"] == ["lost"]
    assert [record.getMessage() for record in caplog.records] == ["kept"]
    assert (list(warnings.filters), logging.getLogger("trimesh").handlers) == before
    assert logging.getLogger("trimesh").propagate


def test_overlapping_threads_restore_the_state() -> None:
    before = list(warnings.filters)
    order = [threading.Event() for _ in range(3)]

    def first() -> None:
        with quiet.silence():
            order[0].set()
            order[1].wait()
        order[2].set()

    def second() -> None:
        order[0].wait()
        with quiet.silence() as messages:
            order[1].set()
            order[2].wait()
            LOGGER.warning("still collected")
            assert messages == ["still collected"]

    threads = [threading.Thread(target=work) for work in (first, second)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert list(warnings.filters) == before
    assert logging.getLogger("trimesh").propagate
    with pytest.warns(RuntimeWarning):
        warnings.warn("shown again", RuntimeWarning, stacklevel=1)
