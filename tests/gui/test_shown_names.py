"""Names of files in a readable form."""

from __future__ import annotations

from app import words
from app.viewmodels.motion import shown_name
from app.viewmodels.names import WORDS, display_name
from resources import folder
from tracker.hand.files import load_hand

ABBREVIATED = {"cmc", "mcp", "pip", "dip", "ip"}
GERMAN = {"index": "Zeigefinger", "flexion": "Beugung", "tip": "Spitze", "red": "Rot"}


def test_names_are_translated_and_unknown_ones_unchanged():
    assert display_name("index_mcp_flexion") == "index mcp flexion"
    words.use(GERMAN.get)
    try:
        assert display_name("index_mcp_flexion") == "Zeigefinger mcp Beugung"
        assert display_name("red") == "Rot"
        assert display_name("tentacle_4") == "tentacle 4"
        assert shown_name("thumb_tip - index_tip") == "thumb Spitze - Zeigefinger Spitze"
    finally:
        words.use()


def test_all_words_in_names_of_included_hands_are_known():
    for path in sorted((folder("hands")).glob("*.toml")):
        parts = {part for name in load_hand(path).joint_names for part in name.split("_")}
        assert parts - set(WORDS) <= ABBREVIATED, path.name
