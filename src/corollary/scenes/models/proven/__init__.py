"""Motions enclosed in ball arithmetic: each step proven, so that what comes out is a bound and no estimate."""
