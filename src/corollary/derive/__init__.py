"""What is true: derivations from laws."""
