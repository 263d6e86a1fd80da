"""The inch, in which springs are sold."""

from corollary.units import register

INCH = register("inch", "m", "0.0254", "", "inches zoll")
