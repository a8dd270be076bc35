"""The moving cars of the city."""

from __future__ import annotations

from nearfar.datasets import _vehicles as vehicles
from nearfar.datasets._stage import Stage, placements

# (runs along z, offset from the middle of the avenue in metres, position along it in metres, body, paint).
_TRAFFIC = (
    (True, 1.7, -17.0, 0, 3), (True, 4.5, -41.0, 5, 0), (True, -1.7, -28.0, 1, 6), (False, 1.7, 34.0, 2, 4),
    (True, -4.5, -64.0, 0, 1), (False, -1.7, -23.0, 3, 2), (True, 1.7, 26.0, 4, 7), (False, 4.5, -52.0, 1, 5),
)  # fmt: skip


def moving_cars(stage: Stage, detail: int) -> list[str]:
    """Add the cars on the two avenues, each an object that can be posed; returns their names."""
    names = []
    for number, (along_z, offset, along, body, paint) in enumerate(_TRAFFIC):
        soup = vehicles.car(vehicles.BODIES[body], vehicles.PAINTS[paint], detail)
        if along_z:
            where = placements(offset, 0.0, along, 0.5 if offset > 0 else 0.0)
        else:
            where = placements(along, 0.0, offset, 0.25 if offset > 0 else 0.75)
        names.append(f"car_{number}")
        stage.many(soup, where, names[-1:], moves=True)
    return names
