"""Mutation scores: laws bent on purpose, and the checks that would notice."""
