"""Glovetrack for Blender: live hands over UDP, and recordings as armatures.

Install this file in Blender (*Edit > Preferences > Add-ons > Install from Disk*). It needs nothing
but Blender; recordings (MCAP) are converted by the program `glovetrack`, whose CSV exports can be
imported directly. Each hand is an armature with a bone for each keypoint, in metres, z up. A bone's
Y axis is the x axis of its keypoint's segment. Custom properties of each bone are its
``state`` (0 lost, 1 inferred, 2 measured) and ``sd`` (m, -1 if lost). A lost bone keeps its last
pose.
"""

import csv
import json
import socket
import subprocess
import tempfile
from pathlib import Path
from typing import NamedTuple

import bpy
from bpy.props import IntProperty, StringProperty
from bpy_extras.io_utils import ImportHelper
from mathutils import Matrix, Quaternion, Vector

bl_info = {
    "name": "Glovetrack",
    "author": "The Glovetrack maintainers",
    "version": (0, 1, 0),
    "blender": (4, 2, 0),
    "location": "3D View > Sidebar > Glovetrack; File > Import > Glovetrack",
    "description": "Hands of a sensor glove: live over UDP, and from recordings",
    "category": "Animation",
}

STATES = {"lost": 0, "inferred": 1, "measured": 2}
FINGERS = ("thumb", "index", "middle", "ring", "little")
ROOT = "wrist"
SHORTEST = 0.005  # m: of a bone whose keypoint has no next one
LARGEST = 65_507  # bytes of a datagram
PERIOD = 1 / 60  # s between two looks at the socket
TURN = Matrix(((0, 1, 0), (-1, 0, 0), (0, 0, 1)))
"""A bone's axes in those of its segment: Y along x."""


class KeypointPose(NamedTuple):
    """One keypoint of an estimate: its pose in the world, None if it is lost."""

    pose: Matrix | None
    state: str
    sd: float  # m; -1 if it is lost


Hand = dict[str, KeypointPose]


def pose_of(position: list[float], xyzw: list[float]) -> Matrix:
    """A bone's matrix (4, 4)."""
    x, y, z, w = xyzw
    turn = Quaternion((w, x, y, z)).to_matrix() @ TURN
    return Matrix.Translation(Vector(position)) @ turn.to_4x4()


def parent_of(name: str, names: list[str]) -> str | None:
    """The keypoint before it on its finger, else the wrist."""
    finger = name.partition("_")[0]
    before = [n for n in names[: names.index(name)] if n.startswith(f"{finger}_")]
    if finger in FINGERS and before:
        return before[-1]
    return ROOT if name != ROOT else None


class HandArmature:
    """The armature of one hand. Its rest pose is the first hand whose keypoints are all known."""

    def __init__(self, side: str, hand: Hand) -> None:
        self._names = list(hand)
        self._parents = {name: parent_of(name, self._names) for name in self._names}
        armature = bpy.data.armatures.new(f"Glovetrack {side}")
        self.object = bpy.data.objects.new(armature.name, armature)
        bpy.context.scene.collection.objects.link(self.object)
        bpy.context.view_layer.objects.active = self.object
        bpy.ops.object.mode_set(mode="EDIT")
        for name in self._names:
            self._add_bone(armature, name, hand)
        bpy.ops.object.mode_set(mode="OBJECT")
        self._rest = {name: armature.bones[name].matrix_local.copy() for name in self._names}
        self._now = dict(self._rest)
        for bone in self.object.pose.bones:
            bone.rotation_mode = "QUATERNION"

    def _add_bone(self, armature: bpy.types.Armature, name: str, hand: Hand) -> None:
        pose = hand[name].pose
        assert pose is not None
        after = [hand[n].pose for n, parent in self._parents.items() if parent == name]
        lengths = [(p.translation - pose.translation).length for p in after if p is not None]
        bone = armature.edit_bones.new(name)
        bone.head, bone.tail = (0, 0, 0), (0, max([SHORTEST, *lengths[:1]]), 0)
        bone.matrix = pose
        parent = self._parents[name]
        bone.parent = armature.edit_bones[parent] if parent else None

    def show(self, hand: Hand, frame: float | None = None) -> None:
        """Pose the bones; with keys at ``frame`` where it is given."""
        for name in self._names:
            found, bone = hand[name], self.object.pose.bones[name]
            if found.pose is not None:
                self._now[name] = found.pose
            bone.location, bone.rotation_quaternion, _ = self._basis(name).decompose()
            bone["state"], bone["sd"] = STATES[found.state], found.sd
            if frame is not None:
                for path in ("location", "rotation_quaternion", '["state"]', '["sd"]'):
                    bone.keyframe_insert(path, frame=frame)

    def _basis(self, name: str) -> Matrix:
        """The pose of a bone in its rest pose's axes, which its parent has moved."""
        parent = self._parents[name]
        if parent is None:
            return self._rest[name].inverted() @ self._now[name]
        rest = self._rest[parent].inverted() @ self._rest[name]
        return rest.inverted() @ self._now[parent].inverted() @ self._now[name]


