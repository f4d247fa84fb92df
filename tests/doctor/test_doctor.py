"""The doctor on computers with broken devices, each in one way."""

from __future__ import annotations

import errno
import json
from dataclasses import replace
from pathlib import Path

import cv2
import pytest

import tracker.doctor.command_runs
from tests.doctor.fake_devices import (
    HELLO,
    PORT,
    FakeCamera,
    FakeCapture,
    FakeClock,
    TunableGlove,
    bare,
    refuse,
    with_camera,
    with_glove,
)
from tests.notices import shows
from tests.sensors.scripted_glove import Scripted
from tracker.base.errors import DeviceError
from tracker.base.notices import notice, plain
from tracker.cli import main
from tracker.doctor.cameras import cameras
from tracker.doctor.command_runs import report_text
from tracker.doctor.computer import _priority, disk, graphics
from tracker.doctor.finding import CHECKS, Check, Finding, Verdict, examine
from tracker.doctor.gloves import gloves
from tracker.doctor.machine import Machine, writing_speed
from tracker.doctor.permissions import permissions
from tracker.sensors.protocol import ErrorText, GloveStatus, Samples


def bad(findings) -> list[str]:
    """The lines that are not ok."""
    return [f.line for f in findings if f.verdict != Verdict.OK]


def test_a_healthy_glove_and_camera_have_no_complaint(tmp_path: Path) -> None:
    found = list(gloves(with_glove(tmp_path, Scripted(HELLO), duration=4.0)))
    assert bad(found) == []
    values = {k: v for f in found for k, v in f.values.items()}
    assert values["rate_hz"] == pytest.approx(100, abs=0.5)
    assert values["skew_ppm"] == pytest.approx(-80, abs=40)  # as in the scripted glove
    seen = list(cameras(with_camera(tmp_path, FakeCamera(FakeClock()))))
    assert bad(seen) == []
    assert seen[0].values["measured_fps"] == pytest.approx(30, rel=0.02)


def test_a_port_without_permission_has_the_group_as_remedy(tmp_path: Path) -> None:
    machine = bare(
        tmp_path,
        usb_ports=lambda: [PORT],
        open_port=refuse(errno.EACCES),
        is_accessible=lambda path: False,
    )
    (line,) = bad(permissions(machine))
    assert line.startswith("error") and "dialout" in line and PORT.path in line
    assert any(shows(text, "doctor.join_group", group="dialout") for text in bad(gloves(machine)))


def test_a_port_in_use_by_another_program_is_an_error(tmp_path: Path) -> None:
    machine = bare(tmp_path, usb_ports=lambda: [PORT], open_port=refuse(errno.EBUSY))
    lines = bad(gloves(machine))
    assert lines[0].startswith("error") and "another program has it open" in lines[0]


def test_a_port_in_use_by_this_window_is_not_opened(tmp_path: Path) -> None:
    machine = bare(tmp_path, usb_ports=lambda: [PORT], in_use=frozenset({PORT.path}))
    (found,) = gloves(machine)
    assert found.verdict == Verdict.OK and found.what.code == "doctor.in_use"


@pytest.mark.parametrize("baud", [57_600, 1_000_000])
def test_a_wrong_baud_rate_is_named(tmp_path: Path, baud: int) -> None:
    glove = TunableGlove(HELLO)
    glove.own_baud = baud
    (line,) = [b for b in bad(gloves(with_glove(tmp_path, glove))) if b.startswith("error")]
    assert f"sends at {baud} baud" in line and "--baud 250000" in line


def test_bytes_of_another_device_are_a_warning(tmp_path: Path) -> None:
    glove = TunableGlove(HELLO)
    glove.own_baud = 3
    lines = bad(gloves(with_glove(tmp_path, glove)))
    assert lines[0].startswith("warning") and shows(lines[0], "doctor.not_decoded")


def test_a_latency_timer_of_16_ms_has_the_command_as_remedy(tmp_path: Path) -> None:
    timer = tmp_path / "sys/bus/usb-serial/devices/ttyUSB0/latency_timer"
    timer.parent.mkdir(parents=True)
    timer.write_text("16\n")
    (line,) = bad(gloves(with_glove(tmp_path, Scripted(HELLO))))
    assert (
        shows(line, "port.latency_linux", latency_ms=16, setting=timer) and f"tee {timer}" in line
    )
    timer.write_text("1\n")
    assert bad(gloves(with_glove(tmp_path, Scripted(HELLO)))) == []


