"""Operations that take seconds if nothing stops them: one for each kernel and file format that grows with its input."""

from __future__ import annotations

from tests.support.long_arrays import ARRAYS
from tests.support.long_operation import LongOperation, code
from tests.support.long_pictures import PICTURES

__all__ = ["OPERATIONS", "LongOperation", "code"]

OPERATIONS = (*ARRAYS, *PICTURES)
