"""Submissions: notebooks of students, run in isolation, their answers brought out as inert data."""
