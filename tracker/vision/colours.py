"""The colour profile: the pixel values of each hue, and the limits on the shape of a patch.

OpenCV units: hue 0..179 (2° each), saturation and value 0..255. A hue range whose first number is
the larger one wraps through 0.
"""

from __future__ import annotations

import base64
import binascii
import zlib
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w
from numpy.typing import NDArray

from tracker.base.notices import notice
from tracker.base.toml_reader import TomlTable, read_text, read_toml
from tracker.messages import IntArray

HUES = 180
LEVELS = 256
SCHEMA = 1
LEARNED_BITS = 6  # bits per channel that index the learned colours
LEARNED_CELLS = 1 << 3 * LEARNED_BITS
SMOOTHING_PX = (0, 3, 5, 7)
ROOM, WORN, UNKNOWN = 0, 254, 255  # learned classes: background, glove cloth, not observed


@dataclass(frozen=True)
class HueRange:
    """One hue by name; all intervals include both ends."""

    name: str
    hue: tuple[int, int]
    saturation: tuple[int, int] = (90, 255)
    value: tuple[int, int] = (45, 255)

    @property
    def centre(self) -> float:
        """The middle of the hue interval, from 0 up to 180 (exclusive)."""
        return (self.hue[0] + self.width / 2) % HUES

    @property
    def width(self) -> int:
        """Number of hue values between the first and the last, with wrapping."""
        return (self.hue[1] - self.hue[0]) % HUES

    def contains(self, hsv: NDArray[Any]) -> NDArray[np.bool_]:
        """Which pixels (…, 3) in HSV lie in the intervals; shape (…)."""
        pixel = np.asarray(hsv).astype(np.int64)
        inside = (pixel[..., 0] - self.hue[0]) % HUES <= self.width
        for channel, (low, high) in ((1, self.saturation), (2, self.value)):
            inside &= (pixel[..., channel] >= low) & (pixel[..., channel] <= high)
        return inside

    def overlaps(self, other: HueRange) -> bool:
        """Whether the intervals of both hues intersect."""
        hues = (other.hue[0] - self.hue[0]) % HUES <= self.width
        hues = hues or (self.hue[0] - other.hue[0]) % HUES <= other.width
        return hues and all(
            a[0] <= b[1] and b[0] <= a[1]
            for a, b in ((self.saturation, other.saturation), (self.value, other.value))
        )


@dataclass(frozen=True)
class ShapeLimits:
    """Limits on a patch: size relative to the expected one, two shape factors, and contrast."""

    size: tuple[float, float] = (0.35, 1.6)
    convexity: float = 0.85  # area / hull area, minimum
    circularity: float = 0.45  # 4 pi area / perimeter², minimum
    contrast: float = 0.25  # of its mean to its surroundings, minimum


@dataclass(frozen=True)
class LearnedColours:
    """Learned classes of `LEARNED_CELLS` colours: markers, cloth and background.

    ``packed`` has a class for each, indexed by b << 12 | g << 6 | r of the channels' upper six
    bits: k + 1 for hue k, `ROOM`, `WORN` (the glove's own cloth) or `UNKNOWN`. ``cloth`` is the
    minimum share of the glove's cloth in the surroundings of a marker. ``smoothing_px``: width of
    the smoothing filter applied to noisy images before learning, and therefore before detection; 0:
    none.
    """

    packed: bytes  # zlib
    cloth: float = 0.0
    smoothing_px: int = 0

    @staticmethod
    def of(classes: NDArray[np.uint8], cloth: float = 0.0, smoothing_px: int = 0) -> LearnedColours:
        """From classes (LEARNED_CELLS,)."""
        return LearnedColours(zlib.compress(classes.tobytes(), 9), cloth, smoothing_px)

    def classes(self) -> NDArray[np.uint8]:
        """(LEARNED_CELLS,) class of each colour."""
        return np.frombuffer(zlib.decompress(self.packed), np.uint8)


@dataclass(frozen=True)
class ColourProfile:
    """Hues in the order of the blobs' hue numbers. A pixel in two hues counts as the first.

    Within the intervals ``learned`` decides: a colour also seen in the background counts as
    background, and for one that was not observed the intervals alone decide.
    """

    name: str
    hues: tuple[HueRange, ...]
    shape: ShapeLimits = ShapeLimits()
    learned: LearnedColours | None = None

    @property
    def hue_names(self) -> tuple[str, ...]:
        return tuple(h.name for h in self.hues)


