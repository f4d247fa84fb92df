"""Tuning colours in the real window: effects of clicks, fits, stored images and restarts."""

import dataclasses
import threading
import time
from types import SimpleNamespace

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QFileDialog

from app.storage.colour_store import ColourStore
from app.storage.image_folder import MOST, ImageFolder, StoredImage, read_image
from app.viewmodels import colour_search
from app.viewmodels.colour_fits import fit_text
from app.viewmodels.colour_images import (
    ROOM_EVERY,
    in_range,
    mask_image,
    masks_image,
    room_shares,
    to_hsv,
)
from app.viewmodels.colour_search import MASK_STEP
from app.viewmodels.colours import hue_colours, seen_rows
from app.viewmodels.states import GOOD, WARN
from app.widgets.range_row import HueRangeSlider
from app.window.main_window import MainWindow
from tests.gui.gui_fakes import ScriptedEngine, frame_and_blobs, models, scripted_setup, with_camera
from tests.notices import shows
from tracker.calibration.colours_fit import FoundHue
from tracker.calibration.light_meter import LightMeter
from tracker.messages import Tracking
from tracker.vision.colours import (
    LEARNED_BITS,
    LEARNED_CELLS,
    ROOM,
    UNKNOWN,
    HueRange,
    LearnedColours,
    load_profile,
)
from tracker.vision.detector import Detector

CAMERA = "Test Cam SN 0815"


def setup_of(engine: ScriptedEngine):
    return with_camera(scripted_setup(engine), name=CAMERA)


@pytest.fixture
def colours(window, engine, qtbot):
    """The visible panel, with a named camera."""
    window.host.adopt(setup_of(engine))
    window.run_command("show_colours")
    qtbot.waitUntil(lambda: window.colours.image.source.image() is not None)
    return window.colours


def idle(colours, qtbot):
    tasks = colours.window().tasks
    qtbot.waitUntil(lambda: not tasks.tasks)


def widget_point(view, u: float, v: float) -> QPoint:
    """The position of a pixel of the camera's image on the mask view."""
    at = view.zoom.origin + QPointF(u / MASK_STEP + 0.5, v / MASK_STEP + 0.5) * view.zoom.scale
    return at.toPoint()


def narrow(colours, name: str) -> HueRange:
    """Select a hue and make it so narrow that it contains none of its patches."""
    index = colours.tuning.profile.hue_names.index(name)
    colours.choose_hue(index)
    first = colours.tuning.profile.hues[index].hue[0]
    colours.ranges.rows["hue"].high.setValue(first)
    return colours.tuning.profile.hues[index]


def test_clicking_a_patch_includes_it_and_the_detector_finds_it(colours, engine, qtbot):
    image, blobs = frame_and_blobs(engine.frame)
    index = colours.tuning.profile.hue_names.index("green")
    green = blobs.left.uv[blobs.left.hue == blobs.hue_names.index("green")]
    before = narrow(colours, "green")
    missed = Detector(colours.tuning.profile).detect(image.left)[0]
    assert not (missed.hue == index).any()
    colours.tools.pick.click()
    for uv in green:
        qtbot.mouseClick(
            colours.image.mask_view,
            Qt.MouseButton.LeftButton,
            pos=widget_point(colours.image.mask_view, *uv),
        )
    tuned = engine.profiles[-1]
    assert tuned.hues[index].width > before.width
    found = Detector(tuned).detect(image.left)[0]
    assert (found.hue == index).sum() >= len(green) - 1


def test_one_click_per_hue_learns_the_colours(colours, engine, qtbot):
    image, blobs = frame_and_blobs(engine.frame)
    colours.tools.pick.click()
    for index, name in enumerate(colours.tuning.profile.hue_names):
        colours.choose_hue(index)
        uv = blobs.left.uv[blobs.left.hue == blobs.hue_names.index(name)][0]
        at = widget_point(colours.image.mask_view, *uv)
        qtbot.mouseClick(colours.image.mask_view, Qt.MouseButton.LeftButton, pos=at)
    qtbot.waitUntil(lambda: engine.profiles[-1].learned is not None)
    found = Detector(engine.profiles[-1]).detect(image.left)[0]
    shown = [np.linalg.norm(found.uv - uv, axis=1).min() < 4 for uv in blobs.left.uv]
    assert np.mean(shown) > 0.85


def click(colours, qtbot, index: int, uv) -> None:
    colours.choose_hue(index)
    at = widget_point(colours.image.mask_view, *uv)
    qtbot.mouseClick(colours.image.mask_view, Qt.MouseButton.LeftButton, pos=at)


