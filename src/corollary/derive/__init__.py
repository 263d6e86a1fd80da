"""Truth: derivations from laws."""
