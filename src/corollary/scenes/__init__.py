"""Physics as motion: bodies, forces, what is observed, and the least model that answers."""
