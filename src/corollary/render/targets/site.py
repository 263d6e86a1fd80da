"""The page to practise on, for a folder of files; `corollary.cli.export_site` writes it."""

from __future__ import annotations

from corollary.render.exports import Target

TARGET = Target(ending="html", site=True)