def test_clicks_report_missing_hues_and_undone_ones_do_not_count(colours, engine, qtbot):
    _, blobs = frame_and_blobs(engine.frame)
    names = colours.tuning.profile.hue_names
    first = [blobs.left.uv[blobs.left.hue == blobs.hue_names.index(n)][0] for n in names]
    message = colours.ranges.words.text
    colours.tools.pick.click()
    other = first[1]  # of another hue: a mistake, which a second click insists on
    click(colours, qtbot, 0, other)
    click(colours, qtbot, 0, other)
    missing = ", ".join(names[1:])
    assert message().startswith(
        f"Clicked: {names[0]}. To learn the colours, also click: {missing}."
    )
    colours.undo()
    assert not message().startswith("Clicked")
    for index in range(1, len(names)):
        click(colours, qtbot, index, first[index])
    assert f"also click: {names[0]}." in message()
    assert engine.profiles[-1].learned is None
    click(colours, qtbot, 0, first[0])
    qtbot.waitUntil(lambda: engine.profiles[-1].learned is not None)
    assert message().startswith("Fitted")


def test_undo_also_removes_the_message_about_colours(colours):
    message = colours.ranges.words.text
    colours.ranges.rows["value"].low.setValue(33)
    colours.factory()
    assert message().startswith("Restored the factory colours.")
    colours.undo()
    assert "factory" not in message()
    colours.redo()
    assert message().startswith("Restored the factory colours.")
    colours.ranges.rows["value"].low.setValue(44)
    assert "factory" not in message()


def test_with_an_active_eyedropper_pixels_outside_the_range_keep_their_colour(colours, engine):
    image, blobs = frame_and_blobs(engine.frame)
    hue = colours.tuning.hue_range
    other = next(k for k, name in enumerate(blobs.hue_names) if name != hue.name)
    u, v = (np.round(blobs.left.uv[blobs.left.hue == other][0] / 2)).astype(int)
    masks = [mask_image(image.left, hue, 2, on)[v, u].astype(int) for on in (False, True)]
    assert np.ptp(masks[0]) == 0
    assert np.ptp(masks[1]) > 40
    colours.tools.pick.click()
    assert colours.tools.is_picking
    colours.tools.drop.click()
    colours.tools.drop.click()
    assert not colours.tools.is_picking


def test_the_other_eyedropper_excludes_a_pixel(colours, engine, qtbot):
    image, blobs = frame_and_blobs(engine.frame)
    colours.choose_hue(colours.tuning.profile.hue_names.index("red"))
    uv = blobs.left.uv[blobs.left.hue == blobs.hue_names.index("red")][0]
    colours.tools.pick.click()
    colours.tools.drop.click()
    assert not colours.tools.pick.isChecked()
    at = widget_point(colours.image.mask_view, *uv)
    qtbot.mouseClick(colours.image.mask_view, Qt.MouseButton.LeftButton, pos=at)
    v, u = round(float(uv[1])), round(float(uv[0]))
    pixel = cv2.cvtColor(image.left[v : v + 1, u : u + 1], cv2.COLOR_BGR2HSV)[0, 0]
    assert models()[2].hues[0].contains(pixel)
    assert not colours.tuning.profile.hues[0].contains(pixel)


@pytest.mark.long
@pytest.mark.parametrize("signal", ["fit_markers", "fit_image"])
def test_a_fit_corrects_a_wrong_hue_and_is_one_undo_step(colours, engine, qtbot, signal):
    if signal == "fit_markers":  # the tracker still sees markers of the other hues
        narrow(colours, "blue")
    spoilt = colours.tuning.profile
    getattr(colours.tools, signal).emit()
    idle(colours, qtbot)
    qtbot.waitUntil(lambda: colours.ranges.words.text().startswith("Fitted"))
    assert engine.profiles[-1] == colours.tuning.profile != spoilt
    default, fitted = Detector(models()[2]), Detector(colours.tuning.profile)
    images = [frame_and_blobs(frame)[0].left for frame in (5, 60, 120)]
    found, usual = (sum(len(d.detect(i)[0]) for i in images) for d in (fitted, default))
    assert found >= 0.85 * usual  # from one image, without markers that are only visible later
    colours.undo()
    assert colours.tuning.profile == spoilt


def test_a_fit_without_a_tracked_hand_gives_instructions(window, engine, qtbot):
    engine.tracking = Tracking.SEARCHING
    window.host.adopt(setup_of(engine))
    window.run_command("show_colours")
    qtbot.waitUntil(lambda: window.colours.image.source.image() is not None)
    window.colours.tools.fit_markers.emit()
    assert shows(window.banner.text(), "window.no_markers_to_fit")


