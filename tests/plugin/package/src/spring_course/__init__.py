"""A course on springs, as a package of somebody else's; it brings a unit, too."""

from spring_course.units import INCH

__all__ = ["INCH"]
