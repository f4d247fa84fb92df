"""Fixtures of the tests of streams."""

from tests.fixtures import glove, hand
from tests.streaming.conftest import wait_for

__all__ = ["glove", "hand", "wait_for"]
