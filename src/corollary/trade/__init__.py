"""The race of methods on the chapter's scenes: speed against accuracy."""
