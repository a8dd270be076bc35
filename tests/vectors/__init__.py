"""Inputs and exact outputs of formulas that several languages implement, and the oracles that write them."""
