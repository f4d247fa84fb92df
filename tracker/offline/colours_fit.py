"""Fits colours to a recording, or to a few live images with the packets around them.

With wide colours a hand is found that is consistent with IMUs, cameras and the hand model. Each of
its markers labels the pixels at its position, and the colours are learned from these. They are
validated on images that they were not learned from, and refused if they explain fewer markers or
more of the room.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice, warning
from tracker.calibration.colours_exchanged import exchanged, renamed
from tracker.calibration.colours_fit import clashes
from tracker.calibration.colours_learn import ColourSamples, learn, wide_profiles
from tracker.calibration.colours_sample import known_sides, samples_of
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.engine.side_watch import other_side
from tracker.glove import library
from tracker.glove.mirror import mirrored_glove, mirrored_hand
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    BlobFrame,
    Blobs,
    FrameResult,
    ImuSample,
    IntArray,
    StereoFrame,
    Tracking,
)
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector, DetectorParams, detect_frame
from tracker.vision.rig import StereoRig

Sensed = ImuSample | StereoFrame
LEAST_IMAGES = 2  # with a hand that is sure, to learn from
LEAST_SHARE = 0.6  # of the markers that should be seen
SHOWS = 0.2  # of the markers that the other camera shows, for a camera that shows the hand at all
ROUNDS = 2  # of learning and looking again
FEW_IMAGES = 2  # and the next, in which other names of the hues are tried


class WatchedGlove(NamedTuple):
    """The hand, the glove on it, and the cameras that see it."""

    hand: HandModel
    glove: GloveModel
    rig: StereoRig


@dataclass(frozen=True)
class HueCheck:
    """One hue over the images of a check: markers that should be seen, those found, and blobs that
    are not markers, per image near the hand and elsewhere; and the hues that overlap with it."""

    name: str
    expected: float
    found: float
    clashing: float
    overlapping: tuple[str, ...] = ()

    @property
    def ok(self) -> bool:
        """Whether enough of its markers are found."""
        return self.found >= LEAST_SHARE * self.expected


@dataclass(frozen=True)
class ColourCheck:
    """How well colours serve: images with and without a hand that is sure, and each hue."""

    images: int
    tracked: int
    hues: tuple[HueCheck, ...]
    sure: float  # markers found by each camera that shows the hand, per image
    exchanged: tuple[str, ...] = ()  # hues whose names are exchanged

    @property
    def found(self) -> float:
        """Markers of all hues, per image."""
        return sum(h.found for h in self.hues)

    @property
    def clashing(self) -> float:
        """Blobs that are not markers, per image."""
        return sum(h.clashing for h in self.hues)

    @property
    def ok(self) -> bool:
        """Whether a hand was sure in enough images, with enough markers of each hue."""
        return self.tracked >= LEAST_IMAGES and all(h.ok for h in self.hues)

    def to_json(self) -> dict[str, Any]:
        """By hue, markers and other blobs per image; ``clash``: the hues that overlap with it."""
        hues = {
            h.name: {
                "found": h.found,
                "expected": h.expected,
                "false_per_picture": h.clashing,
                "clash": list(h.overlapping),
            }
            for h in self.hues
        }
        counts = {"images": self.images, "tracked": self.tracked}
        return {"hues": hues, "ok": self.ok, **counts, "exchanged": list(self.exchanged)}

    def lines(self) -> list[str]:
        """A line for each hue."""
        lines = [f"The hand was sure in {self.tracked} of {self.images} images."]
        for h in self.hues:
            missed = max(h.expected - h.found, 0.0)
            lines.append(
                f"{h.name}: {h.found:.1f} of {h.expected:.1f} markers found in an image, "
                f"{missed:.1f} missed, {h.clashing:.1f} other things of its colour."
            )
        if self.exchanged:
            lines.append(str(warning("colours.exchanged", hues=self.exchanged)))
        return lines


@dataclass(frozen=True)
class SessionFit:
    """The colours, what they were before and are now on images that they were not learned from,
    and the hues whose names were ``exchanged`` before."""

    profile: ColourProfile
    before: ColourCheck
    after: ColourCheck
    patches: dict[str, int]
    exchanged: tuple[str, ...] = ()


@dataclass
class Looked:
    """A pass over images: the detections and the results of those that certainly show a hand."""

    frames: list[StereoFrame] = field(default_factory=list)
    blobs: list[BlobFrame] = field(default_factory=list)
    results: list[FrameResult] = field(default_factory=list)
    images: int = 0

    @property
    def matched(self) -> float:
        """Markers found per image."""
        return sum(_found(r).sum() for r in self.results) / max(self.images, 1)

    @property
    def showing(self) -> NDArray[np.bool_]:
        """(2,) bool: whether the left and the right camera show the hand at all: one may be
        covered, or see no colours."""
        found = np.sum([_by_camera(r).sum(axis=1) for r in self.results], axis=0, initial=0)
        there = np.broadcast_to(found, 2)
        return np.asarray((there > 0) & (there >= SHOWS * there.max()))


def fit_messages(
    messages: Sequence[Sensed], watched: WatchedGlove, profile: ColourProfile
) -> SessionFit:
    """Colours for these packets and images, in the order of feeding.

    Raises GlovetrackError where no hand is found for sure, or the other one, or nothing better than
    ``profile``.
    """
    before = look(messages, watched, profile)
    best = before
    if _is_poor(before):
        _refuse_other_side(messages, watched, profile, before)
        for wide in _starts(profile):
            tried = look(_beginning(messages), watched, wide)
            if tried.matched > best.matched:
                best = tried
                _refuse_other_side(messages, watched, wide, tried)
            if not _is_poor(best):
                break
        other = _renamed(messages, watched, profile, best) if _is_poor(best) else None
        best = other[1] if other is not None else best
    fitted = profile
    patches: dict[str, int] = {}
    for turn in range(ROUNDS):
        if len(best.frames) < min(LEAST_IMAGES, best.images):
            raise GlovetrackError(notice("colours.no_hand_found", cameras=_cameras(watched)))
        samples = _samples(best, watched, fitted.hue_names, odd=len(best.frames) < 4 or turn > 0)
        fitted, patches = learn(fitted, samples), samples.patches
        best = look(messages, watched, fitted)
    showing = before.showing | best.showing
    old, new = (checked(p, watched, c, showing) for p, c in ((before, profile), (best, fitted)))
    if _is_worse(new, old):
        raise GlovetrackError(
            notice(
                "colours.session_fit_worse",
                found=new.sure,
                others=new.clashing,
                found_before=old.sure,
                others_before=old.clashing,
            )
        )
    swapped = exchanged(profile, fitted) if _is_poor(before) else ()
    return SessionFit(fitted, old, new, patches, swapped)


def exchanged_hues(
    messages: Sequence[Sensed], watched: WatchedGlove, profile: ColourProfile
) -> tuple[str, ...]:
    """The hues of ``profile`` whose names are exchanged, as the first images show: with other names
    they show the hand, and with these they do not."""
    own = look(_beginning(messages, FEW_IMAGES), watched, profile)
    other = _renamed(messages, watched, profile, own) if _is_poor(own) else None
    return exchanged(profile, other[0]) if other is not None else ()


def _renamed(
    messages: Sequence[Sensed], watched: WatchedGlove, profile: ColourProfile, own: Looked
) -> tuple[ColourProfile, Looked] | None:
    """The profile with other names of its hues, with which the first images show the hand."""
    first = _beginning(messages, FEW_IMAGES)
    detector = _detector(watched, profile)
    found = {m.t: detect_frame(detector, m) for m in first if isinstance(m, StereoFrame)}
    for other in renamed(profile):
        tried = _track(first, watched, partial(_with_names, found, other.hue_names))
        if tried.matched > own.matched and not _is_poor(tried):
            return other, tried
    return None


def _refuse_other_side(
    messages: Sequence[Sensed], watched: WatchedGlove, profile: ColourProfile, own: Looked
) -> None:
    """Raises GlovetrackError where the first images show more of a glove of the other hand than of
    ours: of mirrored patches a hand that is found by mistake would have learned the colours."""
    hand, glove = mirrored_hand(watched.hand), mirrored_glove(watched.glove)
    mirrored = look(_beginning(messages), WatchedGlove(hand, glove, watched.rig), profile)
    if not _is_poor(mirrored) and mirrored.matched > own.matched:
        raise GlovetrackError(other_side(watched.glove))


def _starts(profile: ColourProfile) -> Iterator[ColourProfile]:
    """Returns wide colours to begin with: around these, and around the program's own, since these
    may be of another room."""
    yield from wide_profiles(profile)
    factory = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
    if set(factory.hue_names) == set(profile.hue_names) and factory.hues != profile.hues:
        yield from wide_profiles(factory)


def _is_worse(new: ColourCheck, old: ColourCheck) -> bool:
    """Whether colours explain fewer markers or more of the room than others of the same images.

    Where two cameras show the hand, markers that only one of them shows do not count: among many
    other things of their colour some are found by chance, which would speak for the colours that
    find the most of everything.
    """
    fewer, same = new.sure < old.sure - 0.25, new.sure < old.sure + 0.5
    return fewer or (same and new.clashing > old.clashing + 1)


def check_messages(
    messages: Sequence[Sensed], watched: WatchedGlove, profile: ColourProfile
) -> ColourCheck:
    """How well ``profile`` serves for these packets and images."""
    looked = look(messages, watched, profile)
    return checked(looked, watched, profile, looked.showing)


def check_with_names(
    messages: Sequence[Sensed], watched: WatchedGlove, profile: ColourProfile
) -> ColourCheck:
    """`check_messages`, and where markers are missed, whether exchanged names are the cause."""
    found = check_messages(messages, watched, profile)
    if found.ok:
        return found
    return replace(found, exchanged=exchanged_hues(messages, watched, profile))


def _with_names(
    found: Mapping[float, BlobFrame], names: tuple[str, ...], image: StereoFrame
) -> BlobFrame:
    """The blobs found in an image, with other names of their hues."""
    return replace(found[image.t], hue_names=names)


def look(messages: Iterable[Sensed], watched: WatchedGlove, profile: ColourProfile) -> Looked:
    """Track the hand with these colours."""
    return _track(messages, watched, partial(detect_frame, _detector(watched, profile)))


def _detector(watched: WatchedGlove, profile: ColourProfile) -> Detector:
    size = float(np.median(watched.glove.marker_size)) if watched.glove.markers else 0.012
    return Detector(profile, size, watched.rig.fx, DetectorParams())


def _track(
    messages: Iterable[Sensed],
    watched: WatchedGlove,
    blobs_of: Callable[[StereoFrame], BlobFrame],
) -> Looked:
    """Track the hand by these blobs of the images."""
    pipeline = Pipeline(watched.hand, watched.glove, watched.rig, Settings())
    out = Looked()
    waiting: dict[float, tuple[StereoFrame, BlobFrame]] = {}
    for message in messages:
        if isinstance(message, StereoFrame):
            blobs = blobs_of(message)
            waiting[message.t] = (message, blobs)
            out.images += 1
            pipeline.feed_frame(blobs)
        else:
            pipeline.feed_imu(message)
            _collect(out, waiting, pipeline.take_results())
    _collect(out, waiting, pipeline.take_results())
    return out


def _collect(
    out: Looked,
    waiting: dict[float, tuple[StereoFrame, BlobFrame]],
    results: list[FrameResult],
) -> None:
    """Keep the results that show a hand for sure."""
    for result in results:
        frame, blobs = waiting.pop(result.t, (None, None))
        if frame is None or blobs is None:
            continue
        expected = float(result.visible.sum())
        share = float(_found(result).sum()) / max(expected, 1.0)
        if result.tracking != Tracking.TRACKING or share < LEAST_SHARE:
            continue
        out.frames.append(frame)
        out.blobs.append(blobs)
        out.results.append(result)


def _found(result: FrameResult) -> NDArray[np.bool_]:
    """(M,) bool: matched in a camera."""
    return np.asarray(_by_camera(result).any(axis=0))


def _by_camera(result: FrameResult) -> NDArray[np.bool_]:
    """(2, M) bool: matched in the left and in the right one."""
    return np.stack([result.match_left, result.match_right]) >= 0


def _cameras(watched: WatchedGlove) -> str:
    return "the camera" if watched.rig.one_camera else "both cameras"


def _is_poor(looked: Looked) -> bool:
    """Whether other colours might find more of the hand."""
    if len(looked.frames) < 0.5 * looked.images:
        return True
    expected = np.mean([float(r.visible.sum()) for r in looked.results])
    return bool(looked.matched < 0.85 * expected)


def _beginning(messages: Sequence[Sensed], images: int = 10) -> list[Sensed]:
    """Returns the messages up to the first images, which show whether colours fit."""
    out: list[Sensed] = []
    for message in messages:
        out.append(message)
        images -= isinstance(message, StereoFrame)
        if images < 0:
            break
    return out


def _samples(
    looked: Looked, watched: WatchedGlove, names: tuple[str, ...], odd: bool, most: int = 12
) -> ColourSamples:
    """Returns pixels of at most ``most`` images, of every other one unless ``odd`` ones are used
    too: those are for the validation."""
    out = ColourSamples.of(names)
    rows = range(0, len(looked.frames), 1 if odd else 2)
    step = max(1, -(-len(rows) // most))
    for k in list(rows)[::step]:
        for side in known_sides(
            looked.frames[k], looked.blobs[k], looked.results[k], watched.glove
        ):
            out.add(samples_of(*side, names))
    return out


def checked(
    looked: Looked, watched: WatchedGlove, profile: ColourProfile, showing: NDArray[np.bool_]
) -> ColourCheck:
    """Returns the check of the colours by a pass, hue by hue; ``showing`` (2,) are the cameras that
    show the hand."""
    names = profile.hue_names
    expected, found, other = np.zeros((3, len(names)))
    hue = np.array([names.index(m.hue) for m in watched.glove.markers])
    for blobs, result in zip(looked.blobs, looked.results, strict=True):
        there = _found(result)
        # a marker that was found was visible, however improbable that was
        np.add.at(expected, hue, np.where(there, 1.0, np.nan_to_num(result.visible)))
        np.add.at(found, hue, there)
        sides = ((blobs.left, result.match_left), (blobs.right, result.match_right))
        free = [_unmatched(b, match, len(names)) for b, match in sides if b is not None]
        other += np.mean(free, axis=0)
    overlaps = _overlaps(profile)
    n = max(len(looked.results), 1)
    return ColourCheck(
        looked.images,
        len(looked.results),
        tuple(
            HueCheck(name, expected[k] / n, found[k] / n, other[k] / n, overlaps[name])
            for k, name in enumerate(names)
        ),
        sum(_found_by_all(b, r, showing) for b, r in zip(looked.blobs, looked.results, strict=True))
        / max(looked.images, 1),
    )


def _overlaps(profile: ColourProfile) -> dict[str, tuple[str, ...]]:
    """Returns, by hue, the others that match its pixels."""
    pairs = [(c.hue, c.other) for c in clashes(profile)]
    pairs += [(other, hue) for hue, other in pairs]
    return {name: tuple(o for h, o in pairs if h == name) for name in profile.hue_names}


def _found_by_all(blobs: BlobFrame, result: FrameResult, showing: NDArray[np.bool_]) -> int:
    """Markers matched in each camera that shows the hand and gave an image."""
    gave = np.array([blobs.left is not None, blobs.right is not None])
    asked = gave & showing if (gave & showing).any() else gave
    return int(_by_camera(result)[asked].all(axis=0).sum()) if asked.any() else 0


def _unmatched(blobs: Blobs, match: IntArray, hues: int) -> IntArray:
    """(hues,) blobs that are not markers."""
    free = np.ones(len(blobs), bool)
    free[match[match >= 0]] = False
    return np.bincount(blobs.hue[free], minlength=hues)
