"""Views in a video: both cameras with the hand drawn in, the hand in 3D, and curves."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import cv2
import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from extensions.interchange.skeleton import bone_tree
from tracker.hand.names import CHAINS
from tracker.hand.skin.mesh import SkinMaker
from tracker.hand.skin.posing import posed, rest_of
from tracker.messages import Array, StereoFrame, Validity
from tracker.session.export.markers import read_sizes
from tracker.session.export.options import VIEWS
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader
from tracker.vision.rig import StereoRig

Image = NDArray[np.uint8]
_COLOUR = {Validity.MEASURED: (80, 220, 80), Validity.INFERRED: (60, 180, 250)}  # BGR
_SKIN = {Validity.MEASURED: (150, 180, 220), Validity.INFERRED: (90, 170, 240)}
_CURVES = ((178, 114, 0), (0, 94, 213), (115, 158, 0), (167, 121, 204), (0, 159, 230))
_GROUND, _LINE, _TEXT = (40, 36, 32), (75, 70, 65), (210, 205, 200)
_FROM = np.array([-0.55, -0.65, 0.55])  # whence the hand is looked at, in G
_LIGHT = np.array([-0.3, -0.5, 0.8])
_SPAN = 5.0  # s that curves reach back
_LOW_DEG, _HIGH_DEG = -30.0, 120.0
_FONT = cv2.FONT_HERSHEY_SIMPLEX


class FilmView(Protocol):
    """Draws a row of the motion with the images of its instant; None without an image."""

    def draw(self, frame: StereoFrame, row: int) -> Image | None: ...


def views_of(
    names: Sequence[str], reader: SessionReader, m: EstimateSeries, rig: StereoRig
) -> list[FilmView]:
    """Views named in `options.VIEWS`; those without a camera have the rig's image size."""
    size = rig.left.width, rig.left.height
    made: dict[str, FilmView] = {}
    for name in names:
        if name in ("left", "right"):
            made[name] = CameraView(m, rig, right=name == "right")
        elif name == VIEWS[2]:
            made[name] = HandView(reader, m, size)
        else:
            made[name] = CurvesView(m, size)
    return list(made.values())


def side_by_side(images: Sequence[Image | None]) -> Image | None:
    """Images in rows of two, scaled to the height of the first; missing ones are black. None if the
    first is missing."""
    first = images[0]
    if first is None or len(images) == 1:
        return first
    h, w = first.shape[:2]
    cells = [np.zeros_like(first) if i is None else _fitted(i, w, h) for i in images]
    cells += [np.zeros_like(first)] * (len(cells) % 2)
    rows = [np.hstack(cells[k : k + 2]) for k in range(0, len(cells), 2)]
    return np.vstack(rows)


def _fitted(image: Image, w: int, h: int) -> Image:
    if image.shape[:2] == (h, w):
        return image
    return np.asarray(cv2.resize(image, (w, h), interpolation=cv2.INTER_AREA), np.uint8)


class CameraView:
    """One camera's image with bones and keypoints; lost ones are not drawn."""

    def __init__(self, m: EstimateSeries, rig: StereoRig, right: bool) -> None:
        self._m, self._rig, self._right = m, rig, right
        self._names, self._parent = bone_tree(m.keypoint_names)

    def draw(self, frame: StereoFrame, row: int) -> Image | None:
        given = frame.right if self._right else frame.left
        if given is None:
            return None
        m, rig, pose = self._m, self._rig, frame.pose or self._rig.pose
        p_C = (m.keypoints[row] - pose.p_GC) @ pose.R_GC
        camera = rig.right if self._right else rig.left
        uv: Array = camera.unrectify(rig.project(p_C, right=self._right))
        image = given.copy()
        columns = [m.keypoint_names.index(n) for n in self._names]
        for i, a in enumerate(self._parent):
            state = Validity(int(m.state[row, columns[i]]))
            if not np.isfinite(uv[columns[i]]).all() or state not in _COLOUR:
                continue
            here = pixel(uv[columns[i]])
            if a >= 0 and np.isfinite(uv[columns[a]]).all():
                cv2.line(image, pixel(uv[columns[a]]), here, _COLOUR[state], 2, cv2.LINE_AA)
            cv2.circle(image, here, 3, _COLOUR[state], -1, cv2.LINE_AA)
        return image


