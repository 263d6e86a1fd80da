"""Models that need no steps: algebra, energy integrals, exact flow between events."""