class Lossy(Scripted):
    """One packet in ten is damaged on the cable."""

    def put(self, *frames: object) -> None:
        for frame in frames:
            before = len(self.out)
            super().put(frame)
            if isinstance(frame, Samples) and frame.seq % 10 == 3:
                self.out = self.out[: before + 4] + b"\x55" + self.out[before + 5 :]


def test_a_bad_cable_is_seen_in_its_damaged_packets(tmp_path: Path) -> None:
    (line,) = bad(gloves(with_glove(tmp_path, Lossy(HELLO))))
    assert "damaged" in line and shows(line, "doctor.shorter_cable")


class Ailing(Scripted):
    """IMU 1 does not answer, the self-test of IMU 2 failed, and the battery is low."""

    def packet(self, t: float) -> Samples:
        if self.seq == 0:
            self.put(GloveStatus(3300, 3100, 0b101, 0))
            self.put(ErrorText("gyroscope self-test failed on IMU 2"))
        samples = super().packet(t)
        samples.raw[1] = -32768
        return samples


def test_broken_imus_and_a_low_battery_are_separate_lines(tmp_path: Path) -> None:
    lines = bad(gloves(with_glove(tmp_path, Ailing(HELLO))))
    assert [line.split()[0] for line in lines] == ["warning", "error", "warning"]
    assert "3.30 V" in lines[0] and "respond: 1." in lines[1] and "self-test" in lines[2]


class Unstreaming(Scripted):
    """Sends HELLO but never streams."""

    def step(self) -> None:
        self.streaming = False
        super().step()


def test_a_glove_that_sends_no_samples_is_an_error(tmp_path: Path) -> None:
    (line,) = bad(gloves(with_glove(tmp_path, Unstreaming(HELLO))))
    assert line.startswith("error") and shows(line, "doctor.no_samples")


def test_two_adapters_with_one_serial_number_are_reported(tmp_path: Path) -> None:
    twin = PORT._replace(path="/dev/ttyUSB1")
    machine = bare(
        tmp_path, usb_ports=lambda: [PORT, twin], in_use=frozenset({PORT.path, twin.path})
    )
    assert shows(bad(gloves(machine))[0], "doctor.twin_adapters")


# ---- cameras


def test_a_slow_grant_has_the_usb_port_as_remedy(tmp_path: Path) -> None:
    camera = FakeCamera(FakeClock(), fps=10.0, granted=(1280, 720, 10.0))
    (line,) = bad(cameras(with_camera(tmp_path, camera)))
    assert line.startswith("error") and shows(line, "camera.slow_grant", rate_hz=10, format="YUYV")


def test_a_camera_slower_than_granted_is_an_error(tmp_path: Path) -> None:
    camera = FakeCamera(FakeClock(), fps=12.0)
    (line,) = bad(cameras(with_camera(tmp_path, camera)))
    assert shows(line, "doctor.camera_slow", measured_fps=12, granted_fps=30) and "light" in line


def test_another_size_than_requested_is_an_error(tmp_path: Path) -> None:
    camera = FakeCamera(FakeClock(), granted=(640, 480, 30.0))
    assert shows(
        bad(cameras(with_camera(tmp_path, camera)))[0],
        "camera.size_not_granted",
        width=640,
        asked_height=720,
    )


def test_an_exposure_that_cannot_be_verified_is_never_ok(tmp_path: Path) -> None:
    without = FakeCamera(FakeClock(), capture=FakeCapture({}, has_exposure=False))
    assert shows(bad(cameras(with_camera(tmp_path, without)))[0], "doctor.no_exposure")
    unheeding = FakeCamera(FakeClock(), capture=FakeCapture({}, keeps_lock=False))
    assert shows(bad(cameras(with_camera(tmp_path, unheeding)))[0], "doctor.exposure_unverified")


def test_the_exposure_is_automatic_again_after_the_test(tmp_path: Path) -> None:
    camera = FakeCamera(FakeClock())
    list(cameras(with_camera(tmp_path, camera)))
    assert camera.capture.values[cv2.CAP_PROP_AUTO_EXPOSURE] == 3.0


def test_dark_absent_and_refusing_cameras_are_distinguished(tmp_path: Path) -> None:
    assert "cover" in bad(cameras(with_camera(tmp_path, FakeCamera(FakeClock(), dark=True))))[0]
    imageless = FakeCamera(FakeClock(), images=0)
    assert shows(bad(cameras(with_camera(tmp_path, imageless)))[0], "doctor.no_images")

    class Busy(FakeCamera):
        def open(self) -> None:
            raise DeviceError(plain("The camera 0 is in use by another program."))

    assert "another program" in bad(cameras(with_camera(tmp_path, Busy(FakeClock()))))[0]