def test_tuned_colours_are_restored_for_the_same_camera_only(
    window, engine, store, qtbot, no_leaks
):
    window.host.adopt(setup_of(engine))
    window.colours.ranges.rows["saturation"].low.setValue(77)
    tuned = window.colours.tuning.profile
    window.close()
    again, other = ScriptedEngine(), ScriptedEngine()
    reopened = MainWindow(store)
    qtbot.addWidget(reopened)
    reopened.host.adopt(setup_of(again))
    assert again.profiles[-1] == reopened.colours.tuning.profile == tuned
    assert reopened.host.setup.profile == tuned  # a checklist and colours on screen follow
    reopened.host.adopt(with_camera(scripted_setup(other), name="Another"))
    assert reopened.colours.tuning.profile == models()[2] and other.profiles == []
    reopened.colours.tools.take_over.emit(reopened.colours.keeper.others()[0])
    assert other.profiles[-1] == tuned
    reopened.close()


def test_a_damaged_profile_is_preserved_and_the_default_is_used(tmp_path):
    store, shipped = ColourStore(tmp_path), models()[2]
    store.path(CAMERA).write_text("schema = 1\nname = 3\n")
    assert store.load(CAMERA, shipped) is None
    assert store.path(CAMERA).read_text() == "schema = 1\nname = 3\n"


def test_a_replay_stores_no_colours(window, engine):
    window.host.adopt(scripted_setup(engine))
    window.colours.ranges.rows["value"].low.setValue(60)
    window.colours.keeper.write()
    assert not (window.store.path.parent / "colours").exists()


def test_a_stored_image_is_tuned_while_the_live_one_continues(colours, engine, qtbot):
    image = frame_and_blobs(engine.frame)[0]
    colours.image.source.store_button.click()
    qtbot.waitUntil(lambda: not colours.image.source.is_live)
    engine.frame = 60
    qtbot.wait(300)
    assert np.array_equal(colours.image.source.image(), image.left)
    colours.image.source.side.setCurrentIndex(1)
    assert np.array_equal(colours.image.source.image(), image.right)
    size = float(models()[1].marker_size.mean())
    fx = colours.host.setup.camera.rig.fx
    found = Detector(colours.tuning.profile, size, fx).detect(image.right)[0]
    count = f"{int((found.hue == 0).sum())}"
    qtbot.waitUntil(lambda: colours.ranges.hues.chips[0].text() == count)
    colours.image.source.choice.setCurrentIndex(0)
    qtbot.waitUntil(lambda: colours.image.source.image() is frame_and_blobs(60)[0].right)


class HeldDetector:
    """Starts a search and ends it on request; counts its calls and records their threads."""

    def __init__(self) -> None:
        self.begun: list[Detector] = []
        self.threads: set[int] = set()
        self.go_on = threading.Event()

    def detector(self, profile, size, fx) -> "HeldDetector":
        self.inner = Detector(profile, size, fx)
        self.threads.add(threading.get_ident())
        return self

    def detect(self, image):
        self.begun.append(self.inner)
        assert self.go_on.wait(120)
        return self.begun[-1].detect(image)


@pytest.fixture
def held(colours, qtbot, monkeypatch):
    """A stored image is shown, and its search is running and does not end on its own."""
    held = HeldDetector()
    monkeypatch.setattr(colour_search, "Detector", held.detector)
    colours.image.source.store_button.click()
    qtbot.waitUntil(lambda: len(held.begun) == 1)
    yield held
    held.go_on.set()


def test_a_stored_image_is_searched_in_the_background(colours, held, qtbot):
    began = time.monotonic()
    colours.image.search()
    colours.refresh(colours.host.snapshot())
    assert time.monotonic() - began < 60  # the search itself would block it for 120
    assert colours.ranges.hues.chips[0].text() == "–"
    assert threading.get_ident() not in held.threads
    held.go_on.set()
    image = colours.image.source.image()
    size, fx = float(models()[1].marker_size.mean()), colours.host.setup.camera.rig.fx
    found = Detector(models()[2], size, fx).detect(image)[0]
    count = f"{int((found.hue == 0).sum())}"
    qtbot.waitUntil(lambda: colours.ranges.hues.chips[0].text() == count)


@pytest.mark.long
def test_a_replay_is_searched_with_the_tuned_colours(colours, qtbot):
    """Its recorded blobs were found with other colours, or there are none."""
    colours.tuning.setup = dataclasses.replace(colours.tuning.setup, player=SimpleNamespace())
    colours.tuning.search = colour_search.ImageSearch(colours.tuning.setup)
    index = colours.tuning.profile.hue_names.index("green")
    chip = colours.ranges.hues.chips[index]
    image = colours.image.source.image()
    size, fx = float(models()[1].marker_size.mean()), colours.host.setup.camera.rig.fx
    found = Detector(models()[2], size, fx).detect(image)[0]
    count = int((found.hue == index).sum())
    assert count > 0
    qtbot.waitUntil(lambda: chip.text() == f"{count}")
    narrow(colours, "green")
    qtbot.waitUntil(lambda: chip.text() == "0")


