"""The progress window while kernels are compiled at the first start from source, and after an
update of it."""

from __future__ import annotations

import os
import subprocess
import sys

from PySide6.QtCore import QEventLoop, QProcess, Qt
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QApplication, QLabel, QProgressBar, QPushButton, QVBoxLayout, QWidget

from tracker.kernels import parts, tools

FOR_DEMO = "--for-demo"
WIDTH_PX = 460
NICE = 19  # the remaining kernels are compiled while the window is in use


class CompilingWindow(QWidget):
    """Shows a compiler's progress. Closes at its end, or when the user does not want to wait."""

    def __init__(self) -> None:
        super().__init__()
        self.setWindowTitle(self.tr("Glovetrack – compiling"))
        self.text = QLabel(
            self.tr(
                "Compiling the numerical kernels for this computer. This happens at the first "
                "start, where it takes a minute or two on two cores, and after updates."
            )
        )
        self.text.setWordWrap(True)
        self.bar = QProgressBar()
        self.bar.setRange(0, 0)
        self.later = QPushButton(self.tr("Start without waiting"))
        self.later.setToolTip(
            self.tr(
                "Kernels that are not compiled yet are compiled on first use, and the "
                "window pauses."
            )
        )
        self.later.clicked.connect(self.close)
        layout = QVBoxLayout(self)
        layout.addWidget(self.text)
        layout.addWidget(self.bar)
        layout.addWidget(self.later, alignment=Qt.AlignmentFlag.AlignRight)
        self.setFixedWidth(WIDTH_PX)
        self._output = ""
        self._process = QProcess(self)
        self._process.setProcessChannelMode(QProcess.ProcessChannelMode.MergedChannels)
        self._process.readyReadStandardOutput.connect(self._read)
        self._waiting = QEventLoop(self)
        self._process.finished.connect(self._waiting.quit)
        self._process.errorOccurred.connect(self._waiting.quit)

    def run(self, command: list[str]) -> bool:
        """Show the progress of the command; whether it succeeded."""
        self.show()
        self._process.start(command[0], command[1:])
        self._waiting.exec()
        ended = self._process.state() == QProcess.ProcessState.NotRunning
        well = ended and self._process.exitStatus() == QProcess.ExitStatus.NormalExit
        well = well and self._process.exitCode() == 0
        if not ended:
            self._process.kill()
            self._process.waitForFinished()
        elif not well:
            print(self._output, file=sys.stderr)
        self.hide()
        return well

    def closeEvent(self, event: QCloseEvent) -> None:
        super().closeEvent(event)
        self._waiting.quit()

    def _read(self) -> None:
        output = bytes(self._process.readAllStandardOutput().data()).decode(errors="replace")
        self._output += output
        print(output, end="", flush=True)
        for line in self._output.splitlines():
            far = tools.progress(line)
            if far is not None:
                self.bar.setRange(0, far[1])
                self.bar.setValue(far[0])


def compile_before_start(app: QApplication) -> None:
    """If kernels were never compiled, or before an update of the source, compile them with a
    progress window and start again.

    Kernels that the demo does not need are compiled in the background afterwards. Does nothing if
    the library is current, or if the user did not want to wait: numba then compiles kernels on
    first use, and tracking stops meanwhile.
    """
    if not tools.are_wanted():
        return
    done = CompilingWindow().run(tools.command(FOR_DEMO))
    app.processEvents()
    if done:
        subprocess.Popen(_nicely(tools.command()), stdout=subprocess.DEVNULL)
        os.environ[parts.MODE] = "kept"  # once per start, even if a source has a time to come
        os.execv(sys.executable, [sys.executable, *sys.orig_argv[1:]])


def _nicely(command: list[str]) -> list[str]:
    return ["nice", "-n", str(NICE), *command] if sys.platform != "win32" else command
