"""``glovetrack completion``: shell completion, answered by the parsers of all commands.

The script of a shell runs ``glovetrack completion words WORD…`` at each request, so that commands
of packages installed later are completed too.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import field

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.cli import build_parser, subparsers_of, with_window

SCRIPTS = {
    "bash": """_glovetrack() {
    local IFS=$'\\n'
    COMPREPLY=($(glovetrack completion words "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null))
}
complete -o default -F _glovetrack glovetrack
""",
    "zsh": """#compdef glovetrack
_glovetrack() {
    local -a found
    found=("${(@f)$(glovetrack completion words "${(@)words[2,CURRENT]}" 2>/dev/null)}")
    if [[ -n "${found[1]}" ]]; then compadd -- "${found[@]}"; else _files; fi
}
compdef _glovetrack glovetrack
""",
    "fish": """complete -c glovetrack -a \
'(glovetrack completion words (commandline -opc)[2..] (commandline -ct) 2>/dev/null)'
""",
}


def candidates(words: Sequence[str]) -> list[str]:
    """What can replace the last of ``words``, which follow ``glovetrack``; empty for file names."""
    *before, last = words or [""]
    if before or last.startswith("--"):
        before = with_window(before)
    parser = build_parser(before)
    for word in before:
        inner = subparsers_of(parser)
        if inner is not None and word in inner.choices:
            parser = inner.choices[word]
    found = _values(parser, before[-1] if before else "")
    if found is None:
        found = list(parser._option_string_actions) if last.startswith("-") else _words(parser)
    return [word for word in found if word.startswith(last)]


def _values(parser: argparse.ArgumentParser, option: str) -> list[str] | None:
    """Values of the option before; None if there is none or it takes no value."""
    action = parser._option_string_actions.get(option)
    if action is None or action.nargs == 0:
        return None
    return [str(choice) for choice in action.choices or ()]


def _words(parser: argparse.ArgumentParser) -> list[str]:
    """Sub-commands, and choices of positional arguments."""
    positional = (a for a in parser._actions if not a.option_strings and a.choices is not None)
    return [str(choice) for action in positional for choice in action.choices or ()]


@options
class CompletionArguments:
    """Arguments of ``glovetrack completion``."""

    shell: str = field(
        metadata=argument("your shell", choices=(*SCRIPTS, "words"), metavar="|".join(SCRIPTS))
    )
    words: tuple[str, ...] = field(metadata=argument(argparse.SUPPRESS, nargs=argparse.REMAINDER))


def _complete(args: CompletionArguments) -> None:
    if args.shell == "words":
        print("\n".join(candidates(args.words)))
    else:
        print(SCRIPTS[args.shell], end="")


COMPLETION = Command(
    "completion",
    "print a script that completes commands and options in a shell",
    _complete,
    options=CompletionArguments,
    description="For bash: glovetrack completion bash > "
    "~/.local/share/bash-completion/completions/glovetrack. For zsh, write it to a file "
    "_glovetrack in a folder of $fpath. For fish: glovetrack completion fish > "
    "~/.config/fish/completions/glovetrack.fish.",
)
