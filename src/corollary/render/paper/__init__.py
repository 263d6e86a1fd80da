"""Sheets and marking schemes on paper, set by Typst: no TeX, no browser, nothing fetched."""
