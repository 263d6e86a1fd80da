"""Keys proven by a kernel that is not ours: scripts for the Coq proof assistant."""
