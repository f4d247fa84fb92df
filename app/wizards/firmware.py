"""The firmware dialog: version of the glove's firmware, and writing the included one."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import (
    QComboBox,
    QFormLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QSpinBox,
    QWidget,
)

from app.engines.engine_host import EngineHost
from app.platform.tasks import TaskOwner
from app.wizards.form_dialog import FormDialog, filler, row_of
from app.words import error_text
from tracker.base.errors import GlovetrackError
from tracker.firmware.flash import BOOTLOADERS, FlashJob, flash
from tracker.firmware.image import BAUDS, shipped_image, version_text
from tracker.firmware.versions import advice, greeting
from tracker.sensors.discovery import PortReport, find_gloves, serial_ports
from tracker.sensors.protocol import Hello

LARGEST_NUMBER = 65535


class FirmwareSetup(FormDialog):
    """Stops tracking of a real glove before writing its firmware."""

    def __init__(
        self,
        host: EngineHost,
        tasks: TaskOwner,
        parent: QWidget | None = None,
        find: Callable[[], list[PortReport]] = find_gloves,
        write: Callable[[FlashJob], None] = flash,
        greet: Callable[[str], Hello | None] = greeting,
    ) -> None:
        super().__init__("firmware", (520, 340), parent)
        self._host, self._tasks = host, tasks
        self._find, self._write_with, self._greet = find, write, greet
        self._found: dict[str, PortReport] = {}
        self._is_busy = False
        self.setWindowTitle(self.tr("Glove firmware"))
        self.ports, self.speeds, self.boards = QComboBox(), QComboBox(), QComboBox()
        self.ports.setEditable(True)
        self.number = QSpinBox()
        self.number.setRange(1, LARGEST_NUMBER)
        self.number.setToolTip(self.tr("Identifies this glove; give each glove its own number"))
        for baud in BAUDS:
            self.speeds.addItem(self.tr("{} baud").format(baud), baud)
        self.speeds.setToolTip(self.tr("115200 for USB adapters without higher speeds"))
        self.boards.addItem(self.tr("Arduino, Optiboot"), BOOTLOADERS["Optiboot"])
        self.boards.addItem(self.tr("early Nano, old bootloader"), BOOTLOADERS["old Nano"])
        self.versions, self.words = QLabel(), QLabel()
        for label in (self.versions, self.words):
            label.setWordWrap(True)
        self.busy = QProgressBar()
        self.busy.setRange(0, 0)
        self.busy.hide()
        self.again.clicked.connect(self.look)
        self.write = QPushButton(self.tr("&Write and verify"))
        self.write.clicked.connect(self._write)
        self.lay_out((self.versions, self._form(), self.busy, self.words, filler()), self.write)
        self.ports.currentTextChanged.connect(lambda _path: self._show_versions())
        self.look()

    def _form(self) -> QFormLayout:
        form = QFormLayout()
        form.addRow(self.tr("Port"), row_of(self.ports, self.again))
        form.addRow(self.tr("&Number of the glove"), self.number)
        form.addRow(self.tr("&Speed"), self.speeds)
        form.addRow(self.tr("&Type of board"), self.boards)
        return form

    # --- available devices

    @property
    def _in_use(self) -> bool:
        """Whether the port of a real glove is in use by tracking."""
        setup = self._host.setup
        live = setup is not None and not setup.simulated and setup.player is None
        return live and setup is not None and setup.connection.present

    def look(self) -> None:
        """Query the ports that are not in use."""
        if self._in_use:
            self._show_ports([PortReport(path, None) for path in serial_ports()])
            self.words.setText(self.tr("The glove is in use. Writing stops tracking first."))
            return
        self._set_busy(True)
        self.words.setText(self.tr("Looking for gloves…"))
        self._tasks.run(
            self.tr("Looking for gloves"),
            lambda _progress: self._find(),
            self._show_ports,
            ended=lambda: self._set_busy(False),
        )

    def _show_ports(self, reports: list[PortReport]) -> None:
        self._found = {r.path: r for r in reports}
        self.ports.clear()
        self.ports.addItems([r.path for r in sorted(reports, key=lambda r: not r.is_glove)])
        self.words.setText("" if reports else self.tr("No serial port found. Plug the glove in."))
        self._show_versions()

    def _show_versions(self) -> None:
        ours = version_text(shipped_image().version)
        lines = [self.tr("Firmware {} is included in this program.").format(ours)]
        report = self._found.get(self.ports.currentText())
        if report is not None and report.hello is not None:
            theirs, number = version_text(report.hello.firmware), report.hello.glove_id
            lines.append(
                self.tr("The glove at this port is number {} with firmware {}.").format(
                    number, theirs
                )
            )
            self.number.setValue(min(max(number, 1), LARGEST_NUMBER))
            if not advice(report.hello.firmware):
                lines.append(self.tr("Its firmware is up to date."))
        self.versions.setText(" ".join(lines))
        self._allow()

    # --- writing

    def _write(self) -> None:
        try:
            image = shipped_image(int(self.speeds.currentData())).for_glove(self.number.value())
        except GlovetrackError as error:
            self.words.setText(error_text(error))
            return
        port = self.ports.currentText().strip()
        job = FlashJob(image, port, int(self.boards.currentData()))
        if self._in_use:
            self._host.shut_down()
        self._set_busy(True)
        self.words.setText(self.tr("Writing for about ten seconds. Leave the cable plugged in."))

        def work(_progress: object) -> Hello | None:
            self._write_with(job)
            return self._greet(port)

        self._tasks.run(
            self.tr("Writing the glove's firmware"),
            work,
            lambda hello: self._written(port, hello),
            ended=lambda: self._set_busy(False),
            failed=self.words.setText,
        )

    def _written(self, port: str, hello: Hello | None) -> None:
        self._found[port] = PortReport(port, hello)
        self._show_versions()
        if hello is None:
            words = self.tr(
                "Firmware written and verified. The glove does not respond yet: unplug it "
                "and plug it "
                "in again."
            )
        else:
            words = self.tr(
                "Firmware written and verified. Glove {} responds with firmware {}."
            ).format(hello.glove_id, version_text(hello.firmware))
        self.words.setText(words)

    def _set_busy(self, busy: bool) -> None:
        self._is_busy = busy
        self.busy.setVisible(busy)
        self._allow()

    def _allow(self) -> None:
        """Enable one action at a time: another job that ends would also end the waiting for the
        writing."""
        self.again.setEnabled(not self._is_busy)
        self.write.setEnabled(not self._is_busy and bool(self.ports.currentText().strip()))
