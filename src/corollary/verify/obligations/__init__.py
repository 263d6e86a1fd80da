"""What must hold of a derivation for all numbers that can be drawn, and how each such claim is settled."""
