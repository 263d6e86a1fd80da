"""Students' programs and figures, one family a file: what a function is called with, and how what it returns is judged."""