def is_whole(hand: Hand) -> bool:
    return all(keypoint.pose is not None for keypoint in hand.values())


# --- recordings


def hands_of_csv(path: Path) -> list[tuple[float, Hand]]:
    """The instants (s) and hands of a CSV export in metres. ValueError for another table."""
    with path.open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    names = [key.removesuffix("_qw") for key in (rows[0] if rows else ()) if key.endswith("_qw")]
    if "t" not in (rows[0] if rows else ()) or not names:
        raise ValueError(f"{path.name} is not a CSV export of Glovetrack in metres.")
    return [(float(row["t"]), {name: _of_row(row, name) for name in names}) for row in rows]


def _of_row(row: dict[str, str], name: str) -> KeypointPose:
    state = row[f"{name}_state"]
    if state == "lost":
        return KeypointPose(None, state, -1.0)
    position, turn = (
        [float(row[f"{name}_{axis}"]) for axis in axes]
        for axes in (("x", "y", "z"), ("qx", "qy", "qz", "qw"))
    )
    return KeypointPose(pose_of(position, turn), state, float(row[f"{name}_sd"]))


def import_csv(path: Path, side: str) -> HandArmature:
    """An armature with a key for each of the scene's frames, the first one at the first estimate.

    ValueError if no estimate of the table has all keypoints.
    """
    table = hands_of_csv(path)
    whole = next((hand for _, hand in table if is_whole(hand)), None)
    if whole is None:
        raise ValueError(f"{path.name} has no estimate in which the whole hand is known.")
    armature, render = HandArmature(side, whole), bpy.context.scene.render
    rate, start = render.fps / render.fps_base, table[0][0]
    row = 0
    for frame in range(int((table[-1][0] - start) * rate) + 1):
        t = start + frame / rate
        while row + 1 < len(table) and abs(table[row + 1][0] - t) <= abs(table[row][0] - t):
            row += 1
        armature.show(table[row][1], bpy.context.scene.frame_start + frame)
    return armature


def import_recording(path: Path, program: str = "glovetrack") -> list[HandArmature]:
    """Armatures of a recording's hands, or of the one in a CSV export.

    ValueError, with the program's own words, if it cannot be converted.
    """
    if path.suffix.lower() == ".csv":
        side = "left" if path.stem.endswith("_left") else "right"
        return [import_csv(path, side)]
    with tempfile.TemporaryDirectory() as folder:
        words = [program, "export", str(path), "--format", "csv", "-o", f"{folder}/hand.csv"]
        try:
            done = subprocess.run(words, capture_output=True, text=True)
        except OSError as error:
            raise ValueError(f"{program} cannot be started: {error}.") from error
        if done.returncode != 0:
            raise ValueError(done.stderr.strip() or f"{program} failed.")
        tables = sorted(Path(folder).glob("*.csv"))
        return [armature for table in tables for armature in import_recording(table, program)]


# --- live


def hand_of_message(data: bytes) -> tuple[str, Hand]:
    """Side and hand of a datagram. ValueError if it is not a message of the UDP stream."""
    try:
        message = json.loads(data)
        points = {name: _of_point(point) for name, point in message["keypoints"].items()}
        return str(message["side"]), points
    except (KeyError, TypeError, AttributeError) as error:
        raise ValueError(f"not a message of Glovetrack with keypoints: {error!r}") from error


