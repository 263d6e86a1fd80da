"""The chapter's scenes, ready-made, one a file."""
