"""The camera dialog: selection of the camera, and locks of its controls."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QTimer, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QFileDialog,
    QFormLayout,
    QGridLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.camera_choice import (
    NAME,
    ONE,
    PAIR,
    TWO,
    by_name,
    by_names,
    is_address,
    stated_count,
)
from app.engines.engine_host import EngineHost
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.widgets.image_view import ImageView
from app.wizards.form_dialog import FormDialog, filler, labelled, row_of
from app.words import local, mark, notice_text, tr
from tracker.sensors.camera_controls import Control, Locks, locks_from, locks_text
from tracker.sensors.camera_plugins import all_cameras
from tracker.sensors.image_input import CameraName, Image

TICK_MS = 200
NAMES = {"exposure": mark("Exposure"), "gain": mark("Gain"), "white_balance": mark("White balance")}
LARGEST = 100_000.0
ABSENT = -1  # index of a selected camera that is not connected
LIVE = 90  # px, minimum height of an image


class CameraSetup(FormDialog):
    """Locks take effect immediately. ``chosen``: another camera was stored."""

    chosen = Signal()

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QWidget | None = None,
        find: Callable[[], list[CameraName]] = all_cameras,
    ) -> None:
        super().__init__("camera_setup", (560, 560), parent)
        self._host, self._store, self._tasks, self._find = host, store, tasks, find
        self._cameras: list[CameraName] = []
        self._searched = False
        self._shown: str | None = None  # `choice` as offered last
        self.setWindowTitle(self.tr("Camera set-up"))
        self.left, self.right, self.other = QComboBox(), QComboBox(), QLineEdit()
        self.other_right = QLineEdit()
        self.exchanged = QCheckBox(self.tr("Swap l&eft and right"))
        self.exchanged.setToolTip(
            self.tr("If a stereo calibration reports that the cameras are swapped")
        )
        self.exchanged.setChecked(store.value.camera_exchanged)
        self.arriving = QLabel()
        self.arriving.setProperty("role", "faint")
        waiting = self.tr("No image yet")
        self.images = (
            ImageView(self.tr("Left"), waiting),
            ImageView(self.tr("Right"), waiting),
        )
        self.locks = LockBox()
        self.locks.wanted.connect(self._lock)
        self.use = QPushButton(self.tr("&Use this camera"))
        self.use.clicked.connect(self._use)
        self.lay_out((self._form(), self._live(), self.arriving, self.locks), self.use)
        self.locks.show_locks(locks_from(store.value.camera_locks))
        self._timer = QTimer(self)
        self._timer.timeout.connect(self._tick)
        self._timer.start(TICK_MS)
        self._show_cameras([])
        self.search()
        self._tick()

    def _form(self) -> QFormLayout:
        self.again.clicked.connect(self.search)
        self.other.setPlaceholderText(self.tr("0 (the first camera), a video file or an address"))
        self.browse = QPushButton(self.tr("&Browse…"))
        self.browse.clicked.connect(self._choose_file)
        form = QFormLayout()
        form.addRow(labelled(self.tr("&Camera"), self.left), row_of(self.left, self.again))
        form.addRow(self.tr("&Right images from"), self.right)
        form.addRow(
            labelled(self.tr("&Or number, file"), self.other), row_of(self.other, self.browse)
        )
        self.other_right.setPlaceholderText(
            self.tr("empty, or the number or address of the right camera")
        )
        form.addRow(self.tr("&And from"), self.other_right)
        form.addRow("", self.exchanged)
        return form

    def _live(self) -> QWidget:
        """Live images, to check which one is the left one."""
        live = filler()
        row = QHBoxLayout(live)
        row.setContentsMargins(0, 0, 0, 0)
        for image in self.images:
            image.setMinimumHeight(LIVE)
            row.addWidget(image)
        return live

    # --- which camera

    def search(self) -> None:
        """List the cameras of the system."""
        self._tasks.run(self.tr("Looking for cameras"), lambda _progress: self._find(), self._found)

    def _found(self, cameras: list[CameraName]) -> None:
        self._searched = True
        self._show_cameras(cameras)

    def _show_cameras(self, cameras: list[CameraName]) -> None:
        """Offer these cameras; keep an edited selection, otherwise select that of the settings."""
        edited = self._shown is not None and self.choice() != self._shown
        chosen = self.choice() if edited else self._store.value.camera
        self._cameras = cameras
        self.left.clear()
        self.left.addItem(self.tr("First camera found"), "")
        self.right.clear()
        self.right.addItem(self.tr("the same image, if it is wide enough for two"), "")
        self.right.addItem(self.tr("none (single camera)"), ONE)
        self.right.addItem(self.tr("the same image, side by side"), TWO)
        for camera in cameras:
            title = f"{camera.name} ({camera.path or camera.index})"
            self.left.addItem(title, camera)
            self.right.addItem(title, camera)
        count, chosen = stated_count(chosen)
        self.right.setCurrentIndex(count)
        self._show_choice(chosen)
        self._shown = self.choice()

    def _show_choice(self, chosen: str) -> None:
        """Show the setting, without its number of images: in the list, or as entered."""
        pair = chosen.startswith(PAIR)
        named = pair or chosen.startswith(NAME)
        first, second = chosen.removeprefix(NAME), ""
        if pair:
            first, _, second = chosen.removeprefix(PAIR).partition("|")
        absent = [n for n in (first, second) if n and not self._is_listed(n)]
        typed = any(n.isdigit() or is_address(n) for n in absent) or first == second
        if absent and (typed or not named):
            self.other.setText(first)
            self.other_right.setText(second)
            return
        self.other.clear()
        self.other_right.clear()
        for box, name in ((self.left, first), (self.right, second)):
            if name in absent:
                title = self.tr("{} (not connected)").format(name) if self._searched else name
                box.addItem(title, CameraName(ABSENT, name, ""))
            _select(box, name)

    def _is_listed(self, wanted: str) -> bool:
        return any(wanted in (c.name, str(c.index)) for c in self._cameras)

    def _choose_file(self) -> None:
        words = self.tr("A video with both images side by side")
        name, _ = QFileDialog.getOpenFileName(self, words, self.other.text())
        if name:
            self.other.setText(name)

    def choice(self) -> str:
        """The selection as stored in the settings."""
        left, right = self.left.currentData(), self.right.currentData()
        count = "" if isinstance(right, CameraName) else str(right or "")
        address, row_of = self.other.text().strip(), self.other_right.text().strip()
        if address:
            return f"{PAIR}{address}|{row_of}" if row_of else count + address
        if not isinstance(left, CameraName):
            return count
        return by_names(left, right) if isinstance(right, CameraName) else count + by_name(left)

    def _use(self) -> None:
        exchanged = self.exchanged.isChecked()
        self._store.update(camera=self.choice(), camera_exchanged=exchanged)
        self.chosen.emit()
        self.close()

    # --- locks

    def _tick(self) -> None:
        setup = self._host.setup
        self.arriving.setText(self._arriving())
        controls = setup.camera.controls if setup is not None else None
        if setup is not None and setup.simulated:
            self.locks.show_nothing(self.tr("The simulated camera's exposure is fixed."))
        elif controls is None:
            words = self.tr("Start glove and camera to see the camera's controls.")
            self.locks.show_nothing(words)
        else:
            self.locks.show_controls(controls.controls())

    def _arriving(self) -> str:
        """Show the live images; returns their size and rate, empty without images."""
        view = self._host.snapshot()
        unfit = view.unfit if view is not None else None
        if unfit is not None:
            self._name_images(alone=unfit.pair[1] is None)
            self._show_pair(unfit.pair)
            return notice_text(unfit.why)
        if view is None or view.frame is None or not view.images_arrive:
            self._show_pair((None, None))
            return ""
        alone = view.setup.camera.is_single(view.frame)
        self._name_images(alone)
        self._show_pair((view.frame.left, view.frame.right))
        image = view.frame.left if view.frame.left is not None else view.frame.right
        rate = view.status.values.get("frame_rate_hz", 0.0) if view.status is not None else 0.0
        if image is None:
            return ""
        if alone:
            words = self.tr("Receiving {} × {} px from one camera, {} images per second")
        else:
            words = self.tr("Receiving {} × {} px from each camera, {} images per second")
        arriving = words.format(image.shape[1], image.shape[0], f"{rate:.0f}")
        if view.setup.simulated:
            return self.tr("{} (simulated camera)").format(arriving)
        return arriving

    def _name_images(self, alone: bool) -> None:
        """Name the image of a single camera "Camera" instead of "Left"."""
        self.images[0].set_title(self.tr("Camera") if alone else self.tr("Left"))
        self.images[1].setHidden(alone)

    def _show_pair(self, pair: tuple[Image | None, Image | None]) -> None:
        for widget, each in zip(self.images, pair, strict=True):
            widget.show_image(each)

    def _lock(self, locks: Locks) -> None:
        self._store.update(camera_locks=locks_text(locks))
        setup = self._host.setup
        if setup is not None and setup.camera.controls is not None:
            setup.camera.controls.request_locks(locks)

    def done(self, result: int) -> None:
        self._timer.stop()
        super().done(result)


class LockBox(QGroupBox):
    """A row for each control: whether it is locked, and at which value."""

    wanted = Signal(object)  # Locks

    def __init__(self) -> None:
        super().__init__()
        self.setTitle(self.tr("Locks"))
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.words.setProperty("role", "faint")
        self.boxes: dict[str, QCheckBox] = {}
        self.values: dict[str, QDoubleSpinBox] = {}
        self._states: dict[str, QLabel] = {}
        self._known: dict[str, Control] = {}
        grid = QGridLayout()
        grid.setColumnStretch(2, 1)
        for i, (name, text) in enumerate(NAMES.items()):
            self._add_row(grid, i, name, tr(text))
        column = QVBoxLayout(self)
        column.addWidget(self.words)
        column.addLayout(grid)

    def _add_row(self, grid: QGridLayout, row: int, name: str, text: str) -> None:
        box, value, state = QCheckBox(text), QDoubleSpinBox(), QLabel()
        value.setRange(-LARGEST, LARGEST)
        value.setDecimals(0)
        value.setKeyboardTracking(False)
        value.setAccessibleName(tr(NAMES[name]))
        state.setProperty("role", "faint")
        box.clicked.connect(lambda on, n=name: self._clicked(n, on))
        value.valueChanged.connect(lambda _value: self._send())
        for column, widget in enumerate((box, value, state)):
            grid.addWidget(widget, row, column)
        self.boxes[name], self.values[name], self._states[name] = box, value, state

    def show_locks(self, locks: Locks) -> None:
        """Show the requested locks."""
        for name, box in self.boxes.items():
            value = getattr(locks, name)
            box.setChecked(value is not None)
            if value is not None:
                self._put(name, value)

    def show_nothing(self, words: str) -> None:
        """Show that there is no camera with controls."""
        self.words.setText(words)
        for widgets in (self.boxes, self.values):
            for widget in widgets.values():
                widget.setEnabled(False)
        for state in self._states.values():
            state.clear()

    def show_controls(self, controls: tuple[Control, ...]) -> None:
        """Show the state that the camera reports."""
        self.words.setText(self.tr("Automatic exposure changes the colours with every movement."))
        for control in controls:
            self._known[control.name] = control
            box, value = self.boxes[control.name], self.values[control.name]
            box.setEnabled(control.available)
            value.setEnabled(control.available and box.isChecked())
            self._states[control.name].setText(_state(control, box.isChecked()))
            if not box.isChecked() and control.available:
                self._put(control.name, control.value)

    def locks(self) -> Locks:
        return Locks(
            **{n: self.values[n].value() for n, box in self.boxes.items() if box.isChecked()}
        )

    def _clicked(self, name: str, on: bool) -> None:
        """Start a lock at the value that the camera has set automatically."""
        if on and name in self._known:
            self._put(name, self._known[name].value)
        self.values[name].setEnabled(on)
        self._send()

    def _send(self) -> None:
        self.wanted.emit(self.locks())

    def _put(self, name: str, value: float) -> None:
        box = self.values[name]
        box.blockSignals(True)
        box.setValue(value)
        box.blockSignals(False)


def _state(control: Control, wanted: bool) -> str:
    if not control.available:
        return tr("not available on this camera")
    if control.is_unverified:
        return tr("◐ cannot be verified: the camera reads {}").format(f"{local(control.value):g}")
    if control.locked:
        return tr("● locked at {}").format(f"{local(control.value):g}")
    if wanted:
        return tr("▲ rejected by the camera")
    return tr("○ automatic, now {}").format(f"{local(control.value):g}")


def _select(box: QComboBox, wanted: str) -> None:
    for i in range(box.count()):
        camera = box.itemData(i)
        if isinstance(camera, CameraName) and wanted in (camera.name, str(camera.index)):
            box.setCurrentIndex(i)
            return
