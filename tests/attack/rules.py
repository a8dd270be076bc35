"""Rules for what a user sees of a refusal."""

from __future__ import annotations

from pathlib import Path

MOST_LETTERS = 1000


def check_sentence(error: Exception, *names: str | Path) -> None:
    """Finding unless the message is one printable line of a usual length that has a name in it."""
    from tests.attack.case import Finding

    text = str(error)
    try:
        text.encode()
    except UnicodeEncodeError:
        raise Finding(f"the message of {type(error).__name__} cannot be printed: {text!a:.200}") from error
    if "\n" in text.strip("\n") or not 5 < len(text) < MOST_LETTERS + sum(len(str(name)) for name in names):
        raise Finding(f"the message of {type(error).__name__} is no short line: {text[:200]!r}") from error
    if names and not any(str(name) in text for name in names):
        raise Finding(f"the message of {type(error).__name__} does not name the file: {text[:200]!r}") from error
    if any(word in text for word in ("bug report", "panicked", "charset_normalizer", "UnboundLocalError")):
        raise Finding(f"an error from inside reached the user: {text[:200]!r}") from error
