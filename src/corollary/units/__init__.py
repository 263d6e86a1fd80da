"""Units and dimensions: what they measure, how they are written, and what they are in SI."""
