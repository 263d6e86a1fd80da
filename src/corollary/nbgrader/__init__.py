"""A course as nbgrader has it: its gradebook, its assignments, what its own commands do here."""
