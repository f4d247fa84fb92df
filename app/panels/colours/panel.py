"""The Colours panel: tuning of the colours that markers are detected by."""

from __future__ import annotations

from pathlib import Path
from typing import Protocol

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QHBoxLayout, QVBoxLayout, QWidget

from app.engines.engine import EngineSetup
from app.engines.host_parts import ColourUse, CurrentEngine, EngineChanges, ErrorSignal
from app.engines.snapshot import Snapshot
from app.panels.colours.fitting import ColoursFitting, ColoursLight
from app.panels.colours.ranges import ColoursRanges
from app.panels.colours.source import ColoursSource
from app.panels.colours.tools import ColoursFiles, ColoursTools
from app.panels.panel import Panel
from app.platform.tasks import LatestJob, TaskOwner
from app.storage.colour_store import ColourAutosave, ColourStore
from app.storage.image_folder import ImageFolder
from app.viewmodels.colour_fits import image_fit
from app.viewmodels.colour_picks import Eyedropper, factory_colours
from app.viewmodels.colour_search import MaskShown, ShownImage
from app.viewmodels.colour_tuning import ColourTuning
from app.widgets.image_view import ImageView
from app.widgets.measures import NEAR, TIGHT
from tracker.messages import Blobs

TWO_COLUMNS = 540  # px, minimum width for two columns
SETTINGS_IMAGES = "pictures"  # folder name in users' settings


class TwoHalves(QWidget):
    """Two widgets side by side from ``least`` px of width on, else stacked; ``shares`` of the
    width."""

    def __init__(self, first: QWidget, second: QWidget, least: int, shares: tuple[int, int]):
        super().__init__()
        self._least = least
        self._halves = QBoxLayout(QBoxLayout.Direction.LeftToRight, self)
        self._halves.setContentsMargins(0, 0, 0, 0)
        self._halves.setSpacing(NEAR)
        for widget, share in zip((first, second), shares, strict=True):
            self._halves.addWidget(widget, share)

    def resizeEvent(self, event: QResizeEvent) -> None:
        wide = event.size().width() >= self._least
        direction = QBoxLayout.Direction
        self._halves.setDirection(direction.LeftToRight if wide else direction.TopToBottom)


class ColoursHost(ColourUse, CurrentEngine, EngineChanges, ErrorSignal, Protocol):
    """What the panel uses of the engine host."""


