"""Words for ways along an axis, in English, German, French and Norwegian: the axis, and the sign that they give."""

from __future__ import annotations

ALONG_X: str = (
    "left leftward leftwards links gauche venstre right rightward rightwards rechts droite høyre "
    "east eastward eastwards osten øst west westward westwards westen vest"
)
ALONG_Y: str = (
    "up upward upwards oben aufwärts haut opp oppover down downward downwards unten abwärts bas ned nedover "
    "north northward northwards norden nord south southward southwards süden sør"
)
AXIS_OF: dict[str, str] = {
    word: axis for axis, words in (("x", ALONG_X), ("y", ALONG_Y)) for word in words.split()
}
# To the right, up and forwards are positive in every figure of the chapter, as are east and north on a map; where they are not, a person decides.
POSITIVE: str = (
    "right rightward rightwards rechts droite høyre up upward upwards oben aufwärts haut opp oppover "
    "forward forwards vorn vorne vorwärts framover fremover east eastward eastwards osten øst north northward northwards norden nord positive positiver positiven positiv"
)
NEGATIVE: str = (
    "left leftward leftwards links gauche venstre down downward downwards unten abwärts bas ned nedover "
    "backward backwards back hinten zurück rückwärts bakover tilbake "
    "west westward westwards westen vest south southward southwards süden sør negative negativer negativen negativ opposite"
)
SIGNS: dict[str, int] = {
    word: sign for sign, words in ((1, POSITIVE), (-1, NEGATIVE)) for word in words.split()
}
