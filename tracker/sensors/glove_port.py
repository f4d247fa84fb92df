"""The glove's port, wherever it is after it was unplugged: by its adapter, by its own number.

Systems number ports in the order of their coming, so a glove may return as ``ttyUSB1`` or ``COM8``,
and another glove may stand where it was. An adapter with a serial number is known by that; one
without (many CH340) by its kind, and the glove behind it by the number in its HELLO.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from tracker.sensors.protocol import BAUD
from tracker.sensors.serial_line import Port, UsbPort, real_path, serial_port, usb_ports


class GlovePort:
    """Opens the port of one glove; `GloveLink` calls it again each time that the glove was gone.

    ``path`` is where it was opened last, ``home`` where the glove itself was last; empty for one
    that is known by its ``glove_id`` alone, which is looked for at all ports.
    Ports that another program holds are not disturbed.
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
        """For the glove that answered first; it is the one that is looked for."""
        self.home, self._baud, self._ports, self._open_at = path, baud, ports, open_at
        self._adapter: UsbPort | None = None
        self._refused: set[str] = set()

    @property
    def adapter(self) -> UsbPort | None:
        """The USB adapter of the glove; None where the port is on no list."""
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
        """The glove's port, open. Raises OSError where there is none."""
        trouble: OSError | None = None
        ports = self._ports()
        for path in self._places(ports):
            try:
                port = self._open_at(path, self._baud)()
            except OSError as error:
                trouble = trouble or error
                continue
            self.path = path
            if self.home:
                self._adapter = self._adapter or _at(path, ports)
            return port
        if not self.home:
            raise FileNotFoundError(2, f"glove {self.glove_id} is not plugged in")
        raise trouble or FileNotFoundError(2, "No such file or directory", self.home)

    def is_right(self, glove_id: int | None) -> bool:
        """Whether the glove that answered at `path` (None: it sent nothing) is the one looked for.

        Where not, its port is asked last from now on.
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
        """Where it may be, the likeliest first; a port that is on no list is where it was."""
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
