"""Methods that step a motion forward in time, as tables of coefficients and the small engines that run them."""
