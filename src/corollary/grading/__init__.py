"""Answers held against the key: verdicts, grades, feedback, records."""
