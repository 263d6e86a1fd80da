"""Problems and solutions proven right, or what is wrong with them."""
