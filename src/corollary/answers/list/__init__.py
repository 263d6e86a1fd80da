"""Several quantities in any order."""
