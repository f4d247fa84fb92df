"""The virtual place: a scripted hand points, grasps, rotates, scales and fades."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from extensions.applications.drawing import Line, Mesh, Text
from extensions.applications.interface import MotorCommand
from extensions.applications.place.place import THINGS
from extensions.applications.tests.hands import datas, outcomes, words
from tracker.simulation.scripted import Key

MIDDLE = np.array([0.36, 0.0, 0.05])
SETTINGS = {"place": MIDDLE.tolist(), "dwell": 0.4}
TO_TIP = {"grasp": (0.054, 0.038, -0.068), "pinch_index": (0.039, 0.026, -0.077)}
TO_TIP["pinch_middle"] = (0.053, -0.007, -0.074)


def aiming(label: str) -> tuple[float, float, float]:
    """The palm from which a finger that points along x points at a label."""
    (thing,) = [t for t in THINGS if t.name == label]
    x, y, z = (MIDDLE + thing.label + [-0.2, 0.0, 0.04]).tolist()
    return x - 0.119, y - 0.0235, z + 0.06


def at_object(gesture: str, sideways: float = 0.0, up: float = 0.0) -> tuple[float, float, float]:
    x, y, z = (MIDDLE + [0.0, -sideways, up] - TO_TIP[gesture]).tolist()
    return x, y, z


CHOOSE = [
    Key(0.0, "relaxed", aiming("Church")),
    Key(0.4, "point", aiming("Church")),
    Key(1.4, "point", aiming("Church")),
]


def then(*keys: Key) -> list[Key]:
    """After the church was chosen; times count from then."""
    return [*CHOOSE, *(k._replace(t=k.t + 1.4) for k in keys)]


def test_a_label_that_is_pointed_at_opens_its_object() -> None:
    found = outcomes("place", CHOOSE, **SETTINGS)
    assert datas(found, "choose")[0]["label"] == "Church"
    labels = [d.text for d in found[0].drawing if isinstance(d, Text)]
    assert labels == [t.name for t in THINGS]
    assert [d.text for d in found[-1].drawing if isinstance(d, Text)] == ["Church"]


def test_a_grasped_object_moves_and_turns_with_the_hand() -> None:
    here = at_object("grasp")
    keys = then(
        Key(0.5, "relaxed", here),
        Key(0.9, "grasp", here),
        Key(1.2, "grasp", here),
        Key(2.0, "grasp", (here[0], here[1] + 0.05, here[2]), (0.0, 0.0, 40.0)),
        Key(2.2, "grasp", (here[0], here[1] + 0.05, here[2]), (0.0, 0.0, 40.0)),
        Key(2.5, "relaxed", (here[0], here[1] + 0.05, here[2]), (0.0, 0.0, 40.0)),
    )
    moved = datas(outcomes("place", keys, **SETTINGS), "moved")
    assert max(m["turned_deg"] for m in moved) == pytest.approx(40.0, abs=1.5)


def test_a_pinch_slide_fades_the_source_over_the_object() -> None:
    keys = then(
        Key(0.5, "relaxed", at_object("pinch_index")),
        Key(0.9, "pinch_index", at_object("pinch_index")),
        Key(1.1, "pinch_index", at_object("pinch_index")),
        Key(1.7, "pinch_index", at_object("pinch_index", sideways=0.05)),
        Key(1.9, "pinch_index", at_object("pinch_index", sideways=0.05)),
        Key(2.2, "relaxed", at_object("pinch_index", sideways=0.05)),
    )
    found = outcomes("place", keys, **SETTINGS)
    faded = datas(found, "faded")[-1]
    assert faded["source"] == pytest.approx(
        0.5 + 0.05 / 0.12, abs=0.15
    )  # a pinch begins before it is closed
    meshes = [d for d in found[-1].drawing if isinstance(d, Mesh)]
    assert meshes[0].opacity == pytest.approx(1 - 0.85 * faded["source"])
    assert any(d.name.startswith("plan") for d in found[-1].drawing if isinstance(d, Line))


def test_a_pinch_of_the_middle_finger_scales_it() -> None:
    keys = then(
        Key(0.5, "relaxed", at_object("pinch_middle")),
        Key(0.9, "pinch_middle", at_object("pinch_middle")),
        Key(1.1, "pinch_middle", at_object("pinch_middle")),
        Key(1.9, "pinch_middle", at_object("pinch_middle", up=0.08)),
        Key(2.1, "pinch_middle", at_object("pinch_middle", up=0.08)),
        Key(2.4, "relaxed", at_object("pinch_middle", up=0.08)),
    )
    scaled = datas(outcomes("place", keys, **SETTINGS), "scaled")[-1]
    assert scaled["size"] == pytest.approx(2.0 * 2**0.8, rel=0.12)


def test_each_touch_buzzes_and_an_open_palm_goes_back() -> None:
    away = (0.1, 0.0, 0.2)
    keys = then(Key(0.5, "open_palm", away), Key(1.8, "open_palm", away))
    found = outcomes("place", keys, **SETTINGS)
    assert words(found)[-1] == "back"
    felt = [o.t for o in found for c in o.commands if isinstance(c, MotorCommand)]
    reported = [o.t for o in found if any(e.data["what"] in ("point", "choose") for e in o.events)]
    assert felt[0] == pytest.approx(reported[0])
    assert all(min(t - s for s in reported if s <= t + 1e-9) < 0.08 for t in felt)


@pytest.mark.parametrize("thing", THINGS, ids=lambda t: t.name)
def test_solids_are_closed_and_turned_outwards(thing) -> None:
    for solid, _ in thing.solids:
        mesh = trimesh.Trimesh(*solid)
        mesh.merge_vertices()
        mesh.update_faces(mesh.nondegenerate_faces())  # at poles two corners are one
        assert mesh.is_watertight
        assert mesh.volume > 0
