"""Somebody else's answer key held against the laws: records of exercises, what is found of each, and readers of banks."""
