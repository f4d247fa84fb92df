"""The demo in a process of its own; the window has the simulated hand for what it shows."""

from __future__ import annotations

import pickle
import threading
from dataclasses import dataclass
from typing import TYPE_CHECKING

from app.engines.apart.messages import Opened
from app.engines.apart.source import Companions
from app.engines.demo_camera import FILES, DemoChoice, start_camera
from app.engines.engine import Built, Send
from app.engines.protocols import ReferenceHand
from app.platform.tasks import JobProgress

if TYPE_CHECKING:
    from tracker.simulation.posture_requests import PostureRequest
    from tracker.simulation.scenario import Simulation


@dataclass(frozen=True)
class DemoSource:
    """Simulated wearers, gloves and camera; ``drawn``: see `start_camera`."""

    choice: DemoChoice
    seed: int = 1
    drawn: int = 0

    def prepare(self) -> None:
        from app.engines import demo  # noqa: F401 - for `build`
        from app.engines.warm_up import load_engine  # deferred: loads every engine

        hand, glove = FILES["right"]
        load_engine(glove, hand)

    def build(self, progress: JobProgress) -> Built:
        camera = start_camera(self.seed, self.choice, self.drawn)  # before the simulator is loaded
        from app.engines.demo import build_demo

        return build_demo(progress, self.seed, self.choice, camera, listened=False)

    def companions(self, opened: Opened, send: Send) -> Companions:
        from app.engines.demo import GuidedWearer

        scene = LaterScene(opened.scene)
        sides = [hand.glove.side for hand in opened.hands]
        truths = {side: ApartTruth(scene, side, opened.begins) for side in sides}
        if len(sides) > 1:  # two wearers follow no guidance
            return Companions(None, truths)

        def send_both(asked: PostureRequest, pose: str) -> None:
            from tracker.simulation.demo import ask

            ask(scene.hand(sides[0]), asked)
            send(asked, pose)

        wearer = GuidedWearer(lambda: scene.hand(sides[0]), send_both, opened.begins)
        return Companions(wearer, truths, wearer.close)


class LaterScene:
    """The simulated hands, built when they are needed first, which takes a second."""

    def __init__(self, spec: bytes) -> None:
        """``spec`` is the pickled `DemoSpec` of the process: files may have changed since."""
        self._spec = spec
        self._hands: dict[str, Simulation] = {}
        self._building = threading.Lock()
        self._thread: threading.Thread | None = None

    def hand(self, side: str) -> Simulation:
        """The hand of this side; waits until it is built."""
        with self._building:
            if not self._hands:
                from tracker.simulation.demo import build_scene, hands_of

                self._hands = hands_of(build_scene(pickle.loads(self._spec)))
            return self._hands[side]

    def hand_if_built(self, side: str) -> Simulation | None:
        """The hand of this side; None until it is built, which begins."""
        found = self._hands.get(side)
        if found is None and self._thread is None:
            self._thread = threading.Thread(
                target=self.hand, args=(side,), name="glovetrack-scene", daemon=True
            )
            self._thread.start()
        return found


class ApartTruth:
    """`GroundTruth` of a simulated hand, whose motion begins at ``begins`` s."""

    is_measured = False

    def __init__(self, scene: LaterScene, side: str, begins: float) -> None:
        self._scene, self._side, self._begins = scene, side, begins

    def at(self, t: float) -> ReferenceHand | None:
        simulation = self._scene.hand_if_built(self._side)
        if simulation is None:
            return None
        from app.engines.demo import SimulatedTruth

        return SimulatedTruth(simulation, self._begins).at(t)