def test_a_replay_faster_than_searches_shows_results(colours, engine, qtbot, monkeypatch):
    held, found = HeldDetector(), []
    monkeypatch.setattr(colour_search, "Detector", held.detector)
    replayed = dataclasses.replace(colours.tuning.setup, player=SimpleNamespace())
    colours.tuning.search = colour_search.ImageSearch(replayed)
    monkeypatch.setattr(colours.tuning.search, "found", found.append)
    qtbot.waitUntil(lambda: len(held.begun) == 1)
    engine.frame = 60
    qtbot.waitUntil(lambda: colours.image.source.image() is frame_and_blobs(60)[0].left)
    for _ in range(3):
        colours.refresh(colours.host.snapshot())
    held.go_on.set()
    qtbot.waitUntil(lambda: len(found) == 2)  # the first one's, and the newest's


@pytest.mark.long
def test_only_the_newest_profile_is_used_and_shown(colours, held, qtbot):
    answers = []
    colours.image.changed.connect(
        lambda: answers.append(colours.tuning.rows(colours.image.shown()))
    )
    for low in (10, 20, 30):
        colours.ranges.rows["saturation"].low.setValue(low)
    newest = colours.tuning.profile
    held.go_on.set()
    qtbot.waitUntil(lambda: len(held.begun) == 2)  # two were skipped
    qtbot.waitUntil(lambda: bool(answers))
    assert len(answers) == 1  # the result of the first search was outdated
    assert held.begun[-1].profile == newest


def test_the_result_for_a_removed_image_is_not_shown(colours, engine, held, qtbot):
    engine.frame = 60
    colours.image.source.choice.setCurrentIndex(0)
    newest = frame_and_blobs(60)[0].left
    qtbot.waitUntil(lambda: colours.image.source.image() is newest)
    held.go_on.set()
    qtbot.wait(200)
    rows = colours.tuning.rows(colours.image.shown())
    assert rows == seen_rows(colours.image.source.view, colours.tuning.profile)


def test_stored_images_are_standard_png_files(colours, engine, qtbot, tmp_path):
    image = frame_and_blobs(engine.frame)[0]
    colours.image.source.stored.save_file(tmp_path / "glove.png", *colours.image.source.pair())
    idle(colours, qtbot)
    read = cv2.imread(str(tmp_path / "glove.png"))
    assert np.array_equal(read, np.hstack([image.left, image.right]))
    colours.image.source.stored.open_file(tmp_path / "glove.png")
    qtbot.waitUntil(lambda: not colours.image.source.is_live)
    assert np.array_equal(colours.image.source.image(), image.left)
    colours.image.source.remove()
    assert colours.image.source.is_live and (tmp_path / "glove.png").exists()


def test_a_removed_image_is_restored_by_undo(colours, engine, qtbot, tmp_path):
    source, window = colours.image.source, colours.window()
    source.store_button.click()
    qtbot.waitUntil(lambda: not source.is_live)
    name, image = source.choice.currentText(), source.image()
    path = source.stored.folder.path(name)
    source.remove()
    assert source.is_live and not path.exists() and source.choice.findText(name) < 0
    assert window.banner.text() == f"The image {name} was removed."
    window.banner.buttons[0].click()
    qtbot.waitUntil(lambda: not source.is_live)
    assert path.exists() and source.choice.currentText() == name
    assert np.array_equal(source.image(), image)
    source.stored.save_file(tmp_path / "elsewhere.png", *colours.image.source.pair())
    idle(colours, qtbot)
    source.stored.open_file(tmp_path / "elsewhere.png")
    qtbot.waitUntil(lambda: source.choice.currentText() == "elsewhere")
    source.remove()
    window.banner.buttons[0].click()
    assert source.choice.currentText() == "elsewhere" and not source.is_live


def test_an_image_that_cannot_be_removed_is_reported(colours, qtbot):
    source = colours.image.source
    source.store_button.click()
    qtbot.waitUntil(lambda: not source.is_live)
    name = source.choice.currentText()
    source.stored.folder.path(name).unlink()
    source.remove()
    assert colours.window().banner.text().startswith(f"{name} was not removed: ")


