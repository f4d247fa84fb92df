"""The start of the window; with ``--headless-report`` the same window off-screen."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QEventLoop, QProcess, Qt, QTimer
from PySide6.QtGui import QCloseEvent, QIcon
from PySide6.QtWidgets import QApplication, QLabel, QProgressBar, QPushButton, QVBoxLayout, QWidget

from app.engines.apart.demo import DemoSource
from app.engines.apart.process import EngineProcess
from app.engines.apart.setup import apart_factory
from app.engines.apart.source import DeviceSource, Source
from app.engines.demo_camera import DemoChoice, start_camera
from app.panels.command_kind import CommandContext
from app.platform.crash import CrashWatch, log_folder, log_to_file
from app.platform.process_tuning import collection_postponed, tune_process
from app.platform.screens import PLATFORM, has_screen
from app.platform.single_instance import Instance, hand_over
from app.platform.translation import install
from app.storage.settings import SettingsStore
from app.window.pauses import keep_pauses_short
from app.window.report_files import check_report
from app.window.window_options import WindowOptions
from resources import folder
from tracker import __version__
from tracker.base.callbacks import ignore
from tracker.base.command import UsageError
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.kernels import parts, tools
from tracker.streaming.connection import ConnectionSettings
from tracker.streaming.registry import StreamSettings, with_streams
from tracker.streaming.remote.registry import with_doors

NO_SCREEN = (
    "The window cannot open because no display is available: neither DISPLAY nor WAYLAND_DISPLAY "
    "refers to a running display server.\n"
    "Without a display, use `glovetrack demo --headless-report 20` or another command "
    "(see the README)."
)

Then = Callable[[CommandContext], None]
SingleShot = Qt.ConnectionType.SingleShotConnection

ENDS = ("SIGINT", "SIGTERM", "SIGHUP")
"""Signals of Ctrl+C, of a logout or a shutdown, and of a terminal that is closed."""


def open_demo(options: WindowOptions) -> int:
    """The command ``demo``: the window with simulated devices."""
    return open_window(replace(options, demo=True))


def open_devices(options: WindowOptions) -> int:
    """The command ``devices``: the window with the connected ones."""
    return open_window(replace(options, devices=True))


def open_window(options: WindowOptions) -> int:
    """Open the window, or use the one that is open; returns the exit status.

    Raises UsageError for options that contradict each other, and GlovetrackError.
    """
    return _open(options, ignore, alone=True)


def open_another(options: WindowOptions, then: Then) -> int:
    """As `open_window`, even if another window is open; ``then`` is called when it is shown."""
    return _open(options, then, alone=False)


def _open(options: WindowOptions, then: Then, alone: bool) -> int:
    try:
        _check(options)
    except GlovetrackError as error:
        raise UsageError(error.notice) from error
    if not has_screen():
        if options.headless_report is None:
            print(NO_SCREEN, file=sys.stderr)
            return 1
        use_offscreen()
    tune_process()
    app = QApplication.instance() or QApplication(["glovetrack"])
    assert isinstance(app, QApplication)
    app.setApplicationName("glovetrack")
    app.setApplicationVersion(__version__)
    app.setDesktopFileName("glovetrack")
    app.setWindowIcon(QIcon(str(folder("icons") / "glovetrack.svg")))
    with collection_postponed():
        if options.headless_report is None:
            return _run(app, options, then, alone)
        return _report(options, options.headless_report)


def _check(options: WindowOptions) -> None:
    """Raises GlovetrackError for options that cannot be used."""
    _streams(options)
    with_doors(ConnectionSettings(), options.remote, options.remote_host)
    if options.camera_errors != "all":
        from tracker.simulation.camera_errors import errors_named  # deferred: the simulator

        errors_named(options.camera_errors)
    if options.wearer is not None:
        read_text(options.wearer)
    if options.at is not None and options.session is None:
        raise ConfigError(notice("option.requires", option="--at", needed="SESSION"))
    if options.at is not None and not 0.0 <= options.at < float("inf"):
        raise ConfigError(notice("option.least", option="--at", least="0 s"))
    if options.headless_report is None:
        return
    if options.session is not None:
        raise ConfigError(notice("option.exclusive", options=("--headless-report", "SESSION")))
    if not 0.0 < options.headless_report < float("inf"):
        raise ConfigError(notice("option.positive", option="--headless-report"))


def _streams(options: WindowOptions) -> StreamSettings:
    return with_streams(
        StreamSettings(), options.stream, options.stream_host, options.stream_joints
    )


def _report(options: WindowOptions, seconds: float) -> int:
    check_report(options.out, options.force)
    settings = SettingsStore().value
    if options.baud is not None:
        settings = replace(settings, baud=options.baud)
    source: Source = DeviceSource(settings) if options.devices else DemoSource(_demo(options))
    process = EngineProcess(source)  # starts before the window is even imported
    from app.window.headless_report import (  # deferred: loads the window
        Connected,
        Watched,
        headless_report,
    )

    name = "devices" if options.devices else "demo"
    watched = Watched(name, apart_factory(source, process))
    connected = Connected(_streams(options), options.remote, options.remote_host)
    return headless_report(seconds, options.out, watched, connected, options.wearer)


def _run(app: QApplication, options: WindowOptions, then: Then, alone: bool) -> int:
    if alone and not options.demo and hand_over(options.session, options.at):
        return 0  # the open window shows it
    store = SettingsStore()
    install(app, store.value.language)
    compile_before_start(app)
    log_to_file(log_folder())
    crashes, instance = CrashWatch(log_folder()), Instance()
    try:
        return _show(app, options, store, crashes, instance, then)
    finally:
        instance.close()
        crashes.end()


def _show(
    app: QApplication,
    options: WindowOptions,
    store: SettingsStore,
    crashes: CrashWatch,
    instance: Instance,
    then: Then,
) -> int:
    apart = store.value.own_process
    camera = start_camera(choice=_demo(options)) if options.demo and not apart else None
    process = EngineProcess(DemoSource(_demo(options))) if options.demo and apart else None
    from app.window.main_window import MainWindow  # deferred: after the camera has started

    window = MainWindow(store, crashes)
    window.outputs.apart, window.sources.apart = True, apart
    instance.requested.connect(window.sources.take_over)
    close_on_signals(window)
    keep_pauses_short(window.host)
    window.outputs.use(_streams(options))
    window.remote.use(options.remote, options.remote_host)
    instance.answer = window.remote.answers.answer_line
    window.sources.baud = options.baud
    if options.wearer is not None:
        window.calibration.profiles.begin_with(options.wearer)
    window.show()
    if options.demo:
        if _demo(options).uses_application:  # once the layout of watching is there
            window.host.opened.connect(lambda _setup: window.show_panel("applications"), SingleShot)
        window.sources.open_demo(_demo(options), camera, process)
    elif options.session is not None:
        window.sources.open_session(options.session, options.at)
    elif options.devices:
        window.sources.open_devices()
    then(window.context)
    return app.exec()


def _demo(options: WindowOptions) -> DemoChoice:
    return DemoChoice(
        options.fps,
        options.hands,
        options.motion,
        options.lenses,
        options.scene,
        options.camera_errors,
        options.independent_fingers,
    )


def close_on_signals(window: QWidget) -> None:
    """Let signals close the window like a click: the file is finished, the devices are freed.

    A signal can interrupt Python while it has a lock that closing needs, so the window is closed in
    the next turn of the event loop. The window's timer lets Python handle signals.
    """
    for name in ENDS:
        if hasattr(signal, name):  # not all of them exist on every system
            number = getattr(signal, name)
            signal.signal(number, lambda *_: QTimer.singleShot(0, window, window.close))


def use_offscreen() -> None:
    """Let Qt paint into memory."""
    os.environ[PLATFORM] = "offscreen"


# ---- the progress window while kernels are compiled at the first start from source, and after an
# update of it

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
