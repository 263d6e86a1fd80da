"""The names of months in the languages that Moodle writes dates in, from the CLDR (2025, by babel; a test holds them together)."""

from __future__ import annotations

import unicodedata

# By language, from January on: within a date, then by itself where that is another form. Croatian is not here: its October is
# November in Polish and Czech.
NAMES: dict[str, tuple[str, ...]] = {
    "ca": ("gener febrer març abril maig juny juliol agost setembre octubre novembre desembre",),
    "cs": (
        "ledna února března dubna května června července srpna září října listopadu prosince",
        "leden únor březen duben květen červen červenec srpen září říjen listopad prosinec",
    ),
    "da": ("januar februar marts april maj juni juli august september oktober november december",),
    "de": ("januar februar märz april mai juni juli august september oktober november dezember",),
    "el": (
        "ιανουαρίου φεβρουαρίου μαρτίου απριλίου μαΐου ιουνίου ιουλίου αυγούστου σεπτεμβρίου οκτωβρίου νοεμβρίου δεκεμβρίου",
        "ιανουάριοσ φεβρουάριοσ μάρτιοσ απρίλιοσ μάιοσ ιούνιοσ ιούλιοσ αύγουστοσ σεπτέμβριοσ οκτώβριοσ νοέμβριοσ δεκέμβριοσ",
    ),
    "en": ("january february march april may june july august september october november december",),
    "es": ("enero febrero marzo abril mayo junio julio agosto septiembre octubre noviembre diciembre",),
    "fi": (
        "tammikuuta helmikuuta maaliskuuta huhtikuuta toukokuuta kesäkuuta heinäkuuta elokuuta syyskuuta lokakuuta marraskuuta joulukuuta",
        "tammikuu helmikuu maaliskuu huhtikuu toukokuu kesäkuu heinäkuu elokuu syyskuu lokakuu marraskuu joulukuu",
    ),
    "fr": ("janvier février mars avril mai juin juillet août septembre octobre novembre décembre",),
    "hu": ("január február március április május június július augusztus szeptember október november december",),
    "it": ("gennaio febbraio marzo aprile maggio giugno luglio agosto settembre ottobre novembre dicembre",),
    "nb": ("januar februar mars april mai juni juli august september oktober november desember",),
    "nl": ("januari februari maart april mei juni juli augustus september oktober november december",),
    "nn": ("januar februar mars april mai juni juli august september oktober november desember",),
    "pl": (
        "stycznia lutego marca kwietnia maja czerwca lipca sierpnia września października listopada grudnia",
        "styczeń luty marzec kwiecień maj czerwiec lipiec sierpień wrzesień październik listopad grudzień",
    ),
    "pt": ("janeiro fevereiro março abril maio junho julho agosto setembro outubro novembro dezembro",),
    "ro": ("ianuarie februarie martie aprilie mai iunie iulie august septembrie octombrie noiembrie decembrie",),
    "ru": (
        "января февраля марта апреля мая июня июля августа сентября октября ноября декабря",
        "январь февраль март апрель май июнь июль август сентябрь октябрь ноябрь декабрь",
    ),
    "sk": (
        "januára februára marca apríla mája júna júla augusta septembra októbra novembra decembra",
        "január február marec apríl máj jún júl august september október november december",
    ),
    "sl": ("januar februar marec april maj junij julij avgust september oktober november december",),
    "sv": ("januari februari mars april maj juni juli augusti september oktober november december",),
    "tr": ("ocak şubat mart nisan mayıs haziran temmuz ağustos eylül ekim kasım aralık",),
    "uk": (
        "січня лютого березня квітня травня червня липня серпня вересня жовтня листопада грудня",
        "січень лютий березень квітень травень червень липень серпень вересень жовтень листопад грудень",
    ),
}  # fmt: skip
NUMBERS = {
    name: number
    for forms in NAMES.values()
    for form in forms
    for number, name in enumerate(form.split(), start=1)
}


def month(word: str) -> int | None:
    """The number of the month that a word names, in any of the languages; None when it names none."""
    return NUMBERS.get(unicodedata.normalize("NFC", word.casefold()))