def test_the_oldest_stored_image_is_removed_first(tmp_path):
    folder = ImageFolder(tmp_path)
    tiny = np.zeros((4, 4, 3), np.uint8)
    for i in range(MOST + 2):
        folder.store(StoredImage(f"{i:03d}", tiny))
    assert folder.names() == [f"{i:03d}" for i in range(2, MOST + 2)]
    assert read_image(folder.path("002")).right is None


def test_a_frozen_image_is_unchanged(colours, engine, qtbot):
    colours.image.source.freeze.setChecked(True)
    engine.frame = 60
    qtbot.wait(300)
    assert colours.image.source.image() is frame_and_blobs(30)[0].left


def test_a_frozen_image_is_counted_with_the_current_colours(colours, engine, qtbot):
    """The engine searches live images only, so its counts did not apply to a frozen one."""
    index = colours.tuning.profile.hue_names.index("green")
    chip = colours.ranges.hues.chips[index]
    colours.image.source.freeze.setChecked(True)
    assert colours.image.mask_view._title == "Mask, image frozen"
    qtbot.waitUntil(lambda: chip.text().startswith("●") or " of about " in chip.text())
    image = colours.image.source.image()
    engine.frame = 60
    narrow(colours, "green")
    missed = lambda: colours.tuning.rows(colours.image.shown())[index]  # noqa: E731
    qtbot.waitUntil(lambda: missed().count.startswith("0 of about "))
    assert missed().look is WARN
    assert colours.image.source.image() is image
    colours.undo()
    size, fx = float(models()[1].marker_size.mean()), colours.host.setup.camera.rig.fx
    found = int((Detector(models()[2], size, fx).detect(image)[0].hue == index).sum())
    assert found > 0
    qtbot.waitUntil(lambda: missed().count.startswith(f"{found} of about "))
    assert missed().look is GOOD
    colours.image.source.freeze.setChecked(False)
    assert colours.image.mask_view._title == "Mask"
    qtbot.waitUntil(lambda: colours.image.source.image() is not image)


def test_another_camera_starts_live(colours):
    colours.image.source.freeze.setChecked(True)
    colours.host.adopt(with_camera(scripted_setup(ScriptedEngine()), name="Another"))
    assert not colours.image.source.freeze.isChecked()


def test_masks_of_frozen_images_follow_the_colours(colours, qtbot):
    cameras = colours.window().cameras
    colours.window().show_panel("cameras")
    cameras.masks.setChecked(True)
    cameras.freeze.setChecked(True)
    cameras.refresh(colours.host.snapshot())
    before = cameras.left._array.copy()
    narrow(colours, "green")
    cameras.refresh(colours.host.snapshot())
    green = hue_colours(models()[2])["green"]
    bgr = [int(green[i : i + 2], 16) for i in (5, 3, 1)]
    count = lambda image: int((image == bgr).all(axis=2).sum())  # noqa: E731
    assert count(before) > 0
    assert count(cameras.left._array) < count(before)


def test_red_wraps_through_zero_on_the_slider(colours, qtbot):
    colours.choose_hue(0)
    slider = colours.ranges.rows["hue"].slider
    assert isinstance(slider, HueRangeSlider) and slider.values() == (169, 11)
    (a, b), (c, d) = slider.bars()
    assert a == slider._x(169) and b > slider._x(179) and c < slider._x(0) and d == slider._x(11)


def test_dragging_a_handle_past_the_end_wraps_and_is_one_step(colours, engine, qtbot):
    colours.choose_hue(0)
    slider, before = colours.ranges.rows["hue"].slider, colours.tuning.profile

    def at(hue: int) -> QPoint:
        return QPoint(round(slider._x(hue)), slider.height() // 2)

    qtbot.mousePress(slider, Qt.MouseButton.LeftButton, pos=at(11))
    for hue in (8, 3, 176):
        slider.mouseMoveEvent(_move(slider, at(hue)))
    qtbot.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=at(176))
    low, high = colours.tuning.profile.hues[0].hue
    assert low == 169 and abs(high - 176) <= 2
    assert engine.profiles[-1].hues[0].hue == (low, high)
    colours.undo()
    assert colours.tuning.profile == before


def _move(widget, at: QPoint) -> QMouseEvent:
    left, none = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
    on_screen = QPointF(widget.mapToGlobal(at))
    kind, keys = QEvent.Type.MouseMove, Qt.KeyboardModifier.NoModifier
    return QMouseEvent(kind, QPointF(at), on_screen, none, left, keys)


