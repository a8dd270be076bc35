"""The files of vectors that tests of every language read: inputs, exact outputs, and bounds for each consumer."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike

FOLDER = Path(__file__).parent.parent / "vectors"


def cases(file: str, section: str = "cases") -> list[Any]:
    """Cases of a file as parameters of a test, named by their regions."""
    document = json.loads((FOLDER / f"{file}.json").read_text(encoding="utf-8"))
    assert (document["format"], document["version"]) == ("nearfar.vectors", 1)
    return [pytest.param(case, id=case.get("region", str(n))) for n, case in enumerate(document[section])]


def check(found: ArrayLike, expected: ArrayLike, bound: float, *, share: float = 0.0, name: str = "") -> None:
    """Fail, with the name of a case, if numbers differ from the expected ones by more than a bound plus a share."""
    values, exact = np.asarray(found, np.float64), np.asarray(expected, np.float64)
    assert values.shape == exact.shape, name
    np.testing.assert_allclose(values, exact, rtol=share, atol=bound, err_msg=name)
