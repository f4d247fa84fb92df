"""Studies: a protocol file, its trials with verdicts, and their data set, report and tables."""