def test_arrow_keys_move_the_selected_end_around_the_circle(colours, qtbot):
    slider = colours.ranges.rows["hue"].slider
    slider.set_values(0, 20)
    qtbot.keyClick(slider, Qt.Key.Key_Left)
    assert slider.values() == (179, 20)
    qtbot.keyClick(slider, Qt.Key.Key_Up)
    qtbot.keyClick(slider, Qt.Key.Key_Right)
    assert slider.values() == (179, 21)


def test_a_background_with_a_colour_of_the_glove_is_reported(colours, engine, qtbot, monkeypatch):
    for _ in range(ROOM_EVERY):
        colours.tuning.room.watch(colours.image.source.view, colours.tuning.profile)
    assert colours.tuning.room.shares == {}  # the grey table and the hand itself do not conflict
    room = np.full((720, 1280, 3), 120, np.uint8)
    room[100:200, 100:300] = (30, 180, 30)
    monkeypatch.setattr(colours.image.source, "image", lambda: room)
    colours.check_room()
    assert "green: the background has this colour" in colours.ranges.words.text()
    colours.start_again()
    message = colours.ranges.words.text()
    assert message.startswith(
        "Restored the initial colours of this session.\n▲ green: the background has this"
    )
    assert room_shares(room, models()[2])["green"] == pytest.approx(
        100 * 200 / (720 * 1280), rel=0.1
    )


def test_learned_background_colours_are_not_reported():
    """Wood within red's range, as after a fit where cloth and wood have one hue."""
    wood, cloth = (90, 90, 200), (20, 20, 200)
    room = np.full((720, 1280, 3), wood, np.uint8)
    room[:72] = cloth
    plain = models()[2]
    assert room_shares(room, plain)["red"] == 1
    classes = np.full(LEARNED_CELLS, UNKNOWN, np.uint8)
    b, g, r = (c >> 8 - LEARNED_BITS for c in wood)
    classes[(b << LEARNED_BITS | g) << LEARNED_BITS | r] = ROOM
    learned = dataclasses.replace(plain, learned=LearnedColours.of(classes))
    assert room_shares(room, learned) == {"red": pytest.approx(0.1)}


def test_a_single_patch_is_reported_in_the_singular():
    profile = models()[2]
    found = [FoundHue(h, n, 0) for n, h in enumerate(profile.hues[:2], start=1)]
    message = fit_text(found, profile)
    assert message.startswith("Fitted red (1 patch), yellow (2 patches). Not changed: green, blue")


def test_fast_masks_equal_those_of_the_profile():
    image = frame_and_blobs(30)[0].left
    hsv, profile = to_hsv(image), models()[2]
    for hue in profile.hues:
        assert np.array_equal(in_range(hsv, hue) > 0, hue.contains(hsv))
    colours = hue_colours(profile)
    shown = masks_image(image, {h: colours[h.name] for h in profile.hues})
    taken = np.any([h.contains(hsv) for h in profile.hues], axis=0)
    red = profile.hues[0]
    bgr = [int(colours["red"][i : i + 2], 16) for i in (5, 3, 1)]
    assert (shown[red.contains(hsv)] == bgr).all()
    assert np.ptp(shown[~taken], axis=1).max() == 0  # grey


def test_closing_during_a_drag_stores_the_last_values(window, engine, store):
    window.host.adopt(setup_of(engine))
    window.colours.ranges.rows["value"].low.setValue(61)
    window.close()
    saved = ColourStore(store.path.parent / "colours").load(CAMERA, models()[2])
    assert saved.hues[0].value[0] == 61


def test_import_and_export_ask_for_a_file(colours, monkeypatch, tmp_path):
    path = tmp_path / "mine.toml"
    bare = str(path.with_suffix(""))  # as a person types it; the dialog to import shows *.toml
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (bare, ""))
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    colours.ranges.rows["value"].low.setValue(33)
    tuned = colours.tuning.profile
    colours.tools.save.emit()
    colours.start_again()
    assert colours.tuning.profile == models()[2]
    colours.tools.load.emit()
    assert colours.tuning.profile == tuned


# --- the light


def test_the_light_is_measured_and_missed_markers_get_rings(colours, qtbot):
    """A stored image whose colours are not in the profile; suitable colours remove the rings."""
    light = colours.light
    qtbot.waitUntil(lambda: light.watch.reading is not None)
    narrow(colours, "green")
    missed = lambda: len(light.rings(colours.image.shown()))  # noqa: E731
    qtbot.waitUntil(lambda: missed() > 0)
    assert "markers missed" in light.watch.line()
    assert shows(light.advice.text(), "light.markers_missed")
    assert shows(light.chip.toolTip(), "light.markers_missed")
    light.show_missed.setChecked(False)
    assert missed() == 0
    light.show_missed.setChecked(True)
    before = missed()
    colours.undo()
    qtbot.waitUntil(lambda: missed() < before)


