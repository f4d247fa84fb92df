"""Tuning the colours that markers are found by."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QFileDialog,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.panels.colours.fitting import ColoursFitting
from app.panels.colours.hues import ColoursHues
from app.panels.colours.source import ColoursSource
from app.panels.colours.tools import ColoursTools
from app.panels.panel import Panel
from app.platform.tasks import TaskOwner
from app.storage.colour_autosave import ColourAutosave
from app.storage.colour_store import ColourStore, write_text_safely
from app.storage.image_folder import Image, ImageFolder
from app.storage.settings import SettingsStore
from app.viewmodels.colour_images import (
    hue_histogram,
    mask_image,
    pixel_hsv,
    room_image,
    room_shares,
)
from app.viewmodels.colours import (
    HueRow,
    ProfileHistory,
    blob_counts,
    hue_rows,
    seen_rows,
    with_channel,
    with_range,
)
from app.widgets.hue_strip import HueStrip
from app.widgets.image_view import ImageView
from app.widgets.overlay import Ring
from app.widgets.range_row import RangeRow
from tracker.calibration.colours_fit import add_pixel, remove_pixel
from tracker.errors import GlovetrackError
from tracker.messages import Blobs
from tracker.vision.colours import ColourProfile, HueRange, load_profile, profile_to_toml
from tracker.vision.detector import Detector

TWO_COLUMNS = 540  # px of width, more than two columns need at least
MASK_STEP = 2
ROOM_EVERY = 8  # refreshes
SETTINGS_IMAGES = "pictures"  # the folder's name in the settings of users
CHANNELS = ("hue", "saturation", "value")


class ColoursPanel(Panel):
    name = "colours"
    period = 1 / 8

    def __init__(
        self,
        host: EngineHost,
        store: SettingsStore,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(host, parent)
        self._folder = store.path.parent
        self.keeper = ColourAutosave(ColourStore(self._folder / "colours"), self)
        self.keeper.failed.connect(host.error)
        self._setup: EngineSetup | None = None
        self._history: ProfileHistory | None = None
        self._hue = 0
        self._holding = False
        self._blobs: Blobs | None = None  # found in a kept image
        self._room: dict[str, float] = {}
        self._room_age = 0
        self._told = ""
        self.source = ColoursSource(tasks)
        self.source.changed.connect(self._image_changed)
        self.source.failed.connect(host.error)
        self.fitting = ColoursFitting(tasks)
        self.fitting.fitted.connect(self._take_fit)
        self.fitting.failed.connect(host.error)
        self.tools = ColoursTools()
        self._connect_tools()
        self._make_widgets()
        self._lay_out()
        host.opened.connect(self._open)

    def title(self) -> str:
        return self.tr("Colours")

    # --- widgets

    def _make_widgets(self) -> None:
        self.hues = ColoursHues()
        self.hues.chosen.connect(self.choose_hue)
        self.strip = HueStrip()
        self.mask_view = ImageView(self.tr("Mask"), self.tr("No image yet"))
        self.mask_view.picked.connect(self._picked)
        self.words = QLabel()
        self.words.setWordWrap(True)
        self.rows = {
            "hue": RangeRow(self.tr("Hue"), 179, wraps=True),
            "saturation": RangeRow(self.tr("Saturation"), 255),
            "value": RangeRow(self.tr("Value"), 255),
        }
        for key, row in self.rows.items():
            row.changed.connect(lambda a, b, held, key=key: self._set(key, a, b, held))

    def _lay_out(self) -> None:
        """Ranges beside the image where the panel is wide, above it where it is narrow."""
        ranges, image = QVBoxLayout(), QVBoxLayout()
        ranges.setSpacing(4)
        ranges.addWidget(self.hues)
        for row in self.rows.values():
            ranges.addWidget(row)
        ranges.addWidget(self.strip)
        ranges.addWidget(self.words)
        ranges.addStretch(1)
        image.setSpacing(4)
        image.addWidget(self.source)
        image.addWidget(self.mask_view, 1)
        self._halves = QBoxLayout(QBoxLayout.Direction.LeftToRight)
        self._halves.setSpacing(8)
        self._halves.addLayout(ranges, 5)
        self._halves.addLayout(image, 4)
        column = QVBoxLayout(self)
        column.setContentsMargins(8, 6, 8, 6)
        column.setSpacing(4)
        column.addLayout(self._halves, 1)
        column.addWidget(self.tools)

    def resizeEvent(self, event: QResizeEvent) -> None:
        wide = event.size().width() >= TWO_COLUMNS
        direction = QBoxLayout.Direction
        self._halves.setDirection(direction.LeftToRight if wide else direction.TopToBottom)

    def _connect_tools(self) -> None:
        tools = self.tools
        tools.picking.connect(lambda on: self.mask_view.set_picking(on))
        tools.undo.connect(self.undo)
        tools.redo.connect(self.redo)
        tools.fit_image.connect(self.fit_image)
        tools.fit_markers.connect(self.fit_markers)
        tools.load.connect(self.load)
        tools.save.connect(self.save)
        tools.shipped.connect(self.start_again)
        tools.room.connect(self.check_room)
        tools.take_over.connect(lambda camera: self.load_file(self.keeper.store.path(camera)))

    # --- the profile

    @property
    def profile(self) -> ColourProfile | None:
        return self._history.profile if self._history is not None else None

    def _open(self, setup: EngineSetup) -> None:
        self._setup, self._blobs, self._room = setup, None, {}
        kept = self.keeper.open(setup.camera, setup.profile)
        self._history = ProfileHistory(kept or setup.profile)
        self._hue = 0
        self.hues.fill(setup.profile.hue_names)
        self.fitting.open(setup.glove, setup.profile)
        camera = self.keeper.camera or "replays"
        self.source.set_folder(ImageFolder(self._folder / SETTINGS_IMAGES / camera))
        self.tools.set_cameras(self.keeper.others())
        self._say(self.tr("Colours of {}").format(setup.camera) if kept is not None else "")
        self.choose_hue(0)
        if kept is not None:
            self.host.set_profile(kept)

    def choose_hue(self, index: int) -> None:
        self._hue = index
        self.hues.choose(index)
        self._show_ranges()
        self._draw()

    def _range(self) -> HueRange | None:
        return self.profile.hues[self._hue] if self.profile is not None else None

    def _show_ranges(self) -> None:
        current = self._range()
        if current is not None:
            for key in CHANNELS:
                self.rows[key].set_values(*getattr(current, key))

    def _set(self, key: str, low: int, high: int, held: bool) -> None:
        current = self._range()
        if current is None:
            return
        self._change(with_channel(current, key, (low, high)), self._holding)
        self._holding = held

    def _change(self, changed: HueRange, merge: bool = False) -> None:
        assert self._history is not None
        self._history.change(with_range(self._history.profile, changed), merge)
        self._apply()

    def _apply(self) -> None:
        """Give the profile to the engine: the next image is searched with it."""
        if self._history is not None:
            self.host.set_profile(self._history.profile)
            self.keeper.changed(self._history.profile)
            self._show_ranges()
            self._search_kept()
            self._draw()

    def undo(self) -> None:
        if self._history is not None and self._history.undo():
            self._apply()

    def redo(self) -> None:
        if self._history is not None and self._history.redo():
            self._apply()

    def _take(self, profile: ColourProfile, words: str) -> None:
        """Another profile as one step that can be undone."""
        if self._history is not None:
            self._history.change(profile)
            self._apply()
            self._say(words)

    def start_again(self) -> None:
        """The colours that the program came with."""
        if self._setup is not None:
            self._take(self._setup.profile, self.tr("These are the colours from the start."))

    def _picked(self, u: float, v: float, modifiers: Qt.KeyboardModifier) -> None:
        current, image = self._range(), self.source.image()
        if current is None or image is None:
            return
        pixel = np.array(pixel_hsv(image, u * MASK_STEP, v * MASK_STEP))
        leave_out = bool(modifiers & Qt.KeyboardModifier.ControlModifier) or self.tools.leaving_out
        self._change(remove_pixel(current, pixel) if leave_out else add_pixel(current, pixel))

    # --- fits

    def fit_image(self) -> None:
        """Fit to the image shown now, whatever is known of the hand."""
        if self.profile is not None:
            self.fitting.from_image(self.source.image(), self.profile)

    def fit_markers(self) -> None:
        """Fit to the markers that were tracked lately, while this panel was in sight."""
        if self.profile is not None:
            self.fitting.from_markers(self.profile)

    def _take_fit(self, profile: ColourProfile, words: str) -> None:
        self._take(profile, words)

    def check_room(self) -> None:
        """Take the image shown now for the room without the glove."""
        image = self.source.image()
        if image is None or self.profile is None:
            return
        self._room, self._room_age = room_shares(image, self.profile), -10 * ROOM_EVERY
        free = self.tr("The room has none of the colours.")
        self._say("" if self._room else free)
        self._draw()

    # --- files

    def load(self) -> None:
        path, _ = QFileDialog.getOpenFileName(self, self.tr("Colour profile"), "", "*.toml")
        if path:
            self.load_file(Path(path))

    def load_file(self, path: Path) -> None:
        if self._history is None:
            return
        try:
            loaded = load_profile(path)
        except GlovetrackError as error:
            self.host.error.emit(str(error))
            return
        if loaded.hue_names != self._history.profile.hue_names:
            names = ", ".join(self._history.profile.hue_names)
            self.host.error.emit(
                self.tr("{} must have the hues {} for this glove.").format(path.name, names)
            )
            return
        self._take(loaded, self.tr("Colours of {}").format(path.name))

    def save(self) -> None:
        path, _ = QFileDialog.getSaveFileName(
            self, self.tr("Export the colours"), "colours.toml", "*.toml"
        )
        if path:
            self.save_file(Path(path))

    def save_file(self, path: Path) -> None:
        if self.profile is None:
            return
        try:
            write_text_safely(path, profile_to_toml(self.profile))
        except GlovetrackError as error:
            self.host.error.emit(str(error))
            return
        self._say(self.tr("Exported to {}").format(path.name))

    # --- what it shows

    def _say(self, text: str) -> None:
        self._told = text
        self.words.setText(text)

    def _image_changed(self) -> None:
        self._search_kept()
        self._draw()

    def _search_kept(self) -> None:
        """What the profile finds in a kept image; the live one is searched by the engine."""
        self._blobs = None
        image = self.source.image()
        if self._holding or self.source.is_live or image is None or self._setup is None:
            return
        assert self._history is not None
        size = float(self._setup.glove.marker_size.mean())
        detector = Detector(self._history.profile, size, self._setup.rig.fx)
        self._blobs = detector.detect(image)[0]

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or self._history is None:
            return
        self.source.take(view)
        self.fitting.watch(view)
        self._room_age += 1
        if self._room_age >= ROOM_EVERY:
            self._watch_room()
        self._draw()

    def _watch_room(self) -> None:
        """The colours beside the tracked hand, now and then."""
        self._room_age = 0
        view = self.source.view
        image = room_image(view) if view is not None else None
        if image is not None and self.profile is not None:
            self._room = room_shares(image, self.profile)

    def _side_blobs(self) -> Blobs | None:
        """The blobs in the image shown."""
        view = self.source.view
        if view is None or view.blobs is None:
            return self._blobs
        return view.blobs.right if self.source.right else view.blobs.left

    def _rows(self) -> list[HueRow]:
        assert self.profile is not None
        view, profile = self.source.view, self.profile
        if view is not None:
            return seen_rows(view, profile, self._room)
        found = blob_counts([self._blobs], profile.hue_names, profile)
        return hue_rows(profile, found, None, self._room)

    def _draw(self) -> None:
        current, profile = self._range(), self.profile
        if current is None or profile is None:
            return
        rows = self._rows()
        self.hues.show_rows(rows)
        self._show_warnings(rows)
        image = self.source.image()
        if image is None:
            self.mask_view.show_image(None)
            return
        self._show_mask(image, current, rows[self._hue].colour)
        intervals = [(*h.hue, row.colour) for h, row in zip(profile.hues, rows, strict=True)]
        self.strip.show_hues(hue_histogram(image), intervals)

    def _show_warnings(self, rows: list[HueRow]) -> None:
        """What stands in the way of a hue, else what was done last."""
        clashing = [f"▲ {row.name}: {row.clash}" for row in rows if row.clash]
        self.words.setText("\n".join(clashing) if clashing else self._told)

    def _show_mask(self, image: Image, current: HueRange, colour: str) -> None:
        blobs, rings = self._side_blobs(), []
        if blobs is not None:
            for i in np.flatnonzero(blobs.hue == self._hue):
                u, v = blobs.uv[i] / MASK_STEP
                radius = float(max(blobs.size[i])) / 2 / MASK_STEP + 2
                rings.append(Ring(float(u), float(v), radius, colour))
        self.mask_view.show_image(mask_image(image, current, MASK_STEP), rings)

    def shut_down(self) -> None:
        self.keeper.write()