@lru_cache(maxsize=16)
def hue_rows(names: tuple[str, ...], among: tuple[str, ...]) -> IntArray:
    """Row of each of ``names`` in ``among``, -1 where it is not there."""
    rows = np.array([among.index(n) if n in among else -1 for n in names], np.int64)
    rows.setflags(write=False)  # shared by all callers
    return rows


def load_profile(path: Path) -> ColourProfile:
    """Read a profile. Raises FileError with file, key and line."""
    return parse_profile(read_text(path), path.name)


def parse_profile(text: str, name: str = "colours.toml") -> ColourProfile:
    """A profile from TOML text; ``name`` replaces the file name in messages."""
    root = read_toml(text, name)
    if root.integer("schema") != SCHEMA:
        raise root.fail("schema", notice("toml.schema", expected=SCHEMA))
    title = root.text("name")
    hues = tuple(_hue_range(key, table) for key, table in root.tables("hues", labels=True).items())
    if not hues:
        raise root.fail("hues", notice("colours.file_no_hue"))
    shape = _shape(root.table("shape", {}))
    learned = _learned(root.table("learned", {}), len(hues)) if root.has("learned") else None
    root.finish()
    return ColourProfile(title, hues, shape, learned)


def _learned(table: TomlTable, hues: int) -> LearnedColours:
    cloth = table.number("cloth", 0.0, 0.0, 1.0)
    smoothing_px = table.integer("smoothing_px", 0)
    if smoothing_px not in SMOOTHING_PX:
        raise table.fail(
            "smoothing_px", notice("toml.choice", value=smoothing_px, known=SMOOTHING_PX)
        )
    text = table.text("classes")
    table.finish()
    try:
        packed = base64.b64decode(text, validate=True)
        unpacker = zlib.decompressobj()
        data = unpacker.decompress(packed, LEARNED_CELLS + 1)
    except (binascii.Error, zlib.error) as error:
        raise table.fail("classes", notice("colours.file_encoding")) from error
    classes = np.frombuffer(data, np.uint8)
    if len(classes) != LEARNED_CELLS or not unpacker.eof:
        raise table.fail("classes", notice("colours.file_cells", expected=LEARNED_CELLS))
    if np.any((classes > hues) & (classes < WORN)):
        raise table.fail("classes", notice("colours.file_hue", hues=hues))
    return LearnedColours(packed, cloth, smoothing_px)


def _hue_range(name: str, table: TomlTable) -> HueRange:
    hue = _interval(table, "hue", HUES - 1, wraps=True)
    saturation = _interval(table, "saturation", LEVELS - 1)
    value = _interval(table, "value", LEVELS - 1)
    table.finish()
    return HueRange(name, hue, saturation, value)


def _interval(table: TomlTable, key: str, top: int, wraps: bool = False) -> tuple[int, int]:
    low, high = table.vector(key, 2)
    if low % 1 or high % 1:
        raise table.fail(key, notice("colours.file_integers"))
    if not (0 <= low <= top and 0 <= high <= top):
        raise table.fail(key, notice("toml.between", low=0, high=top))
    if low > high and not wraps:
        raise table.fail(key, notice("toml.order"))
    return int(low), int(high)


def _shape(table: TomlTable) -> ShapeLimits:
    default = ShapeLimits()
    low, high = table.vector("size", 2, list(default.size))
    if not 0 <= low < high:
        raise table.fail("size", notice("colours.file_pair"))
    convexity = table.number("convexity", default.convexity, 0.0, 1.0)
    circularity = table.number("circularity", default.circularity, 0.0, 1.0)
    contrast = table.number("contrast", default.contrast, 0.0, 1.0)
    table.finish()
    return ShapeLimits((float(low), float(high)), convexity, circularity, contrast)


def profile_to_toml(profile: ColourProfile) -> str:
    """The file text, from which `parse_profile` reads an equal profile."""
    hues = {
        h.name: {key: [int(v) for v in getattr(h, key)] for key in ("hue", "saturation", "value")}
        for h in profile.hues
    }
    s = profile.shape
    shape = {
        "size": [float(v) for v in s.size],
        "convexity": float(s.convexity),
        "circularity": float(s.circularity),
        "contrast": float(s.contrast),
    }
    out = {"schema": SCHEMA, "name": profile.name, "hues": hues, "shape": shape}
    if profile.learned is not None:
        out["learned"] = {
            "cloth": float(profile.learned.cloth),
            "smoothing_px": profile.learned.smoothing_px,
            "classes": base64.b64encode(profile.learned.packed).decode(),
        }
    return tomli_w.dumps(out)
