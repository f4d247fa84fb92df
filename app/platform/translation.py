"""The window in the user's language.

Qt looks up translations by the class that calls `tr`. In Python that is the class of the object,
not the one that contains the call, so a subclass would lose its parent's texts. Therefore all texts
are in one context and are found by the text alone.
"""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QCoreApplication, QLibraryInfo, QLocale, QTranslator

from app import words
from resources import folder

CONTEXT = "glovetrack"
SYSTEM, ENGLISH = "system", "en"
PREFIX = f"{CONTEXT}_"


class Catalogue(QTranslator):
    """A ``.qm`` file whose texts are all in one context."""

    def translate(
        self,
        context: str,
        text: str,
        disambiguation: str | None = None,
        n: int = -1,
    ) -> str | None:
        """Returns None, which means "not found" to Qt, if the file does not contain ``text``."""
        return super().translate(CONTEXT, text, disambiguation, n) or None


def translations_folder() -> Path:
    return Path(str(folder("translations")))


def languages(where: Path | None = None) -> list[str]:
    """Codes of the languages that are complete: English, and those with a ``.qm`` file."""
    found = sorted((where or translations_folder()).glob(f"{PREFIX}*.qm"))
    return [ENGLISH, *(path.stem.removeprefix(PREFIX) for path in found)]


def chosen(setting: str, system: str, offered: list[str]) -> str:
    """The language for a setting: ``system`` is the desktop's; English if it has no translation."""
    wanted = system.partition("_")[0] if setting == SYSTEM else setting
    return wanted if wanted in offered else ENGLISH


def install(app: QCoreApplication, setting: str, where: Path | None = None) -> str:
    """Install the translation for ``setting``; returns the code of its language."""
    where = where or translations_folder()
    system = QLocale.system()
    code = chosen(setting, system.name(), languages(where))
    # fields for numbers use the language's separator too; the system's own region otherwise
    QLocale.setDefault(system if system.name().startswith(code) else QLocale(code))
    if code == ENGLISH:
        words.use()
        return code
    _install_qt_words(app, code)
    catalogue = Catalogue(app)
    catalogue.load(str(where / f"{PREFIX}{code}.qm"))
    app.installTranslator(catalogue)
    words.use(lambda text: catalogue.translate(CONTEXT, text), QLocale().decimalPoint(), code)
    return code


def _install_qt_words(app: QCoreApplication, code: str) -> None:
    """Qt's own texts: buttons of dialogs, names of keys. Installed first, it is searched last."""
    qt = QTranslator(app)
    folder_of_qt = QLibraryInfo.path(QLibraryInfo.LibraryPath.TranslationsPath)
    if qt.load(f"qtbase_{code}", folder_of_qt):
        app.installTranslator(qt)