def test_missed_markers_of_a_frozen_image_are_those_of_that_image(colours, engine, qtbot):
    """It was never measured if the live one had been measured within the second before."""
    light = colours.light
    narrow(colours, "green")
    qtbot.waitUntil(lambda: len(light.rings(colours.image.shown())) > 0)
    engine.frame = 33  # a tenth of a second later
    newest = frame_and_blobs(33)[0].left
    qtbot.waitUntil(lambda: colours.image.source.image() is newest)
    colours.image.source.freeze.setChecked(True)
    qtbot.waitUntil(lambda: light.watch.is_of(newest))
    rings = light.rings(colours.image.shown())
    missed = (
        LightMeter(colours.tuning.profile, colours.host.setup.camera.rig.fx).read(newest).missed
    )
    assert [(r.u, r.v) for r in rings] == [tuple(uv) for uv in missed / MASK_STEP]


def warmer(profile):
    """The effect of the light on a profile: every hue is shifted slightly."""
    hues = tuple(
        dataclasses.replace(h, hue=((h.hue[0] - 5) % 180, (h.hue[1] - 5) % 180))
        for h in profile.hues
    )
    return dataclasses.replace(profile, hues=hues)


def test_colours_that_follow_the_light_can_be_seen_stored_and_tuned(
    colours, engine, qtbot, tmp_path
):
    """A slider moved afterwards changes the colours of this light, not of the previous one."""
    old = colours.tuning.profile
    engine.followed = new = warmer(old)
    qtbot.waitUntil(lambda: colours.tuning.profile == new)
    row = colours.ranges.rows["hue"]
    assert row.values() == new.hues[colours.tuning.hue].hue != old.hues[colours.tuning.hue].hue
    assert colours.host.setup.profile == new  # overlays and the checklist go by it
    assert engine.profiles == []  # the engine has received no other colours
    assert colours.ranges.words.text().startswith("The colours were adapted to the light.")
    colours.keeper.write()
    assert colours.keeper.store.load(CAMERA, old) == new
    colours.files.save(tmp_path / "out.toml")
    assert load_profile(tmp_path / "out.toml") == new
    colours.ranges.rows["saturation"].low.setValue(66)
    moved = engine.profiles[-1]
    assert moved.hues[0].saturation[0] == 66
    assert [h.hue for h in moved.hues] == [h.hue for h in new.hues]
    colours.undo()
    assert engine.profiles[-1] == new
    colours.undo()
    assert engine.profiles[-1] == old  # the automatic change can be undone


def test_a_continuous_change_of_light_is_one_undo_step(colours, engine, qtbot):
    old = colours.tuning.profile
    for _ in range(3):
        engine.followed = new = warmer(colours.tuning.profile)
        qtbot.waitUntil(lambda new=new: colours.tuning.profile == new)
    colours.undo()
    assert colours.tuning.profile == old
    colours.redo()
    assert colours.tuning.profile == new


def test_a_change_of_light_during_clicks_preserves_them(colours, engine, qtbot):
    _, blobs = frame_and_blobs(engine.frame)
    first = blobs.left.uv[blobs.left.hue == blobs.hue_names.index("red")][0]
    colours.tools.pick.click()
    click(colours, qtbot, 0, first)
    engine.followed = new = warmer(colours.tuning.profile)
    qtbot.waitUntil(lambda: colours.tuning.profile == new)
    assert colours.ranges.words.text().startswith("Clicked: red.")


def test_a_click_on_a_marker_of_another_hue_needs_confirmation(colours, engine, qtbot):
    """It would merge two colours. A second click confirms, and Undo reverts it."""
    _, blobs = frame_and_blobs(engine.frame)
    green = blobs.left.uv[blobs.left.hue == blobs.hue_names.index("green")][0]
    red = colours.tuning.profile.hue_names.index("red")
    before, message = colours.tuning.profile, colours.ranges.words.text
    colours.tools.pick.click()
    click(colours, qtbot, red, green)
    assert message().startswith("This looks like green, not red.")
    assert colours.tuning.profile == before and engine.profiles == []
    assert not colours.tuning.all_picked
    click(colours, qtbot, red, green)
    assert message().startswith("Clicked: red.")
    assert engine.profiles[-1] == colours.tuning.profile != before
    colours.undo()
    assert engine.profiles[-1] == colours.tuning.profile == before
    click(colours, qtbot, red, green)
    assert message().startswith("This looks like green")  # asked each time
    click(colours, qtbot, colours.tuning.profile.hue_names.index("green"), green)
    assert message().startswith("Clicked: green.")


