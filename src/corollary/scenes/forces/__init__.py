"""The forces of the chapter, one a file."""
