"""One file a target of exports."""
