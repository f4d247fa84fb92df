"""Finds the glove's port again after it was unplugged, by its adapter or its own number.

Systems number ports in the order of connection, so a glove may return as ``ttyUSB1`` or ``COM8``,
and another glove may have its old port. An adapter is identified by its serial number; one
without (many CH340) by its type, and the glove by the number in its HELLO.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tracker.sensors.protocol import BAUD
from tracker.sensors.serial_line import Port, UsbPort, real_path, serial_port, usb_ports


class GlovePort:
    """Opens the port of one glove; `GloveLink` calls it again after each disconnection.

    ``path`` is the port opened last, ``home`` the port where the glove was found last; empty for
    one that is identified only by its ``glove_id``, which is searched at all ports.
    Ports in use by another program are left alone.
    """

    def __init__(
        self,
        path: str,
        baud: int = BAUD,
        ports: Callable[[], Sequence[UsbPort]] = usb_ports,
        open_at: Callable[[str, int], Callable[[], Port]] = serial_port,
        glove_id: int | None = None,
    ) -> None:
        self.path = path
        self.glove_id = glove_id
        """For the glove that answered first; only this one is searched afterwards."""
        self.home, self._baud, self._ports, self._open_at = path, baud, ports, open_at
        self._adapter: UsbPort | None = None
        self._refused: set[str] = set()

    @property
    def adapter(self) -> UsbPort | None:
        """The USB adapter of the glove; None if the port is not listed."""
        return self._adapter

    @property
    def has_twin(self) -> bool:
        """Whether another adapter has the same serial number, so that it does not
        distinguish the gloves."""
        own = self._adapter
        if own is None or not own.serial_number:
            return False
        return sum(port[1:] == own[1:] for port in self._ports()) > 1

    def __call__(self) -> Port:
        """Returns the glove's open port. Raises OSError if there is none."""
        problem: OSError | None = None
        ports = self._ports()
        for path in self._places(ports):
            try:
                port = self._open_at(path, self._baud)()
            except OSError as error:
                problem = problem or error
                continue
            self.path = path
            if self.home:
                self._adapter = self._adapter or _at(path, ports)
            return port
        if not self.home:
            raise FileNotFoundError(2, f"glove {self.glove_id} is not plugged in")
        raise problem or FileNotFoundError(2, "No such file or directory", self.home)

    def is_right(self, glove_id: int | None) -> bool:
        """Whether the glove that answered at `path` (None: it sent nothing) is the expected one.

        If not, its port is tried last from now on.
        """
        if self.glove_id is None:
            self.glove_id = glove_id
        if glove_id == self.glove_id or (glove_id is None and self.path == self.home):
            self.home = self.path
            self._adapter = _at(self.path, self._ports()) or self._adapter
            self._refused.clear()
            return True
        self._refused.add(self.path)
        return False

    def _places(self, ports: Sequence[UsbPort]) -> list[str]:
        """Candidate ports, the most likely first; an unlisted port is assumed to be unchanged."""
        own = self._adapter if self.home else None
        if own is None and self.home:
            return [self.home]
        alike = [p.path for p in ports if own is None or p[1:] == own[1:]]
        if real_path(self.home) in alike:
            alike = [self.home, *(p for p in alike if p != real_path(self.home))]
        if self._refused.issuperset(alike):
            self._refused.clear()
        return [p for p in alike if p not in self._refused]


def _at(path: str, ports: Sequence[UsbPort]) -> UsbPort | None:
    return next((p for p in ports if p.path == real_path(path)), None)
