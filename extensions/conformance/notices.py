"""Texts of the conformance checker's notices."""

TEXTS = {
    "isaac.no_file": "Specify a file for the Isaac record: isaac:take.mcap.",
    "isaac.record": "Isaac record {file}",
    "isaac.test_written": "{stream}: {count} hands were written. The file is complete when the "
    "stream is switched off.",
    "isaac.not_mcap": "{path} is not an MCAP file, or it is truncated.",
    "isaac.damaged": "A hand record is damaged.",
    "conformance.no_records": "{name} contains no hand records.",
    "conformance.no_hand": "{path} contains no records of these hands: {sides:words}.",
    "conformance.glove_side": "The glove {glove} is for the {side:word} hand.",
    "isaac.needs_openxr": "The Isaac record requires the joints of OpenXR.",
    "conformance.labels": "{path} is not a list of labelled steps.",
}
