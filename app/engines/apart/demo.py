"""The demo in a process of its own; the window has the simulated hand for what it shows."""

from __future__ import annotations

from dataclasses import dataclass

from app.engines.apart.messages import Opened
from app.engines.apart.source import Companions
from app.engines.demo_camera import FILES, DemoChoice, start_camera
from app.engines.engine import Built, Send
from app.platform.tasks import JobProgress
from tracker.live.listeners import remote_kinds


@dataclass(frozen=True)
class DemoSource:
    """Simulated wearers, gloves and camera; ``drawn``: see `start_camera`."""

    choice: DemoChoice
    seed: int = 1
    drawn: int = 0

    def prepare(self) -> None:
        # deferred: loads every engine; `demo` for `build`
        from app.engines import demo, warm_up  # noqa: F401

        hand, glove = FILES["right"]
        warm_up.load_engine(glove, hand)

    def build(self, progress: JobProgress) -> Built:
        camera = start_camera(self.seed, self.choice, self.drawn)  # before the simulator is loaded
        from app.engines.demo import build_demo  # deferred: as above

        return build_demo(progress, self.seed, self.choice, camera, remote_kinds())

    def companions(self, opened: Opened, send: Send) -> Companions:
        from app.engines.apart.demo_truth import companions_of  # deferred: loads the simulator

        return companions_of(opened, send)
