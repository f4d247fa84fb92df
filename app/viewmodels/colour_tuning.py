"""A colour profile that is being tuned: its changes with undo and redo, and its display."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

import numpy as np

from app.engines.engine import EngineSetup
from app.viewmodels.colour_fits import FitWork, MarkerWatch
from app.viewmodels.colour_images import (
    Image,
    RoomColours,
    hue_histogram,
    mask_image,
    pixel_bgr,
    pixel_hsv,
)
from app.viewmodels.colour_live import LiveImages
from app.viewmodels.colour_picks import Eyedropper, PickCheck, missing_picks, range_at
from app.viewmodels.colour_search import MASK_STEP, ImageSearch, MaskShown, ShownImage
from app.viewmodels.colours import HueRow, blob_counts, expected_counts, hue_rows, seen_rows
from app.viewmodels.names import display_name
from app.words import tr
from tracker.base.errors import ConfigError
from tracker.base.files import write_with_folder
from tracker.base.notices import notice
from tracker.calibration.colours_fit import add_pixel, remove_pixel
from tracker.calibration.colours_image import Pick, learn_picked
from tracker.calibration.colours_learn import with_colour
from tracker.messages import Blobs
from tracker.vision.colours import (
    ColourProfile,
    HueRange,
    load_profile,
    profile_to_toml,
)

CHANNELS = ("hue", "saturation", "value")


@dataclass(frozen=True, eq=False)
class Tuned:
    """A profile, a message about its origin, and the markers clicked so far, by hue."""

    profile: ColourProfile
    words: str = ""
    picks: Mapping[str, Pick] = field(default_factory=dict)
    followed: bool = False  # changed by the engine, which follows the light


class ProfileHistory:
    """The profile being tuned, with undo and redo."""

    def __init__(self, first: Tuned, depth: int = 100) -> None:
        self._past: list[Tuned] = []
        self._future: list[Tuned] = []
        self._depth = depth
        self.now = first

    @property
    def profile(self) -> ColourProfile:
        return self.now.profile

    def change(self, new: Tuned, merge: bool = False) -> None:
        """Set a new profile; ``merge`` (a slider is still moving) does not add a step."""
        if new.profile != self.profile:
            if not (merge and self._past):
                self._past = [*self._past, self.now][-self._depth :]
            self._future.clear()
        self.now = new

    def follow(self, new: Tuned, own_step: bool) -> None:
        """Set a profile that the engine has changed. Consecutive changes of the light are one step;
        without ``own_step`` they are not a step."""
        if own_step and not self.now.followed:
            self.change(new)
        self.now = new

    def undo(self) -> bool:
        """Go back one step; whether there was one."""
        if not self._past:
            return False
        self._future.append(self.now)
        self.now = self._past.pop()
        return True

    def redo(self) -> bool:
        if not self._future:
            return False
        self._past.append(self.now)
        self.now = self._future.pop()
        return True


def with_range(profile: ColourProfile, changed: HueRange) -> ColourProfile:
    """``profile`` with the hue of the same name replaced."""
    hues = tuple(changed if h.name == changed.name else h for h in profile.hues)
    return replace(profile, hues=hues)


def with_channel(hue_range: HueRange, channel: str, interval: tuple[int, int]) -> HueRange:
    """``hue_range`` with its "hue", "saturation" or "value" interval replaced."""
    if channel == "hue":
        return replace(hue_range, hue=interval)
    if channel == "saturation":
        return replace(hue_range, saturation=interval)
    return replace(hue_range, value=interval)


class ColourTuning:
    """The profile of one camera while it is tuned."""

    def __init__(self, setup: EngineSetup, kept: ColourProfile | None = None) -> None:
        """``kept``: a stored profile to use instead of the engine's."""
        self.setup = setup
        self.hue = 0  # row of the selected hue
        self.markers, self.live = MarkerWatch(setup), LiveImages(setup)
        self.message = tr("Colours of {}").format(setup.camera.name) if kept is not None else ""
        self.room, self.search, self._check = RoomColours(), ImageSearch(setup), PickCheck()
        self._history = ProfileHistory(Tuned(kept or setup.profile, self.message))
        self._dragging = False

    @property
    def profile(self) -> ColourProfile:
        return self._history.profile

    @property
    def hue_range(self) -> HueRange:
        """The range of the selected hue."""
        return self.profile.hues[self.hue]

    # --- changes

    def move(self, channel: str, interval: tuple[int, int], held: bool) -> None:
        """Set an interval of the selected hue; all changes while a slider is ``held`` are one
        step."""
        changed = with_range(self.profile, with_channel(self.hue_range, channel, interval))
        if changed != self.profile:
            self._change(Tuned(changed, picks=self._history.now.picks), merge=self._dragging)
        self._dragging = held

    def _change(self, new: Tuned, merge: bool = False) -> None:
        """Add a step. Messages about the previous colours do not apply to the new ones."""
        self._history.change(new, merge)
        if new.words or not self.live.wanted:  # the message that a fit is pending remains
            self.message = new.words

    def pick(self, image: Image, u: float, v: float, how: Eyedropper) -> bool:
        """Include a pixel of the mask in the range, set the range from it, or exclude it.

        False if the pixel is grey, or looks like another hue than the selected one, which a second
        click accepts. ``message`` explains the reason.
        """
        at_u, at_v = u * MASK_STEP, v * MASK_STEP
        pixel = np.array(pixel_hsv(image, at_u, at_v))
        name, picks = self.hue_range.name, dict(self._history.now.picks)
        if how is Eyedropper.REMOVE:
            changed, row = remove_pixel(self.hue_range, pixel), -1
        else:
            problem = self._check.problem(pixel, u, v, self.hue_range, self.profile)
            if problem:
                self.message = problem
                return False
            setting = how is Eyedropper.SET
            changed = (
                range_at(image, at_u, at_v, name) if setting else add_pixel(self.hue_range, pixel)
            )
            row, picks[name] = self.hue, Pick(image, np.array([at_u, at_v]), name)
        learned = with_colour(self.profile, pixel_bgr(image, at_u, at_v), row)
        words = missing_picks(self.profile.hue_names, picks) if row >= 0 else ""
        self._change(Tuned(with_range(learned, changed), words, picks))
        return True

    @property
    def all_picked(self) -> bool:
        """Whether a marker of each hue was clicked since the last `picked_fit`."""
        return self._history.now.picks.keys() == set(self.profile.hue_names)

    def picked_fit(self) -> FitWork:
        """A fit to the clicked markers and, if available, the live images, for another thread."""
        picks = list(self._history.now.picks.values())
        self._history.now = replace(self._history.now, picks={})
        profile, size = self.profile, float(self.setup.glove.marker_size.mean())
        learned = partial(learn_picked, picks, profile, size, self.setup.camera.rig.fx)
        return self.live.after(learned, self.setup.profile)

    def take(self, profile: ColourProfile, words: str) -> None:
        """Set another profile as one step, with a message."""
        self._change(Tuned(profile, words))

    def follow(self, profile: ColourProfile) -> None:
        """Use colours that the engine has changed, to adapt them to the light or because the replay
        position changed.

        Further changes start from these colours. Clicked markers are preserved.
        """
        live, before = self.setup.player is None, self._history.now
        words = tr("The colours were adapted to the light.") if live else ""
        if before.picks or self.live.wanted:
            words = self.message  # the message about the pending fit remains
        self._history.follow(Tuned(profile, words, before.picks, followed=True), live)
        self._dragging = False  # the next movement of a slider is a step of its own
        self.message = words

    def undo(self) -> bool:
        """Go back one step; whether there was one."""
        return self._went(self._history.undo())

    def redo(self) -> bool:
        return self._went(self._history.redo())

    def _went(self, there: bool) -> bool:
        if there:
            self.message = self._history.now.words
        return there

    def load(self, path: Path) -> None:
        """Import a profile. Raises GlovetrackError if it does not fit this glove."""
        loaded = load_profile(path)
        if loaded.hue_names != self.profile.hue_names:
            hues = self.profile.hue_names
            raise ConfigError(notice("window.other_hues", file=path.name, hues=hues))
        self.take(loaded, tr("Colours of {}").format(path.name))

    def save(self, path: Path) -> None:
        """Write the profile to a file. Raises FileError."""
        write_with_folder(path, profile_to_toml(self.profile))
        self.message = tr("Exported to {}").format(path.name)

    def check_room(self, image: Image) -> None:
        """Measure the colours of the room in an image without the glove."""
        self.room.measure(image, self.profile)
        self.message = "" if self.room.shares else tr("The background has none of these colours.")

    def search_work(self, shown: ShownImage) -> Callable[[], Blobs] | None:
        """A search of an image with the current profile; see `ImageSearch.work`."""
        return self.search.work(shown, None if self._dragging else self.profile)

    # --- displayed data

    def rows(self, shown: ShownImage) -> list[HueRow]:
        """One row per hue."""
        if shown.view is not None and not self.search.is_own(shown):
            return seen_rows(shown.view, self.profile, self.room.shares)
        counts = blob_counts([self.search.blobs], self.profile.hue_names, self.profile)
        live = shown.view if shown.frozen and self.setup.player is None else None
        expected = expected_counts(live) if live is not None else None
        return hue_rows(self.profile, counts, expected, self.room.shares)

    def words(self, rows: list[HueRow]) -> str:
        """The result of the last action, and problems of hues."""
        clashing = [f"▲ {display_name(row.name)}: {row.clash}" for row in rows if row.clash]
        return "\n".join([*([self.message] if self.message else []), *clashing])

    def mask(
        self, shown: ShownImage, rows: list[HueRow], picking: bool = False
    ) -> MaskShown | None:
        """The mask; None without an image. ``picking``: an eyedropper is selected."""
        if shown.image is None:
            return None
        pairs = zip(self.profile.hues, rows, strict=True)
        return MaskShown(
            mask_image(shown.image, self.hue_range, MASK_STEP, picking),
            self.search.rings(shown, self.hue, rows[self.hue].colour),
            hue_histogram(shown.image),
            [(*hue.hue, row.colour) for hue, row in pairs],
        )
