"""Opens an engine in a process of its own."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from app.engines.apart.devices import ApartCamera, ApartControls, ApartGlove
from app.engines.apart.engine import ApartEngine, Parts
from app.engines.apart.hand import ApartHand
from app.engines.apart.messages import HandFacts, Opened
from app.engines.apart.process import EngineProcess
from app.engines.apart.source import Source
from app.engines.engine import EngineSetup, LivePart
from app.platform.tasks import JobProgress
from tracker.base.clock import monotonic
from tracker.live.listeners import ListenedHand, Listeners, LiveAccess, local_kinds


def apart_factory(
    source: Source,
    started: EngineProcess | None = None,
    open_process: Callable[[Source], EngineProcess] = EngineProcess,
) -> Callable[[JobProgress], EngineSetup]:
    """A job that builds the engine of ``source`` in a process; ``started`` is one that began to do
    so already, and is used once; others are made by ``open_process``."""
    waiting = [started] if started is not None else []

    def build(progress: JobProgress) -> EngineSetup:
        process = waiting.pop() if waiting else open_process(source)
        try:
            return apart_setup(process, process.wait_opened(progress))
        except BaseException:  # also Cancelled: no process may remain
            process.kill()
            raise

    return build


def apart_setup(process: EngineProcess, opened: Opened) -> EngineSetup:
    """The engine that ``process`` has built."""
    engine = ApartEngine(process, opened.hands[0].profile)
    facts = {hand.glove.side: hand for hand in opened.hands}
    report = partial(engine.report, "error")
    hands = {side: ApartHand(process, side, Listeners(report)) for side in facts}
    gloves = {
        side: ApartGlove(process, side, hand.device)
        for side, hand in facts.items()
        if hand.device is not None
    }
    fps = opened.hands[0].fps
    parts = Parts(hands, gloves, ApartCamera(fps) if fps is not None else None)
    added = process.source.companions(opened, partial(process.tell, "wearer", "send"))
    controls = ApartControls(process) if opened.hands[0].has_controls else None

    def close() -> None:
        added.close()
        process.close()

    def seen_from(side: str, hand: HandFacts) -> EngineSetup:
        device = gloves.get(side)
        _attach(hands[side], hand, device)
        make_recorder = partial(engine.make_recorder, side)
        return EngineSetup(
            name=hand.name,
            engine=engine,
            tracked=hands[side],
            hand=hand.hand,
            glove=hand.glove,
            camera=replace(hand.camera, device=parts.camera, controls=controls),
            profile=hand.profile,
            close=close,
            connection=replace(hand.connection, device=device),
            live=LivePart(engine, hands[side], make_recorder, added.wearer, engine),
            simulated=hand.simulated,
            truth=added.truths.get(side),
            listeners=hands[side].listeners.by_name,
            application=hand.application,
            missing=hand.missing,
            anchor=hand.anchor,
        )

    setups = [seen_from(side, hand) for side, hand in facts.items()]
    engine.begin(parts)
    return replace(setups[0], others=tuple(setups[1:]))


def _attach(hand: ApartHand, facts: HandFacts, device: ApartGlove | None) -> None:
    """Attach what other packages declare to the hand, here or in the process that tracks."""
    vibrate = device.vibrate if device is not None else None
    live = LiveAccess(hand.record, hand.telemetry, monotonic, hand.right_of_way, vibrate)
    hand.listeners.attach(ListenedHand(facts.hand, facts.glove, live), local_kinds())
    hand.listeners.attach_proxies(hand.line_to)
