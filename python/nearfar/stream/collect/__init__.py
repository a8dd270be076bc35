"""Sphere collection task of CloVR's (2024) Experiment 2, and simulated users who play it."""

from __future__ import annotations

from nearfar.stream.collect._person import Person
from nearfar.stream.collect._play import play
from nearfar.stream.collect._settings import Settings
from nearfar.stream.collect._simulate import Collected, Outcome, simulate

__all__ = ["Collected", "Outcome", "Person", "Settings", "play", "simulate"]
