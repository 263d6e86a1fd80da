"""Hostile hand-ins of our own, played against this machine in a throw-away course."""
