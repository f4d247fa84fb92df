"""The simulated hands of a demo in another process, for what the window shows of them."""

from __future__ import annotations

import pickle
import threading

from app.engines.apart.messages import Opened
from app.engines.apart.source import Companions
from app.engines.demo import GuidedWearer, SimulatedTruth
from app.engines.engine import Send
from app.engines.protocols import ReferenceHand
from tracker.simulation.demo import DemoSpec, ask, build_scene, hands_of
from tracker.simulation.posture_requests import PostureRequest
from tracker.simulation.scenario import Simulation


def companions_of(opened: Opened, send: Send) -> Companions:
    """The simulated hands and their wearer, in the window's process."""
    scene = LaterScene(opened.scene)
    sides = [hand.glove.side for hand in opened.hands]
    truths = {side: ApartTruth(scene, side, opened.begins) for side in sides}
    if len(sides) > 1:  # two wearers follow no guidance
        return Companions(None, truths)

    def send_both(request: PostureRequest, pose: str) -> None:
        ask(scene.hand(sides[0]), request)
        send(request, pose)

    wearer = GuidedWearer(lambda: scene.hand(sides[0]), send_both, opened.begins, scene.alone)
    return Companions(wearer, truths, wearer.close)


class LaterScene:
    """The simulated hands, built when they are needed first, which takes a second."""

    def __init__(self, spec: bytes) -> None:
        """``spec`` is the pickled `DemoSpec` of the process: files may have changed since."""
        self._spec: DemoSpec = pickle.loads(spec)
        self._hands: dict[str, Simulation] = {}
        self._building = threading.Lock()
        self._thread: threading.Thread | None = None

    @property
    def alone(self) -> bool:
        """Whether only the finger of a pinch bends."""
        return self._spec.alone

    def hand(self, side: str) -> Simulation:
        """The hand of this side; waits until it is built."""
        with self._building:
            if not self._hands:
                self._hands = hands_of(build_scene(self._spec))
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
        return SimulatedTruth(simulation, self._begins).at(t)
