"""Runs inside Blender: imports a recording with the add-on, or receives one datagram for each hand,
and writes what the armatures show as JSON. Arguments after ``--``: mode, source, output, add-on."""

import json
import sys
import time
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path

import bpy

mode, source, out, addon = sys.argv[sys.argv.index("--") + 1 :]
spec = spec_from_file_location("glovetrack_blender", addon)
assert spec is not None and spec.loader is not None
module = module_from_spec(spec)
spec.loader.exec_module(module)
module.register()


def shown() -> dict[str, dict[str, dict[str, object]]]:
    """By armature and bone: head, y and z axes in the world, state and sd."""
    found = {}
    for thing in bpy.data.objects:
        if thing.type == "ARMATURE":
            found[thing.name] = {
                bone.name: {
                    "position": list((thing.matrix_world @ bone.matrix).translation),
                    "y": list((thing.matrix_world @ bone.matrix).col[1][:3]),
                    "z": list((thing.matrix_world @ bone.matrix).col[2][:3]),
                    "state": bone["state"],
                    "sd": bone["sd"],
                    "parent": bone.parent.name if bone.parent else None,
                }
                for bone in thing.pose.bones
            }
    return found


scene = bpy.context.scene
if mode == "import":
    scene.render.fps = 20
    assert bpy.ops.import_scene.glovetrack(filepath=source) == {"FINISHED"}
    frames = []
    for frame in range(1, 20):
        scene.frame_set(frame)
        frames.append(shown())
    Path(out).write_text(json.dumps(frames))
else:
    receiver = module.Receiver(0)
    Path(source).write_text(str(receiver.port))
    end = time.monotonic() + 60
    while len(receiver.armatures) < 2 and time.monotonic() < end:
        receiver.poll()
        time.sleep(0.02)
    bpy.context.view_layer.update()
    Path(out).write_text(json.dumps(shown() | {"refused": receiver.refused}))
    receiver.close()
module.unregister()