def test_a_grey_pixel_is_rejected_by_both_including_eyedroppers(colours, engine, qtbot):
    """It would widen a hue until it includes the wall, the table and the glove's cloth."""
    image, _ = frame_and_blobs(engine.frame)
    wall = np.array([3.0, 3.0])
    assert np.ptp(image.left[3, 3].astype(int)) < 15  # levels between its channels
    before, message = colours.tuning.profile, colours.ranges.words.text
    for button in (colours.tools.pick, colours.tools.take):
        button.click()
        for _ in range(2):  # not even a second time
            click(colours, qtbot, 0, wall)
            assert message().startswith("This pixel is too grey or too dark to have a hue")
        assert "Click the middle of a red marker." in message()
        assert colours.tuning.profile == before and engine.profiles == []


@pytest.mark.long
@pytest.mark.parametrize("hue", range(4))
def test_setting_from_a_pixel_restores_the_markers_of_a_shifted_hue(colours, engine, qtbot, hue):
    """*Pick +* only widens: a hue shifted far away would then be half the circle."""
    image, blobs = frame_and_blobs(engine.frame)
    name = colours.tuning.profile.hue_names[hue]
    markers = blobs.left.uv[blobs.left.hue == blobs.hue_names.index(name)]
    sizes = blobs.left.size[blobs.left.hue == blobs.hue_names.index(name)]
    largest = markers[np.argmax(sizes.min(axis=1))]
    colours.choose_hue(hue)
    shipped = colours.tuning.profile.hues[hue].hue
    colours.tuning.move("hue", tuple((end + 60) % 180 for end in shipped), held=False)
    moved = colours.tuning.profile
    colours.tools.take.click()
    assert not colours.tools.pick.isChecked()
    click(colours, qtbot, hue, largest)
    tuned = engine.profiles[-1].hues[hue]
    assert tuned == colours.tuning.profile.hues[hue]
    assert tuned.width < 40 and tuned.hue == colours.ranges.rows["hue"].values()
    size, fx = float(models()[1].marker_size.mean()), colours.host.setup.camera.rig.fx
    found = Detector(colours.tuning.profile, size, fx).detect(image.left)[0]
    gaps = np.linalg.norm(found.uv[found.hue == hue] - largest, axis=1)
    assert gaps.min() < 4
    colours.undo()
    assert colours.tuning.profile == moved


def test_a_marker_of_a_shifted_hue_is_not_taken_for_another(colours, engine, qtbot):
    _, blobs = frame_and_blobs(engine.frame)
    yellow = blobs.left.uv[blobs.left.hue == blobs.hue_names.index("yellow")][0]
    index = colours.tuning.profile.hue_names.index("yellow")
    colours.choose_hue(index)
    colours.tuning.move("hue", (80, 95), held=False)
    message = colours.ranges.words.text
    colours.tools.pick.click()
    click(colours, qtbot, index, yellow)
    assert message().startswith("Clicked: yellow.")
    colours.undo()
    click(colours, qtbot, colours.tuning.profile.hue_names.index("red"), yellow)
    assert message().startswith("This looks like yellow, not red.")


def test_a_number_being_typed_is_not_changed_by_the_light(colours, engine, qtbot):
    """The user's edit has priority; the other end and the other hues are those of the present
    light."""
    colours.window().activateWindow()
    row = colours.ranges.rows["hue"]
    index = colours.tuning.profile.hue_names.index("green")
    colours.choose_hue(index)
    old = row.values()
    row.low.setFocus()
    qtbot.waitUntil(row.low.hasFocus)
    row.low.selectAll()
    qtbot.keyClicks(row.low, "4")
    engine.followed = first = warmer(colours.tuning.profile)
    qtbot.waitUntil(lambda: colours.tuning.profile == first)
    assert row.low.lineEdit().text() == "4"
    assert row.high.value() == first.hues[index].hue[1] == old[1] - 5
    qtbot.keyClicks(row.low, "1")
    qtbot.keyClick(row.low, Qt.Key.Key_Return)
    assert engine.profiles[-1].hues[index].hue == (41, old[1] - 5)
    assert engine.profiles[-1].hues[0] == first.hues[0]
    row.low.selectAll()
    engine.followed = second = warmer(colours.tuning.profile)
    qtbot.waitUntil(lambda: colours.tuning.profile == second)
    assert row.low.lineEdit().selectedText() == "41"  # about to be typed over
    colours.image.mask_view.setFocus()
    assert row.values() == second.hues[index].hue, "once it is left it shows the latest"
    assert colours.tuning.profile == second
    row.low.setFocus()
    colours.undo()
    assert row.values() == colours.tuning.profile.hues[index].hue, "what was asked for is shown"
