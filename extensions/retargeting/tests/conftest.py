"""Fixtures of the tests of streams."""

from tests.streaming.conftest import make_estimate, names

__all__ = ["make_estimate", "names"]
