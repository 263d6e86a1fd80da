"""The whole way, played: a class of students with real notebooks, good, clumsy and bad, and the marks they deserve."""
