"""The images in the real window: masks, freeze, zoom, pairs, what is dimmed."""

import dataclasses

import numpy as np
import pytest
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtWidgets import QPushButton, QWidget

from app.engines.engine_host import EngineHost
from app.panels.colours.source import FlowLayout
from app.platform.tasks import TaskOwner
from app.viewmodels.camera_overlay import DIM, EDGE_PX, Layers, overlay
from app.viewmodels.colours import hue_colours
from app.widgets.image_shapes import Crosses, Rings
from tests.gui.gui_fakes import ScriptedEngine, frame_and_blobs, models, scripted_setup
from tracker.messages import CameraPose, Shed


@pytest.fixture
def cameras(live, qtbot):
    qtbot.waitUntil(lambda: live.cameras._view is not None)
    return live.cameras


@pytest.fixture
def view(qapp):
    host = EngineHost(TaskOwner())
    host.adopt(scripted_setup(ScriptedEngine()))
    yield host.snapshot()
    host.shut_down()


def patches(engine, hue: str) -> np.ndarray:
    """(n, 2) rows and columns of the pixels in the middle of a hue's blobs, left."""
    blobs = frame_and_blobs(engine.frame)[1]
    uv = blobs.left.uv[blobs.left.hue == blobs.hue_names.index(hue)]
    return np.round(uv[:, ::-1]).astype(int)


def test_a_mask_shows_its_hue_alone_and_each_can_be_switched(cameras, engine):
    assert all(box.isHidden() for box in cameras.hue_boxes.values())
    cameras.masks.click()
    assert not any(box.isHidden() for box in cameras.hue_boxes.values())
    colours = hue_colours(models()[2])

    def painted(hue: str) -> float:
        bgr = np.array([int(colours[hue][i : i + 2], 16) for i in (5, 3, 1)])
        rows, columns = patches(engine, hue).T
        return float((cameras.left._array[rows, columns] == bgr).all(axis=1).mean())

    assert painted("red") > 0.8 and painted("blue") > 0.8
    cameras.hue_boxes["blue"].click()
    assert painted("red") > 0.8 and painted("blue") == 0.0


def test_an_overloaded_computer_shows_images_without_overlays(cameras, engine, qtbot):
    qtbot.waitUntil(lambda: len(cameras.left._shapes) > 0)
    engine.values["load_shed"] = float(Shed.OVERLAYS)
    qtbot.waitUntil(lambda: len(cameras.left._shapes) == 0)
    assert cameras.left._array is not None
    engine.values["load_shed"] = float(Shed.VIEW_RATE)
    qtbot.waitUntil(lambda: len(cameras.left._shapes) > 0)


def test_layers_change_on_a_frozen_image(cameras, engine, qtbot):
    cameras.freeze.click()
    before = len(cameras.left._shapes)
    engine.frame = 60
    qtbot.wait(200)
    assert np.array_equal(cameras.left._array, frame_and_blobs(30)[0].left)
    cameras._layer_boxes["predicted"].click()
    assert 0 < len(cameras.left._shapes) < before
    cameras.freeze.click()
    qtbot.waitUntil(lambda: np.array_equal(cameras.left._array, frame_and_blobs(60)[0].left))


def test_keys_zoom_and_move_and_stop_following(cameras, qtbot):
    image = cameras.left
    assert cameras.follow.isChecked()
    image.fit()
    middle = QPointF(image.rect().center())
    before = image.zoom.to_image(middle)
    qtbot.keyClick(image, Qt.Key.Key_Plus)
    assert not cameras.follow.isChecked()
    assert image.zoom.to_image(middle) == pytest.approx(before, abs=1e-6)
    scale = image.zoom.scale
    qtbot.keyClick(image, Qt.Key.Key_Right)
    assert image.zoom.to_image(middle)[0] > before[0]
    qtbot.keyClick(image, Qt.Key.Key_Minus)
    assert image.zoom.scale < scale
    qtbot.keyClick(image, Qt.Key.Key_0)
    assert image.zoom.zoom == 1.0


def test_one_camera_takes_the_whole_width(cameras):
    cameras.sides.setCurrentIndex(1)
    assert cameras.right.isHidden() and not cameras.left.isHidden()
    cameras.sides.setCurrentIndex(2)
    assert cameras.left.isHidden() and not cameras.right.isHidden()


def test_blobs_of_markers_that_both_cameras_see_are_filled(view):
    result = view.result
    right = result.match_right.copy()
    pair = int(np.flatnonzero(result.match_left >= 0)[0])
    right[pair] = 0
    seen = dataclasses.replace(view, result=dataclasses.replace(result, match_right=right))
    only = Layers(rejected=False, predicted=False, residuals=False, skeleton=False)
    (rings,) = overlay(seen, only, {}, right=False)
    assert isinstance(rings, Rings)
    assert np.flatnonzero(rings.filled).tolist() == [int(result.match_left[pair])]
    (without,) = overlay(seen, dataclasses.replace(only, pairs=False), {}, right=False)
    assert isinstance(without, Rings) and not without.filled.any()


def test_markers_out_of_view_are_dimmed_at_the_edge_where_they_left(view):
    """The camera is moved so that the hand is left of the image, as by a turned head."""
    pose = view.setup.camera.rig.pose
    moved = CameraPose(pose.R_GC, pose.p_GC + pose.R_GC @ [0.6, 0.0, 0.0])
    result = dataclasses.replace(
        view.result, predicted_left=np.full_like(view.result.predicted_left, np.nan)
    )
    frame = dataclasses.replace(view.frame, pose=moved)
    away = dataclasses.replace(view, frame=frame, result=result)
    only = Layers(blobs=False, rejected=False, residuals=False, skeleton=False)
    (crosses,) = overlay(away, only, {}, right=False)
    assert isinstance(crosses, Crosses) and crosses.opacity == DIM
    assert len(crosses.uv) == len(view.setup.glove.markers)
    assert (crosses.uv[:, 0] == EDGE_PX).all()


@pytest.mark.styled
def test_controls_wrap_in_a_narrow_panel(qtbot):
    box = QWidget()
    qtbot.addWidget(box)
    flow = FlowLayout(box, spacing=6)
    buttons = [QPushButton("word") for _ in range(5)]
    for button in buttons:
        button.setFixedSize(QSize(80, 20))
        flow.addWidget(button)
    assert flow.heightForWidth(5 * 86) == 20
    assert flow.heightForWidth(2 * 86) == 3 * 20 + 2 * 4
    box.resize(172, 100)
    box.show()
    assert buttons[2].geometry().left() == 0 and buttons[2].geometry().top() == 24
    buttons[0].hide()
    assert flow.heightForWidth(2 * 86) == 2 * 20 + 4
