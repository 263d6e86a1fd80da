"""The trade as a work-precision study: seven families, twenty draws each, every method at the same tolerances."""
