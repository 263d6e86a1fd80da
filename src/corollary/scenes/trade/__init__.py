"""The trade between speed and accuracy, measured: every method on every scene."""
