"""The trade between speed and accuracy, measured: every method on every scene, every arithmetic on every closed form."""
