"""Benchmarks by stage, run from the checkout: `python -m benchmarks.<stage>.<name>`."""
