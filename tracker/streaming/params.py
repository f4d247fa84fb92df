"""Which outputs run and where they go. As built, none does."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from types import ModuleType

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.streaming.osc import VmcPublisher
from tracker.streaming.publisher import LOOPBACK, Names, Publisher, StreamError
from tracker.streaming.udp import UdpPublisher

EXTRA = 'pip install "glovetrack[streams]"'


@dataclass(frozen=True)
class StreamParams:
    """All off; where on, this machine alone hears it unless ``host`` says otherwise."""

    udp: bool = False
    websocket: bool = False
    vmc: bool = False
    lsl: bool = False
    host: str = LOOPBACK  # UDP and VMC send to it, the WebSocket server listens on it
    udp_port: int = 9750
    websocket_port: int = 9751
    vmc_port: int = 39540
    lsl_network: bool = False  # whether other machines find the LSL outlet


def open_publishers(params: StreamParams, hand: HandModel, glove: GloveModel) -> list[Publisher]:
    """The outputs that are on. Raises StreamError in words; what was opened is closed again."""
    names = Names.of(hand, glove)
    openers: list[tuple[bool, Callable[[], Publisher]]] = [
        (params.udp, lambda: UdpPublisher(names, params.host, params.udp_port)),
        (params.websocket, lambda: _websocket(params, names)),
        (params.vmc, lambda: VmcPublisher(hand, params.host, params.vmc_port)),
        (params.lsl, lambda: _lsl(params, names)),
    ]
    out: list[Publisher] = []
    try:
        for wanted, opener in openers:
            if wanted:
                out.append(opener())
    except StreamError:
        for publisher in out:
            publisher.close()
        raise
    return out


def _websocket(params: StreamParams, names: Names) -> Publisher:
    module = _optional("websocket", "WebSocket")
    publisher: Publisher = module.WebSocketPublisher(names, params.host, params.websocket_port)
    return publisher


def _lsl(params: StreamParams, names: Names) -> Publisher:
    publisher: Publisher = _optional("lsl", "LSL").LslPublisher(names, params.lsl_network)
    return publisher


def _optional(module: str, words: str) -> ModuleType:
    """A module whose package is an optional extra; StreamError where it is not installed."""
    try:
        return import_module(f"tracker.streaming.{module}")
    except (ImportError, RuntimeError) as error:  # pylsl: RuntimeError without its library
        raise StreamError(
            f"The {words} stream needs a package that is not installed ({error}). Run: {EXTRA}"
        ) from error
