"""A photograph travels without what it tells besides: where it was taken, when, by whom; what is seen stays the same."""

from __future__ import annotations

import io

import pytest
from PIL import Image, ImageCms, PngImagePlugin

from corollary.figure.picture import Damaged, without_metadata

GPS, MAKE, ORIENTATION, LATITUDE = 0x8825, 0x010F, 0x0112, 2


def photograph(kind: str, **options) -> bytes:
    image = Image.radial_gradient("L").resize((48, 32)).convert("RGB")
    out = io.BytesIO()
    image.save(out, kind, **options)
    return out.getvalue()


def exif(orientation: int = 1) -> Image.Exif:
    found = Image.Exif()
    found[MAKE] = "Telltale"
    if orientation != 1:
        found[ORIENTATION] = orientation
    found.get_ifd(GPS)[LATITUDE] = (59.0, 54.0, 51.0)
    return found


def opened(raw: bytes) -> Image.Image:
    return Image.open(io.BytesIO(raw))


@pytest.mark.parametrize("progressive", [False, True])
@pytest.mark.parametrize("orientation", [1, 6])
def test_a_jpeg_forgets_all_but_which_way_up(progressive, orientation):
    colours = ImageCms.ImageCmsProfile(ImageCms.createProfile("sRGB")).tobytes()
    raw = photograph(
        "JPEG", exif=exif(orientation), comment=b"by Telltale", icc_profile=colours, progressive=progressive
    )
    assert opened(raw).getexif()[MAKE] == "Telltale"
    assert opened(raw).getexif().get_ifd(GPS)
    bare = without_metadata(
        "jpeg", raw + photograph("JPEG", exif=exif())
    )  # a second one behind the first, as phones do it
    assert b"Telltale" not in bare
    kept = opened(bare)
    assert dict(kept.getexif()) == ({} if orientation == 1 else {ORIENTATION: orientation})
    assert kept.info["icc_profile"] == colours
    assert kept.tobytes() == opened(raw).tobytes()
    assert without_metadata("jpeg", bare) == bare


def test_a_png_forgets_its_texts():
    words = PngImagePlugin.PngInfo()
    words.add_text("Author", "Telltale")
    words.add_itxt("XML:com.adobe.xmp", "Telltale, 59 N", zip=True)
    raw = photograph("PNG", pnginfo=words, exif=exif(), dpi=(300, 300))
    assert opened(raw).text
    bare = without_metadata("png", raw + b"Telltale")
    kept = opened(bare)
    assert b"Telltale" not in bare
    assert not kept.text
    assert not kept.getexif()
    assert kept.tobytes() == opened(raw).tobytes()
    assert kept.info["dpi"] == opened(raw).info["dpi"]
    assert without_metadata("png", bare) == bare


@pytest.mark.parametrize("kind", ["JPEG", "PNG"])
def test_what_is_cut_anywhere_is_damaged(kind):
    raw = without_metadata(kind.lower(), photograph(kind, exif=exif(6)))
    for end in range(9, len(raw), 7):
        with pytest.raises(Damaged):
            without_metadata(kind.lower(), raw[:end])


def test_exif_that_cannot_be_read_is_left_out():
    raw = photograph("JPEG", exif=exif(6))
    broken = raw.replace(b"MM\0*", b"MM\0*"[:2] + b"\xff\xff", 1).replace(b"II*\0", b"XX*\0", 1)
    assert b"Telltale" not in without_metadata("jpeg", broken)
