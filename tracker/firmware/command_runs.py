"""``glovetrack firmware``."""

from __future__ import annotations

from tracker.base.notices import warning
from tracker.base.terminal import finish
from tracker.firmware.command import FirmwareShowArguments, FirmwareWriteArguments
from tracker.firmware.flash import BOOTLOADERS, FlashJob, flash
from tracker.firmware.image import read_image, shipped_image, version_text
from tracker.firmware.versions import advice, greeting
from tracker.sensors.discovery import find_gloves


def run_show(args: FirmwareShowArguments) -> int:
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


def run_write(args: FirmwareWriteArguments) -> int:
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
