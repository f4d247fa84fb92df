"""Firmware images, and a real avrdude that writes them into a simulated bootloader."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.firmware.bootloader import Bootloader
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.cli import main
from tracker.firmware.flash import FlashError, FlashJob, flash
from tracker.firmware.image import BAUDS, FirmwareImage, read_image, shipped_image
from tracker.firmware.versions import advice, is_old

IS_CI = os.environ.get("CI") == "true"  # where a missing tool is a failure
has_avrdude = pytest.mark.skipif(
    shutil.which("avrdude") is None and not IS_CI, reason="needs avrdude"
)


@pytest.fixture
def bootloader() -> Iterator[Bootloader]:
    board = Bootloader()
    yield board
    board.close()


@pytest.mark.parametrize("baud", BAUDS)
def test_the_image_contains_its_version_and_accepts_a_number(baud: int) -> None:
    image = shipped_image(baud)
    other = image.for_glove(0x01020304)
    assert image.version == (1, 3, 0)
    assert (image.glove_id, other.glove_id) == (1, 0x01020304)
    differs = [i for i, (a, b) in enumerate(zip(image.data, other.data, strict=True)) if a != b]
    assert len(differs) == 4 and differs[-1] - differs[0] == 3


def test_images_for_two_speeds_differ() -> None:
    assert shipped_image(BAUDS[0]).data != shipped_image(BAUDS[1]).data
    with raises(ConfigError, "firmware.baud"):
        shipped_image(9600)


@pytest.mark.parametrize("number", [0, -1, 2**32])
def test_an_invalid_number_is_rejected(number: int) -> None:
    with raises(ConfigError, "firmware.number"):
        shipped_image().for_glove(number)


def test_a_written_file_is_read_back(tmp_path: Path) -> None:
    path, image = tmp_path / "glove.hex", shipped_image().for_glove(77)
    path.write_text(image.to_hex())
    assert read_image(path) == image


@pytest.mark.skipif(shutil.which("avr-objcopy") is None and not IS_CI, reason="needs avr-objcopy")
def test_objcopy_reads_the_same_bytes(tmp_path: Path) -> None:
    path, out, image = tmp_path / "glove.hex", tmp_path / "glove.bin", shipped_image()
    path.write_text(image.to_hex())
    subprocess.run(["avr-objcopy", "-I", "ihex", "-O", "binary", path, out], check=True)
    assert out.read_bytes() == image.data


def test_included_images_are_up_to_date(build: Path) -> None:
    """`make -C resources/firmware images` rebuilds them."""
    assert read_image(build / "glove.hex") == shipped_image().for_glove(7)


@pytest.mark.parametrize(
    ("spoil", "words"),
    [
        (lambda text: text.replace(":10", ":11", 1), "firmware.line_damaged"),
        (lambda text: text[: len(text) // 2], "firmware.line_damaged"),
        (lambda text: text.rsplit("\n", 2)[0], "firmware.cut_off"),
        (lambda text: text.split("\n", 1)[1], "firmware.line_unknown"),
        (lambda text: "hello", "firmware.line_damaged"),
        (lambda text: "", "firmware.cut_off"),
        (lambda text: FirmwareImage(b"x" * 64).to_hex(), "firmware.not_glove"),
        (
            lambda text: FirmwareImage(shipped_image().data + b"x" * 33000).to_hex(),
            "firmware.too_large",
        ),
    ],
)
def test_a_damaged_file_is_rejected(tmp_path: Path, spoil, words: str) -> None:
    path = tmp_path / "glove.hex"
    path.write_text(spoil(shipped_image().to_hex()))
    with raises(ConfigError, words):
        read_image(path)


@has_avrdude
def test_the_chip_contains_the_image_afterwards(
    bootloader: Bootloader, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tracker.firmware.command_runs.greeting", lambda _port: None)
    assert main(["firmware", "write", bootloader.port, "--glove-id", "42"]) == 0
    image = shipped_image().for_glove(42)
    assert bootloader.flash[: len(image.data)] == image.data
    assert "glove 42" in capsys.readouterr().out


@has_avrdude
def test_a_byte_that_is_not_stored_is_reported() -> None:
    board = Bootloader(spoils=4000)
    try:
        with raises(FlashError, "firmware.not_verified"):
            flash(FlashJob(shipped_image(), board.port))
    finally:
        board.close()


@has_avrdude
def test_a_missing_port_is_reported(tmp_path: Path) -> None:
    with raises(FlashError, "firmware.port_absent"):
        flash(FlashJob(shipped_image(), str(tmp_path / "ttyUSB9")))


def test_without_avrdude_its_package_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tracker.firmware.flash.avrdude_path", lambda: None)
    with raises(FlashError, "firmware.no_avrdude"):
        flash(FlashJob(shipped_image(), "/dev/null"))


def test_an_old_version_is_reported_and_a_newer_one_is_not() -> None:
    newer = advice((1, 0, 0))
    assert newer is not None and newer.values["installed"] == "1.0.0" and is_old((1, 0, 9))
    assert advice((1, 3, 0)) is None and advice((2, 0, 0)) is None
