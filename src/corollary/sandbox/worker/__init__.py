"""Code beside the student's: these files reach that process as text and see nothing of the package."""
