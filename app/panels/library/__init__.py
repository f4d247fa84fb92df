"""The library: sessions, their replay, export and comparison."""
