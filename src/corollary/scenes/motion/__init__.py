"""Newton's second law followed in time for any scene: one loop over scipy's steps, with every event in them isolated."""
