"""Runs the command line by `python -m nearfar.cli`."""

from nearfar.cli import main

main()
