"""Any language: no text is left out, and a catalogue reaches widgets and view-models alike."""

import ast
import re
from dataclasses import replace
from pathlib import Path
from string import Formatter

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication

from app import words
from app.platform.translation import (
    CONTEXT,
    Catalogue,
    chosen,
    install,
    languages,
    translations_folder,
)
from app.tools.translations import (
    SAYS,
    all_words,
    read,
    release,
    words_in,
    write,
)
from app.viewmodels.recording import position_text
from app.window.main_window import MainWindow
from tracker.base import files
from tracker.base.errors import DeviceError, FileError
from tracker.base.notices import (
    Notice,
    Severity,
    all_templates,
    failure,
    notice,
    plain,
    warning,
)
from tracker.messages import Event

ROOT = Path(__file__).resolve().parents[2]
APP = ROOT / "app"
WINDOWS = [APP, *(ROOT / "extensions").glob("*/window")]
"""Folders of code that shows words in the window."""
SETTERS = {
    "setText", "setToolTip", "setWindowTitle", "addAction", "addMenu", "setPlaceholderText",
    "addRow", "addTab", "setAccessibleName", "setTabText", "setLabelText", "setStatusTip",
    "setHorizontalHeaderLabels", "setTitle", "QLabel", "QPushButton", "QCheckBox", "QRadioButton",
    "QGroupBox", "QAction",
}  # fmt: skip
TAG = re.compile(r"<[^>]*>")
WORD = re.compile(r"[A-Za-z]{2}")


