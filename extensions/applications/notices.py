"""Texts of the notices of this extension, by code."""

TEXTS = {
    "arm.not_command": "That is not a command for an arm: {why}.",
    "arm.address": 'A robot is at host:port, not "{address}".',
    "application.needs_package": (
        "The application {application} requires a package that is not installed ({why}).{install}"
    ),
    "swarm.address": 'Vehicles are at host:port, such as 127.0.0.1:14550, not "{address}".',
    "mesh.unknown": 'There is no mesh "{name}". For a file, include its extension.',
    "mesh.unknown_kind": "{path} is not a mesh that can be read: .obj or .stl.",
    "mesh.not_obj": "{name} is not an OBJ file: {why}.",
    "mesh.not_stl": "{name} is not an STL file: {why}.",
    "mesh.too_few": "{name} does not contain a mesh: a closed one has at least four triangles.",
    "mesh.bad_points": "{name} refers to points that it does not have, or that are not finite.",
    "applications.setting": 'A setting is KEY=VALUE, not "{text}".',
    "applications.none_recorded": "{path} contains no application.",
    "applications.address": 'A live stream is udp, udp:PORT or ws://HOST:PORT, not "{address}".',
    "applications.no_hand": "No hand was received at {where} within {wait_s:.0f} s.",
    "applications.no_side": "{path} contains no {side:word} hand.",
    "applications.no_server": "No program responds at {address}: {why}.",
}
