"""The set-up dialogs through the window: a board becomes a calibration."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import cv2
import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.viewmodels.stereo import split_fresh
from app.window.set_up_dialogs import board_from, board_text
from app.wizards.stereo.board import ImageChoice
from app.wizards.stereo.image_choices import (
    ChosenImages,
    SessionImages,
    folder_choice,
    folder_input,
    image_choices,
)
from app.wizards.stereo.wizard import BOARD, CHECK, RESULT, VIEWS, ImportFormDialog, StereoWizard
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.notices import raises, shows
from tracker.base.errors import DeviceError
from tracker.calibration.stereo.board import BoardSpec
from tracker.calibration.stereo.files import load_rig, save_calibration
from tracker.geometry import so3
from tracker.sensors.image_input import CameraName
from tracker.sensors.stereo_calibration import Intrinsics
from tracker.simulation.board_images import BoardRenderer, TrueRig, board_pose

WIDTH, HEIGHT = 480, 270
SPEC = BoardSpec()


def small_rig() -> TrueRig:
    K = np.array([[262.0, 0, 243.0], [0, 263.0, 132.0], [0, 0, 1.0]])
    camera = Intrinsics(WIDTH, HEIGHT, K, np.array([-0.1, 0.01, 0, 0, 0]))
    return TrueRig(camera, camera, so3.exp(np.array([0.002, 0.01, 0.0])), np.array([-0.06, 0, 0]))


@lru_cache
def renderer() -> BoardRenderer:
    return BoardRenderer(small_rig(), SPEC)


@lru_cache
def board_pair(k: int):
    """Images of the k-th pose."""
    return renderer().pair(board_pose(SPEC, small_rig(), k, 1), np.random.default_rng(k))


class StillBoard:
    """An `ImageInput`: every pose is shown for two images. ``swapped`` exchanges the sides, for a
    single camera ``alone`` there is only the left one."""

    live, name, fps = True, "board", 0.0

    def __init__(self, swapped: bool = False, alone: bool = False) -> None:
        self._swapped, self._alone, self._k, self.closed = swapped, alone, 0, False

    def open(self) -> None:
        """Never fails."""

    def read(self):
        pair = board_pair(self._k // 2)
        self._k += 1
        if self._alone:
            return pair[0], None
        return pair[::-1] if self._swapped else pair

    def close(self) -> None:
        self.closed = True


@pytest.fixture
def wizard(window, tmp_path):
    """Opens the calibration as the window does, with a source of images; closes with the window."""

    def make(source) -> StereoWizard:
        choices = [ImageChoice("Test camera", lambda _spec: source)]
        dialog = StereoWizard(window.tasks, choices, tmp_path / "cameras", SPEC, window)
        window.set_up.show_dialog("stereo", dialog)
        return dialog

    return make


def collect(dialog: StereoWizard, qtbot, views: int) -> None:
    assert dialog.pages.currentIndex() == BOARD
    dialog.next.click()
    assert dialog.pages.currentIndex() == VIEWS and not dialog.next.isEnabled()
    qtbot.waitUntil(lambda: dialog.collect.list.count() >= views)


def test_a_board_becomes_a_calibration_that_is_checked_and_saved(wizard, qtbot, window):
    source = StillBoard()
    dialog, done = wizard(source), []
    dialog.finished_with.connect(lambda path, real: done.append((path, real)))
    collect(dialog, qtbot, 10)
    before = len(dialog.watching.views())
    qtbot.waitUntil(lambda: "error 0." in dialog.collect.list.item(0).text())
    dialog.collect.list.setCurrentRow(0)
    first = dialog.watching.views()[0]
    dialog.collect.remove.click()
    assert all(v is not first for v in dialog.watching.views()) and before >= 10
    dialog.next.click()
    assert dialog.pages.currentIndex() == RESULT
    qtbot.waitUntil(dialog.next.isEnabled)
    assert dialog.outcome.table.rowCount() >= 9
    dialog.next.click()
    assert dialog.pages.currentIndex() == CHECK and not dialog.next.isEnabled()
    qtbot.waitUntil(dialog.next.isEnabled)
    assert shows(dialog.check.words.text(), "verify.rows_good")
    assert "Largest corner error" in dialog.check.figures.text()
    dialog.next.click()
    ((path, real),) = done
    assert real and not dialog.isVisible()
    assert load_rig(path).baseline == pytest.approx(0.06, abs=5e-4)
    qtbot.waitUntil(lambda: source.closed)


@pytest.mark.long
def test_one_camera_becomes_a_calibration_too(wizard, qtbot, window):
    source = StillBoard(alone=True)
    dialog, done = wizard(source), []
    dialog.finished_with.connect(lambda path, _real: done.append(path))
    collect(dialog, qtbot, 10)
    qtbot.waitUntil(dialog.collect.images.right.isHidden)
    dialog.next.click()
    qtbot.waitUntil(dialog.next.isEnabled)
    assert dialog.outcome.table.isColumnHidden(2)
    dialog.next.click()
    qtbot.waitUntil(dialog.next.isEnabled)
    assert shows(dialog.check.words.text(), "verify.corners_good")
    assert dialog.check.images.right.isHidden()
    dialog.next.click()
    rig = load_rig(done[0])
    assert rig.one_camera and rig.left.K[0, 0] == pytest.approx(262.0, rel=0.01)


@pytest.mark.long
def test_exchanged_cameras_are_rejected_on_the_result_page(wizard, qtbot):
    source = StillBoard(swapped=True)
    dialog = wizard(source)
    collect(dialog, qtbot, 8)
    dialog.next.click()
    qtbot.waitUntil(lambda: "exchanged" in dialog.outcome.reasons.text())
    assert dialog.outcome.reasons.isVisible() and not dialog.next.isEnabled()
    dialog.back.click()
    assert dialog.pages.currentIndex() == VIEWS
    qtbot.keyClick(dialog, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: source.closed)


@pytest.mark.long
def test_a_known_baseline_detects_a_wrong_square_size(wizard, qtbot):
    dialog = wizard(StillBoard())
    dialog.board.baseline_mm.setValue(63.0)
    collect(dialog, qtbot, 8)
    dialog.next.click()
    qtbot.waitUntil(lambda: "Measure a square" in dialog.outcome.reasons.text())
    assert not dialog.next.isEnabled()
    dialog.board.baseline_mm.setValue(60.0)
    dialog.back.click()
    dialog.next.click()
    qtbot.waitUntil(dialog.next.isEnabled)


def test_a_camera_that_does_not_open_is_reported(wizard, qtbot):
    class Absent(StillBoard):
        def open(self) -> None:
            raise DeviceError("The camera 7 cannot be opened: it is not there.")

    dialog = wizard(Absent())
    dialog.next.click()
    qtbot.waitUntil(lambda: "camera 7" in dialog.collect.words.text())


def test_an_impossible_board_stops_at_the_first_page(wizard):
    dialog = wizard(StillBoard())
    dialog.board.kind.setCurrentIndex(dialog.board.kind.findData("chessboard"))
    dialog.board.columns.setValue(9)
    assert shows(dialog.board.problem.text(), "board.symmetric")
    assert dialog.board.problem.isVisible() and not dialog.next.isEnabled()
    dialog.board.columns.setValue(10)
    assert not dialog.board.problem.isVisible() and dialog.next.isEnabled()


def test_the_board_is_saved_at_its_scale(wizard, tmp_path):
    dialog = wizard(StillBoard())
    assert dialog.board.save_board(tmp_path / "board.png")
    page = cv2.imread(str(tmp_path / "board.png"), 0)
    black = np.flatnonzero((page < 128).any(axis=0))
    width = black[-1] - black[0] + 1
    # pHYs: pixels per metre, big-endian, after the chunk's name
    data = (tmp_path / "board.png").read_bytes()
    at = data.index(b"pHYs") + 4
    per_metre = int.from_bytes(data[at : at + 4], "big")
    assert width / per_metre == pytest.approx(SPEC.width, rel=2e-3)
    assert not dialog.board.save_board(tmp_path / "absent" / "board.png")
    assert "cannot be written" in dialog.board.problem.text()


def test_an_earlier_file_can_be_tested_or_used_and_a_bad_one_is_rejected(wizard, tmp_path):
    dialog, done = wizard(StillBoard()), []
    dialog.finished_with.connect(lambda path, real: done.append((path, real)))
    rig = small_rig()
    save_calibration(tmp_path / "bad.yml", rig.left, rig.right, rig.R, 10 * rig.T)
    assert not dialog.take_file(tmp_path / "bad.yml")
    assert shows(dialog.board.problem.text(), "stereo.baseline_impossible", found_mm=600.0)
    save_calibration(tmp_path / "good.yml", rig.left, rig.right, rig.R, rig.T)
    assert dialog.take_file(tmp_path / "good.yml")
    assert dialog.pages.currentIndex() == CHECK and dialog.next.isEnabled()
    dialog.next.click()
    assert done == [(tmp_path / "good.yml", True)]


@pytest.mark.data
def test_real_images_from_a_folder_are_split_into_views_and_check(wizard, qtbot, data_folder):
    dialog = wizard(StillBoard())
    dialog.board.kind.setCurrentIndex(dialog.board.kind.findData("chessboard"))
    dialog.use_folder(data_folder / "stereo_chessboard")
    collect(dialog, qtbot, 8)
    dialog.next.click()
    # eight pairs, of which every third is reserved for verification, are too few
    qtbot.waitUntil(lambda: "at least 8" in dialog.outcome.reasons.text())


def test_a_folder_needs_as_many_left_as_right_images(tmp_path):
    for name in ("left1.png", "left2.png", "right1.png", "notes.txt"):
        (tmp_path / name).write_bytes(b"")
    with raises(DeviceError, "images.unequal_sequences"):
        folder_input(tmp_path)
    assert tmp_path.name in folder_choice(tmp_path).title
    assert split_fresh(range(7)) == ([0, 1, 3, 4, 6], [2, 5])


def test_the_camera_in_use_delivers_each_image_once(window):
    engine = ScriptedEngine()
    window.host.adopt(scripted_setup(engine))
    images = SessionImages(window.host)
    first = images.read()
    assert first is not None and first[0].shape == (720, 1280, 3)
    assert images.read() is None
    engine.frame = 31
    assert images.read() is not None
    window.host.shut_down()
    with raises(DeviceError, "camera.closed"):
        images.read()


def test_a_camera_has_one_reader_the_wizard_or_the_session(window):
    """Devices may be opened while the wizard uses the selected camera."""

    class Own:
        name, live, fps, opened = "own", True, 4.0, 0

        def open(self):
            self.opened += 1

        def read(self):
            return np.zeros((2, 2, 3), np.uint8), None

        def close(self):
            self.opened -= 1

    own = Own()
    images = ChosenImages(window.host, own)
    images.open()
    assert images.read()[0].shape == (2, 2, 3) and own.opened == 1
    window.host.adopt(replace(scripted_setup(ScriptedEngine()), simulated=False))
    assert images.read()[0].shape == (720, 1280, 3) and own.opened == 0
    window.host.adopt(scripted_setup(ScriptedEngine()))
    assert images.read()[0].shape == (2, 2, 3) and own.opened == 1
    images.close()
    assert own.opened == 0


def test_an_imported_lens_is_checked_in_one_image(wizard, tmp_path):
    path = tmp_path / "one.yml"
    K = np.array([[640.0, 0, 639.5], [0, 640.0, 359.5], [0, 0, 1]])
    save_calibration(path, Intrinsics(1280, 720, K, np.zeros(5)))
    dialog = wizard(StillBoard())
    assert dialog.take_file(path)
    images = dialog.check.images
    assert images.right.isHidden() and images.left._title == "Camera"


def test_an_import_asks_for_size_and_unit(qtbot, tmp_path):
    dialog = ImportFormDialog(tmp_path / "theirs.yml")
    qtbot.addWidget(dialog)
    dialog.width_px.setValue(640)
    assert dialog.form().unit == pytest.approx(1e-3) and dialog.form().width == 640
    assert not dialog.square_mm.isEnabled()
    dialog.unit.setCurrentIndex(3)
    assert dialog.square_mm.isEnabled() and dialog.form().unit == pytest.approx(0.025)


def test_the_board_is_remembered():
    spec = BoardSpec("chessboard", 8, 5, 0.0301)
    assert board_from(board_text(spec)) == spec
    assert board_from("") == board_from("chessboard 9 7 1") == BoardSpec()


def test_the_window_opens_each_dialog_once_and_closes_them(window, qtbot):
    for key, name in (("stereo", "stereo"), ("glove_setup", "glove")):
        window.run_command(key)
        qtbot.waitUntil(lambda n=name: n in window.set_up.dialogs)
        window.run_command(key)
    qtbot.waitUntil(lambda: not window.tasks.tasks)
    assert len(window.set_up.dialogs) == 2
    window.set_up.shut_down()
    assert window.set_up.dialogs == {}


def test_before_devices_are_open_the_list_is_there_with_the_calibration(
    window, qtbot, monkeypatch, tmp_path
):
    monkeypatch.setattr("app.engines.found_gloves.serial_ports", list)
    window.sources.open_devices()
    qtbot.waitUntil(lambda: "No glove was found" in window.banner.text())
    assert window.docks["checklist"].isVisible() and window.start_page.isVisible()
    assert window.checklist.summary.text().startswith("0 of")
    rig = small_rig()
    save_calibration(tmp_path / "mine.yml", rig.left, rig.right, rig.R, rig.T)
    assert window.set_up.set_calibration(tmp_path / "mine.yml")
    assert window.checklist.summary.text().startswith("1 of")


def test_a_new_calibration_is_used_at_once_with_the_devices_in_use(
    window, store, qtbot, monkeypatch, tmp_path
):
    monkeypatch.setattr("app.engines.found_gloves.serial_ports", list)
    rig = small_rig()
    path = tmp_path / "mine.yml"
    save_calibration(path, rig.left, rig.right, rig.R, rig.T)

    def finish(real: bool) -> None:
        dialog = StereoWizard(window.tasks, [], tmp_path, SPEC, window)
        window.set_up.show_stereo(dialog)
        dialog.finished_with.emit(path, real)
        dialog.close()

    window.host.adopt(scripted_setup(ScriptedEngine()))
    with qtbot.assertNotEmitted(window.set_up.restart):
        finish(False)  # the demo's own
    assert store.value.calibration == ""
    with qtbot.assertNotEmitted(window.set_up.restart):
        finish(True)
    assert store.value.calibration == str(path)
    window.host.adopt(replace(scripted_setup(ScriptedEngine()), simulated=False))
    with qtbot.waitSignal(window.set_up.restart):
        finish(True)
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_images_may_come_from_the_selected_camera_all_others_and_a_simulation(window):
    cameras = [CameraName(0, "Webcam", "/dev/video0"), CameraName(2, "ZED-M", "/dev/video2")]
    window.store.update(camera="name:ZED-M")
    titles = [c.title for c in image_choices(window.host, window.store.value, cameras)]
    assert titles == [
        "Selected camera: ZED-M",
        "Webcam (/dev/video0)",
        "ZED-M (/dev/video2)",
        "Simulated board (demo)",
    ]
    plugged = CameraName(-1, "Depth camera", "depth://7")
    (other, *_) = image_choices(window.host, replace(window.store.value, camera=""), [plugged])
    with raises(DeviceError, "camera.not_opened"):
        other.make(SPEC).open()  # by its address: there is no such plug-in here
    window.host.adopt(scripted_setup(ScriptedEngine()))
    first = image_choices(window.host, window.store.value, cameras)[0]
    assert first.simulated
    window.host.adopt(replace(scripted_setup(ScriptedEngine()), simulated=False))
    in_use = image_choices(window.host, window.store.value, cameras)[0]
    assert in_use.make(SPEC).read() is not None and not in_use.simulated


@pytest.mark.data
def test_a_zed_factory_file_is_accepted_unchanged(wizard, data_folder):
    dialog, done = wizard(StillBoard()), []
    dialog.finished_with.connect(lambda path, real: done.append((path, real)))
    folder = data_folder / "zed_calibration"
    assert not dialog.take_file(folder / "zed1_orbslam2ros6_spaced_partial.conf")
    assert "incomplete" in dialog.board.problem.text()
    assert dialog.take_file(folder / "SN1010_zed1_factory.conf")
    assert "120.00 mm" in dialog.check.figures.text()
    dialog.next.click()
    assert done == [(folder / "SN1010_zed1_factory.conf", True)]
