"""What Glovetrack streams by UDP, live in Rerun's viewer or in a file for it.

    pip install rerun-sdk
    glovetrack devices --stream udp
    python glovetrack_rerun.py                     # opens the viewer
    python glovetrack_rerun.py --save hand.rrd     # writes a file until Ctrl+C

Bones and keypoints are coloured by their state: measured blue, inferred orange. Lost ones are
absent. Curves are the joint angles in degrees. The timelines are the session's clock and the wall
clock, both of the instant at which the hand was in this pose.
"""

import argparse
import itertools
import json
import math
import socket
from collections.abc import Iterator
from typing import Any

import rerun as rr

FINGERS = ("thumb", "index", "middle", "ring", "little")
COLOURS = {"measured": (0, 114, 178), "inferred": (230, 159, 0)}


def bones(names: list[str]) -> list[tuple[str, str]]:
    """Pairs of keypoints that a line connects: each finger from the wrist outwards."""
    out = []
    for finger in FINGERS:
        chain = ["wrist", *(n for n in names if n.startswith(f"{finger}_"))]
        out += list(itertools.pairwise(chain))
    return out


def log(message: dict[str, Any], recording: rr.RecordingStream | None = None) -> None:
    """One message of the stream; ``recording``: Rerun's global one if it is None."""
    entity = f"hand/{message['side']}"
    rr.set_time("session", duration=message["t"], recording=recording)
    if message.get("t_unix_ns") is not None:
        rr.set_time("wall", timestamp=message["t_unix_ns"] * 1e-9, recording=recording)
    points = message.get("keypoints") or message["joints"]
    known = {name: p for name, p in points.items() if p["position"] is not None}
    rr.log(
        f"{entity}/keypoints",
        rr.Points3D(
            [p["position"] for p in known.values()],
            colors=[COLOURS[p["state"]] for p in known.values()],
            labels=list(known),
            radii=[max(p.get("sd") or p.get("radius") or 0.003, 0.001) for p in known.values()],
            show_labels=False,
        ),
        recording=recording,
    )
    shown = [(a, b) for a, b in bones(list(points)) if a in known and b in known]
    rr.log(
        f"{entity}/bones",
        rr.LineStrips3D([[known[a]["position"], known[b]["position"]] for a, b in shown]),
        recording=recording,
    )
    for name, angle in message["angles"].items():
        if angle["value"] is not None:
            value = rr.Scalars(math.degrees(angle["value"]))
            rr.log(f"{entity}/angles/{name}", value, recording=recording)
    rr.log(f"{entity}/tracking", rr.TextLog(message["tracking"]), recording=recording)


def messages(host: str, port: int) -> Iterator[dict[str, Any]]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.bind((host, port))
        while True:
            yield json.loads(sock.recv(65536))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=9750)
    parser.add_argument("--save", metavar="FILE", help="write a file instead of opening the viewer")
    parser.add_argument("--messages", type=int, default=-1, help="stop after this many")
    args = parser.parse_args()
    rr.init("glovetrack", spawn=args.save is None)
    if args.save is not None:
        rr.save(args.save)
    rr.log("/", rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    try:
        for count, message in enumerate(messages(args.host, args.port), start=1):
            log(message)
            if count == args.messages:
                break
    except KeyboardInterrupt:
        pass


if __name__ == "__main__":
    main()
