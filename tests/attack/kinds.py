"""All kinds of cases by name."""

from __future__ import annotations

import functools

from tests.attack import (
    kind_arguments,
    kind_interrupts,
    kind_long,
    kind_saved,
    kind_saves,
    kind_scenes,
    kind_together,
)
from tests.attack.case import Kind


@functools.cache
def all_kinds(*, own_only: bool) -> dict[str, Kind]:
    """Return the kinds; `own_only` makes cases from files made here alone, which are the same on every machine."""
    listed = [
        *kind_scenes.kinds(own_only=own_only),
        *kind_saved.kinds(),
        *kind_arguments.kinds(),
        *kind_saves.kinds(),
        *kind_interrupts.kinds(),
        *kind_together.kinds(),
        *([] if own_only else kind_long.kinds()),
    ]
    return {kind.name: kind for kind in listed}
