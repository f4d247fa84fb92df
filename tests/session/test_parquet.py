"""Our Parquet files, read by Arrow; Thrift's bytes from its specification."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest

from tracker.session.export import parquet_file
from tracker.session.export.parquet_file import Numbers, Times, Words, bit_packed, write_parquet
from tracker.session.export.thrift import I32, struct, varint


def columns(count: int) -> tuple[Times, Numbers, Words]:
    random = np.random.default_rng(3)
    numbers = random.normal(size=count)
    numbers[random.random(count) < 0.3] = np.nan
    words = np.array(["measured", "inferred", "lost", "größer", ""])[random.integers(5, size=count)]
    stamps = 1_760_000_000_123_456_789 + np.arange(count) * 10_000_000
    return Times("t", stamps), Numbers("x", numbers), Words("x_state", words)


@pytest.mark.parametrize("count", [0, 1, 7, 8, 1000])
def test_arrow_reads_what_was_written(tmp_path: Path, count: int) -> None:
    t, x, state = columns(count)
    write_parquet(tmp_path / "o.parquet", [t, x, state])
    table = pq.read_table(tmp_path / "o.parquet")
    assert table.schema.field("t").type == pa.timestamp("ns", "UTC")
    assert table.schema.field("x").type == pa.float64()
    assert table.schema.field("x_state").type == pa.string()
    assert table["t"].cast(pa.int64()).to_pylist() == t.values.tolist()
    assert table["x"].to_pylist() == [None if np.isnan(v) else v for v in x.values.tolist()]
    assert table["x_state"].to_pylist() == state.values.tolist()


def test_long_tables_are_of_several_groups(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(parquet_file, "ROWS", 300)
    written = columns(1000)
    write_parquet(tmp_path / "o.parquet", written)
    file = pq.ParquetFile(tmp_path / "o.parquet")
    assert file.metadata.num_row_groups == 4
    assert [file.metadata.row_group(k).num_rows for k in range(4)] == [300, 300, 300, 100]
    assert file.read()["x_state"].to_pylist() == written[2].values.tolist()
    assert file.read_row_group(3)["t"].cast(pa.int64())[0].as_py() == written[0].values[900]


def test_columns_of_other_lengths_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="different lengths"):
        write_parquet(tmp_path / "o.parquet", [*columns(3), Numbers("y", np.zeros(4))])
    assert not (tmp_path / "o.parquet").exists()


def test_many_columns_and_words_are_described(tmp_path: Path) -> None:
    """More than 14 elements of a list, and a dictionary whose numbers take nine bits."""
    words = np.array([f"word {k % 300}" for k in range(5000)])
    written = [Words(f"column {k}", words) for k in range(20)]
    write_parquet(tmp_path / "o.parquet", written)
    table = pq.read_table(tmp_path / "o.parquet")
    assert table.column_names == [w.name for w in written]
    assert table["column 19"].to_pylist() == words.tolist()


def test_thrift_as_specified() -> None:
    assert varint(50399) == bytes([0xDF, 0x89, 0x03])  # the specification's example
    assert struct({}) == b"\0"
    assert struct({1: True, 4: I32(-1)}) == bytes([0x11, 0x35, 0x01, 0])
    assert struct({2: "a", 3: [I32(1), I32(-2)]}) == bytes(
        [0x28, 1, ord("a"), 0x19, 0x25, 0x02, 0x03, 0]
    )
    with pytest.raises(ValueError, match="more than 15 apart"):
        struct({1: True, 17: True})


def test_bits_as_in_parquets_example() -> None:
    """The numbers 0 to 7 of three bits are 88 C6 FA (Encodings.md)."""
    assert bit_packed(np.arange(8), 3) == bytes([0b11, 0x88, 0xC6, 0xFA])