def _of_point(point: dict) -> KeypointPose:
    if point["state"] == "lost":
        return KeypointPose(None, "lost", -1.0)
    pose = pose_of(point["position"], point["orientation_xyzw"])
    return KeypointPose(pose, point["state"], float(point["sd"]))


class Receiver:
    """Receives the UDP stream and shows the newest estimate of each hand."""

    def __init__(self, port: int) -> None:
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        try:
            self._socket.bind(("127.0.0.1", port))
        except OSError:
            self._socket.close()
            raise
        self._socket.setblocking(False)
        self.port: int = self._socket.getsockname()[1]
        self.armatures: dict[str, HandArmature] = {}
        self.refused = 0  # datagrams that are not of the stream

    def poll(self) -> None:
        """Show what has arrived since the last call."""
        newest: dict[str, Hand] = {}
        while True:
            try:
                side, hand = hand_of_message(self._socket.recv(LARGEST))
            except BlockingIOError:
                break
            except ValueError:
                self.refused += 1
            else:
                newest[side] = hand
        for side, hand in newest.items():
            if side not in self.armatures and is_whole(hand):
                self.armatures[side] = HandArmature(side, hand)
            if side in self.armatures:
                self.armatures[side].show(hand)

    def close(self) -> None:
        self._socket.close()


_receiver: Receiver | None = None


def _tick() -> float | None:
    if _receiver is None:
        return None
    _receiver.poll()
    return PERIOD


# --- what Blender shows


class Preferences(bpy.types.AddonPreferences):
    bl_idname = __name__
    program: StringProperty(  # type: ignore[valid-type]
        name="Program", default="glovetrack", subtype="FILE_PATH"
    )

    def draw(self, _context: bpy.types.Context) -> None:
        self.layout.prop(self, "program")


class ImportRecording(bpy.types.Operator, ImportHelper):
    """Import the hands of a Glovetrack recording (MCAP) or of a CSV export"""

    bl_idname = "import_scene.glovetrack"
    bl_label = "Import Glovetrack recording"
    filter_glob: StringProperty(  # type: ignore[valid-type]
        default="*.mcap;*.csv", options={"HIDDEN"}
    )

    def execute(self, context: bpy.types.Context) -> set[str]:
        addon = context.preferences.addons.get(__name__)
        program = addon.preferences.program if addon else "glovetrack"
        try:
            import_recording(Path(self.filepath), program)
        except (ValueError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class Listen(bpy.types.Operator):
    """Show the hands that Glovetrack sends (stream UDP); again to stop"""

    bl_idname = "glovetrack.listen"
    bl_label = "Live hand"
    port: IntProperty(name="Port", default=9750, min=0, max=65535)  # type: ignore[valid-type]

    def execute(self, _context: bpy.types.Context) -> set[str]:
        global _receiver
        if _receiver is not None:
            _receiver.close()
            _receiver = None
            return {"FINISHED"}
        try:
            _receiver = Receiver(self.port)
        except OSError as error:
            self.report({"ERROR"}, f"Port {self.port} cannot be used: {error}.")
            return {"CANCELLED"}
        bpy.app.timers.register(_tick)
        return {"FINISHED"}


class LivePanel(bpy.types.Panel):
    bl_label = "Glovetrack"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Glovetrack"

    def draw(self, _context: bpy.types.Context) -> None:
        label = "Start live hand" if _receiver is None else "Stop live hand"
        self.layout.operator(Listen.bl_idname, text=label)


CLASSES = (Preferences, ImportRecording, Listen, LivePanel)


def _menu(menu: bpy.types.Menu, _context: bpy.types.Context) -> None:
    menu.layout.operator(ImportRecording.bl_idname, text="Glovetrack (.mcap, .csv)")


def register() -> None:
    for part in CLASSES:
        bpy.utils.register_class(part)
    bpy.types.TOPBAR_MT_file_import.append(_menu)


def unregister() -> None:
    if _receiver is not None:
        bpy.ops.glovetrack.listen()
    bpy.types.TOPBAR_MT_file_import.remove(_menu)
    for part in reversed(CLASSES):
        bpy.utils.unregister_class(part)