class HandView:
    """The skin of the calibrated hand from a fixed viewpoint; a text where the hand is lost."""

    def __init__(self, reader: SessionReader, m: EstimateSeries, size: tuple[int, int]) -> None:
        self._m, (self._w, self._h) = m, size
        hand = m.info.hand
        self._skin = SkinMaker(hand).skin()
        sizes = read_sizes(reader)
        scale = np.median(sizes.scale[sizes.at(m.stamp_ns + m.zero_ns)], axis=0)
        self._rest = rest_of(self._skin, hand, scale)
        self._part = self._skin.bones[self._skin.faces[:, 0], 0]
        known = m.keypoints[np.isfinite(m.keypoints).all(axis=2)]
        self._middle = known.mean(axis=0) if len(known) else np.zeros(3)
        reach = np.linalg.norm(known - self._middle, axis=1).max() if len(known) else 0.2
        self._pixels = 0.45 * min(size) / float(max(reach, 0.1) + 0.03)  # per metre
        ahead = -_FROM / np.linalg.norm(_FROM)
        right = np.cross(ahead, [0.0, 0, 1])
        right /= np.linalg.norm(right)
        self._axes = np.stack([right, np.cross(ahead, right), ahead])

    def draw(self, frame: StereoFrame, row: int) -> Image | None:
        image = np.full((self._h, self._w, 3), _GROUND, np.uint8)
        m = self._m
        q, p = m.segment_q[row], m.segment_p[row]
        if not (np.isfinite(q).all() and np.isfinite(p).all()):
            cv2.putText(image, "lost", (20, 40), _FONT, 1.0, _TEXT, 2, cv2.LINE_AA)
            return image
        self._cross(image)
        points, normals = posed(self._rest, Rotation.from_quat(q).as_matrix(), p)
        seen = (points - self._middle) @ self._axes.T
        faces = self._skin.faces
        depth = seen[faces, 2].mean(axis=1)
        facing = normals[faces].mean(axis=1)
        front = np.flatnonzero(facing @ self._axes[2] < 0.1)
        lit = 0.45 + 0.55 * np.clip(facing @ (_LIGHT / np.linalg.norm(_LIGHT)), 0, 1)
        flat = np.round(self._at(seen)).astype(np.int32)
        tone = self._tones(row)
        for f in front[np.argsort(-depth[front])]:
            cv2.fillConvexPoly(image, flat[faces[f]], (tone[self._part[f]] * lit[f]).tolist())
        return image

    def _at(self, seen: Array) -> Array:
        return seen[:, :2] * self._pixels + [0.5 * self._w, 0.5 * self._h]

    def _tones(self, row: int) -> Array:
        """Colours (S, 3) by the segments' states."""
        m = self._m
        states = np.full(len(m.info.hand.segments), int(Validity.INFERRED))
        segments = m.info.glove.keypoint_segments(m.info.hand)
        for k, s in zip(range(len(segments) - 1, -1, -1), segments[::-1], strict=True):
            states[s] = m.state[row, k]
        dull = _SKIN[Validity.INFERRED]
        return np.array([_SKIN.get(Validity(int(s)), dull) for s in states], float)

    def _cross(self, image: Image) -> None:
        """Draw G's axes at the hand's median position, 10 cm each, with their names."""
        ends = np.vstack([np.zeros(3), 0.1 * np.eye(3)]) @ self._axes.T
        at = self._at(ends) + [-0.36 * self._w, 0.36 * self._h]
        for k, name in enumerate("xyz"):
            cv2.line(image, pixel(at[0]), pixel(at[k + 1]), _TEXT, 1, cv2.LINE_AA)
            cv2.putText(image, name, pixel(at[k + 1] + 4), _FONT, 0.5, _TEXT, 1, cv2.LINE_AA)


class CurvesView:
    """Flexion of one joint per finger over the last `_SPAN` seconds."""

    def __init__(self, m: EstimateSeries, size: tuple[int, int]) -> None:
        self._m, (self._w, self._h) = m, size
        self._joints = [name for digit in CHAINS if (name := _middle_joint(m, digit))]
        self._columns = [m.joint_names.index(name) for name in self._joints]
        self._angles = np.degrees(m.angles[:, self._columns])

    def draw(self, frame: StereoFrame, row: int) -> Image | None:
        image = np.full((self._h, self._w, 3), _GROUND, np.uint8)
        t = self._m.elapsed
        first = int(np.searchsorted(t, t[row] - _SPAN))
        for level in range(0, 120, 30):
            y = self._y(np.array([float(level)]))[0]
            cv2.line(image, (0, y), (self._w, y), _LINE, 1)
            cv2.putText(image, f"{level} deg", (6, y - 4), _FONT, 0.45, _TEXT, 1, cv2.LINE_AA)
        x = np.round((t[first : row + 1] - t[row] + _SPAN) / _SPAN * self._w).astype(np.int32)
        for k, name in enumerate(self._joints):
            values, colour = self._angles[first : row + 1, k], _CURVES[k % len(_CURVES)]
            known = np.isfinite(values)
            for part in np.split(np.arange(len(values)), np.flatnonzero(np.diff(known)) + 1):
                if len(part) > 1 and known[part[0]]:
                    line = np.column_stack([x[part], self._y(values[part])])
                    cv2.polylines(image, [line], False, colour, 2, cv2.LINE_AA)
            now = f"{values[-1]:5.0f}" if known[-1] else "    -"
            at = (self._w - 300, 28 + 24 * k)
            cv2.putText(image, f"{now} {name}", at, _FONT, 0.55, colour, 1, cv2.LINE_AA)
        return image

    def _y(self, values: Array) -> NDArray[np.int32]:
        share = (values - _LOW_DEG) / (_HIGH_DEG - _LOW_DEG)
        return np.round(self._h * (1 - np.clip(share, 0, 1))).astype(np.int32)


def _middle_joint(m: EstimateSeries, digit: str) -> str:
    """The most representative flexion of a digit; empty if it has none."""
    of = [n for n in m.joint_names if n.startswith(f"{digit}_") and n.endswith("_flexion")]
    return of[min(1, len(of) - 1)] if of else ""


def pixel(uv: Array) -> tuple[int, int]:
    """Integer pixel coordinates, clipped to the range that OpenCV can draw."""
    u, v = np.clip(np.round(uv), -30000, 30000).astype(int)
    return int(u), int(v)
