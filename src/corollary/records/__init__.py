"""The memory of a course: who was given which numbers, what came back, and how it was marked."""
