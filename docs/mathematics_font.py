"""Makes the font of the formulas: the letters, signs and growing brackets of STIX Two Math that mechanics needs.

The pages Corollary writes are read offline, and browsers lay MathML out well only with an OpenType MATH font; so each page with
a formula carries this one. STIX Two Math (1.5 MB, SIL Open Font License 1.1) comes with the Python package ziamath, or from the
STIX project. Needed to run this, and for nothing else: fonttools and brotli.

    python docs/mathematics_font.py STIXTwoMath-Regular.ttf src/corollary/render/templates

The second file, half as large, has the letters of most formulas: italic, and no bold ones.
"""

from __future__ import annotations

import sys
from pathlib import Path

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont

NAME = "Corollary Mathematics"
RANGES = (
    (0x20, 0x7E),
    (0x391, 0x3A9),
    (0x3B1, 0x3C9),  # ASCII and Greek
    (0x1D400, 0x1D433),
    (0x1D434, 0x1D49B),  # bold; italic and bold italic
    (0x1D6E2, 0x1D71B),
    (0x1D736, 0x1D74F),  # italic Greek; bold italic small Greek
    (0x1D7CE, 0x1D7D7),  # bold digits
)
SIGNS = (
    "\u00a0¬°±·×÷¯¨²³´µ`ϑϕϖϱϵℎℏℓıȷˆ˜˙′″\u2061‾―–—’…\u0305\u20d7ℂℝℕℤℒ"
    "←→↔⇐⇒⇔↦⟹∂∇∆∈∀∃∑∏−∓∕∗∘√∝∞∠∣∥∫∮∴∼≃≅≈≠≡≤≥≪≫⊥⋅⋯⋮⌈⌉⌊⌋⟨⟩‖⏞⏟"
)
# `USUAL` in `corollary/render/page.py` has the same, by which a page is given the smaller file.
USUAL_RANGES = ((0x20, 0x7E), (0x3B1, 0x3C9), (0x1D434, 0x1D467), (0x1D6FC, 0x1D71B))
USUAL_SIGNS = "\u00a0°·±×ℎΔ\u2061…′→∂∑−√∞∫˙⃗¨≈≠≤≥≪≫⋅"


def main(source: str, folder: str) -> None:
    make(source, RANGES, SIGNS, Path(folder) / "mathematics.woff2")
    make(source, USUAL_RANGES, USUAL_SIGNS, Path(folder) / "mathematics_usual.woff2")


def make(source: str, ranges: tuple[tuple[int, int], ...], signs: str, target: Path) -> None:
    options = Options()
    options.flavor, options.hinting, options.layout_features, options.notdef_outline = (
        "woff2",
        False,
        [],
        True,
    )
    font = TTFont(source)
    letters = {code for first, last in ranges for code in range(first, last + 1)} | {
        ord(sign) for sign in signs
    }
    subsetter = Subsetter(options)
    subsetter.populate(unicodes=letters)
    subsetter.subset(font)
    for entry in font["name"].names:
        if entry.nameID in {1, 4, 6, 16}:
            entry.string = NAME.replace(" ", "") if entry.nameID == 6 else NAME
    font.flavor = "woff2"
    font.save(target)
    print(f"{target}: {len(font.getGlyphOrder())} glyphs, {target.stat().st_size} bytes")


if __name__ == "__main__":
    main(*sys.argv[1:])
