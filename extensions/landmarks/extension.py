"""Descriptors of streams for programs made for webcams and headsets."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class HtsOptions:
    host: str = option(LOOPBACK, "destination; with transport server, the listening address")
    port: int = option(9000, "port")
    transport: str = option(
        "udp",
        "udp; tcp: connect to a program that listens; server: wait for programs to connect",
        ("udp", "tcp", "server"),
    )
    numbered: bool = option(False, "whether lines have a frame number and a time")


@dataclass(frozen=True)
class MediaPipeOptions:
    host: str = option(LOOPBACK, "destination")
    port: int = option(9002, "destination port")
    width: float = option(0.8, "width (m) that the virtual camera's image shows")


def _hts(options: HtsOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.landmarks.hts import HtsPublisher
    from extensions.landmarks.lines import open_lines

    lines = open_lines(options.transport, "HTS", options.host, options.port)
    for i, names in enumerate(hands):
        yield HtsPublisher(names, lines, options.numbered, owner=i == 0)


def _mediapipe(options: MediaPipeOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.landmarks.mediapipe import ImaginedView, MediaPipePublisher

    for names in hands:
        yield MediaPipePublisher(names, ImaginedView(options.width), options.host, options.port)


HTS = StreamKind(
    name="hts",
    title="Hand Tracking Streamer",
    options=HtsOptions,
    make=_hts,
    order=24,
)
MEDIAPIPE = StreamKind(
    name="mediapipe",
    title="MediaPipe (JSON)",
    options=MediaPipeOptions,
    make=_mediapipe,
    order=25,
)
