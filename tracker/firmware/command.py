"""``glovetrack firmware``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.notices import warning
from tracker.base.terminal import add_json, finish


def _add_show(show: argparse.ArgumentParser) -> None:
    show.add_argument(
        "port",
        nargs="?",
        help="serial port of the glove, such as /dev/ttyUSB0 or COM5 (default: all ports)",
    )
    add_json(show)


def _add_write(write: argparse.ArgumentParser) -> None:
    write.add_argument("port", help="serial port of the glove, such as /dev/ttyUSB0 or COM5")
    write.add_argument(
        "--glove-id",
        type=int,
        help="number that identifies the glove (default: its current number, or 1)",
    )
    write.add_argument(
        "--baud",
        type=int,
        default=250_000,
        help="baud rate of the new firmware: 250000 (default) or 115200",
    )
    write.add_argument(
        "--image", type=Path, help="Intel HEX file to write instead of the bundled firmware"
    )
    write.add_argument(
        "--old-bootloader",
        action="store_true",
        help="use the 57600 baud bootloader of early Arduino Nanos",
    )


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
    lines = [f"bundled: {version_text(ours)}"]
    lines += [f"{g['port']}: glove {g['glove_id']}, {g['version']}" for g in gloves]
    available = (advice(r.hello.firmware) for r in found if r.hello is not None)
    lines += [str(newer) for newer in available if newer is not None]
    lines += [] if gloves else ["no glove responded"]
    finish(args, {"shipped": version_text(ours), "gloves": gloves}, lines)
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
    print(f"{args.port}: firmware {version} written and verified, glove {number}")
    after = greeting(args.port)
    if after is None:
        print(warning("firmware.no_response"))
    return 0


FIRMWARE = Command[argparse.Namespace]("firmware", "show or write the glove's firmware")
SHOW = Command(
    "firmware show",
    "show the versions of the bundled firmware and of the connected gloves",
    _show,
    add=_add_show,
)
WRITE = Command("firmware write", "write firmware to a glove and verify it", _write, add=_add_write)