class ColoursPanel(Panel):
    """Connects `ColourTuning`, which contains the state, with widgets, files in ``folder`` and the
    engine."""

    period = 1 / 8

    def __init__(
        self,
        host: ColoursHost,
        folder: Path,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.host = host
        self._folder = folder
        self.keeper = ColourAutosave(ColourStore(self._folder / "colours"), self)
        self.tuning: ColourTuning | None = None
        self.fitting = ColoursFitting(tasks, self)
        self.ranges, self.image = ColoursRanges(), ColoursImage(tasks)
        self.files, self.tools, self.light = ColoursFiles(self), ColoursTools(), ColoursLight()
        column = QVBoxLayout(self)
        column.setContentsMargins(NEAR, TIGHT, NEAR, TIGHT)
        column.setSpacing(TIGHT)
        least = TWO_COLUMNS - 2 * NEAR
        head = QHBoxLayout()  # on top: warnings below must not move it
        head.addWidget(self.tools, 1)
        head.addWidget(self.light)
        column.addLayout(head)
        column.addWidget(TwoHalves(self.ranges, self.image, least, (5, 4)), 1)
        self._connect_tools()
        self._connect_parts()

    def _connect_tools(self) -> None:
        tools = self.tools
        tools.picking.connect(self._pick)
        tools.undo.connect(self.undo)
        tools.redo.connect(self.redo)
        image = self.image.source.image
        fit = self.fitting.fit
        tools.fit_live.connect(self.fitting.fit_live)
        tools.fit_image.connect(lambda: fit(lambda t: image_fit(image(), t.profile, t.setup)))
        tools.fit_markers.connect(lambda: fit(lambda t: t.markers.fit(t.profile)))
        tools.load.connect(self.files.ask_load)
        tools.save.connect(self.files.ask_save)
        tools.shipped.connect(self.start_again)
        tools.factory.connect(self.factory)
        tools.room.connect(self.check_room)
        tools.take_over.connect(lambda camera: self.files.load(self.keeper.store.path(camera)))

    def _connect_parts(self) -> None:
        self.ranges.hues.chosen.connect(self.choose_hue)
        self.ranges.moved.connect(self._moved)
        self.image.picked.connect(self._picked)
        self.image.changed.connect(self._draw)
        self.files.loaded.connect(self._apply)
        self.fitting.taken.connect(self._apply)
        self.files.saved.connect(self._draw)
        self.light.changed.connect(self._draw)
        for part in (self.keeper, self.image, self.files, self.light, self.fitting):
            part.failed.connect(self.host.error)
        self.host.opened.connect(self._open)
        self.host.profile_followed.connect(self._follow)

    # --- the profile

    def _open(self, setup: EngineSetup) -> None:
        kept = self.keeper.open(setup.camera.name, setup.profile)
        self.tuning = ColourTuning(setup, kept)
        self.files.tuning = self.image.tuning = self.fitting.tuning = self.tuning
        self.ranges.hues.fill(setup.profile.hue_names)
        folder = self._folder / SETTINGS_IMAGES / (self.keeper.camera or "replays")
        self.image.source.set_folder(ImageFolder(folder))
        self.tools.set_cameras(self.keeper.others())
        self.choose_hue(0)
        if kept is not None:
            self.host.set_profile(kept)

    def choose_hue(self, index: int) -> None:
        if self.tuning is not None:
            self.tuning.hue = index
            self.ranges.show_range(self.tuning)
            self._draw()

    def _apply(self) -> None:
        """Send the profile to the engine, which uses it for the next image."""
        if self.tuning is not None:
            self.host.set_profile(self.tuning.profile)
            self._took_over(self.tuning)

    def _took_over(self, tuning: ColourTuning, followed: bool = False) -> None:
        """Save and show the profile that the engine now uses."""
        self.keeper.changed(tuning.profile)
        self.ranges.show_range(tuning, followed)
        self.image.search()
        self._draw()

    def _follow(self) -> None:
        """Continue with colours that the engine has changed automatically."""
        setup = self.host.setup
        if self.tuning is not None and setup is not None:
            self.tuning.follow(setup.profile)
            self._took_over(self.tuning, followed=True)

    def undo(self) -> None:
        if self.tuning is not None and self.tuning.undo():
            self._apply()

    def redo(self) -> None:
        if self.tuning is not None and self.tuning.redo():
            self._apply()

    def start_again(self) -> None:
        """Restore the colours from the start of the session."""
        if self.tuning is not None:
            words = self.tr("Restored the initial colours of this session.")
            self.tuning.take(self.tuning.setup.profile, words)
            self._apply()

    def factory(self) -> None:
        """Use the colours shipped with the program; can be undone."""
        if self.tuning is None:
            return
        colours = factory_colours()
        if colours.hue_names != self.tuning.profile.hue_names:
            self.host.error.emit(self.tr("The factory colours do not match this glove."))
            return
        self.tuning.take(colours, self.tr("Restored the factory colours."))
        self._apply()

    def _moved(self, channel: str, low: int, high: int, held: bool) -> None:
        if self.tuning is not None:
            self.tuning.move(channel, (low, high), held)
            self._apply()

    def _pick(self, on: bool) -> None:
        """Select or deselect an eyedropper."""
        self.image.mask_view.set_picking(on)
        self._draw()

    def _picked(self, u: float, v: float, modifiers: Qt.KeyboardModifier) -> None:
        image = self.image.source.image()
        if self.tuning is not None and image is not None:
            with_control = bool(modifiers & Qt.KeyboardModifier.ControlModifier)
            dropper = Eyedropper.REMOVE if with_control else self.tools.dropper
            if not self.tuning.pick(image, u, v, dropper or Eyedropper.ADD):
                self._draw()  # shows the question
                return
            self._apply()
            if self.tuning.all_picked:
                self.fitting.fit(lambda t: t.picked_fit())

    @property
    def works_unseen(self) -> bool:
        return self.fitting.waits

    def check_room(self) -> None:
        """Measure the background in the displayed image, without the glove."""
        image = self.image.source.image()
        if self.tuning is not None and image is not None:
            self.tuning.check_room(image)
            self._draw()

    # --- displayed data

    def refresh(self, view: Snapshot | None) -> None:
        if view is None or self.tuning is None:
            return
        self.image.source.take(view)
        self.image.refresh()
        self.tuning.markers.watch(view)
        if self.image.source.is_live:
            self.fitting.gather(view)
        self.tuning.room.watch(self.image.source.view, self.tuning.profile)
        self.light.look_at(self.image.shown(), self.tuning)
        self._draw()

    def _draw(self) -> None:
        if self.tuning is None:
            return
        shown = self.image.shown()
        rows = self.tuning.rows(shown)
        self.ranges.show_rows(rows, self.tuning.words(rows))
        mask = self.tuning.mask(shown, rows, self.tools.is_picking)
        if mask is not None:
            mask.rings.extend(self.light.rings(shown))
        self.image.show_mask(mask)
        if mask is not None:
            self.ranges.strip.show_hues(mask.histogram, mask.intervals)

    def shut_down(self) -> None:
        self.keeper.write()
        self.image.shut_down()
        self.light.shut_down()


# ---- the image that colours are tuned on, with its mask and the detected blobs


class ColoursImage(QWidget):
    """The part of the panel with the image. ``changed``: the image or its blobs have changed.

    Stored images and those of a replay are searched in the background: a search takes tens of
    milliseconds.
    """

    changed = Signal()
    picked = Signal(float, float, object)  # u, v in the mask, Qt.KeyboardModifiers
    failed = Signal(str)

    def __init__(self, tasks: TaskOwner, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.tuning: ColourTuning | None = None
        self.source = ColoursSource(tasks)
        self.source.changed.connect(self._image_changed)
        self.source.failed.connect(self.failed)
        self.mask_view = ImageView(self.tr("Mask"), self.tr("No image yet"))
        self.mask_view.picked.connect(self.picked)
        self._search = LatestJob(self.tr("Searching the image"), self)
        self._search.failed.connect(self.failed)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(TIGHT)
        column.addWidget(self.source)
        column.addWidget(self.mask_view, 1)

    def shown(self) -> ShownImage:
        source = self.source
        return ShownImage(source.image(), source.view, source.right, source.is_frozen)

    def _image_changed(self) -> None:
        frozen = self.source.is_frozen
        self.mask_view.set_title(self.tr("Mask, image frozen") if frozen else self.tr("Mask"))
        self.search()
        self.changed.emit()

    def refresh(self) -> None:
        """Search the next image of a replay after the previous search has finished; restarting on
        every image would never finish if images arrive faster than they are searched."""
        new = self.tuning is not None and self.tuning.search.is_new(self.shown())
        if new and not self._search.is_busy:
            self.search()

    def search(self) -> None:
        """Search the image with the current profile; discard the result of an earlier search."""
        work = self.tuning.search_work(self.shown()) if self.tuning is not None else None
        if work is None:
            self._search.forget()
        else:
            self._search.run(lambda _progress: work(), self._found)

    def _found(self, blobs: Blobs) -> None:
        if self.tuning is not None:
            self.tuning.search.found(blobs)
            self.changed.emit()

    def show_mask(self, mask: MaskShown | None) -> None:
        self.mask_view.show_image(*((None, ()) if mask is None else (mask.image, mask.rings)))

    def shut_down(self) -> None:
        self._search.shut_down()
