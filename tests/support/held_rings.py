"""Holds back the files of a bundle's rings until a test releases them."""

from __future__ import annotations

from typing import Any

import nearfar as nf

# The page gives up a server that sends nothing for ten seconds; tests hold files longer.
PATIENT = """() => {
  const wait = window.setTimeout;
  window.setTimeout = (work, milliseconds, ...more) => wait(work, milliseconds >= 5000 ? 1e6 : milliseconds, ...more);
}"""


class HeldRings:
    """Held requests of the page; created before the page is opened. Ring 0 and shared files pass at once."""

    def __init__(self, page: Any, bundle: nf.stream.Bundle) -> None:
        self.allowed = 0
        self._waiting: list[tuple[int, Any]] = []
        self._rings: dict[str, int] = {}
        for number, ring in enumerate(bundle._region["rings"]):
            names = [ring["geometry"], *ring["parts"]]
            for kind in ("color", "range"):
                listed = ring["map"].get(kind)
                names += listed if isinstance(listed, list) else [listed]
            for name in names:
                if name:
                    self._rings.setdefault(name, number)
        page.add_init_script(f"({PATIENT})()")
        page.route("**/files/*", self._take)

    def release(self, ring: int) -> None:
        """Release the files of a ring and of the rings before it."""
        self.allowed = ring
        waiting, self._waiting = self._waiting, []
        for number, route in waiting:
            if number <= ring:
                route.continue_()
            else:
                self._waiting.append((number, route))

    def _take(self, route: Any) -> None:
        number = self._rings.get("files/" + route.request.url.rsplit("/", 1)[1].split("?")[0], 0)
        if number <= self.allowed:
            route.continue_()
        else:
            self._waiting.append((number, route))
