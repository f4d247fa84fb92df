"""Errors that reach a user: each carries a notice with what happened, why, and what to do."""

from __future__ import annotations

from tracker.base.notices import Notice, Severity, plain


class GlovetrackError(Exception):
    """Something the user asked for could not be done.

    ``notice`` has the code and the values; ``str(error)`` is its English text. A plug-in may give
    a finished sentence instead.
    """

    def __init__(self, what: Notice | str = "") -> None:
        super().__init__(what)
        report = what if isinstance(what, Notice) else plain(what)
        self.notice = report.with_severity(Severity.ERROR)

    def __str__(self) -> str:
        return str(self.notice)


class FileError(GlovetrackError):
    """A file is missing, damaged or not what it claims to be."""


class DeviceError(GlovetrackError):
    """A glove or camera is absent, in use or faulty."""


class ConfigError(GlovetrackError):
    """A setting has an unknown name, a wrong type or an impossible value."""


class DataError(ValueError):
    """A part of a file or message is invalid; ``notice`` gives the reason. Its reader, which knows
    the file, reports it."""

    def __init__(self, what: Notice) -> None:
        super().__init__(what)
        self.notice = what.with_severity(Severity.ERROR)

    def __str__(self) -> str:
        return str(self.notice)


def notice_of(failure: BaseException) -> Notice:
    """What an error reports: its notice, or the text of an error that is not ours."""
    if isinstance(failure, GlovetrackError | DataError):
        return failure.notice
    text = str(failure) or type(failure).__name__
    return plain(text, Severity.ERROR)
