"""Requests of other programs and replies to them, independent of the transport.

    {"do": "note", "text": "the cup is taken", "id": 7}
    {"ok": true, "do": "note", "text": "Noted.", "id": 7}
    {"ok": false, "do": "stop", "error": "Nothing is being recorded.", "id": 8}

A datagram may also be plain text: ``start``, ``note the cup is taken``. A further request
needs a line in `FIELDS` and in the receiver; an unknown word or field is reported as an error,
so that a client can find out what this version supports.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, notice, to_json
from tracker.hand.names import CHAINS

MOST_BYTES = 2048  # of a request
MOST_REPLY = 16384  # characters of an answer; a path may have 4096
MOST_TEXT = 500  # characters of a note
MOST_NAME = 64  # characters of the name of an object
MOST_ID = 64  # characters of an id
MOST_AMPLITUDE, USUAL_AMPLITUDE = 255, 200
MOST_MS, USUAL_MS = 2000, 80  # of one vibration: a client that crashes cannot leave a motor running
FIELDS: Mapping[str, tuple[str, ...]] = {
    "start": (),
    "stop": (),
    "note": ("text",),
    "status": (),
    "vibrate": ("finger", "amplitude", "duration_ms"),
    "contact": ("finger", "strength", "object"),
}
"""The requests, and the fields of each besides ``do`` and ``id``."""


_REPLY_VALUES = (str, int, float, bool, type(None))


class RequestError(GlovetrackError):
    """A request cannot be parsed."""


@dataclass(frozen=True)
class Request:
    """``t``: arrival time (s) on the host's monotonic clock; ``id`` is returned in the answer.

    ``data``: values of a note besides its text; ``side``: the hand that vibrates ("": the first);
    requests do not contain them, the receiving socket sets them.
    """

    do: str
    t: float
    text: str = ""
    finger: str = ""
    amplitude: int = USUAL_AMPLITUDE
    duration_ms: int = USUAL_MS
    strength: float = 1.0
    object: str = ""
    id: str | int | None = None
    data: Mapping[str, Any] = field(default_factory=dict)
    side: str = ""


@dataclass(frozen=True)
class Reply:
    """``text`` is a sentence that says what was done or, if not ``ok``, why it was not.

    ``more`` contains values for programs, ready for JSON.
    """

    ok: bool
    do: str
    text: str
    file: Path | None = None
    more: Mapping[str, Any] = field(default_factory=dict)
    id: str | int | None = None
    notice: Notice | None = None
    """The reason as code and values, which programs should compare instead of ``text``."""

    @staticmethod
    def refused(do: str, why: Notice, id: str | int | None = None) -> Reply:
        """Nothing was done, for this reason."""
        return Reply(False, do, str(why), id=id, notice=why)

    def as_json(self, with_folder: bool = False) -> str:
        """One line. The file's path is reported to this computer's user only."""
        out: dict[str, Any] = {"ok": self.ok, "do": self.do}
        out["text" if self.ok else "error"] = self.text
        if self.file is not None:
            out["file"] = str(self.file) if with_folder else self.file.name
        if self.notice is not None:
            report = to_json(self.notice)
            out |= {"code": report["code"], "values": report["values"]}
        out |= self.more
        if self.id is not None:
            out["id"] = self.id
        return json.dumps(out, allow_nan=False)


def parse(data: bytes | str, t: float) -> Request | None:
    """Parses a request in JSON or plain text; returns None for an answer, which gets no reply.

    Raises RequestError.
    """
    if len(data) > MOST_BYTES:
        raise RequestError(notice("request.too_long", most=MOST_BYTES))
    try:
        text = data.decode("utf-8") if isinstance(data, bytes) else data
        given = json.loads(text) if text.lstrip().startswith("{") else _words(text)
    except (ValueError, RecursionError) as error:
        raise RequestError(notice("request.not_readable")) from error
    return None if "ok" in given else from_fields(given, t)


def is_reply(data: bytes | str) -> bool:
    """Whether this is one line as `Reply.as_json` writes them, and nothing else."""
    try:
        text = data.decode("utf-8") if isinstance(data, bytes) else data
        given = json.loads(text)
    except (ValueError, RecursionError):
        return False
    if not isinstance(given, dict) or "\n" in text.rstrip("\n") or len(text) > MOST_REPLY:
        return False
    ok = given.get("ok")
    return (
        isinstance(ok, bool)
        and (given.get("do") == "" or given.get("do") in FIELDS)
        and isinstance(given.get("text" if ok else "error"), str)
        and all(isinstance(given.get(key, ""), str) for key in ("text", "error", "file"))
        and isinstance(given.get("values", {}), dict)
        and all(isinstance(v, _REPLY_VALUES) for key, v in given.items() if key != "values")
    )


def _words(text: str) -> dict[str, Any]:
    """``note the cup is taken`` or ``vibrate index`` as fields."""
    do, _, rest = text.strip().partition(" ")
    given: dict[str, Any] = {"do": do.lower()}
    fields = FIELDS.get(given["do"], ())
    if rest.strip():
        given[fields[0] if fields else "text"] = rest.strip()
    return given


def from_fields(given: Mapping[str, Any], t: float) -> Request:
    """A request that contains only known fields with valid values. Raises RequestError."""
    do = given.get("do")
    if not isinstance(do, str) or do not in FIELDS:
        raise RequestError(notice("request.unknown", known=FIELDS))
    known = (*FIELDS[do], "do", "id")
    strange = [key for key in given if key not in known]
    if strange:
        raise RequestError(notice("request.unknown_field", do=do, field=str(strange[0])[:40]))
    values = {key: _CHECKS[key](value) for key, value in given.items() if key != "do"}
    request = Request(do, t, **values)
    if do == "note" and not request.text:
        raise RequestError(notice("request.note_empty"))
    if do in ("vibrate", "contact") and not request.finger:
        raise RequestError(notice("request.finger_missing", do=do, fingers=CHAINS))
    return request


def _text(value: object) -> str:
    """Returns one line without control characters. Raises RequestError."""
    if not isinstance(value, str):
        raise RequestError(notice("request.text"))
    clean = "".join(c if c.isprintable() else " " for c in value).strip()
    if len(clean) > MOST_TEXT:
        raise RequestError(notice("request.note_too_long", most=MOST_TEXT))
    return clean


def _finger(value: object) -> str:
    if not isinstance(value, str) or value not in CHAINS:
        raise RequestError(notice("request.finger", fingers=CHAINS))
    return value


def _whole(name: str, low: int, high: int) -> Callable[[object], int]:
    def check(value: object) -> int:
        if isinstance(value, float) and value.is_integer():
            value = int(value)  # surfaces of OSC send floats
        if type(value) is not int or not low <= value <= high:
            raise RequestError(notice("request.integer", field=name, least=low, most=high))
        return value

    return check


def _share(value: object) -> float:
    if isinstance(value, int | float) and not isinstance(value, bool) and 0 <= value <= 1:
        return float(value)
    raise RequestError(notice("request.strength"))


def _object(value: object) -> str:
    """The name of a touched object. Raises RequestError."""
    name = _text(value)
    if len(name) > MOST_NAME:
        raise RequestError(notice("request.object", most=MOST_NAME))
    return name


def _id(value: object) -> str | int | None:
    """Checks that an id is small, since it is returned."""
    if value is None or (isinstance(value, str) and len(value) <= MOST_ID):
        return value
    if type(value) is int and abs(value) < 2**63:
        return value
    raise RequestError(notice("request.id", most=MOST_ID))


_CHECKS: Mapping[str, Callable[[object], Any]] = {
    "text": _text,
    "finger": _finger,
    "amplitude": _whole("amplitude", 0, MOST_AMPLITUDE),
    "duration_ms": _whole("duration_ms", 1, MOST_MS),
    "strength": _share,
    "object": _object,
    "id": _id,
}
