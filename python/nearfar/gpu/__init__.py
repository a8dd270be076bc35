"""Graphics adapters: which there are, which one is used, and whether it is faster than the CPU."""

from nearfar.gpu._adapters import Adapter, adapters, select, selected, stats
from nearfar.gpu._measure import measure

__all__ = ["Adapter", "adapters", "measure", "select", "selected", "stats"]
