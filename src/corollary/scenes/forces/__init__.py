"""The forces of the chapter, one a file; somebody else's is one more class that inherits from `Force`."""
