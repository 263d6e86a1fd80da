"""What a course remembers: who was given which numbers, what came back, and how it was marked."""
