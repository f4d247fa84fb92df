"""Notices: every code has a text with values, and files can be rendered in any language."""

from __future__ import annotations

import ast
import json
import math
import pickle
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from string import Formatter
from typing import NamedTuple

import numpy as np
import pytest

from tracker.base.errors import DeviceError, FileError, GlovetrackError, notice_of
from tracker.base.notices import (
    PLAIN,
    Language,
    Notice,
    Outbox,
    Severity,
    all_templates,
    failure,
    from_json,
    notice,
    plain,
    render,
    to_json,
    try_render,
    warning,
)

ROOT = Path(__file__).resolve().parents[2]
MAKERS = {"notice", "warning", "failure"}
GERMAN = {
    "The {side:word} hand is out of sight; its position is extrapolated.": "{side:word} verdeckt",
    "left": "links",
    "red": "rot",
    "{} and {}": "{} und {}",
}


class Module(NamedTuple):
    """The parts of a module that are checked."""

    imports: list[ast.ImportFrom]
    classes: list[ast.ClassDef]
    calls: list[ast.Call]


def read_module(text: str) -> Module:
    found = Module([], [], [])
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Call):
            found.calls.append(node)
        elif isinstance(node, ast.ImportFrom):
            found.imports.append(node)
        elif isinstance(node, ast.ClassDef):
            found.classes.append(node)
    return found


@cache
def modules() -> dict[str, Module]:
    """Each module of the program, by its path."""
    return {
        path.relative_to(ROOT).as_posix(): read_module(path.read_text("utf-8"))
        for folder in ("tracker", "app", "extensions", "glovetrack")
        for path in sorted((ROOT / folder).rglob("*.py"))
        if "/tests/" not in path.as_posix()
    }


def emitted() -> Iterator[tuple[str, str, set[str] | None]]:
    """File position, code and names of the values of each notice created in the code; None where
    these are passed as a mapping."""
    for path, module in modules().items():
        makers = makers_in(module)
        for call in module.calls:
            if isinstance(call.func, ast.Name) and call.func.id in makers:
                names = {k.arg for k in call.keywords}
                known = None if None in names else {str(name) for name in names}
                for code in codes_in(call.args[0]):
                    yield f"{path}:{call.lineno}", code, known


def makers_in(module: Module) -> set[str]:
    """Those of `MAKERS` that a module imports; others have functions of the same name."""
    return {
        alias.name
        for node in module.imports
        if node.module == "tracker.base.notices"
        for alias in node.names
        if alias.name in MAKERS
    }


def codes_in(node: ast.expr) -> list[str]:
    """The code, or both codes of a conditional expression."""
    if isinstance(node, ast.IfExp):
        return codes_in(node.body) + codes_in(node.orelse)
    assert isinstance(node, ast.Constant), f"line {node.lineno}: {ast.unparse(node)}"
    return [str(node.value)]


def placeholders(template: str) -> set[str]:
    return {name for _, name, _, _ in Formatter().parse(template) if name is not None}


def name_of(function: ast.expr) -> str:
    """The last part of ``a.b.name``; empty for other expressions."""
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def error_classes() -> set[str]:
    """The errors that carry a notice, and all classes derived from them."""
    bases = {c.name: set(map(name_of, c.bases)) for m in modules().values() for c in m.classes}
    found = {"GlovetrackError", "DataError"}
    while more := {name for name, those in bases.items() if those & found} - found:
        found |= more
    return found


def sentences_in(module: Module, errors: set[str]) -> list[str]:
    """Calls that make an error of a sentence, or put a translated sentence into a notice."""
    made = [call for call in module.calls if name_of(call.func) in errors and call.args]
    wrong = [call for call in made if is_sentence(call.args[0])]
    for call in module.calls:
        if name_of(call.func) in MAKERS:
            parts = [part for k in call.keywords for part in ast.walk(k.value)]
            wrong += [call] if any(map(is_translated, parts)) else []
    return [f"{call.lineno}: {ast.unparse(call)}" for call in wrong]


def is_sentence(node: ast.AST) -> bool:
    literal = isinstance(node, ast.Constant) and isinstance(node.value, str)
    made = isinstance(node, ast.Call) and name_of(node.func) in {"str", "format", "join", "plain"}
    return literal or made or isinstance(node, ast.JoinedStr | ast.BinOp) or is_translated(node)


def is_translated(node: ast.AST) -> bool:
    return isinstance(node, ast.Call) and name_of(node.func) in {"tr", "translate", "error_text"}


@pytest.mark.long
def test_errors_carry_notices_rather_than_sentences_of_the_window() -> None:
    """A sentence that is translated when the error is raised cannot be shown in other languages."""
    errors = error_classes()
    assert {"DeviceError", "DiskError", "StreamError", "UsageError"} <= errors
    wrong = [f"{path}:{w}" for path, m in modules().items() for w in sentences_in(m, errors)]
    assert wrong == []


