"""Which outputs run and where they go. As built, none does.

In a settings file it is the table ``[streams]``; on a command line ``--stream udp,vmc``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any, NamedTuple

from extensions.conformance.stream import IsaacPublisher
from tracker.base.errors import ConfigError
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.streaming.osc import VmcPublisher
from tracker.streaming.publisher import (
    JOINT_SETS,
    LOOPBACK,
    OPENXR,
    OWN,
    Names,
    Publisher,
    StreamError,
)
from tracker.streaming.udp import UdpPublisher

EXTRA = 'pip install "glovetrack[streams]"'


@dataclass(frozen=True)
class StreamParams:
    """All off; where on, this machine alone hears it unless ``host`` says otherwise."""

    udp: bool = False
    websocket: bool = False
    vmc: bool = False
    lsl: bool = False
    foxglove: bool = False
    host: str = LOOPBACK  # UDP and VMC send to it, WebSocket and Foxglove servers listen on it
    udp_port: int = 9750
    websocket_port: int = 9751
    vmc_port: int = 39540
    foxglove_port: int = 8765
    foxglove_origins: str = ""  # further sites whose pages may connect, with commas between
    lsl_network: bool = False  # whether other machines find the LSL outlet
    isaac: bool = False  # a record for NVIDIA's Isaac tools, to the file `isaac_file`
    isaac_file: str = ""
    joints: str = OWN  # our keypoints, or openxr: its 26 joints in every output


STREAMS = ("udp", "websocket", "vmc", "lsl", "foxglove", "isaac")
"""Names of the outputs, as fields of `StreamParams` and as words of the command line."""


def with_streams(
    params: StreamParams, words: str, host: str = "", joints: str = ""
) -> StreamParams:
    """``params`` with the outputs of a comma-separated list on; another host and other joints.

    ``udp:9000`` takes another port, ``isaac:take.mcap`` its file. Raises ConfigError for a word
    that is no stream.
    """
    for word in filter(None, (w.strip() for w in words.split(","))):
        name, colon, port = word.partition(":")
        name = name.lower()
        if name not in STREAMS:
            raise ConfigError(f"There is no stream {name!r}; there are {', '.join(STREAMS)}.")
        on: dict[str, Any] = {name: True}
        params = replace(params, **on)
        if colon:
            params = _with_port(params, name, port)
    return replace(params, host=host or params.host, joints=joints or params.joints)


def _with_port(params: StreamParams, name: str, port: str) -> StreamParams:
    if name == "isaac":
        return replace(params, isaac_file=port)
    if name == "lsl":
        raise ConfigError("The LSL stream has no port: clients find it by its name.")
    if not port.isdecimal() or not 1 <= int(port) <= 65535:
        raise ConfigError(f"{port!r} is no port for the {name} stream: ports are 1 to 65535.")
    changed: dict[str, Any] = {f"{name}_port": int(port)}
    return replace(params, **changed)


class Worn(NamedTuple):
    """A hand and the glove on it."""

    hand: HandModel
    glove: GloveModel

    def names(self, joints: str) -> Names:
        """Of the rows of its estimates."""
        return Names.of(self.hand, self.glove, joints)


def open_publishers(params: StreamParams, hand: HandModel, glove: GloveModel) -> list[Publisher]:
    """The outputs that are on, of one hand. Raises StreamError in words; what was opened is closed
    again."""
    return [publishers[0] for publishers in open_for_hands(params, [Worn(hand, glove)])]


def open_for_hands(params: StreamParams, worn: Sequence[Worn]) -> list[list[Publisher]]:
    """Of each output that is on a publisher for each hand, in their order. Raises as
    `open_publishers`."""
    if params.joints not in JOINT_SETS:
        raise StreamError(f"Joints can be {' or '.join(JOINT_SETS)}, not {params.joints!r}.")
    openers: list[tuple[bool, Callable[[StreamParams, Sequence[Worn]], Iterator[Publisher]]]] = [
        (params.udp, _udp),
        (params.websocket, _websocket),
        (params.vmc, _vmc),
        (params.lsl, _lsl),
        (params.foxglove, _foxglove),
        (params.isaac, _isaac),
    ]
    out: list[list[Publisher]] = []
    try:
        for wanted, opener in openers:
            if wanted:
                out.append([])
                for publisher in opener(params, worn):
                    out[-1].append(publisher)
    except StreamError:
        for publisher in (p for publishers in out for p in publishers):
            publisher.close()
        raise
    return out


def _udp(params: StreamParams, worn: Sequence[Worn]) -> Iterator[Publisher]:
    for w in worn:
        yield UdpPublisher(w.names(params.joints), params.host, params.udp_port)


def _vmc(params: StreamParams, worn: Sequence[Worn]) -> Iterator[Publisher]:
    for w in worn:
        yield VmcPublisher(w.hand, params.host, params.vmc_port, w.names(params.joints))


def _websocket(params: StreamParams, worn: Sequence[Worn]) -> Iterator[Publisher]:
    module = _optional("websocket", "WebSocket")
    first, *others = [w.names(params.joints) for w in worn]
    server = module.WebSocketPublisher(first, params.host, params.websocket_port)
    yield server
    yield from map(server.beside, others)


def _lsl(params: StreamParams, worn: Sequence[Worn]) -> Iterator[Publisher]:
    module = _optional("lsl", "LSL")
    for w in worn:
        yield module.LslPublisher(w.names(params.joints), params.lsl_network)


def _foxglove(params: StreamParams, worn: Sequence[Worn]) -> Iterator[Publisher]:
    module = _optional("foxglove_live", "Foxglove")
    origins = [o.strip() for o in params.foxglove_origins.split(",") if o.strip()]
    first, *others = [w.names(params.joints) for w in worn]
    server = module.FoxglovePublisher(
        first, params.host, params.foxglove_port, origins=origins, others=others
    )
    yield server
    yield from map(server.beside, others)


def _isaac(params: StreamParams, worn: Sequence[Worn]) -> Iterator[Publisher]:
    if not params.isaac_file:
        raise StreamError("The Isaac record needs a file: isaac:take.mcap.")
    first, *others = [w.names(OPENXR) for w in worn]
    record = IsaacPublisher(first, Path(params.isaac_file))
    yield record
    yield from map(record.beside, others)


def _optional(module: str, words: str) -> ModuleType:
    """A module whose package is an optional extra; StreamError where it is not installed."""
    try:
        return import_module(f"{__package__}.{module}")
    except (ImportError, RuntimeError) as error:  # pylsl: RuntimeError without its library
        raise StreamError(
            f"The {words} stream needs a package that is not installed ({error}). Run: {EXTRA}"
        ) from error
