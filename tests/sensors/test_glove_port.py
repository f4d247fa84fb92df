"""A glove that returns at another port is found there; other devices are not disturbed."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from tests.sensors.scripted_glove import N, Run, Scripted
from tracker.base.notices import notice, warning
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.link_params import LinkState
from tracker.sensors.protocol import BAUD, Hello
from tracker.sensors.serial_line import Port, UsbPort

FTDI, WCH = (0x0403, 0x6001), (0x1A86, 0x7523)


class Desk:
    """Gloves at ports of a computer: the list, and the device at each port."""

    def __init__(self) -> None:
        self.listed: list[UsbPort] = []
        self.behind: dict[str, Scripted] = {}
        self.opened: list[str] = []
        self.held: set[str] = set()  # by another program

    def plug(self, path: str, glove: Scripted, kind: tuple[int, int], number: str | None) -> None:
        self.listed.append(UsbPort(path, *kind, number))
        self.behind[path] = glove

    def unplug(self, path: str) -> None:
        self.listed = [p for p in self.listed if p.path != path]
        glove = self.behind.pop(path)
        glove.streaming, glove.seq, glove.out, glove.gone = False, 0, b"", True

    def open_at(self, path: str, baud: int) -> Callable[[], Port]:
        def opened() -> Port:
            assert baud == BAUD
            if path not in self.behind:
                raise FileNotFoundError(2, "No such file or directory", path)
            if path in self.held:
                raise BlockingIOError(11, "Resource temporarily unavailable")
            self.opened.append(path)
            self.behind[path].gone = False
            return self.behind[path]

        return opened

    def port(self, path: str) -> GlovePort:
        return GlovePort(path, ports=lambda: self.listed, open_at=self.open_at)


def numbered(number: int) -> Scripted:
    return Scripted(Hello(number, N))


@pytest.fixture
def desk() -> Desk:
    return Desk()


def streaming(desk: Desk, glove: Scripted) -> Run:
    run = Run(glove, desk.port("/dev/ttyUSB0"))
    run.go(1.0)
    assert len(run.samples) > 80
    return run


def test_it_is_found_at_another_path_by_its_adapters_serial_number(desk: Desk) -> None:
    mine, other = numbered(11), numbered(22)
    desk.plug("/dev/ttyUSB0", mine, FTDI, "A1")
    desk.plug("/dev/ttyUSB1", other, FTDI, "B2")
    run = streaming(desk, mine)
    desk.unplug("/dev/ttyUSB0")
    run.go(1.0)
    desk.plug("/dev/ttyUSB2", mine, FTDI, "A1")
    before = len(run.samples)
    run.go(2.0)
    assert len(run.samples) > before + 100
    assert run.notices[-1] == notice("glove.back_at", port="/dev/ttyUSB2")
    assert desk.opened == ["/dev/ttyUSB0", "/dev/ttyUSB2"], "the other adapter was not touched"
    assert run.link.figures.reopened == 1


def test_its_return_is_reported_once_also_at_its_old_path(desk: Desk) -> None:
    mine = numbered(11)
    desk.plug("/dev/ttyUSB0", mine, FTDI, "A1")
    run = streaming(desk, mine)
    desk.unplug("/dev/ttyUSB0")
    run.go(1.0)
    desk.plug("/dev/ttyUSB0", mine, FTDI, "A1")
    run.go(3.0)
    assert run.notices.count(notice("glove.back_at", port="/dev/ttyUSB0")) == 1
    assert run.link.state == LinkState.STREAMING


def test_its_old_path_is_not_used_if_another_adapter_has_it(desk: Desk) -> None:
    mine, other = numbered(11), numbered(22)
    desk.plug("/dev/ttyUSB0", mine, FTDI, "A1")
    run = streaming(desk, mine)
    desk.unplug("/dev/ttyUSB0")
    run.go(0.2)
    desk.plug("/dev/ttyUSB0", other, FTDI, "B2")
    desk.plug("/dev/ttyUSB1", mine, FTDI, "A1")
    run.go(2.0)
    assert run.link.state == LinkState.STREAMING
    assert desk.opened == ["/dev/ttyUSB0", "/dev/ttyUSB1"]


def test_adapters_without_serial_numbers_are_distinguished_by_the_glove(desk: Desk) -> None:
    mine, other = numbered(11), numbered(22)
    desk.plug("/dev/ttyUSB0", mine, WCH, None)
    run = streaming(desk, mine)
    desk.unplug("/dev/ttyUSB0")
    run.go(0.2)
    desk.plug("/dev/ttyUSB0", other, WCH, None)
    run.go(2.0)
    assert run.link.state != LinkState.STREAMING and not other.streaming
    stranger = warning("glove.stranger", port="/dev/ttyUSB0", found=22, glove_id=11)
    assert stranger in run.notices
    desk.plug("/dev/ttyUSB1", mine, WCH, None)
    before = len(run.samples)
    run.go(3.0)
    assert len(run.samples) > before + 100 and mine.streaming
    assert run.link.hello == Hello(11, N)
    assert sum(code.startswith("glove.stranger") for code in run.codes) == 1


def test_a_port_used_by_another_program_is_not_touched(desk: Desk) -> None:
    mine, other = numbered(11), numbered(22)
    desk.plug("/dev/ttyUSB0", mine, WCH, None)
    desk.plug("/dev/ttyUSB1", other, WCH, None)
    desk.held.add("/dev/ttyUSB1")
    run = streaming(desk, mine)
    desk.unplug("/dev/ttyUSB0")
    run.go(2.0)
    assert "/dev/ttyUSB1" not in desk.opened
    desk.plug("/dev/ttyUSB7", mine, WCH, None)
    run.go(2.0)
    assert desk.opened[-1] == "/dev/ttyUSB7" and run.link.state == LinkState.STREAMING


def test_a_device_that_sends_nothing_is_never_started(desk: Desk) -> None:
    mine, silent = numbered(11), Scripted(None)
    desk.plug("/dev/ttyUSB0", mine, WCH, None)
    run = streaming(desk, mine)
    desk.unplug("/dev/ttyUSB0")
    desk.plug("/dev/ttyUSB1", silent, WCH, None)
    run.go(6.0)
    assert not silent.streaming
    stranger = warning("glove.stranger_unknown", port="/dev/ttyUSB1", glove_id=11)
    assert stranger in run.notices


def test_an_unlisted_port_is_opened_at_its_old_path(desk: Desk) -> None:
    """A pseudo-terminal, Bluetooth, or a link created by udev."""
    mine = numbered(11)
    desk.behind["/dev/rfcomm0"] = mine
    run = Run(mine, desk.port("/dev/rfcomm0"))
    run.go(1.0)
    mine.gone = True
    del desk.behind["/dev/rfcomm0"]
    run.go(1.0)
    assert run.link.state == LinkState.UNPLUGGED
    desk.behind["/dev/rfcomm0"] = mine
    mine.streaming = False
    run.go(2.0)
    assert run.link.state == LinkState.STREAMING
