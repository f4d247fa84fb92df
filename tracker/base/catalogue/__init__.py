"""The English text of each notice, by its code: the one catalogue.

A text is a template: ``{name:spec}`` is replaced by the value of that name
(`tracker.base.notices` lists the specifications). Window translations use these texts as sources.
Extensions declare theirs as entry points of the group ``glovetrack.notices``.
"""

from __future__ import annotations

from tracker.base.catalogue import (
    colours,
    devices,
    exports,
    sessions,
    settings,
    stereo,
    tracking,
)

TEMPLATES: dict[str, str] = {
    **devices.TEXTS,
    **tracking.TEXTS,
    **colours.TEXTS,
    **stereo.TEXTS,
    **sessions.TEXTS,
    **exports.TEXTS,
    **settings.TEXTS,
}
