"""``glovetrack schema``: the JSON Schema of messages, for programs that read or check them."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from resources import folder
from tracker.base.arguments import argument
from tracker.base.command import Command


@dataclass(frozen=True)
class SchemaOptions:
    what: Literal["stream"] = field(metadata=argument("messages of the UDP and WebSocket streams"))
    version: Literal["1", "2"] = field(
        default="2", metadata=argument("version of the messages (default: 2)")
    )


def schema_text(version: int) -> str:
    """JSON Schema (draft 2020-12) of the stream's messages of this version."""
    return (folder("schemas") / f"stream-{version}.schema.json").read_text("utf-8")


def _print(options: SchemaOptions) -> None:
    print(schema_text(int(options.version)), end="")


SCHEMA = Command(
    "schema", "print the JSON Schema of streamed messages", _print, options=SchemaOptions
)
