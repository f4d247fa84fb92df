"""Descriptor of the stream of keyed poses."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind


@dataclass(frozen=True)
class KeyedPoseOptions:
    host: str = option(LOOPBACK, "destination")
    port: int = option(9003, "destination port")
    joints: str = option(
        "tips",
        "tips: wrist and fingertips; openxr: 26 joints; landmarks: 21, in MediaPipe's order",
        ("tips", "openxr", "landmarks"),
    )
    frame: str = option(
        "world",
        "world: z up; openxr: y up; wrist: relative to the wrist; operator: dex-retargeting's",
        ("world", "openxr", "wrist", "operator"),
    )
    matrix: bool = option(False, "whether each pose also has a 4×4 matrix")


def _poses(options: KeyedPoseOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    from extensions.retargeting.poses import PosePublisher, PoseView

    view = PoseView(options.joints, options.frame, options.matrix)
    for names in hands:
        yield PosePublisher(names.with_openxr(), view, options.host, options.port)


POSES = StreamKind(
    name="poses",
    title="Keyed poses (Isaac, retargeting)",
    options=KeyedPoseOptions,
    make=_poses,
    order=26,
)
