"""Runs batches of all kinds on all cores, for a time or for a number of cases."""

from __future__ import annotations

import threading
import time
from collections.abc import Iterable
from dataclasses import dataclass

from tests.attack.case import Kind
from tests.attack.report import Report
from tests.attack.runner import Result, Runner

BATCH_SECONDS = 5.0
"""Time that a batch should take, so that all kinds get on and a stop is not far."""
FIRST_BATCH, MOST_IN_BATCH = 8, 200


@dataclass
class _Share:
    kind: Kind
    done: int = 0
    seconds: float = 0.0

    @property
    def served(self) -> float:
        return self.done / self.kind.share

    @property
    def batch(self) -> int:
        """Cases of the next batch."""
        if not self.done:
            return max(1, round(FIRST_BATCH * min(1.0, self.kind.share)))
        return int(min(MOST_IN_BATCH, max(1, BATCH_SECONDS * self.done / max(self.seconds, 1e-3))))


class Attack:
    """Deals batches out to workers so that kinds get on in proportion to their shares.

    Parameters
    ----------
    kinds
        Kinds of cases by name.
    seed
        Seed of all cases.
    report
        Takes the results.
    limits, own_only
        As for `Runner`.
    """

    def __init__(self, kinds: dict[str, Kind], seed: int, report: Report, *, limits: bool, own_only: bool) -> None:
        self._kinds, self._seed, self.report = kinds, seed, report
        self._options = {"limits": limits, "own_only": own_only}
        self._shares = [_Share(kind) for kind in kinds.values()]
        self._lock = threading.Lock()
        self._runners: list[Runner] = []
        self._has_stopped = False

    def run(self, workers: int, *, until: float | None = None, cases: int | None = None) -> None:
        """Run until a time of the monotonic clock, or a number of cases of a kind with share 1 have run."""
        faults: list[BaseException] = []

        def serve() -> None:
            try:
                self._serve(until, cases)
            except BaseException as fault:
                faults.append(fault)

        threads = [threading.Thread(target=serve) for _ in range(workers)]
        for thread in threads:
            thread.start()
        try:
            for thread in threads:
                while thread.is_alive():
                    thread.join(0.2)
        except BaseException:
            self._has_stopped = True
            for runner in self._runners:
                runner.stop()
            raise
        finally:
            for thread in threads:
                thread.join()
        if faults:
            raise faults[0]

    def _serve(self, until: float | None, cases: int | None) -> None:
        with Runner(self._kinds, **self._options) as runner:
            self._runners.append(runner)
            while not self._has_stopped and (until is None or time.monotonic() < until):
                taken = self._take(cases)
                if taken is None:
                    break
                share, first, count = taken
                start = time.monotonic()
                results = runner.batch(share.kind.name, self._seed, first, count)
                if not self._has_stopped:
                    self._note(share, results, time.monotonic() - start)
            ending = runner.close()
            if ending and not self._has_stopped:
                self._note(None, [Result("exit", -1, "died", finding=ending)], 0.0)

    def _take(self, cases: int | None) -> tuple[_Share, int, int] | None:
        with self._lock:
            open_shares = [
                share for share in self._shares if cases is None or share.done < max(1, round(cases * share.kind.share))
            ]
            if not open_shares:
                return None
            share = min(open_shares, key=lambda share: share.served)
            count = share.batch
            if cases is not None:
                count = min(count, max(1, round(cases * share.kind.share)) - share.done)
            first, share.done = share.done, share.done + count
            return share, first, count

    def _note(self, share: _Share | None, results: Iterable[Result], seconds: float) -> None:
        with self._lock:
            if share is not None:
                share.seconds += seconds
            self.report.add(results)