def test_time_stamps_of_the_driver_are_recognised(tmp_path: Path) -> None:
    with_stamps = list(cameras(with_camera(tmp_path, FakeCamera(FakeClock()))))[-1]
    without = list(cameras(with_camera(tmp_path, FakeCamera(FakeClock(), stamps=False))))[-1]
    assert "stamp_jitter_ms" in with_stamps.values and "stamp_jitter_ms" not in without.values


# ---- the computer


def test_tracking_that_waits_for_other_programs_has_a_remedy(tmp_path: Path) -> None:
    """It is not a warning: an idle computer needs no priority."""
    granted = _priority(bare(tmp_path, may_run_first=lambda: True))
    refused = _priority(bare(tmp_path, may_run_first=lambda: False))
    assert granted.what.code == "doctor.urgent" and granted.remedy is None
    assert refused.verdict == Verdict.OK and refused.remedy is not None
    assert "rtprio" in str(refused.remedy)


def test_slow_full_and_forbidden_disks(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    slow = bare(tmp_path, writing_speed=lambda folder, size: 12.0)
    assert shows(bad(disk(slow))[0], "doctor.disk_speed", disk_mb_s=12)
    monkeypatch.setattr("tracker.doctor.computer.free_bytes", lambda folder: 2e9)
    assert shows(bad(disk(bare(tmp_path)))[0], "doctor.free_disk")

    def forbid(folder: Path, size: int) -> float:
        raise PermissionError(errno.EACCES, "no")

    assert shows(
        bad(disk(bare(tmp_path, writing_speed=forbid)))[0],
        "file.not_writable",
        why="you may not write there",
    )


def test_the_disk_is_measured_and_left_clean(tmp_path: Path) -> None:
    assert writing_speed(tmp_path, 1) > 0
    assert list(tmp_path.iterdir()) == []


def test_graphics_cards_of_linux(tmp_path: Path) -> None:
    assert shows(bad(graphics(bare(tmp_path)))[0], "doctor.no_graphics")
    node = tmp_path / "dev/dri/renderD128"
    node.parent.mkdir(parents=True)
    node.touch()
    assert bad(graphics(bare(tmp_path))) == []
    assert "render,video" in bad(graphics(bare(tmp_path, is_accessible=lambda path: False)))[0]


# ---- the command


def test_a_check_that_fails_does_not_stop_the_others(tmp_path: Path) -> None:
    def fail(machine: Machine):
        raise ZeroDivisionError("oops")

    fine = Finding(notice("doctor.compiled"))
    checks = [Check("b", "B", lambda m: [fine], 2), Check("a", "A", fail, 1)]
    results = list(examine(bare(tmp_path), checks))
    assert [r.finding.verdict for r in results] == ["warning", "ok"]
    assert "oops" in results[0].finding.line


def test_the_command_writes_json_and_a_report(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    slow = replace(bare(tmp_path), writing_speed=lambda folder, size: 12.0)
    monkeypatch.setattr(tracker.doctor.command_runs, "Machine", lambda folder, fps: slow)
    out, report = tmp_path / "d.json", tmp_path / "report.txt"
    words = ["doctor", "--only", "disk", "system", "--json", str(out), "-o", str(report)]
    assert main(words) == 1  # a slow disk is an error
    found = json.loads(out.read_text())
    assert not found["ok"]
    assert {"check", "verdict", "code", "what", "remedy", "values"} == set(found["findings"][0])
    printed = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in printed] == [f["verdict"] for f in found["findings"]]
    text = report.read_text()
    assert "numpy" in text and "\nDisk\n" in text and "disk_mb_s 12" in text
    with pytest.raises(SystemExit, match="2"):
        main(["doctor", "--only", "kitchen"])


def test_the_report_does_not_name_the_user(tmp_path: Path) -> None:
    check = Check(
        "a", "A", lambda machine: [Finding(notice("doctor.in_use", device=f"{Path.home()}/x"))]
    )
    assert str(Path.home()) not in report_text(list(examine(bare(tmp_path), [check])))


def test_all_checks_are_registered_in_their_order() -> None:
    found = sorted(CHECKS.all().values(), key=lambda check: check.order)
    assert [c.name for c in found][:4] == ["system", "processor", "disk", "graphics"]
    assert {"permissions", "gloves", "cameras"} <= {c.name for c in found}


def test_the_processor_is_measured_on_simulated_data() -> None:
    from tracker.doctor.computer import detection_s, tracking_s

    assert 0 < detection_s(1) < 10 and 0 < tracking_s(warm=0.2, span=0.2) < 60
