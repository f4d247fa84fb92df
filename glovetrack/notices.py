"""What plug-ins report to people: a notice is a code with values, or a finished text.

`plain` makes a notice of a finished text, which is shown unchanged in every language. `notice`,
`warning` and `failure` make one of a code; a package declares the texts of its codes as an entry
point of the group ``glovetrack.notices``: ``TEXTS = {"mine.full": "The disk {path} is full."}``.
Errors (`glovetrack.GlovetrackError`) take a text or a notice.
"""

from tracker.base.notices import Notice, Severity, failure, notice, plain, warning

__all__ = ["Notice", "Severity", "failure", "notice", "plain", "warning"]
