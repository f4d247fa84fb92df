"""``glovetrack openxr``: the layer registered for this user, and which applications read the hand.

Functions import what they need, so that ``glovetrack --help`` is fast.
"""

from __future__ import annotations

import argparse

from tracker.base.command import Command


def _register(_args: argparse.Namespace) -> None:
    from extensions.openxr.registration import user_registration

    registration = user_registration()
    registration.register()
    print(f"The OpenXR layer is registered: {registration.manifest}")
    print("Applications that are started from now on read the hand while the stream is on:")
    print("    glovetrack demo --stream openxr")


def _unregister(_args: argparse.Namespace) -> None:
    from extensions.openxr.registration import Registered, user_registration

    registration = user_registration()
    was = registration.state()
    registration.unregister()
    if was == Registered.NO:
        print("The OpenXR layer was not registered.")
    else:
        print("The OpenXR layer is unregistered.")


def _status(_args: argparse.Namespace) -> int:
    from extensions.openxr.readers import link_lines, read_link
    from extensions.openxr.registration import Registered, user_registration

    found = user_registration().state()
    print(f"layer: {found.value}")
    for line in link_lines(read_link()):
        print(line)
    return 0 if found == Registered.YES else 1


OPENXR = Command[argparse.Namespace](
    "openxr", "register the OpenXR layer, and show which applications read the hand"
)
REGISTER = Command[argparse.Namespace](
    "openxr register",
    "register the layer for this user",
    _register,
    description="Copies the layer into the user's data folder and adds it to the layers of the "
    "OpenXR loader. OpenXR applications that this user starts then have hand tracking.",
)
UNREGISTER = Command[argparse.Namespace](
    "openxr unregister", "remove the layer of this user", _unregister
)
STATUS = Command[argparse.Namespace](
    "openxr status",
    "show whether the layer is registered and which applications read the hand",
    _status,
    description="The exit status is 0 if the layer is registered.",
)
