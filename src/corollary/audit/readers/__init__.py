"""Readers of banks, one file each: an exercise's ranges and key as a record, read without running anything of theirs."""
