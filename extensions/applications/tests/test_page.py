"""The page: what is served, and, in a real browser with an emulated headset, what it shows."""

from __future__ import annotations

import json
import shutil
import subprocess
import threading
import urllib.error
import urllib.request
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from websockets.sync.client import connect

from extensions.applications.page import PageServer
from extensions.applications.runner import ApplicationRunner
from extensions.applications.tests.hands import GLOVE, HAND, estimates
from tracker.simulation.scripted import Key

BROWSER = shutil.which("chromium") or shutil.which("google-chrome")
KEYS = [Key(0.0, "point", (0.17, 0.0, 0.1)), Key(0.3, "point", (0.17, 0.0, 0.1))]


@pytest.fixture
def page() -> Iterator[PageServer]:
    server = PageServer()
    yield server
    server.close()


def shown(server: PageServer):
    """The virtual place around a pointing hand, on the page."""
    runner = ApplicationRunner("place", HAND, GLOVE)
    outcome = [o for e in estimates(KEYS) for o in runner.feed(e)][-1]
    server.show("Virtual place", outcome.hand, outcome.drawing)
    return outcome


def test_it_serves_its_files_and_nothing_else(page: PageServer) -> None:
    with urllib.request.urlopen(page.url) as answer:
        assert "page.js" in answer.read().decode()
    with urllib.request.urlopen(page.url + "three.module.min.js") as answer:
        assert "javascript" in answer.headers["Content-Type"]
    for name in ("../pyproject.toml", "LICENSE-three", "hands/reference-right.toml"):
        with pytest.raises(urllib.error.HTTPError, match="404"):
            urllib.request.urlopen(page.url + name)


def test_a_message_has_the_hand_in_openxr_axes_and_meshes_once(page: PageServer) -> None:
    outcome = shown(page)
    with connect(page.url.replace("http", "ws") + "stream") as client:
        first = json.loads(client.recv(10))
        shown(page)
        second = json.loads(client.recv(10))
    x, y, z = outcome.hand.p[outcome.hand.names["index_tip"]]
    assert first["hand"]["index_tip"]["position"] == pytest.approx([-y, z, -x], abs=1e-5)
    assert first["gestures"] == ["point"]
    meshes = [d for d in first["drawing"] if d["kind"] == "mesh"]
    assert all("points" in d for d in meshes)
    matrix = np.array(meshes[0]["matrix"]).reshape(4, 4).T
    mesh = next(d for d in outcome.drawing if d.name == meshes[0]["name"])
    x, y, z = mesh.p
    assert matrix[:3, 3] == pytest.approx([-y, z, -x], abs=1e-5)
    again = [d for d in second["drawing"] if d["kind"] == "mesh"]
    assert len(again) == len(meshes)


class Browser:
    """A headless one with one page, by its debugging protocol."""

    def __init__(self, folder: Path, url: str) -> None:
        assert BROWSER is not None
        self._process = subprocess.Popen(
            [BROWSER, "--headless=new", "--no-sandbox", "--remote-debugging-port=0",
             "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--window-size=900,600",
             f"--user-data-dir={folder}", "about:blank"],
            stderr=subprocess.PIPE, text=True,
        )  # fmt: skip
        self._number, self._page = 0, ""
        self._stack = ExitStack()
        self._link = self._stack.enter_context(connect(self._address(), max_size=None))
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        attached = self.ask("Target.attachToTarget", targetId=target, flatten=True)
        self._page = attached["sessionId"]
        self.ask("Page.enable")
        self._number += 1
        self._send("Page.navigate", url=url)
        self._receive(lambda said: said.get("method") == "Page.loadEventFired")

    def _address(self) -> str:
        """The address is written to standard error; the rest of that output is discarded."""
        assert self._process.stderr is not None
        for line in self._process.stderr:
            if "listening on ws://" in line:
                threading.Thread(target=self._process.stderr.read, daemon=True).start()
                return line.split()[-1]
        raise AssertionError("the browser has ended")

    def ask(self, method: str, **params: Any) -> dict[str, Any]:
        self._number += 1
        self._send(method, **params)
        answer = self._receive(lambda said: said.get("id") == self._number)
        assert "error" not in answer, answer
        return dict(answer["result"])

    def _send(self, method: str, **params: Any) -> None:
        said: dict[str, Any] = {"id": self._number, "method": method, "params": params}
        self._link.send(json.dumps(said | ({"sessionId": self._page} if self._page else {})))

    def _receive(self, wanted: Callable[[dict[str, Any]], bool]) -> dict[str, Any]:
        """The next message that is wanted."""
        while True:
            said = json.loads(self._link.recv(60))
            if wanted(said):
                return dict(said)

    def value(self, script: str) -> Any:
        """The value of an expression; of a promise, its result."""
        result = self.ask(
            "Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True,
            userGesture=True,
        )  # fmt: skip
        assert "exceptionDetails" not in result, result
        return result["result"].get("value")

    def until(self, script: str) -> None:
        """Wait until an expression is true in the page."""
        look = f"const look = () => ({script}) ? done(true) : setTimeout(look, 20); look()"
        assert self.value(f"new Promise(done => {{ {look} }})") is True

    def close(self) -> None:
        self._stack.close()
        self._process.terminate()
        self._process.wait(60)


@pytest.mark.skipif(BROWSER is None, reason="needs Chromium")
def test_a_browser_with_an_emulated_headset_shows_the_hand(
    page: PageServer, tmp_path: Path
) -> None:
    outcome = shown(page)
    browser = Browser(tmp_path, page.url + "?emulate")
    try:
        browser.until("window.glovetrack && glovetrack.figures.messages > 0")
        x, y, z = outcome.hand.p[outcome.hand.names["thumb_tip"]]
        tip = browser.value("glovetrack.joint('thumb_tip')")
        assert tip == pytest.approx([-y, z, -x], abs=1e-4)
        drawn = set(browser.value("glovetrack.drawn()"))
        assert {"text label Church", "line edge", "line ray"} <= drawn
        browser.until("!document.getElementById('enter').disabled")
        browser.value("document.getElementById('enter').click()")
        browser.until("glovetrack.figures.presenting")
        frames = browser.value("glovetrack.figures.frames")
        browser.until(f"glovetrack.figures.frames > {frames} + 3")
        said = browser.value("document.getElementById('said').textContent")
        assert said == "Virtual place: point"
    finally:
        browser.close()