def literals(node: ast.expr) -> list[str]:
    """Texts that an argument shows as they stand."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return [node.value]
    if isinstance(node, ast.JoinedStr):
        return ["".join(v.value for v in node.values if isinstance(v, ast.Constant))]
    if isinstance(node, ast.List | ast.Tuple):
        return [text for item in node.elts for text in literals(item)]
    return []


def untranslated(code: str) -> list[str]:
    """Words handed to Qt without passing through tr."""
    found = []
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Call) and words_name(node.func) in SETTERS:
            texts = [text for a in node.args for text in literals(a)]
            found += [text for text in texts if WORD.search(TAG.sub("", text))]
    return found


def test_words_that_pass_tr_by_are_noticed():
    assert untranslated('label.setText("Left")') == ["Left"]
    assert untranslated('box.setHorizontalHeaderLabels(["a", "Key"])') == ["Key"]
    assert untranslated('QLabel(f"<b>{x}</b> frames")') == ["<b></b> frames"]
    assert untranslated('label.setText(self.tr("Left"))') == []
    assert untranslated('label.setText(f"<span>{x}</span>")') == []


def test_no_words_are_handed_to_qt_untranslated():
    found = {str(p): untranslated(p.read_text("utf-8")) for f in WINDOWS for p in f.rglob("*.py")}
    assert {p: texts for p, texts in found.items() if texts} == {}


PARTS = ("viewmodels", "jobs", "engines", "storage", "panels", "window", "wizards")
SPOKEN_TO_PROGRAMS = {
    "engines/warm_up.py",  # the log
    "jobs/remote.py",  # answers of the remote control, which other programs read
    "window/command_line.py",
    "window/headless_report.py",  # the terminal speaks English, as does its help
    "window/remote_command.py",
    "window/start.py",
    "window/window_options.py",
    "window/theme.py",  # style sheets
    "extensions/robot/window/command_latency.py",  # a measurement, run in a terminal
}
NOT_SHOWN = {
    'install -m 644 "$1" "$2" && udevadm control --reload && udevadm trigger',  # for the shell
    "exit status ",  # of that command
    "simulated camera",  # key of stored colours
    "none is open",  # for who reads a bug report
    "● 19 of about 9 ",  # the widest count, which a column is made for
    "Hz",  # a unit
    "font-size: pt",  # of a style sheet
    "window command",  # for the log file
    "Optiboot", "old Nano", "postures asked for",  # keys
    "UDP (JSON)", "WebSocket (JSON)", "Lab Streaming Layer", "Foxglove",  # names
    "*.png *.jpg *.jpeg *.bmp *.tif", "*.yml *.yaml *.xml *.json *.toml",
}  # fmt: skip
SENTENCE = re.compile(r"[A-Za-z]{2}[^A-Za-z]* [^A-Za-z]*[A-Za-z]{2}|^[A-Z][a-z]+$")
KEYS = re.compile(r"(Ctrl|Shift|Alt)\+\S*|Space|Del|Fusion|Glovetrack")
PASS = {*SAYS, "debug", "info", "warning", "error", "exception", "setStyleSheet", "getLogger"}


def left_english(code: str) -> list[str]:
    """What reads like words for people and passes neither tr nor mark.

    A single word in small letters cannot be distinguished from a key, so it is let through.
    """
    tree = ast.parse(code)
    passed: set[int] = set()
    found = []
    for node in ast.walk(tree):
        called = isinstance(node, ast.Call) and words_name(node.func) in PASS
        stated = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
        if called or stated:
            passed |= {id(inner) for inner in ast.walk(node)}
        elif isinstance(node, ast.Dict):  # what is looked up by is not shown
            passed |= {id(key) for key in node.keys if isinstance(key, ast.Constant)}
        elif id(node) not in passed and isinstance(node, ast.JoinedStr | ast.Constant):
            texts = literals(node)
            passed |= {id(v) for v in getattr(node, "values", ()) if isinstance(v, ast.Constant)}
            found += [t for t in texts if SENTENCE.search(TAG.sub("", t)) and not KEYS.fullmatch(t)]
    return [text for text in found if text not in NOT_SHOWN]


def words_name(function: ast.expr) -> str:
    return getattr(function, "attr", getattr(function, "id", ""))


def test_words_of_view_models_that_pass_tr_by_are_noticed():
    assert left_english('Row(GOOD, "not open")') == ["not open"]
    assert left_english('name = "Views"') == ["Views"]
    assert left_english('Row(f"{n} of {m} views")') == [" of  views"]
    assert left_english('"""What it is."""\n_log.warning("it fails at %s", 1)') == []
    assert left_english('Row(tr("not open"), mark("Views and more"), "latency_p99")') == []


def test_no_words_are_left_english_in_what_is_handed_to_widgets():
    found = {}
    folders = [*(APP / part for part in PARTS), *WINDOWS[1:]]
    for path in (p for folder in folders for p in folder.rglob("*.py")):
        inside = path.relative_to(ROOT).as_posix()
        if inside.removeprefix("app/") not in SPOKEN_TO_PROGRAMS:
            found[inside] = left_english(path.read_text("utf-8"))
    assert {p: texts for p, texts in found.items() if texts} == {}


def test_words_made_of_pieces_are_refused():
    assert list(words_in('self.tr("{} of {}").format(a, b)')) == [("{} of {}", 1)]
    with pytest.raises(ValueError, match="line 1"):
        list(words_in('self.tr(f"{a} of {b}")'))


@pytest.mark.parametrize("path", sorted(translations_folder().glob("*.ts")), ids=lambda p: p.stem)
def test_every_text_is_listed_and_what_is_offered_is_complete(path):
    listed = path.read_text("utf-8")
    wanted = all_words()
    assert len(wanted) > 500
    fresh = path.parent / "fresh.ts"
    try:
        write(fresh, path.stem.removeprefix(f"{CONTEXT}_"), wanted, read(path))
        assert fresh.read_text("utf-8") == listed, "make translations lists the new texts"
    finally:
        fresh.unlink()
    if path.with_suffix(".qm").exists():
        assert wanted.keys() <= read(path).keys()


def test_a_catalogue_speaks_from_menus_subclasses_and_view_models(tmp_path, store, qtbot, no_leaks):
    wanted = all_words()
    ts = tmp_path / f"{CONTEXT}_xx.ts"
    write(ts, "de", wanted, {text: f"«{text}»" for text in wanted})
    release(ts)
    assert languages(tmp_path) == ["en", "xx"]
    app = QApplication.instance()
    assert install(app, "xx", tmp_path) == "xx"
    window = MainWindow(store)
    qtbot.addWidget(window)
    try:
        for name, action in window.commands.actions.items():
            own = name.startswith("language_")  # each language by its own name
            assert own or "«" in action.text(), action.text()
        for name, dock in window.docks.items():
            assert dock.windowTitle().startswith("«"), name
        qtbot.waitUntil(lambda: window.bar.tracking.text() == "«Stopped»")
        assert words.tr("what no file holds") == "what no file holds"
    finally:
        window.close()
        words.use()
        QLocale.setDefault(QLocale.system())
        for catalogue in app.findChildren(Catalogue):
            app.removeTranslator(catalogue)
            catalogue.deleteLater()
    assert window.tr("Glovetrack {}") == "Glovetrack {}"


@pytest.mark.parametrize(
    ("setting", "system", "code"),
    [
        ("system", "de_AT", "de"),
        ("system", "fr_FR", "en"),
        ("en", "de_DE", "en"),
        ("de", "C", "de"),
    ],
)
def test_the_language_is_the_one_set_else_the_desktop_s_else_english(setting, system, code):
    assert chosen(setting, system, ["en", "de"]) == code


@pytest.fixture
def german(monkeypatch):
    """A catalogue with a few notices."""
    done = {
        "The camera {camera} is connected.": "Die Kamera {camera} ist verbunden.",
        "No packets from the {side:word} glove: the hand follows the images alone.": (
            "Handschuh {side:word}: keine Pakete."
        ),
        "The {hues:words} markers look alike in this light. Use another lamp, or other cloth.": (
            "Die Marker {hues:words} sehen gleich aus."
        ),
        "The glove's battery is low ({volts:.2f} V). Charge it soon.": "Akku: {volts:.2f} V",
        "The recording has ended: {why}": "Aufnahme beendet: {why}",
        "red": "rot",
        "Left": "Links",
        "{} and {}": "{} und {}",
    }
    monkeypatch.setattr(words._Catalogue, "look_up", staticmethod(done.get))
    monkeypatch.setattr(words._Catalogue, "decimal", ",")


@pytest.mark.parametrize(
    ("report", "text"),
    [
        (notice("camera.connected", camera="front"), "Die Kamera front ist verbunden."),
        (warning("glove.packets_missing", side="left"), "Handschuh links: keine Pakete."),
        (
            warning("light.hues_alike", hues=("red", "pearl")),
            "Die Marker rot und pearl sehen gleich aus.",
        ),
        (warning("glove.battery_low", volts=3.49), "Akku: 3,49 V"),
        (
            failure("recording.ended", why=notice("camera.connected", camera="b")),
            "Aufnahme beendet: Die Kamera b ist verbunden.",
        ),
        (plain("Whatever a plug-in says."), "Whatever a plug-in says."),
        (notice("tracking.searching"), "Looking for the hand."),
    ],
)
def test_notices_are_rendered_in_the_language_of_the_window(german, report, text):
    assert words.notice_text(report) == text
    assert words.error_text(FileError(report)) == text
    assert words.event_text(Event.of(1.0, "device", report)) == text


def test_events_of_other_versions_show_the_text_that_they_have(german):
    old = Event(1.0, "device", "The camera front is connected.")
    assert words.event_text(old) == old.text
    later = replace(old, notice=Notice("camera.invented_later", Severity.INFO, {}))
    assert words.event_text(later) == old.text
    note = Event(1.0, "note", "red")
    assert words.event_text(note) == "red", "a note is the user's own"


def test_decimals_are_written_as_the_language_does(german):
    assert f"{words.local(63.0):.1f} mm" == "63,0 mm" and f"{words.local(5.4):.0f}" == "5"
    assert position_text(83.996) == "1:24,00"


FOR_PROGRAMS = {"graphs.py": ["x", "t"]}  # a table of comma-separated values
DECIMALS = re.compile(r"[-+]?\.([1-9]|\{)\S*[fg]|g")


def not_local(code: str) -> list[str]:
    """Formatted numbers with decimals that are not passed through `words.local`."""
    found = []
    for node in ast.walk(ast.parse(code)):
        pairs: list[tuple[ast.expr, str]] = []
        if isinstance(node, ast.FormattedValue) and node.format_spec is not None:
            pairs = [(node.value, ast.unparse(node.format_spec)[2:-1])]
        elif isinstance(node, ast.Call) and words_name(node.func) == "format":
            template = "".join(
                part.value
                for part in ast.walk(node.func)
                if isinstance(part, ast.Constant) and isinstance(part.value, str)
            )
            specs = [spec or "" for _, name, spec, _ in Formatter().parse(template) if name == ""]
            pairs = list(zip(node.args, specs, strict=False))
        for value, spec in pairs:
            local = isinstance(value, ast.Call) and words_name(value.func) == "local"
            if DECIMALS.fullmatch(spec) and not local:
                found.append(ast.unparse(value))
    return found


def test_numbers_that_pass_local_by_are_noticed():
    assert not_local('f"{x:.1f} {local(y):.1f} {z:.0f}"') == ["x"]
    assert not_local('tr("{} of {:.2f}").format(a, b)') == ["b"]
    assert not_local('f"{x:.{digits}f}"') == ["x"]


@pytest.mark.parametrize("part", ["viewmodels", "panels"])
def test_decimals_on_the_screen_are_in_the_user_s_language(part):
    found = {p.name: not_local(p.read_text("utf-8")) for p in (APP / part).rglob("*.py")}
    assert {p: n for p, n in found.items() if n and n != FOR_PROGRAMS.get(p)} == {}


def test_templates_of_notices_and_reasons_of_the_disk_are_listed_for_translation():
    listed = all_words()
    assert set(all_templates().values()) <= listed.keys()
    assert set(files._WORDS.values()) <= listed.keys()


def test_every_translation_of_a_notice_takes_just_the_values_of_its_text():
    def values(template):
        return {name for _, name, _, _ in Formatter().parse(template) if name}

    for path in translations_folder().glob("*.ts"):
        done = read(path)
        for code, template in all_templates().items():
            if template in done:
                assert values(done[template]) == values(template), code


def test_a_lost_camera_is_reported_in_banner_and_log(window, german):
    front = DeviceError(notice("camera.connected", camera="0"))
    window.host.error.emit(words.error_text(front))
    text = "Die Kamera 0 ist verbunden."
    assert window.messages.banner.text() == text
    assert window.log.model.ends_with(text)
