"""Scenes composed as a physicist would, by the dozen, each with a reference that shares nothing with the engine."""
