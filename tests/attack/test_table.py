"""The table of hostile values excuses a parameter only from values that it really accepts."""

from __future__ import annotations

from collections import defaultdict

from tests.support import missing
from tests.support.hostile import hostile_values, variants
from tests.support.hostile_calls import Call
from tests.support.name_patterns import match_length
from tests.support.parameters import ANNOTATIONS, RANGES, TAKEN, kinds_of
from tests.support.valid_calls.calls import NAMES, needs, parameters_of
from tests.support.valid_calls.objects import Valid
from tests.support.wrong_values import WRONG


def full_names(call: str) -> list[str]:
    """Return names of a call's parameters, by the callable and by the call."""
    return [name for key, (own, _) in parameters_of(call).items() for name in (own, f"{call}.{key}")]


def test_every_pattern_matches_a_parameter() -> None:
    names = {name for call in NAMES for name in full_names(call)}
    patterns = {pattern for text in (*TAKEN.values(), *RANGES.values(), *WRONG) for pattern in text.split()}
    assert [pattern for pattern in patterns if not any(match_length(name, pattern) for name in names)] == []


def test_every_kind_belongs_to_a_value(valid: Valid) -> None:
    values = (*hostile_values(valid), *variants(valid.vertices))
    stated = {kind for text in (*TAKEN, *ANNOTATIONS.values()) for kind in text.split()}
    assert stated - {"any"} - {kind for value in values for kind in value.kinds} == set()


def test_every_exception_is_accepted_by_all_matching_parameters(valid: Valid) -> None:
    calls = [Call(name, valid) for name in NAMES if not any(map(missing, needs(name)))]
    taken: dict[tuple[str, str, str], bool] = defaultdict(bool)
    for kinds, pattern in ((kinds, pattern) for kinds, patterns in TAKEN.items() for pattern in patterns.split()):
        for call in calls:
            for parameter, (own, _) in parameters_of(call.name).items():
                if match_length(own, pattern) or match_length(f"{call.name}.{parameter}", pattern):
                    key = (kinds, pattern, own)
                    taken[key] = taken[key] or is_taken(call, parameter, frozenset(kinds.split()), valid)
    assert [key for key, is_needed in taken.items() if not is_needed] == []


def is_taken(call: Call, parameter: str, kinds: frozenset[str], valid: Valid) -> bool:
    """Return whether a parameter accepts a value of these kinds that its annotation does not state."""
    usual = kinds_of(parameters_of(call.name)[parameter][1])
    return any(
        call.caught({parameter: value.make()}, begins=False) is None
        for value in (*hostile_values(valid), *variants(call.arguments.get(parameter)))
        if ("any" in kinds or value.kinds & kinds) and not value.kinds & usual
    )
