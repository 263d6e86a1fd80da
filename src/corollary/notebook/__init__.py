"""What goes out, before and in a file format; it cannot see the truth."""
