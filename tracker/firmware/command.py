"""``glovetrack firmware``."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from tracker.terminal import add_json, finish


def add_commands(commands: Any) -> None:
    """Sub-commands ``firmware show`` and ``firmware write``."""
    parser = commands.add_parser("firmware", help="what runs in the glove, and writing it anew")
    actions = parser.add_subparsers(title="actions", metavar="ACTION", required=True)
    show = actions.add_parser("show", help="versions: what comes with the program, and the glove's")
    show.add_argument("port", nargs="?", help="of the glove, /dev/ttyUSB0 or COM5; without: all")
    add_json(show)
    show.set_defaults(func=_show)
    write = actions.add_parser("write", help="write it into a glove, and have it read back")
    write.add_argument("port", help="of the glove, as /dev/ttyUSB0 or COM5")
    write.add_argument("--glove-id", type=int, help="tells gloves apart; without: as it is, else 1")
    write.add_argument("--baud", type=int, default=250_000, help="of the glove's port: or 115200")
    write.add_argument("--image", type=Path, help="an Intel HEX file instead of the program's")
    write.add_argument("--old-bootloader", action="store_true", help="of early Nanos: 57600 baud")
    write.set_defaults(func=_write)


def _show(args: argparse.Namespace) -> int:
    from tracker.firmware.image import shipped_image, version_text
    from tracker.firmware.versions import advice
    from tracker.sensors.discovery import find_gloves

    ours = shipped_image().version
    found = [r for r in find_gloves([args.port] if args.port else None) if r.hello is not None]
    gloves = [
        {"port": r.path, "glove_id": r.hello.glove_id, "version": version_text(r.hello.firmware)}
        for r in found
        if r.hello is not None
    ]
    told = [f"comes with the program: {version_text(ours)}"]
    told += [f"{g['port']}: glove {g['glove_id']}, {g['version']}" for g in gloves]
    told += [advice(r.hello.firmware) for r in found if r.hello is not None]
    told += [] if gloves else ["no glove answers"]
    finish(args, {"shipped": version_text(ours), "gloves": gloves}, filter(None, told))
    return 0


def _write(args: argparse.Namespace) -> int:
    from tracker.firmware.flash import BOOTLOADERS, FlashJob, flash
    from tracker.firmware.image import read_image, shipped_image, version_text
    from tracker.firmware.versions import greeting

    image = read_image(args.image) if args.image else shipped_image(args.baud)
    before = greeting(args.port)
    number = args.glove_id or (before.glove_id if before else image.glove_id)
    kind = "old Nano" if args.old_bootloader else "Optiboot"
    flash(FlashJob(image.for_glove(number), args.port, BOOTLOADERS[kind]))
    version = version_text(image.version)
    print(f"{args.port}: firmware {version} is written and read back, glove {number}")
    after = greeting(args.port)
    if after is None:
        print("It does not say HELLO yet: unplug it and plug it in again.")
    return 0
