"""Languages that are offered: their catalogues fit the program, and the real window speaks them."""

import os
import string
from collections import Counter
from collections.abc import Iterator

import pytest
from PySide6.QtCore import QTranslator
from PySide6.QtGui import QAction
from PySide6.QtWidgets import (
    QAbstractButton,
    QComboBox,
    QDialogButtonBox,
    QGroupBox,
    QLabel,
    QLineEdit,
    QMenu,
    QTableWidget,
    QTabWidget,
    QWidget,
)

from app import words
from app.platform.translation import (
    CONTEXT,
    ENGLISH,
    Catalogue,
    install,
    languages,
    translations_folder,
)
from app.tools.translations import read
from app.window.main_window import MainWindow
from app.wizards.camera import LockBox
from tests.gui.gui_fakes import scripted_setup

OFFERED = [code for code in languages() if code != ENGLISH]


def catalogue(code: str) -> dict[str, str]:
    return read(translations_folder() / f"{CONTEXT}_{code}.ts")


def fields(text: str) -> Counter[tuple[str, str | None, str | None]]:
    """What formatting inserts: which value, in which format; unnamed ones are counted.

    The words of a plural, ``{count:gap|gaps}``, belong to the language.
    """
    found: Counter[tuple[str, str | None, str | None]] = Counter()
    for _text, name, spec, conversion in string.Formatter().parse(text):
        if name is not None:
            unnamed = sum(n for (key, _, _), n in found.items() if key.isdigit())
            found[name or str(unnamed), "|" if "|" in (spec or "") else spec, conversion] += 1
    return found


def accelerator(text: str) -> str:
    """The letter after a single ampersand, small; empty where there is none."""
    bare = text.replace("&&", "")
    return bare[bare.index("&") + 1].lower() if "&" in bare else ""


def test_german_is_offered():
    assert "de" in OFFERED


def test_fields_are_distinguished_by_order_format_and_conversion():
    assert fields("{} of {}") == fields("{0}: {1}")
    assert fields("{:.1f} of {}") != fields("{} of {:.1f}")
    assert fields("{!r}") != fields("{}")
    assert fields("no {name}") != fields("no")


@pytest.mark.parametrize("code", OFFERED)
def test_a_translation_takes_the_values_of_its_text(code):
    wrong = {t: to for t, to in catalogue(code).items() if fields(t) != fields(to)}
    assert wrong == {}


@pytest.mark.parametrize("code", OFFERED)
def test_a_translation_has_an_accelerator_and_blanks_where_its_text_has(code):
    def shape(text: str) -> tuple[bool, bool, bool]:
        return bool(accelerator(text)), text[:1] == " ", text[-1:] == " "

    wrong = {t: to for t, to in catalogue(code).items() if shape(t) != shape(to)}
    assert wrong == {}


@pytest.mark.parametrize("code", OFFERED)
def test_the_compiled_translation_matches_its_source(code):
    compiled = Catalogue()
    assert compiled.load(str(translations_folder() / f"{CONTEXT}_{code}.qm"))
    listed = catalogue(code)
    assert len(listed) > 500
    assert {text: compiled.translate("", text) for text in listed} == listed


@pytest.fixture
def speaking(qapp):
    """Installs a language for the length of a test."""

    def speak(code: str) -> None:
        assert install(qapp, code) == code

    yield speak
    words.use()
    for translator in qapp.findChildren(QTranslator):
        qapp.removeTranslator(translator)
        translator.deleteLater()


@pytest.fixture
def foreign(speaking, store, engine, qtbot, no_leaks):
    """The real window in a language, on a scripted engine."""
    opened: list[MainWindow] = []

    def show(code: str) -> MainWindow:
        speaking(code)
        window = MainWindow(store)
        opened.append(window)
        qtbot.addWidget(window)
        window.resize(1366, 768)
        window.show()
        window.host.adopt(scripted_setup(engine))
        qtbot.waitUntil(lambda: window.hand._scene is not None)
        return window

    yield show
    for window in opened:
        window.close()


