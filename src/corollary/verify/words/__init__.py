"""Checks of the words of a problem: numbers, units, signs, holes, labels, translations."""
