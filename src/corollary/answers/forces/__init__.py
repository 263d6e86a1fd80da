"""The forces on a body: a free-body diagram in words."""
