"""Any language: no text is left out, and a catalogue reaches widgets and view-models alike."""

import ast
import re
from pathlib import Path
from string import Formatter

import pytest
from PySide6.QtCore import QLocale
from PySide6.QtWidgets import QApplication

from app import words
from app.platform.engine_sentences import EngineSentences, own, templates_in
from app.platform.translation import CONTEXT, Catalogue, chosen, install, languages, place
from app.tools.translations import (
    SAYS,
    all_words,
    engine_sentences,
    read,
    release,
    sentences_in,
    words_in,
    write,
)
from app.viewmodels.recording import position_text
from app.window.main_window import MainWindow

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
    "jobs/remote_answers.py",  # answers of the remote control, which other programs read
    "window/command_line.py",
    "window/headless_report.py",  # the terminal speaks English, as does its help
    "window/remote_command.py",
    "window/start.py",
    "window/window_options.py",
    "window/theme.py",  # style sheets
    "extensions/robot/window/command_latency.py",  # a measurement, run in a terminal
}
NOT_SHOWN = {
    "simulated camera",  # what colours are kept by
    "none is open",  # for who reads a bug report
    "● 19 of about 9 ",  # the widest count, which a column is made for
    "Hz",  # a unit
    "window command",  # for the log file
    "Optiboot", "old Nano", "postures asked for",  # keys
    "UDP (JSON)", "WebSocket (JSON)", "Lab Streaming Layer", "Foxglove",  # names
    "*.png *.jpg *.jpeg *.bmp *.tif", "*.yml *.yaml *.xml *.json",
}  # fmt: skip
SENTENCE = re.compile(r"[A-Za-z]{2}[^A-Za-z]* [^A-Za-z]*[A-Za-z]{2}|^[A-Z][a-z]+$")
KEYS = re.compile(r"(Ctrl|Shift|Alt)\+\S*|Space|Del|Fusion|Glovetrack")
PASS = {*SAYS, "debug", "info", "warning", "error", "exception", "setStyleSheet", "getLogger"}


def left_english(code: str) -> list[str]:
    """What reads like words for people and passes neither tr nor mark.

    A single word in small letters cannot be told from a key, so it is let through.
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
    with pytest.raises(ValueError, match="no plain words"):
        list(words_in('self.tr(f"{a} of {b}")'))


@pytest.mark.parametrize("path", sorted(place().glob("*.ts")), ids=lambda p: p.stem)
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
        qtbot.waitUntil(lambda: window.bar.tracking.text() == "«Stopped»", timeout=30_000)
        assert words.tr("what no file holds") == "what no file holds"
    finally:
        window.close()
        words.use(None)
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


def test_sentences_of_the_engine_are_found_with_their_values_and_docstrings_are_not():
    code = """
def f(x, y):
    \"\"\"This is no sentence for anybody.\"\"\"
    raise FileError(f"The glove {x} is at "
                    f"{y:.1f} metres.", "key", "no sentence, no capital.", f"{x}: {y}.")
"""
    assert list(sentences_in(code)) == ["The glove {} is at {} metres."]
    assert len(engine_sentences()) > 200  # of files, devices, colours, the fit, the export


@pytest.fixture
def german(tmp_path):
    """A catalogue whose engine says three things."""
    done = {
        "The camera {} is connected.": "Die Kamera {} ist verbunden.",
        "{} and {} are exchanged.": "{1} ist mit {0} vertauscht.",
        "{} cannot be read: {}.": "{} ist nicht lesbar: {}.",
        "Window": "Fenster",
    }
    path = tmp_path / "glovetrack_de.ts"
    write(path, "de", dict.fromkeys(done, "tracker/a.py") | {"Window": "app/a.py"}, done)
    assert "Window" not in dict(templates_in(path))
    return EngineSentences(path).translate


@pytest.mark.parametrize(
    ("said", "translated"),
    [
        ("The camera front is connected.", "Die Kamera front ist verbunden."),
        ("a and b are exchanged.", "b ist mit a vertauscht."),
        ("x.mcap cannot be read: no such. file.", "x.mcap ist nicht lesbar: no such. file."),
        (
            "a and b are exchanged. The camera c is connected. Who knows?",
            "b ist mit a vertauscht. Die Kamera c ist verbunden. Who knows?",
        ),
        ("Die Kamera front ist verbunden.", "Die Kamera front ist verbunden."),
        ("", ""),
    ],
)
def test_what_the_engine_says_is_translated_with_its_values(german, said, translated):
    assert german(said) == translated


def test_decimals_are_written_as_the_language_does(german, monkeypatch):
    monkeypatch.setattr(words._Catalogue, "decimal", ",")
    assert f"{words.local(63.0):.1f} mm" == "63,0 mm" and f"{words.local(5.4):.0f}" == "5"
    assert position_text(83.996) == "1:24,00"
    assert german("1.25 mm and a are exchanged.") == "a ist mit 1,25 mm vertauscht."
    assert german("1.2.0 and b are exchanged.") == "b ist mit 1.2.0 vertauscht.", "a version"


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


def test_hues_that_the_engine_enumerates_are_translated(monkeypatch):
    german = {"red": "rot", "blue": "blau", "green": "grün", "{} and {}": "{} und {}"}
    monkeypatch.setattr(words._Catalogue, "look_up", staticmethod(german.get))
    said = EngineSentences(place() / "glovetrack_de.ts").translate(
        "The red, green and blue markers are too bright: shorten the exposure, or move the lamp "
        "away."
    )
    assert "rot, grün und blau" in said and " and " not in said


def test_every_translation_of_the_engine_takes_just_the_values_of_its_sentence():
    for path in place().glob("*.ts"):
        for source, target in templates_in(path):
            values = [f"<{k}>" for k in range(source.count("{}"))]
            if own(source) and values:
                assert all(target.format(*values).count(v) == 1 for v in values), source


def test_a_lost_camera_is_told_in_german_in_banner_and_log(window, monkeypatch):
    sentences = EngineSentences(place() / "glovetrack_de.ts")
    monkeypatch.setattr(words._Catalogue, "sentences", staticmethod(sentences.translate))
    window.host.error.emit("The camera 0 gives no images; waiting for it.")
    said = "Die Kamera 0 gibt keine Bilder; es wird auf sie gewartet."
    assert window.messages.banner.text() == said
    assert window.log.model.ends_with(said)