@pytest.mark.parametrize(
    "code",
    [
        'raise errors.DeviceError(tr("No glove."))',
        'raise FileError(self.tr("{} is missing.").format(path))',
        'raise FileError(f"{path} is missing.")',
        'raise FileError(notice("file.damaged", file=path, why=tr("It is too short.")))',
        "error = FileError(str(failed))",
    ],
)
def test_a_sentence_in_an_error_is_found(code: str) -> None:
    right = 'raise FileError(notice("file.damaged", file=path))\n'
    assert len(sentences_in(read_module(right + code), {"DeviceError", "FileError"})) == 1


@pytest.mark.long
def test_every_code_in_use_has_a_text_whose_values_are_supplied() -> None:
    templates, found = all_templates(), list(emitted())
    assert len(found) > 60
    unknown = [(where, code) for where, code, _ in found if code not in templates]
    assert unknown == []
    wrong = [
        (where, code, sorted(names ^ placeholders(templates[code])))
        for where, code, names in found
        if names is not None and names != placeholders(templates[code])
    ]
    assert wrong == []


def test_every_text_in_the_catalogue_is_used() -> None:
    used = {code for _, code, _ in emitted()} | {PLAIN}
    source = (ROOT / "tracker/firmware/flash.py").read_text("utf-8")  # by what avrdude prints
    left = [code for code in all_templates() if code not in used and f'"{code}"' not in source]
    assert left == []


def test_a_template_without_all_its_values_is_not_rendered() -> None:
    sizes = {"width": 1, "height": 2, "calibrated_width": 3, "calibrated_height": 4}
    assert "1 by 2" in str(warning("camera.size_misfit", **sizes))
    assert try_render(warning("camera.size_misfit", width=1)) is None


def test_numbers_lists_and_plurals_are_written_by_the_template() -> None:
    assert "12 images per second instead of 30" in str(
        warning("camera.slow", rate_hz=np.float64(12.3), asked_hz=np.int64(30))
    )
    three = warning("light.room_has_hues", hues=["red", "blue", "green"], spots=3)
    assert "red, blue and green, in 3 spots" in str(three)
    assert "red, in 1 spot." in str(warning("light.room_has_hues", hues=("red",), spots=1))
    assert "chessboard or charuco" in str(
        failure("board.unknown_kind", kinds=("chessboard", "charuco"), kind="x")
    )


def test_a_notice_is_rendered_in_the_readers_language_with_its_decimals() -> None:
    german = Language(lambda text: GERMAN.get(text, text), ",")
    assert render(warning("tracking.side_coasting", side="left"), german) == "links verdeckt"
    assert "rot und lila" in render(warning("light.hues_alike", hues=("red", "lila")), german), (
        "a hue of the user's own keeps its name"
    )
    assert "2,50 V" in render(warning("glove.battery_low", volts=2.5), german)


def test_a_code_of_another_version_is_shown_as_such() -> None:
    later = Notice("glove.invented_later", Severity.WARNING, {"port": "/dev/x"})
    assert try_render(later) is None
    assert str(later) == "glove.invented_later (port=/dev/x)"


@pytest.mark.parametrize(
    "report",
    [
        notice("camera.connected", camera="front"),
        failure("recording.ended", why=plain("no disk")),
        warning("light.room_has_hues", hues=("red", "blue"), spots=2),
        warning("glove.battery_low", volts=3.49),
    ],
)
def test_a_notice_survives_a_file_and_another_process(report: Notice) -> None:
    assert from_json(json.loads(json.dumps(to_json(report)))) == report
    assert pickle.loads(pickle.dumps(report)) == report


@pytest.mark.parametrize("record", [{}, {"code": 3}, {"code": ""}, {"code": "a", "values": 3}])
def test_other_data_are_not_taken_for_a_notice(record: dict[str, object]) -> None:
    assert from_json(record) is None


def test_an_unknown_severity_and_unusual_values_are_harmless() -> None:
    found = from_json({"code": "a.b", "severity": "??", "values": {"x": None, "y": [1, {}]}})
    assert found is not None and found.severity is Severity.INFO
    assert found.values == {"x": "None", "y": (1, "{}")}


def test_an_error_carries_its_notice_or_a_plug_ins_sentence() -> None:
    error = FileError(notice("file.missing", path=Path("a.mcap")))
    assert (error.notice.code, error.notice.severity) == ("file.missing", Severity.ERROR)
    assert str(error) == "There is no file a.mcap."
    assert str(pickle.loads(pickle.dumps(error))) == str(error)
    ours = DeviceError("My camera is unplugged.")
    assert str(ours) == "My camera is unplugged." and ours.notice.code == "plain"
    around = failure("recording.ended", why=error)
    assert str(around) == "The recording has ended: There is no file a.mcap."
    assert notice_of(ZeroDivisionError()).values["text"] == "ZeroDivisionError"
    assert isinstance(error, GlovetrackError)


def test_an_outbox_returns_each_notice_once_in_order() -> None:
    box = Outbox()
    for code in ("camera.swapped", "camera.in_order"):
        box.post(notice(code))
    assert [n.code for n in box.drain()] == ["camera.swapped", "camera.in_order"]
    assert box.drain() == []


def test_values_that_are_not_numbers_are_rendered_too() -> None:
    assert "nan" in str(warning("glove.battery_low", volts=math.nan))
