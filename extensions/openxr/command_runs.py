"""``glovetrack openxr``: the layer registered for this user, and which applications read hands."""

from __future__ import annotations

import argparse

from extensions.openxr.readers import link_lines, read_link
from extensions.openxr.registration import Registered, user_registration


def run_register(_args: argparse.Namespace) -> None:
    registration = user_registration()
    registration.register()
    print(f"The OpenXR layer is registered: {registration.manifest}")
    print("Applications that are started from now on read the hand while the stream is on:")
    print("    glovetrack demo --stream openxr")


def run_unregister(_args: argparse.Namespace) -> None:
    registration = user_registration()
    was = registration.state()
    registration.unregister()
    if was == Registered.NO:
        print("The OpenXR layer was not registered.")
    else:
        print("The OpenXR layer is unregistered.")


def run_status(_args: argparse.Namespace) -> int:
    found = user_registration().state()
    print(f"layer: {found.value}")
    for line in link_lines(read_link()):
        print(line)
    return 0 if found == Registered.YES else 1
