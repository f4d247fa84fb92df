"""The glove's firmware in the window: installed and included versions, and writing it."""

from __future__ import annotations

import shutil
import threading
from dataclasses import replace

import pytest

from app.wizards.firmware import FirmwareSetup
from tests.firmware.bootloader import Bootloader
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tracker.firmware.flash import FlashError, FlashJob
from tracker.firmware.image import shipped_image, version_text
from tracker.sensors.discovery import PortReport
from tracker.sensors.protocol import Hello

OLD = Hello(glove_id=7, imu_count=7, firmware=(1, 0, 0))
PORT = "/dev/ttyUSB0"


class Board:
    """A glove at a port, which accepts writing or fails with a message."""

    def __init__(self) -> None:
        self.hello, self.problem = OLD, ""
        self.jobs: list[FlashJob] = []
        self.may_end = threading.Event()
        self.may_end.set()

    def find(self) -> list[PortReport]:
        self.may_end.wait(60)
        return [PortReport("/dev/ttyS0", None), PortReport(PORT, self.hello)]

    def write(self, job: FlashJob) -> None:
        self.may_end.wait(60)
        if self.problem:
            raise FlashError(self.problem)
        self.jobs.append(job)
        image = job.image
        self.hello = replace(OLD, glove_id=image.glove_id, firmware=image.version)

    def greet(self, port: str) -> Hello:
        return self.hello


@pytest.fixture
def board() -> Board:
    return Board()


@pytest.fixture
def dialog(window, board: Board, qtbot) -> FirmwareSetup:
    made = FirmwareSetup(
        window.host, window.tasks, window, find=board.find, write=board.write, greet=board.greet
    )
    made.show()
    qtbot.waitUntil(lambda: made.ports.count() == 2 and made.write.isEnabled())
    return made


def test_the_glove_is_listed_first_with_its_version_and_number(dialog: FirmwareSetup) -> None:
    assert dialog.ports.currentText() == PORT
    shipped = version_text(shipped_image().version)
    assert "1.0.0" in dialog.versions.text() and shipped in dialog.versions.text()
    assert dialog.number.value() == 7


def test_the_written_image_has_the_chosen_number_and_speed(
    dialog: FirmwareSetup, board: Board, qtbot
) -> None:
    dialog.number.setValue(12)
    dialog.speeds.setCurrentIndex(1)
    dialog.boards.setCurrentIndex(1)
    board.may_end.clear()
    dialog.write.click()
    assert not dialog.write.isEnabled() and dialog.busy.isVisible()
    board.may_end.set()
    qtbot.waitUntil(dialog.write.isEnabled)
    assert board.jobs == [FlashJob(shipped_image(115_200).for_glove(12), PORT, 57_600)]
    assert "Glove 12" in dialog.words.text()
    assert "Its firmware is up to date" in dialog.versions.text()


def test_nothing_is_written_while_gloves_are_searched_for(
    dialog: FirmwareSetup, board: Board, qtbot
) -> None:
    """The name of another port shows its versions, but must not start a second operation."""
    board.may_end.clear()
    dialog.again.click()
    dialog.ports.setCurrentText("/dev/ttyUSB7")
    assert not dialog.write.isEnabled() and not dialog.again.isEnabled()
    board.may_end.set()
    qtbot.waitUntil(dialog.write.isEnabled)
    assert dialog.again.isEnabled()


@pytest.mark.skipif(shutil.which("avrdude") is None, reason="needs avrdude")
def test_a_real_avrdude_writes_the_included_image_from_the_window(window, qtbot) -> None:
    """Into a bootloader on a simulated line, which holds the image with its number afterwards."""
    chip = Bootloader()
    dialog = FirmwareSetup(
        window.host, window.tasks, window, find=lambda: [PortReport(chip.port, OLD)], greet=_newer
    )
    try:
        qtbot.waitUntil(dialog.write.isEnabled)
        assert "1.0.0" in dialog.versions.text() and "up to date" not in dialog.versions.text()
        dialog.number.setValue(12)
        dialog.write.click()
        qtbot.waitUntil(dialog.write.isEnabled)
    finally:
        chip.close()
    image = shipped_image().for_glove(12)
    assert bytes(chip.flash[: len(image.data)]) == image.data
    assert "written and verified. Glove 12 responds" in dialog.words.text()


def _newer(_port: str) -> Hello:
    return replace(OLD, glove_id=12, firmware=shipped_image().version)


def test_a_failure_is_reported_and_can_be_retried(
    dialog: FirmwareSetup, board: Board, qtbot
) -> None:
    board.problem = "The board does not answer as a bootloader."
    dialog.write.click()
    qtbot.waitUntil(dialog.write.isEnabled)
    assert dialog.words.text() == board.problem
    board.problem = ""
    dialog.write.click()
    qtbot.waitUntil(lambda: len(board.jobs) == 1)


def test_tracking_is_stopped_before_the_firmware_is_written(window, board: Board, qtbot) -> None:
    window.host.adopt(replace(scripted_setup(ScriptedEngine()), simulated=False))
    asked: list[str] = []
    dialog = FirmwareSetup(
        window.host,
        window.tasks,
        window,
        find=lambda: asked.append("") or [],
        write=board.write,
        greet=board.greet,
    )
    assert not asked and "in use" in dialog.words.text()
    dialog.ports.setCurrentText(PORT)
    dialog.write.click()
    assert window.host.setup is None
    qtbot.waitUntil(lambda: len(board.jobs) == 1)


def test_the_menu_opens_it_once(window) -> None:
    window.run_command("firmware")
    first = window.set_up.dialogs["firmware"]
    window.run_command("firmware")
    assert window.set_up.dialogs["firmware"] is first
