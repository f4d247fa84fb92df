"""Images of the set-up dialogs, driven through their pages on the simulated devices."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from PySide6.QtWidgets import QDialog, QWidget

from app.viewmodels.glove_setup import SetUpPhase
from app.window.headless_report import wait_until
from app.window.main_window import MainWindow
from app.wizards.camera import CameraSetup
from app.wizards.glove.wizard import GloveSetup
from app.wizards.stereo.wizard import StereoWizard

D = TypeVar("D", bound=QDialog)
PATIENCE = 90.0  # s for a page to be ready on a busy machine
VIEWS = 15
Save = Callable[[QWidget, Path], None]


def take_set_up(window: MainWindow, out: Path, save: Save) -> bool:
    """All pages in both themes; False where one did not get ready."""

    def both(dialog: QDialog, name: str) -> None:
        for theme in ("light", "dark"):
            window.set_theme(theme)
            wait_until(lambda: False, 0.3)
            save(dialog, out / f"{name}-{theme}.png")

    return _stereo(window, both) and _glove(window, both) and _camera(window, both)


Both = Callable[[QDialog, str], None]


def _opened(window: MainWindow, command: str, name: str, kind: type[D]) -> D:
    window.run_command(command)
    wait_until(lambda: name in window.set_up.dialogs, PATIENCE)
    dialog = window.set_up.dialogs[name]
    assert isinstance(dialog, kind)
    return dialog


def _stereo(window: MainWindow, both: Both) -> bool:
    wizard = _opened(window, "stereo", "stereo", StereoWizard)
    wizard.resize(980, 680)  # whatever the off-screen screen is
    both(wizard, "stereo-board")
    wizard.go_on()
    ready = wait_until(lambda: wizard.collect.list.count() >= VIEWS, PATIENCE)
    both(wizard, "stereo-views")
    wizard.go_on()
    ready = ready and wait_until(wizard.next.isEnabled, PATIENCE)
    both(wizard, "stereo-result")
    wizard.go_on()
    ready = ready and wait_until(wizard.next.isEnabled, PATIENCE)
    both(wizard, "stereo-check")
    wizard.close()
    return ready


def _glove(window: MainWindow, both: Both) -> bool:
    dialog = _opened(window, "glove_setup", "glove", GloveSetup)
    wait_until(lambda: not window.tasks.tasks, PATIENCE)
    both(dialog, "glove-choice")
    dialog.tabs.setCurrentWidget(dialog.still)
    ready = wait_until(dialog.still.start.isEnabled, PATIENCE)
    dialog.still.begin()
    ready = ready and wait_until(lambda: dialog.still.table.rowCount() > 0, PATIENCE)
    both(dialog, "glove-still")
    dialog.tabs.setCurrentWidget(dialog.wiggle)
    dialog.wiggle.begin()
    ready = ready and wait_until(lambda: dialog.wiggle.phase == SetUpPhase.DONE, PATIENCE)
    both(dialog, "glove-wiggle")
    dialog.close()
    return ready


def _camera(window: MainWindow, both: Both) -> bool:
    dialog = _opened(window, "camera_setup", "camera", CameraSetup)
    wait_until(lambda: not window.tasks.tasks, PATIENCE)
    both(dialog, "camera-setup")
    dialog.close()
    return True
