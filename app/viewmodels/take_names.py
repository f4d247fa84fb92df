"""Names of recordings by a template: ``{participant}_{task}_{n:03}`` gives ``P01_pinch_007.mcap``.

``{date}`` and ``{time}`` are those of now, ``{n}`` counts: one more than the highest number that a
file of that name has. What is empty leaves no ``_`` behind.
"""

from __future__ import annotations

import re
from datetime import datetime
from pathlib import Path

from app.words import tr
from tracker.base.errors import ConfigError
from tracker.base.files import free_path, name_part

USUAL = "{participant}_{task}_{date}_{time}"
FIELDS = ("participant", "task", "date", "time", "n")
_FIELD = re.compile(r"\{(\w+)(?::0?(\d))?\}")
_SUFFIX = ".mcap"


def check_template(template: str) -> None:
    """Raises ConfigError for one that names nothing, or something that is not known."""
    known = ", ".join(f"{{{name}}}" for name in FIELDS)
    for found in _FIELD.finditer(template):
        if found[1] not in FIELDS:
            raise ConfigError(tr("A name can hold {}, not {}.").format(known, found[0]))
    rest = _FIELD.sub("", template)
    if "{" in rest or "}" in rest or not template.strip():
        raise ConfigError(
            tr("The name {!r} is not complete; it can hold text and {}.").format(template, known)
        )


def take_path(
    folder: Path, participant: str, task: str, now: datetime, template: str = USUAL
) -> Path:
    """A path in ``folder`` that no file has yet. Raises ConfigError for a wrong template."""
    check_template(template)
    values = {
        "participant": name_part(participant),
        "task": name_part(task),
        "date": now.strftime("%Y-%m-%d"),
        "time": now.strftime("%H-%M-%S"),
    }
    named = _FIELD.sub(lambda m: m[0] if m[1] == "n" else values[m[1]], template)
    named = re.sub(r"_{2,}", "_", named).strip("_ ")
    if (count := _FIELD.search(named)) is None:
        return free_path(folder / f"{name_part(named) or 'recording'}{_SUFFIX}")
    before, after = _part(named[: count.start()]), _part(named[count.end() :])
    number = _next_number(folder, before, after)
    return free_path(folder / f"{before}{number:0{count[2] or 1}}{after}{_SUFFIX}")


def _part(text: str) -> str:
    """Text beside the number, which may come to it with a ``-``."""
    return re.sub(r"[^\w-]+", "-", _FIELD.sub("", text))


def _next_number(folder: Path, before: str, after: str) -> int:
    same = re.compile(re.escape(before) + r"(\d+)" + re.escape(after + _SUFFIX))
    names = (path.name for path in folder.glob(f"*{_SUFFIX}"))
    return 1 + max((int(m[1]) for m in map(same.fullmatch, names) if m), default=0)
