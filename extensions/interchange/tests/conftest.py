"""Fixtures of the session's tests."""

from tests.session.conftest import (  # noqa: F401
    maker,
    record,
    session_info,
)
