"""The list of the window's commands: what they are called and where they stand."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from app.window.commands import Command, Commands
from tracker.settings import ENGINES

if TYPE_CHECKING:
    from app.window.main_window import MainWindow


def add_commands(window: MainWindow, commands: Commands) -> None:
    """Every command, in menu order."""
    for group in (_file, _set_up, _tracking, _replay, _camera, _view):
        for command in group(window):
            commands.add(command)


def _file(w: MainWindow) -> list[Command]:
    menu = w.tr("&File")
    return [
        Command("demo", menu, w.tr("Start the &demo"), w.start_demo, "Ctrl+D"),
        Command("hardware", menu, w.tr("&Glove and camera"), w.start_hardware, "Ctrl+G"),
        Command("open", menu, w.tr("&Open a session…"), w.choose_session, "Ctrl+O"),
        Command("export", menu, w.tr("&Export…"), w.export_session, "Ctrl+E"),
        Command("close", menu, w.tr("&Close the session"), w.host.shut_down, "Ctrl+W"),
        Command("quit", menu, w.tr("&Quit"), lambda: w.close(), "Ctrl+Q", separator=True),
    ]


def _set_up(w: MainWindow) -> list[Command]:
    menu = w.tr("&Set-up")
    return [
        Command("glove_setup", menu, w.tr("&Glove…"), w.set_up.open_glove, "Ctrl+Shift+G"),
        Command("camera_setup", menu, w.tr("&Camera…"), w.set_up.open_camera),
        Command("stereo", menu, w.tr("&Stereo calibration…"), w.set_up.open_stereo),
        Command("lock_camera", menu, w.tr("&Lock the exposure as it is"), w.set_up.lock_camera),
    ]


def _tracking(w: MainWindow) -> list[Command]:
    menu = w.tr("&Tracking")
    return [
        Command("start", menu, w.tr("&Start"), w.host.start, "F5"),
        Command("stop", menu, w.tr("S&top"), w.host.stop, "Shift+F5"),
        Command("record", menu, w.tr("&Record"), w.toggle_recording, "Space", separator=True),
        Command("pause", menu, w.tr("&Pause the recording"), w.toggle_pause, "Ctrl+P"),
        Command("note", menu, w.tr("Add a &note…"), w.ask_note, "N"),
        *_engines(w, menu),
    ]


def _engines(w: MainWindow, menu: str) -> list[Command]:
    titles = {name: w.tr("Engine: {}").format(title) for name, title in ENGINES.items()}
    return [
        Command(f"engine_{n}", menu, title, partial(w.set_engine, n), separator=n == "chain")
        for n, title in titles.items()
    ]


def _replay(w: MainWindow) -> list[Command]:
    menu, bar = w.tr("&Replay"), w.library.transport
    return [
        Command("play", menu, w.tr("&Play or pause"), bar.toggle, "Ctrl+Space"),
        Command("step_back", menu, w.tr("The image &before"), lambda: bar.step(-1), ","),
        Command("step", menu, w.tr("The &next image"), lambda: bar.step(1), "."),
        Command("in_point", menu, w.tr("&In point here"), bar.set_in, "I", separator=True),
        Command("out_point", menu, w.tr("&Out point here"), bar.set_out, "O"),
        Command("whole", menu, w.tr("&Whole session"), bar.clear_range),
        Command("loop", menu, w.tr("&Loop on or off"), bar.toggle_loop, "L"),
        Command("again", menu, w.tr("Track &again…"), w.library.ask_track, separator=True),
        Command("compare", menu, w.tr("&Compare two sessions"), w.library.compare_selected),
    ]


def _camera(w: MainWindow) -> list[Command]:
    menu = w.tr("&Images")
    return [
        Command("freeze", menu, w.tr("&Freeze the images"), w.cameras.freeze.toggle, "F"),
        Command("fit", menu, w.tr("&Whole image"), w.fit_images, "Ctrl+0"),
        Command("view_back", menu, w.tr("Hand from the &back"), _look(w, "back"), "1"),
        Command("view_palm", menu, w.tr("Hand from the &palm"), _look(w, "palm"), "2"),
        Command("view_side", menu, w.tr("Hand from the &side"), _look(w, "side"), "3"),
        Command("view_camera", menu, w.tr("Hand from the &camera"), _look(w, "camera"), "4"),
        Command("undo", menu, w.tr("&Undo the colour change"), w.colours.undo, "Ctrl+Z"),
        Command("redo", menu, w.tr("&Redo the colour change"), w.colours.redo, "Ctrl+Y"),
    ]


def _view(w: MainWindow) -> list[Command]:
    menu = w.tr("&View")
    return [
        Command("palette", menu, w.tr("&Command palette…"), w.open_palette, "Ctrl+K"),
        Command("latencies", menu, w.tr("Latency of &each stage"), w.bar.show_latencies),
        Command("reset_layout", menu, w.tr("&Reset the layout"), w.reset_layout, "Ctrl+Shift+0"),
        Command("fullscreen", menu, w.tr("&Full screen"), w.toggle_full_screen, "F11"),
        Command("view_auto", menu, w.tr("3D view: &chosen by itself"), _chooser(w, "auto")),
        Command("view_card", menu, w.tr("3D view: by the &graphics card"), _chooser(w, "card")),
        Command("view_painted", menu, w.tr("3D view: &painted"), _chooser(w, "painted")),
        Command("theme_light", menu, w.tr("&Light"), lambda: w.set_theme("light"), separator=True),
        Command("theme_dark", menu, w.tr("&Dark"), lambda: w.set_theme("dark")),
        Command("theme_system", menu, w.tr("As the &system"), lambda: w.set_theme("system")),
    ]


def add_help(window: MainWindow, commands: Commands) -> None:
    """The last menu; it comes after the docks have been listed under View."""
    menu = window.tr("&Help")
    keeper = window.housekeeping
    for command in (
        Command("report", menu, window.tr("Save a &bug report…"), keeper.ask_report),
        Command("about", menu, window.tr("&About Glovetrack"), keeper.show_about),
    ):
        commands.add(command)


def _chooser(w: MainWindow, setting: str) -> Callable[[], None]:
    return partial(w.hand.chooser.choose, setting)


def _look(w: MainWindow, name: str) -> Callable[[], None]:
    return partial(w.hand.look_from, name)
