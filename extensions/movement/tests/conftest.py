"""Fixtures of the session's tests."""

from tests.session.conftest import maker, record, session_info

__all__ = ["maker", "record", "session_info"]
