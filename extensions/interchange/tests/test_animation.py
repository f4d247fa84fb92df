"""BVH and glTF files, read by bvhio and pygltflib."""

from collections.abc import Callable
from pathlib import Path

import bvhio
import numpy as np
import pytest
from pygltflib import GLTF2
from scipy.spatial.transform import Rotation

from tracker.messages import Estimate
from tracker.session.export.axes import AXES
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export

Y_UP = AXES["y-up"].rows


@pytest.fixture
def tracked(tmp_path: Path, record: Callable[..., Path], maker) -> tuple[Path, list[Estimate]]:
    """Thirty random poses at 100 Hz, the thumb's keypoint 3 and angle 2 lost in some."""
    estimates = [maker.estimate(10.0 * k, lost=k % 10 > 7) for k in range(30)]
    return record(tmp_path / "in.mcap", estimates), estimates


def test_bvh_joints_have_our_positions(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "bvh", tmp_path / "o.bvh", ExportOptions(units="m"))
    root = bvhio.readAsHierarchy(str(tmp_path / "o.bvh"))
    for k in (0, 7, 25):
        root.loadPose(k)
        found = {joint.Name: np.array(joint.PositionWorld) for joint, _, _ in root.layout()}
        for name, wanted in zip(session_info.keypoint_names, estimates[k].keypoints, strict=True):
            if name in found:
                assert np.linalg.norm(found[name] - Y_UP @ wanted) < 1e-4, name
        assert {"wrist", "index_pip", "thumb_ip"} <= found.keys()


def test_gltf_animation_in_pygltflib(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "glb", tmp_path / "o.glb")
    gltf = GLTF2().load(str(tmp_path / "o.glb"))
    blob, k = gltf.binary_blob(), 7

    def values(accessor: int, width: int) -> np.ndarray:
        a = gltf.accessors[accessor]
        start = gltf.bufferViews[a.bufferView].byteOffset
        return np.frombuffer(blob, "<f4", a.count * width, start).reshape(-1, width)

    animation = gltf.animations[0]
    rotation, place = {}, np.zeros(3)
    for channel in animation.channels:
        output = animation.samplers[channel.sampler].output
        if channel.target.path == "rotation":
            rotation[channel.target.node] = values(output, 4)[k]
        else:
            place = values(output, 3)[k]
    found: dict[str, np.ndarray] = {}

    def walk(node: int, R: np.ndarray, p: np.ndarray) -> None:
        n = gltf.nodes[node]
        if node not in rotation:
            return
        p = p + R @ (place if node == 0 else np.array(n.translation))
        found[n.name] = p
        for child in n.children or []:
            walk(child, R @ Rotation.from_quat(rotation[node]).as_matrix(), p)

    walk(0, np.eye(3), np.zeros(3))
    assert len(found) > 10
    for name, p in found.items():
        wanted = estimates[k].keypoints[session_info.keypoint_names.index(name)]
        assert np.linalg.norm(p - Y_UP @ wanted) < 1e-4, name
