"""Sheets that go out, before and in a file format; they cannot see the truth."""
