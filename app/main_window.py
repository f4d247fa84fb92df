"""The window: docks, commands, one timer that asks for the latest."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtGui import QAction, QCloseEvent
from PySide6.QtWidgets import (
    QApplication,
    QDockWidget,
    QInputDialog,
    QLabel,
    QMainWindow,
    QProgressBar,
    QPushButton,
    QToolBar,
    QVBoxLayout,
    QWidget,
)

from app import theme
from app.commands import Commands
from app.layout import arrange
from app.panels import PANELS
from app.panels.panel import Panel
from app.panels.recording import RecordingPanel
from app.panels.start_page import StartPage
from app.session import Session
from app.settings import SettingsStore
from app.sources import demo_factory, hardware_factory, replay_factory
from app.tasks import TaskOwner
from app.viewmodels.status import fields, tracking_look
from app.widgets.banner import Banner
from app.widgets.chip import Chip
from app.window_commands import window_commands

_log = logging.getLogger(__name__)
TICK_MS = 16
STATUS_PERIOD = 0.25
