"""TOML is read as by the standard library, with limits on time and size."""

import os
import random
import time
import tomllib
from pathlib import Path

import pytest

from tests.notices import raises
from tracker.base.errors import FileError
from tracker.base.files import read_bounded
from tracker.base.toml_reader import MOST_BYTES, parse_toml, read_text

SECONDS = 6.0
"""Processor time that a text of the largest allowed size may take."""
PIECES = ['"', '"', "\\", '"""', "'", "'''", "a", "\n", " = ", "#", "b", "[", "]", "\\n"]


@pytest.mark.long
@pytest.mark.parametrize(
    ("begin", "part"),
    [
        ('"', '\\"'), ('"""', '\\"'), ("", '"'), ("", "'"), ("", '"""a'), ("", "'''a'"),
        ("", '"\n'), ("", "'\n"), ('a="', "\\\\"), ("", "[[a]]\n"), ("", "[[a]]\n[a.b]\n"),
        ("", "\r\n"), ("a=[", "1,"), ("a=[", "#\n"), ('a="""', '""\\"'), ('a="""', "\\\n "),
        ("a={b=1", ",b=1"), ("", "=" * 2), ("", "- "), ("#", "'\""), ("", "a.b.c=1\n"),
    ],
)  # fmt: skip
def test_any_text_of_the_largest_size_takes_linear_time(begin: str, part: str) -> None:
    text = begin + part * ((MOST_BYTES - len(begin)) // len(part))
    started = time.process_time()
    try:
        parse_toml(text, "a.toml")
    except FileError as error:
        assert str(error).startswith("a.toml")
    assert time.process_time() - started < SECONDS


def test_the_limits_reject_no_valid_text() -> None:
    rng, valid = random.Random(1), 0
    for _ in range(15_000):
        text = "a = " + "".join(rng.choices(PIECES, k=rng.randint(1, 10)))
        try:
            wanted = tomllib.loads(text)
        except tomllib.TOMLDecodeError:
            with pytest.raises(FileError):
                parse_toml(text, "a.toml")
            continue
        valid += 1
        assert parse_toml(text, "a.toml") == wanted, text
    assert valid > 250


def test_an_unterminated_text_is_reported_by_its_line() -> None:
    with raises(FileError, "config.unclosed_text"):
        parse_toml('a = 1\nb = "x"\nc = "y\n', "a.toml")


def test_line_endings_of_all_systems_are_read(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_bytes(b"a = 1\r\nb = 2\rc = 3\n")
    assert read_text(path) == "a = 1\nb = 2\nc = 3\n"


def test_only_regular_files_within_the_limit_are_read(tmp_path: Path) -> None:
    path = tmp_path / "a.toml"
    path.write_bytes(bytes(101))
    with raises(FileError, "file.too_large"):
        read_bounded(path, 100, "a configuration file")
    assert read_bounded(path, 101, "a configuration file") == bytes(101)
    os.mkfifo(tmp_path / "pipe")
    for endless in (tmp_path / "pipe", Path("/dev/zero"), tmp_path):
        with raises(FileError, "file.not_regular"):
            read_text(endless)
