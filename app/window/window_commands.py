"""The commands of the window: their names, menus and shortcuts."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Protocol

from PySide6.QtCore import QLocale

from app.engines.engine_host import EngineHost
from app.jobs.pose_reset import PoseReset
from app.jobs.record_key import RecordKey
from app.panels.calibration.panel import CalibrationPanel
from app.panels.cameras import CamerasPanel
from app.panels.colours.panel import ColoursPanel
from app.panels.hand.panel import HandPanel
from app.panels.library.panel import LibraryPanel
from app.platform.guide import site
from app.platform.translation import ENGLISH, SYSTEM, languages
from app.storage.settings import SettingsStore
from app.viewmodels.recording import RecordingPlan
from app.widgets.icons import dress, text_by_icon
from app.window.bug_reports import BugReports
from app.window.commands import Commands, MenuChoice, MenuCommand
from app.window.contributions import AddedCommand
from app.window.dialogs import Dialogs
from app.window.layout_keeper import LayoutKeeper
from app.window.recordings import RecordingChecks
from app.window.set_up_dialogs import SetUpDialogs
from app.window.sources import Sources
from app.window.status_bar import StatusBar
from app.words import tr
from tracker.engine.kinds import engine_kinds


class Window(Protocol):
    """Methods of the window that commands call."""

    store: SettingsStore

    def tr(self, text: str, /) -> str: ...

    def close(self) -> bool: ...

    def show_panel(self, name: str) -> None: ...

    def set_theme(self, name: str) -> None: ...

    def set_language(self, code: str) -> None: ...

    def set_up_pose_reset(self) -> None: ...


@dataclass(frozen=True, eq=False)
class Targets:
    """The objects on which commands act."""

    window: Window
    dialogs: Dialogs
    checks: RecordingChecks
    host: EngineHost
    sources: Sources
    plan: RecordingPlan
    record_key: RecordKey
    pose_reset: PoseReset
    set_up: SetUpDialogs
    layouts: LayoutKeeper
    reports: BugReports
    bar: StatusBar
    library: LibraryPanel
    cameras: CamerasPanel
    hand: HandPanel
    colours: ColoursPanel
    calibration: CalibrationPanel
    added: Mapping[str, AddedCommand]


def add_commands(on: Targets, commands: Commands) -> None:
    """Add every command, in menu order."""
    for group in (_file, _set_up, _tracking, _replay, _camera, _view):
        for command in group(on):
            commands.add(command)
            for name, added in on.added.items():
                if added.after == command.key:
                    commands.add(_added(name, added, command.menu))
    for name, added in on.added.items():
        if name not in commands.actions:
            commands.add(_added(name, added, on.window.tr("E&xtensions")))


def _added(name: str, added: AddedCommand, menu: str) -> MenuCommand:
    """A command that a package has declared."""
    return MenuCommand(name, menu, added.title, added.run, added.shortcut)


def _file(on: Targets) -> list[MenuCommand]:
    w = on.window
    menu = w.tr("&File")

    def choose_session() -> None:
        on.sources.choose_session(on.plan)

    def export_selected() -> None:
        w.show_panel("library")
        on.library.ask_export(opened_first=True)

    return [
        MenuCommand("demo", menu, w.tr("Start the &demo"), on.sources.open_demo, "Ctrl+D"),
        MenuCommand("hardware", menu, w.tr("&Glove and camera"), on.sources.open_devices, "Ctrl+G"),
        MenuCommand("open", menu, w.tr("&Open recording…"), choose_session, "Ctrl+O"),
        MenuCommand("export", menu, w.tr("&Export…"), export_selected, "Ctrl+E"),
        MenuCommand("close", menu, w.tr("&Close"), on.host.shut_down, "Ctrl+W"),
        MenuCommand("quit", menu, w.tr("&Quit"), w.close, "Ctrl+Q", separator=True),
    ]


def _set_up(on: Targets) -> list[MenuCommand]:
    w = on.window
    menu = w.tr("&Set-up")
    return [
        MenuCommand("glove_setup", menu, w.tr("&Glove…"), on.set_up.open_glove, "Ctrl+Shift+G"),
        MenuCommand("imu_positions", menu, w.tr("&IMU accuracy…"), on.set_up.open_positions),
        MenuCommand("firmware", menu, w.tr("Glove &firmware…"), on.set_up.open_firmware),
        MenuChoice(
            "both_hands",
            menu,
            w.tr("&Both hands"),
            on.sources.toggle_both_hands,
            ticked=lambda: w.store.value.both_hands,
        ),
        MenuCommand("camera_setup", menu, w.tr("&Camera…"), on.set_up.open_camera),
        MenuCommand("stereo", menu, w.tr("Camera c&alibration…"), on.set_up.open_stereo),
        MenuCommand("guided", menu, w.tr("Guided &poses…"), on.set_up.open_guided, "F6"),
        MenuCommand(
            "save_wearer", menu, w.tr("Save &wearer profile…"), on.calibration.wearer.ask_name
        ),
        MenuCommand("lock_camera", menu, w.tr("&Lock the current exposure"), on.set_up.lock_camera),
    ]


def _tracking(on: Targets) -> list[MenuCommand]:
    w = on.window
    menu = w.tr("&Tracking")
    return [
        MenuCommand("start", menu, w.tr("&Start tracking"), on.host.start, "F5"),
        MenuCommand("stop", menu, w.tr("S&top tracking"), on.host.stop, "Shift+F5"),
        MenuCommand("record", menu, w.tr("&Record"), on.record_key.press, "Space", separator=True),
        MenuCommand(
            "pause", menu, w.tr("&Pause recording"), on.host.recording.toggle_pause, "Ctrl+P"
        ),
        MenuCommand("note", menu, w.tr("Add a &note…"), on.checks.ask_note, "N"),
        MenuCommand(
            "pose_reset",
            menu,
            w.tr("R&eset pose"),
            on.pose_reset.press,
            w.store.value.pose_reset_key,
            separator=True,
        ),
        MenuCommand("pose_reset_setup", menu, w.tr("Pose reset sett&ings…"), w.set_up_pose_reset),
        *_engines(on, menu),
        MenuChoice(
            "own_process",
            menu,
            w.tr("Track in a separate pro&cess"),
            on.sources.toggle_apart,
            separator=True,
            ticked=lambda: w.store.value.own_process,
        ),
    ]


def _engines(on: Targets, menu: str) -> list[MenuCommand]:
    w = on.window
    kinds = engine_kinds()
    titles = {name: w.tr("Engine: {}").format(tr(kind.title)) for name, kind in kinds.items()}
    return [
        MenuChoice(
            f"engine_{n}",
            menu,
            title,
            partial(on.sources.set_engine, n),
            separator=n == next(iter(kinds)),
            ticked=_is_set(on, "engine", n),
        )
        for n, title in titles.items()
    ]


def _replay(on: Targets) -> list[MenuCommand]:
    w, bar = on.window, on.library.transport
    side_by_side = partial(on.library.compare_selected, as_two_recordings=True)
    menu = w.tr("&Replay")
    return [
        MenuCommand("live", menu, w.tr("Return to li&ve tracking"), on.sources.go_live, "Ctrl+L"),
        MenuCommand("play", menu, w.tr("&Play or pause"), bar.toggle, "Ctrl+Space", separator=True),
        MenuCommand("step_back", menu, w.tr("Previous &image"), lambda: bar.step(-1), ","),
        MenuCommand("step", menu, w.tr("&Next image"), lambda: bar.step(1), "."),
        MenuCommand("note_before", menu, w.tr("Previous no&te"), lambda: bar.jump(-1), "Ctrl+,"),
        MenuCommand("note_after", menu, w.tr("Next n&ote"), lambda: bar.jump(1), "Ctrl+."),
        MenuCommand(
            "in_point", menu, w.tr("Set the &start of the range"), bar.set_in, "I", separator=True
        ),
        MenuCommand("out_point", menu, w.tr("Set the &end of the range"), bar.set_out, "O"),
        MenuCommand("whole", menu, w.tr("&Clear the range"), bar.clear_range),
        MenuCommand("crop", menu, w.tr("C&rop to a new session"), on.library.crop),
        MenuCommand("loop", menu, w.tr("&Loop"), bar.toggle_loop, "L"),
        MenuCommand("again", menu, w.tr("Track &again…"), on.library.ask_track, separator=True),
        MenuCommand("compare", menu, w.tr("Co&mpare two sessions"), on.library.compare_selected),
        MenuCommand("beside", menu, w.tr("Two recordings side by si&de"), side_by_side),
    ]


def _camera(on: Targets) -> list[MenuCommand]:
    w = on.window
    menu = w.tr("&Images")

    def fit_images() -> None:
        on.cameras.left.fit()
        on.cameras.right.fit()

    return [
        MenuCommand("freeze", menu, w.tr("&Freeze images"), on.cameras.freeze.toggle, "F"),
        MenuCommand("fit", menu, w.tr("&Whole image"), fit_images, "Ctrl+0"),
        MenuCommand("view_back", menu, w.tr("Hand from the &back"), _look(on, "back"), "1"),
        MenuCommand("view_palm", menu, w.tr("Hand from the &palm"), _look(on, "palm"), "2"),
        MenuCommand("view_side", menu, w.tr("Hand from the &side"), _look(on, "side"), "3"),
        MenuCommand("view_camera", menu, w.tr("Hand from the &camera"), _look(on, "camera"), "4"),
        MenuCommand("undo", menu, w.tr("&Undo colour change"), on.colours.undo, "Ctrl+Z"),
        MenuCommand("redo", menu, w.tr("&Redo colour change"), on.colours.redo, "Ctrl+Y"),
    ]


def _view(on: Targets) -> list[MenuCommand]:
    w = on.window
    menu = w.tr("&View")
    views = {
        "auto": w.tr("3D view: &automatic"),
        "card": w.tr("3D view: &graphics card"),
        "painted": w.tr("3D view: soft&ware"),
    }
    themes = {
        "light": w.tr("Theme: &light"),
        "dark": w.tr("Theme: &dark"),
        "system": w.tr("Theme: s&ystem"),
    }
    return [
        MenuCommand("palette", menu, w.tr("&Command palette…"), on.dialogs.palette, "Ctrl+K"),
        MenuCommand("latencies", menu, w.tr("Latency p&er stage"), on.bar.show_latencies),
        MenuCommand("reset_layout", menu, w.tr("&Reset layout"), on.layouts.reset, "Ctrl+Shift+0"),
        MenuCommand("fullscreen", menu, w.tr("&Full screen"), on.dialogs.full_screen, "F11"),
        *_hands(on, menu),
        *_choices(on, menu, ("view", "view_3d"), views, on.hand.chooser.choose),
        *_choices(on, menu, ("theme", "theme"), themes, w.set_theme),
        *_languages(on, menu),
    ]


def _hands(on: Targets, menu: str) -> list[MenuCommand]:
    """Commands that choose which of two hands the panels show."""
    w = on.window
    titles = {"left": w.tr("Show the left &hand"), "right": w.tr("Show the r&ight hand")}

    def is_shown(side: str) -> bool:
        return on.host.setup is not None and on.host.setup.side == side

    return [
        MenuChoice(
            f"hand_{side}",
            menu,
            title,
            partial(on.host.show_hand, side),
            f"{5 + i}",
            separator=i == 0,
            ticked=partial(is_shown, side),
        )
        for i, (side, title) in enumerate(titles.items())
    ]


def _choices(
    on: Targets,
    menu: str,
    names: tuple[str, str],
    titles: Mapping[str, str],
    choose: Callable[[str], None],
) -> list[MenuCommand]:
    """A command per choice, checked if selected; ``names`` of the commands and of the setting."""
    return [
        MenuChoice(
            f"{names[0]}_{value}",
            menu,
            title,
            partial(choose, value),
            separator=value == next(iter(titles)),
            ticked=_is_set(on, names[1], value),
        )
        for value, title in titles.items()
    ]


def _is_set(on: Targets, name: str, value: str) -> Callable[[], bool]:
    return lambda: bool(getattr(on.window.store.value, name) == value)


def add_help(on: Targets, commands: Commands) -> None:
    """Add the last menu, after the docks have been listed under View."""
    w = on.window
    menu = w.tr("&Help")
    commands.add(MenuCommand("guide", menu, w.tr("&Guide"), on.dialogs.guide, "F1"))
    if site() is not None:
        text = w.tr("Open &documentation in the browser")
        commands.add(MenuCommand("documentation", menu, text, on.dialogs.documentation))
    commands.add(MenuCommand("keys", menu, w.tr("&Keyboard shortcuts"), on.dialogs.keys, "Ctrl+F1"))
    text = w.tr("&Check computer and devices…")
    commands.add(MenuCommand("doctor", menu, text, on.reports.examine))
    commands.add(MenuCommand("report", menu, w.tr("Save a &bug report…"), on.reports.ask))
    commands.add(MenuCommand("about", menu, w.tr("&About Glovetrack"), on.dialogs.about))


def enable_commands(on: Targets, commands: Commands) -> None:
    """Enable the commands that make sense in the present state of the engine."""
    host, w = on.host, on.window
    opened = host.setup is not None
    tracks = host.setup is not None and host.setup.player is None
    guided = host.setup is not None and host.setup.live is not None
    has_glove = host.setup is not None and host.setup.connection.present
    recording = host.recording.request is not None
    both = host.setup is not None and bool(host.setup.others)
    for key, able in (
        ("hand_left", both),
        ("hand_right", both),
        ("start", tracks and not host.running),
        ("stop", tracks and host.running),
        ("close", opened),
        ("record", host.running and host.recording.is_possible),
        ("pause", recording),
        ("pose_reset", on.pose_reset.available),
        ("guided", host.running and guided),
        ("imu_positions", host.running and guided and has_glove),
        ("save_wearer", on.calibration.profiles.link.available),
        ("note", host.recording.is_possible),  # a replayed file is not modified
        ("live", on.sources.can_go_live),
    ):
        commands.enable(key, able)
    for key, added in on.added.items():
        commands.enable(key, added.enabled())
    name = w.tr("Stop &recording") if recording else w.tr("&Record")
    action = commands.actions["record"]
    action.setText(name)
    action.setIconText(text_by_icon(w.tr("Stop recording") if recording else w.tr("Record")))
    dress(action, "circle-stop" if recording else "circle-dot")


def _languages(on: Targets, menu: str) -> list[MenuCommand]:
    """Complete translations, by their native names; none where only English is available."""
    codes = languages()
    if len(codes) < 2:
        return []
    own = {code: QLocale(code).nativeLanguageName() for code in codes}
    own[ENGLISH] = QLocale.languageToString(QLocale(ENGLISH).language())  # not "American English"
    titles = {SYSTEM: on.window.tr("Language: system default"), **own}
    return [
        MenuChoice(
            f"language_{code}",
            menu,
            title,
            partial(on.window.set_language, code),
            separator=code == SYSTEM,
            ticked=_is_set(on, "language", code),
        )
        for code, title in titles.items()
    ]


def _look(on: Targets, name: str) -> Callable[[], None]:
    return partial(on.hand.look_from, name)
