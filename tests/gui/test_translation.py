"""Any language: no text is left out, and a catalogue reaches widgets and view-models alike."""

import ast
import re
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication

from app import words
from app.platform.translation import CONTEXT, Catalogue, chosen, install, languages, place
from app.tools.translations import all_words, read, release, words_in, write
from app.window.main_window import MainWindow

APP = Path(__file__).resolve().parents[2] / "app"
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
        if isinstance(node, ast.Call):
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            if name in SETTERS:
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
    found = {str(p): untranslated(p.read_text("utf-8")) for p in APP.rglob("*.py")}
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
        for action in window.commands.actions.values():
            assert action.text().startswith("«") or "«" in action.text(), action.text()
        for name, dock in window.docks.items():
            assert dock.windowTitle().startswith("«"), name
        qtbot.waitUntil(lambda: window.bar.tracking.text() == "«Stopped»", timeout=30_000)
        assert words.tr("what no file holds") == "what no file holds"
    finally:
        window.close()
        words.use(None)
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
