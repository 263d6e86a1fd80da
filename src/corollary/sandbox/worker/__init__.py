"""What runs beside the student's code: these files reach that process as text and see nothing of the package."""
