"""Methods that step a motion forward in time: tables of coefficients, kernels, and the rows and contacts they follow."""