def texts_of(widget: QWidget) -> Iterator[str]:
    """All texts of one widget."""
    yield from (widget.windowTitle(), widget.toolTip(), widget.accessibleName())
    if isinstance(widget, QLabel | QAbstractButton):
        yield widget.text()
    elif isinstance(widget, QLineEdit):
        yield widget.placeholderText()
    elif isinstance(widget, QGroupBox | QMenu):
        yield widget.title()
    elif isinstance(widget, QComboBox):
        yield from (widget.itemText(i) for i in range(widget.count()))
    elif isinstance(widget, QTabWidget):
        yield from (widget.tabText(i) for i in range(widget.count()))
    elif isinstance(widget, QTableWidget):
        heads = (widget.horizontalHeaderItem(i) for i in range(widget.columnCount()))
        yield from (head.text() for head in heads if head is not None)


def english_of(window: QWidget, listed: dict[str, str]) -> set[str]:
    """Visible texts that are in the catalogue but are not translated."""
    shown = {text for w in [window, *window.findChildren(QWidget)] for text in texts_of(w)}
    shown |= {action.text() for action in window.findChildren(QAction)}
    translated = set(listed.values())
    return {text for text in shown if text in listed and text not in translated}


@pytest.mark.parametrize("code", OFFERED)
def test_the_real_window_shows_no_english_of_the_catalogue(foreign, code, qtbot):
    listed = catalogue(code)
    window = foreign(code)
    for name in window.docks:
        window.show_panel(name)
        qtbot.wait(150)  # a visible panel is refreshed
        assert english_of(window, listed) == set(), name
    shown = {text for w in window.findChildren(QWidget) for text in texts_of(w)}
    assert len(shown & set(listed.values())) > 200
    box = LockBox()
    qtbot.addWidget(box)
    assert english_of(box, listed) == set()


@pytest.mark.parametrize("code", OFFERED)
def test_english_in_a_window_is_noticed(code, qtbot):
    label = QLabel("Calibration")
    qtbot.addWidget(label)
    assert english_of(label, catalogue(code)) == {"Calibration"}


@pytest.mark.parametrize("code", OFFERED)
def test_no_two_entries_of_a_menu_have_one_accelerator(foreign, code):
    bar = foreign(code).menuBar()
    menus = [action.menu() for action in bar.actions() if action.menu() is not None]
    assert len(menus) > 5
    for entries in [bar.actions(), *(menu.actions() for menu in menus)]:
        letters = [key for entry in entries if (key := accelerator(entry.text()))]
        twice = {key for key in letters if letters.count(key) > 1}
        assert [e.text() for e in entries if accelerator(e.text()) in twice] == []


@pytest.mark.parametrize("code", OFFERED)
def test_keys_are_the_same_in_every_language(window, foreign, code):
    def keys(of: MainWindow) -> dict[str, list[str]]:
        portable = {n: a.shortcuts() for n, a in of.commands.actions.items()}
        return {name: [key.toString() for key in found] for name, found in portable.items()}

    english = keys(window)
    assert keys(foreign(code)) == english


@pytest.mark.skipif(os.name != "posix", reason="looks at the wheel's own folder of Qt")
@pytest.mark.parametrize("code", OFFERED)
def test_qt_s_own_buttons_speak_it_too(speaking, code, qtbot):
    def discard() -> str:
        box = QDialogButtonBox(QDialogButtonBox.StandardButton.Discard)
        qtbot.addWidget(box)
        return box.button(QDialogButtonBox.StandardButton.Discard).text()

    english = discard()
    speaking(code)
    assert discard() != english


@pytest.mark.parametrize("code", OFFERED)
def test_a_language_is_chosen_in_the_menu_for_the_next_start(window, code):
    window.commands.actions[f"language_{code}"].trigger()
    assert window.store.value.language == code
    assert "after a restart" in window.banner.text()
