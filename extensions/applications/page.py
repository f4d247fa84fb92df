"""Shows the hand and the application's drawing in browsers, including headsets (WebXR).

A server on this computer provides the page and, at ``/stream``, a WebSocket. Its messages are in
OpenXR's axes (y up, -z forward), in m; a mesh's points are sent once to each client, then its pose.

    {"title": "place", "gestures": ["point"],
     "hand": {"wrist": {"position": [x, y, z], "state": "measured", "radius": 0.013}, ...},
     "drawing": [{"kind": "mesh", "name": ..., "matrix": [16], "colour": "#...", "opacity": 1,
                  "points": [...], "faces": [...]}, {"kind": "line", ...}, ...]}
"""

from __future__ import annotations

import asyncio
import json
import mimetypes
import threading
from http import HTTPStatus
from typing import Any

import numpy as np
from websockets.asyncio.server import ServerConnection
from websockets.datastructures import Headers
from websockets.http11 import Request, Response

from extensions.applications.drawing import Drawing, Line, Mesh, Points, Primitive, Text
from extensions.applications.hand import HandSample
from extensions.applications.runner import Outcome
from resources import folder
from tracker.base.clock import monotonic
from tracker.hand.openxr import R_BX
from tracker.messages import Array, Validity
from tracker.streaming.publisher import LOOPBACK, STATE_WORDS
from tracker.streaming.server_thread import LOCAL_PAGE, ServerThread

FILES = ("index.html", "page.js", "three.module.min.js", "iwer.min.js")
STREAM = "/stream"
DECIMALS = 5
MOST_RECEIVED = 1024  # bytes; a page sends nothing


class PageServer:
    """Serves until `close`. Port 0 selects a free port; ``url`` is the page's address.

    Raises StreamError if the port is not available.
    """

    def __init__(self, port: int = 0) -> None:
        self._latest: tuple[str, HandSample, Drawing] | None = None
        self._fresh, self._closing = asyncio.Event(), False
        self._server = ServerThread(
            "Page",
            self._feed,
            LOOPBACK,
            port,
            origins=[None, LOCAL_PAGE],
            max_size=MOST_RECEIVED,
            process_request=_answer,
        )
        self.url = f"http://localhost:{self._server.port}/"

    @property
    def clients(self) -> int:
        """Number of connected pages."""
        return self._server.connected

    def show(self, title: str, hand: HandSample, drawing: Drawing) -> None:
        """Send the newest hand and drawing; slow pages skip some."""
        self._server.call(self._put, (title, hand, drawing))

    def close(self) -> None:
        """Free the port. May be called again."""
        self._closing = True
        self._server.call(self._put, None)
        self._server.close()

    # --- in the server's thread

    def _put(self, latest: tuple[str, HandSample, Drawing] | None) -> None:
        self._latest = latest
        fresh, self._fresh = self._fresh, asyncio.Event()
        fresh.set()

    async def _feed(self, connection: ServerConnection) -> None:
        known: dict[str, Array] = {}
        last = None
        while not self._closing:
            latest = self._latest
            if latest is None or latest is last:
                await self._fresh.wait()
                continue
            await connection.send(message(*latest, known))
            last = latest


def _answer(connection: ServerConnection, request: Request) -> Response | None:
    """A file of the page; None continues with the WebSocket."""
    path = request.path.partition("?")[0]
    if path == STREAM:
        return None
    name = path.strip("/") or FILES[0]
    if name not in FILES:
        return connection.respond(HTTPStatus.NOT_FOUND, "There is no such page.\n")
    body = (folder("webxr") / name).read_bytes()
    kind = mimetypes.guess_type(name)[0] or "application/octet-stream"
    headers = Headers([("Content-Type", kind), ("Content-Length", str(len(body)))])
    headers["Cache-Control"] = "no-store"
    return Response(HTTPStatus.OK.value, HTTPStatus.OK.phrase, headers, body)


def message(title: str, hand: HandSample, drawing: Drawing, known: dict[str, Array]) -> str:
    """Message for one client; ``known``, which is updated, contains the mesh points it has."""
    message = {
        "title": title,
        "gestures": list(hand.gestures),
        "hand": {name: _joint(hand, row) for name, row in hand.names.items()},
        "drawing": [_primitive(d, known) for d in drawing],
    }
    return json.dumps(message, separators=(",", ":"), allow_nan=False)


def _joint(hand: HandSample, row: int) -> dict[str, Any]:
    state = Validity(int(hand.state[row]))
    there = state != Validity.LOST and bool(np.isfinite(hand.p[row]).all())
    return {
        "position": _numbers(hand.p[row] @ R_BX) if there else None,
        "state": STATE_WORDS[state],
        "radius": float(hand.radius[row]),
    }


def _primitive(d: Primitive, known: dict[str, Array]) -> dict[str, Any]:
    if isinstance(d, Mesh):
        return _mesh(d, known)
    if isinstance(d, Line):
        return {"kind": "line", "name": d.name, "points": _turned(d.points), "colour": d.colour}
    if isinstance(d, Points):
        out: dict[str, Any] = {"kind": "points", "name": d.name, "points": _turned(d.points)}
        return {**out, "radius": d.radius, "colour": d.colour}
    assert isinstance(d, Text)
    at = _turned(d.p)
    return {"kind": "text", "name": d.name, "text": d.text, "position": at, "colour": d.colour}


def _mesh(d: Mesh, known: dict[str, Array]) -> dict[str, Any]:
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = R_BX.T @ d.R, R_BX.T @ d.p
    out: dict[str, Any] = {"kind": "mesh", "name": d.name, "matrix": _numbers(matrix.T)}
    out |= {"colour": d.colour, "opacity": d.opacity}
    if known.get(d.name) is not d.points:
        known[d.name] = d.points
        out |= {"points": _numbers(d.points), "faces": d.faces.ravel().tolist()}
    return out


def _turned(p_G: Array) -> list[float]:
    """Points (..., 3) of G in OpenXR's axes, flattened."""
    return _numbers(p_G @ R_BX)


def _numbers(values: Array) -> list[float]:
    return [round(v, DECIMALS) for v in np.asarray(values, float).ravel().tolist()]


class PacedPage:
    """Shows each sample when it is due; ``paced`` False: immediately, for live input."""

    def __init__(self, port: int, paced: bool) -> None:
        self._server, self._paced = PageServer(port), paced
        self._began: float | None = None
        self.url = self._server.url

    def look(self, title: str, outcome: Outcome) -> None:
        """Wait for the sample's time, then show it."""
        now = monotonic()
        if self._began is None:
            self._began = now - outcome.t
        if self._paced and self._began + outcome.t > now:
            threading.Event().wait(self._began + outcome.t - now)
        self._server.show(title, outcome.hand, outcome.drawing)

    def close(self) -> None:
        self._server.close()
