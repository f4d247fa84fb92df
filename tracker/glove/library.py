"""Hand files, glove files and colour profiles by name or by path.

A name is searched for in the user's own folder first, then among the files included in the program.
"""

from __future__ import annotations

from pathlib import Path

from platformdirs import user_data_path

from resources import folder
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.glove.files import glove_hand_name, parse_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import parse_hand
from tracker.hand.model import HandModel

KINDS = ("hands", "gloves", "colours")
DEFAULT_GLOVE = "vist-small"
DEFAULT_COLOURS = "fabric-default"


def user_folder(kind: str) -> Path:
    """The folder of a user's own files of ``kind``; it need not exist."""
    return user_data_path("glovetrack", appauthor=False) / kind


def names(kind: str) -> list[str]:
    """All names of ``kind``, the user's and the included ones, sorted."""
    own = [p.stem for p in user_folder(kind).glob("*.toml")]
    ours = [p.name.removesuffix(".toml") for p in folder(kind).iterdir() if p.name[-5:] == ".toml"]
    return sorted({*own, *ours})


def text(kind: str, name: str) -> str:
    """The text of a file given by name or path.

    Raises FileError that lists the choices.
    """
    path = Path(name)
    if path.suffix or len(path.parts) > 1:
        return read_text(path)
    own = user_folder(kind) / f"{name}.toml"
    if own.is_file():
        return read_text(own)
    ours = folder(kind) / f"{name}.toml"
    if ours.is_file():
        return ours.read_text("utf-8")
    raise FileError(notice("library.unknown", name=name, kind=kind, known=names(kind)))


def load(glove: str = DEFAULT_GLOVE, hand: str | None = None) -> tuple[HandModel, GloveModel]:
    """A glove and its hand, by names or paths; the default is the hand to which the glove
    refers."""
    glove_text = text("gloves", glove)
    model = parse_hand(*_named("hands", hand or glove_hand_name(glove_text, glove)))
    return model, parse_glove(glove_text, model, glove)


def _named(kind: str, name: str) -> tuple[str, str]:
    return text(kind, name), name


def texts(glove: str = DEFAULT_GLOVE, hand: str | None = None) -> tuple[str, str]:
    """(hand text, glove text) as read by `load`, and validated. Raises FileError as it does."""
    load(glove, hand)  # its errors name the files
    glove_text = text("gloves", glove)
    return text("hands", hand or glove_hand_name(glove_text, glove)), glove_text
