"""Calls with hostile arguments, and the verdict on what they raise."""

from __future__ import annotations

import asyncio
import contextlib
import functools
import inspect
import itertools
import re
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import nearfar as nf
from tests.support.digest import digest

ALLOWED = (ValueError, TypeError, nf.Error, OSError, MemoryError)
"""Exceptions for invalid arguments; their subclasses below are accidents."""

ACCIDENTS = (UnicodeError,)
"""Subclasses of allowed exceptions that come from inside."""

LONGEST = 600
"""Maximum length of a message: values are cut, and paths are shorter."""

FOREIGN = re.compile(
    r"object is not|is not iterable|not subscriptable|has no attribute|has no len|unsupported operand|truth value"
    r"|only integer scalar|only length-1|size-1 arrays|cannot be interpreted|could not convert|cannot convert"
    r"|cannot be converted|cannot be cast|can't convert|invalid literal|not supported between|must be real number"
    r"|must be a string|must be str|must be an integer|too many values|not enough values|inhomogeneous"
    r"|setting an array|ufunc|broadcast together|Unable to allocate|array is too big|unhashable"
    r"|required positional argument|unexpected keyword|takes \d|takes from|not callable|<class '"
    r"|embedded null|surrogates not allowed|codec can't|argument '|Python int too large|int too big"
    r"|out of bounds|dtype\(|data type .* not understood|nan to integer|infinity to integer|expected str, bytes"
    r"|is read-only"
)
"""Parts of messages of Python, NumPy and PyO3."""


@contextlib.contextmanager
def strict_warnings() -> Iterator[None]:
    """Raise warnings as exceptions, except those about folded pictures."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", "the picture folds")
        yield


@strict_warnings()
def attempt(call: Callable[..., Any], arguments: Mapping[str, Any]) -> BaseException | None:
    """Call with keywords and return the exception; warnings count as such."""
    return caught(call, arguments)


def caught(call: Callable[..., Any], arguments: Mapping[str, Any], *, begins: bool = True) -> BaseException | None:
    """Call with keywords and return the exception.

    Without `begins` a returned iterator is not started: invalid arguments are refused at the call.
    """
    try:
        result(call, arguments, begins=begins)
    except Exception as error:
        return error
    except BaseException as error:
        # PyO3's panics derive from BaseException alone.
        if type(error).__name__ != "PanicException":
            raise
        return error
    return None


def outcome(call: Callable[..., Any], arguments: Mapping[str, Any]) -> str:
    """Call with keywords and return the digest of the result, or an empty text for a refusal."""
    with warnings.catch_warnings(), contextlib.suppress(*ALLOWED):
        warnings.simplefilter("ignore")
        return digest(result(call, arguments))
    return ""


def result(call: Callable[..., Any], arguments: Mapping[str, Any], *, begins: bool = True) -> Any:
    """The result of a call; an iterator is started unless disabled, and a coroutine is run."""
    returned = call(**arguments)
    if inspect.iscoroutine(returned):
        return asyncio.run(returned)
    return list(itertools.islice(returned, 2)) if begins and isinstance(returned, Iterator) else returned


def verdict(exception: BaseException | None, parameter: str, others: Iterable[str] = ()) -> str | None:
    """Return why an exception is wrong for an unusable value of a parameter; None if it is right or there is none.

    The message must name the parameter, or one of the call's `others`, which may no longer fit it.
    """
    if exception is None:
        return None
    text = ascii(f"{type(exception).__name__}: {exception}")
    allowed = (*ALLOWED, IndexError) if parameter == "index" else ALLOWED
    if not isinstance(exception, allowed) or isinstance(exception, ACCIDENTS):
        return f"an exception of a wrong type, {text}"
    if FOREIGN.search(str(exception)):
        return f"a message that is not ours, {text}"
    is_named = _any_of((parameter, *others)).search(str(exception)) is not None
    if len(text) > LONGEST:
        return f"a message of {len(text)} characters, {text}"
    # Files, scenes and devices are named by their own names.
    if not is_named and not isinstance(exception, OSError | nf.Error):
        return f"a message that does not name {parameter}, {text}"
    return None


@functools.cache
def _any_of(names: tuple[str, ...]) -> re.Pattern[str]:
    """Return a pattern that finds each of these names as a whole word."""
    return re.compile(rf"(?<![A-Za-z0-9])({'|'.join(map(re.escape, names))})(?![A-Za-z0-9])")
