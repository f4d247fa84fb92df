"""CSV, BVH, GLB and URDF of a tracked session give the same hand, and no values where it is
lost."""

import csv
import json
from dataclasses import replace
from pathlib import Path

import bvhio
import ezc3d
import numpy as np
import pytest
import yourdfpy
from pygltflib import GLTF2
from scipy.spatial.transform import Rotation

from tracker.messages import Estimate
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.export.axes import AXES
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder

pytestmark = pytest.mark.long

Y_UP = AXES["y-up"].rows
NEAR = 1e-4  # m
START = 0.5  # s, after which the hand is found
HOLE = (1.0, 1.7)  # s without estimates


@pytest.fixture(scope="module")
def tracked(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Four seconds of a simulated hand whose size is being estimated."""
    folder = tmp_path_factory.mktemp("same")
    simulate(folder / "in.mcap", SimulateOptions(images=False, duration=4.0))
    track(folder / "in.mcap", folder / "out.mcap")
    return folder / "out.mcap"


@pytest.fixture(scope="module")
def holed(tracked: Path) -> Path:
    """The same without the estimates of 0.7 s, and one finger lost for half a second."""
    path = tracked.with_name("holed.mcap")
    with SessionReader(tracked) as reader:
        info, found = reader.info, list(reader.messages((Estimate,)))
    row = info.keypoint_names.index("ring_tip")
    with SessionRecorder(path, info) as recorder:
        for m in found:
            assert isinstance(m, Estimate)
            t = m.t - found[0].t
            if not HOLE[0] < t < HOLE[1]:
                recorder.write(_without(m, row) if 2.5 < t < 3.0 else m)
    return path


def _without(m: Estimate, row: int) -> Estimate:
    keypoints, state = m.keypoints.copy(), m.keypoint_state.copy()
    keypoints[row], state[row] = np.nan, 0
    return replace(m, keypoints=keypoints, keypoint_state=state)


def table(path: Path, **options: object) -> tuple[np.ndarray, dict[str, np.ndarray], list]:
    """t from the first row (s), keypoints by name with NaN where lost, and all rows."""
    out = path.with_name("o.csv")
    export(path, "csv", out, ExportOptions(**options), force=True)  # type: ignore[arg-type]
    with out.open() as file:
        rows = list(csv.DictReader(file))
    names = [k[:-6] for k in rows[0] if k.endswith("_state") and f"{k[:-6]}_x" in rows[0]]
    points = {
        n: np.array([[float(r[f"{n}_{c}"] or "nan") for c in "xyz"] for r in rows]) for n in names
    }
    t = np.array([float(r["t"]) for r in rows])
    return t - t[0], points, rows


class Glb:
    """Positions of nodes by walking the tree, as the format's specification requires."""

    def __init__(self, path: Path) -> None:
        self.gltf = GLTF2().load(str(path))
        self.tracks = {}
        animation = self.gltf.animations[0]
        for channel in animation.channels:
            sampler = animation.samplers[channel.sampler]
            key = channel.target.node, channel.target.path
            values = self._values(sampler.input), self._values(sampler.output)
            self.tracks[key] = (*values, sampler.interpolation)

    def _values(self, accessor: int) -> np.ndarray:
        a = self.gltf.accessors[accessor]
        width = {"SCALAR": 1, "VEC3": 3, "VEC4": 4}[a.type]
        start = self.gltf.bufferViews[a.bufferView].byteOffset
        return np.frombuffer(self.gltf.binary_blob(), "<f4", a.count * width, start).reshape(
            -1, width
        )

    def value(self, node: int, path: str, t: float) -> np.ndarray:
        if (node, path) not in self.tracks:
            return np.array(getattr(self.gltf.nodes[node], path), float)
        times, values, way = self.tracks[node, path]
        assert np.all(np.diff(times[:, 0]) > 0)
        i = int(np.clip(np.searchsorted(times[:, 0], t + 1e-6, "right") - 1, 0, len(times) - 1))
        if way == "STEP" or i == len(times) - 1:
            return values[i]
        share = np.clip((t - times[i, 0]) / (times[i + 1, 0] - times[i, 0]), 0, 1)
        return values[i] + share * (values[i + 1] - values[i])

    def positions(self, t: float) -> dict[str, np.ndarray]:
        out: dict[str, np.ndarray] = {}

        def walk(node: int, R: np.ndarray, p: np.ndarray) -> None:
            n = self.gltf.nodes[node]
            if n.name.startswith("bone_to_"):
                return
            p = p + R @ self.value(node, "translation", t)
            out[n.name] = p
            for child in n.children or []:
                walk(child, R @ Rotation.from_quat(self.value(node, "rotation", t)).as_matrix(), p)

        walk(0, np.eye(3), np.zeros(3))
        return out

    def size(self, bone: str, t: float) -> float:
        (node,) = (i for i, n in enumerate(self.gltf.nodes) if n.name == f"bone_to_{bone}")
        return float(self.value(node, "scale", t)[0])


def test_bones_change_while_calibrating(tracked: Path) -> None:
    """Otherwise the tests below would be meaningless."""
    _, points, _ = table(tracked)
    fingers = ("index", "middle", "ring", "little")
    bones = [points[f"{f}_pip"] - points[f"{f}_mcp"] for f in fingers]
    lengths = np.linalg.norm(bones, axis=2)
    assert (np.nanmax(lengths, axis=1) - np.nanmin(lengths, axis=1)).max() > 3 * NEAR


def test_bvh_agrees_with_the_csv(tracked: Path) -> None:
    out = tracked.with_name("o.bvh")
    export(tracked, "bvh", out, ExportOptions(units="m"), force=True)
    t, points, _ = table(tracked)
    root = bvhio.readAsHierarchy(str(out))
    for k in range(10, len(t), 37):
        root.loadPose(k)
        found = {joint.Name: np.array(joint.PositionWorld) for joint, _, _ in root.layout()}
        assert len(found) == 21
        for name, p in found.items():
            if np.isfinite(points[name][k]).all():
                assert np.linalg.norm(p - Y_UP @ points[name][k]) < NEAR, (name, k)


def test_glb_agrees_with_the_csv(tracked: Path) -> None:
    out = tracked.with_name("o.glb")
    export(tracked, "glb", out, force=True)
    t, points, _ = table(tracked)
    glb = Glb(out)
    for k in range(10, len(t), 37):
        found = glb.positions(t[k])
        assert len(found) == 21
        for name, p in found.items():
            if np.isfinite(points[name][k]).all():
                assert np.linalg.norm(p - Y_UP @ points[name][k]) < NEAR, (name, k)


def urdf_positions(path: Path, every: int = 1) -> list[tuple[int, dict[str, np.ndarray]]]:
    """A row of the trajectory, and yourdfpy's positions of the keypoints in the world for its
    values."""
    robot = yourdfpy.URDF.load(str(path), load_meshes=False)
    with path.with_suffix(".joints.csv").open() as file:
        rows = list(csv.DictReader(file))
    names = robot.actuated_joint_names
    links = [n for n in robot.link_map if n.endswith("_keypoint")]
    out = []
    for k in range(0, len(rows), every):
        if all(rows[k][n] for n in names):
            robot.update_cfg([float(rows[k][n]) for n in names])
            place = {n[:-9]: robot.get_transform(n, "world")[:3, 3] for n in links}
            out.append((k, place))
    return out


def test_urdf_with_its_trajectory_agrees_with_the_csv(tracked: Path) -> None:
    """Read by another library: bones that change, and axes that a joint lacks."""
    out = tracked.with_name("o.urdf")
    export(tracked, "urdf", out, force=True)
    t, points, _ = table(tracked)
    found = urdf_positions(out, every=4)
    assert len(found) > 0.2 * len(t)
    for k, place in found:
        assert set(place) == set(points)
        away = [np.linalg.norm(place[n] - points[n][k]) for n in points]
        assert max(away) < NEAR, k


def test_urdf_follows_a_part_at_another_rate_in_other_axes(tracked: Path) -> None:
    out, options = tracked.with_name("o.urdf"), {"rate": 40.0, "start": 1.0, "axes": "opensim"}
    export(tracked, "urdf", out, ExportOptions(**options), force=True)  # type: ignore[arg-type]
    _, points, _ = table(tracked, **options)
    found = urdf_positions(out, every=9)
    assert len(found) > 10
    for k, place in found:
        assert max(np.linalg.norm(place[n] - points[n][k]) for n in points) < NEAR


def test_values_of_urdf_joints_are_within_limits(tracked: Path) -> None:
    out = tracked.with_name("o.urdf")
    export(tracked, "urdf", out, force=True)
    robot = yourdfpy.URDF.load(str(out), load_meshes=False)
    with out.with_suffix(".joints.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert set(rows[0]) == {"t", *robot.actuated_joint_names}
    for joint in robot.actuated_joints:
        values = np.array([float(r[joint.name] or "nan") for r in rows])
        if joint.type != "continuous":
            assert np.nanmin(values) > joint.limit.lower - 1e-7, joint.name
            assert np.nanmax(values) < joint.limit.upper + 1e-7, joint.name


def test_urdf_with_the_angles_alone_differs_as_its_json_says(tracked: Path) -> None:
    """Without the other joints it has one size for all time, the CSV the size known then."""
    out = tracked.with_name("o.urdf")
    said = export(tracked, "urdf", out, force=True)["angles_alone_differ_mm"]
    t, points, rows = table(tracked)
    robot = yourdfpy.URDF.load(str(out), load_meshes=False)
    k = len(t) - 1
    robot.update_cfg({n: float(rows[k].get(n, 0.0)) for n in robot.actuated_joint_names})
    links = {n: robot.get_transform(f"{n}_keypoint", "dorsum")[:3, 3] for n in points}
    a = np.array([links[n] for n in points])
    b = np.array([points[n][k] for n in points])
    palm = [i for i, n in enumerate(points) if n.endswith("_mcp") or n == "wrist"]
    turn, _ = Rotation.align_vectors(b[palm] - b[palm].mean(axis=0), a[palm] - a[palm].mean(axis=0))
    placed = turn.apply(a - a[palm].mean(axis=0)) + b[palm].mean(axis=0)
    worst_mm = 1e3 * np.linalg.norm(placed - b, axis=1).max()
    assert worst_mm == pytest.approx(said["at_end"], abs=1.0)
    assert said["median"] <= said["largest"] < 15


@pytest.mark.parametrize("rate", [50.0, 100.0, 250.0])
def test_a_hole_stays_a_hole_in_the_csv(holed: Path, rate: float) -> None:
    t, points, rows = table(holed, rate=rate)
    inside = (t > HOLE[0] + 0.02) & (t < HOLE[1] - 0.02)
    assert inside.sum() > 0.6 * rate
    for name, p in points.items():
        assert np.isnan(p[inside]).all(), name
        assert {rows[k][f"{name}_state"] for k in np.flatnonzero(inside)} == {"lost"}
    assert all(rows[k]["index_mcp_flexion"] == "" for k in np.flatnonzero(inside))
    lost = (t > 2.53) & (t < 2.97)
    assert np.isnan(points["ring_tip"][lost]).all()
    assert np.isfinite(points["index_tip"][lost]).all()


def test_motion_around_a_hole_is_not_changed(tracked: Path, holed: Path) -> None:
    t, whole, _ = table(tracked, rate=40.0)
    _, points, _ = table(holed, rate=40.0)
    near = (np.abs(t - HOLE[0] + 0.1) < 0.08) | (np.abs(t - HOLE[1] - 0.1) < 0.08)
    gap = np.linalg.norm(points["index_tip"][near] - whole["index_tip"][near], axis=1)
    assert np.nanmax(gap) < 2e-3


def test_a_short_gap_is_filled(tracked: Path) -> None:
    path = tracked.with_name("short.mcap")
    with SessionReader(tracked) as reader:
        info, found = reader.info, list(reader.messages((Estimate,)))
    with SessionRecorder(path, info) as recorder:
        for m in found:
            if not 1.0 < m.t - found[0].t < 1.08:
                recorder.write(m)
    _, points, _ = table(path, rate=100.0)
    assert np.isfinite(points["wrist"][round(100 * START) :]).all()


def test_a_hole_stays_a_hole_in_c3d_and_trc(holed: Path) -> None:
    export(holed, "c3d", holed.with_name("o.c3d"), force=True)
    file = ezc3d.c3d(str(holed.with_name("o.c3d")))
    rate = file["parameters"]["POINT"]["RATE"]["value"][0]
    points = file["data"]["points"]
    t = np.arange(points.shape[2]) / rate
    inside = (t > HOLE[0] + 0.02) & (t < HOLE[1] - 0.02)
    assert np.isnan(points[:3, :, inside]).all()
    assert (file["data"]["meta_points"]["residuals"][0][:, inside] < 0).all()
    export(holed, "trc", holed.with_name("o.trc"), force=True)
    lines = holed.with_name("o.trc").read_text().split("\n")[6:]
    cells = [line.split("\t") for line in lines if line]
    empty = [set(c[2:]) == {""} for c in cells]
    assert np.array_equal(np.array(empty)[inside], np.ones(inside.sum(), bool))
    assert not any(np.array(empty)[(t > START) & (t < HOLE[0])])


def test_a_hole_keeps_the_last_pose_in_bvh_and_is_reported(holed: Path) -> None:
    out = holed.with_name("o.bvh")
    export(holed, "bvh", out, force=True)
    motion = out.read_text().split("Frame Time:")[1].split("\n")[1:]
    values = np.array([[float(v) for v in line.split()] for line in motion if line])
    inside = slice(round(100 * HOLE[0]) + 3, round(100 * HOLE[1]) - 3)
    assert np.ptp(values[inside], axis=0).max() == 0
    holes = json.loads(out.with_name("o.bvh.json").read_text())["holes_s"]
    assert [h for h in holes["wrist"] if h[0] > START] == [pytest.approx(HOLE, abs=0.03)]
    assert holes["ring_tip"][-2:] == [
        pytest.approx(HOLE, abs=0.03),
        pytest.approx((2.5, 3), abs=0.03),
    ]


def test_a_hole_shows_nothing_in_glb(holed: Path) -> None:
    out = holed.with_name("o.glb")
    export(holed, "glb", out, force=True)
    glb = Glb(out)
    for bone in ("index_tip", "ring_tip", "thumb_mcp"):
        assert glb.size(bone, 0.5) > 0.01 and glb.size(bone, 2.0) > 0.01
        assert glb.size(bone, 1.1) == glb.size(bone, 1.6) == 0
    assert glb.size("ring_tip", 2.75) == 0 < glb.size("index_tip", 2.75)
    assert glb.size("ring_tip", 3.2) > 0.01
    before, late = glb.positions(1.02), glb.positions(1.6)
    assert all(np.allclose(before[n], late[n], atol=1e-6) for n in before), "nodes stand still"


def test_formats_contain_the_uncertainty_of_each_point(holed: Path) -> None:
    """For each instant in glTF; as a summary next to formats without a field for it."""
    out = holed.with_name("o.glb")
    export(holed, "glb", out, force=True)
    t, _, rows = table(holed)
    gltf, glb = GLTF2().load(str(out)), Glb(out)
    extras = gltf.asset.extras["accessors"]
    assert np.allclose(glb._values(extras["t"])[:, 0], t, atol=1e-5)
    for name in ("index_tip", "ring_tip"):
        state = glb._values(extras["state"][name])[:, 0]
        words = {0: "lost", 1: "inferred", 2: "measured"}
        assert [words[int(s)] for s in state] == [r[f"{name}_state"] for r in rows]
        sd = np.array([float(r[f"{name}_sd"] or -1) for r in rows])
        assert np.allclose(glb._values(extras["sd"][name])[:, 0], sd, atol=1e-6)
    said = export(holed, "bvh", holed.with_name("o.bvh"), force=True)["certainty"]["ring_tip"]
    assert said["measured"] + said["inferred"] + said["lost"] == pytest.approx(1.0, abs=1e-5)
    assert said["lost"] > 0.1 and 0 < said["sd_m"] < 0.1
