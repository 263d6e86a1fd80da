"""References for the ready scenes, found without the scenes' own code: exact fractions, forty digits, and steps of twice a double's length."""
