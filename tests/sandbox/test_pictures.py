"""Pictures come last: whatever becomes of them, the answers stand."""

from __future__ import annotations

import base64
import io

from PIL import Image

HELD = "import matplotlib.pyplot as plt\nfig, ax = plt.subplots()\nax.plot([0, 1], [1, 2])\nplt.show()"
ENDLESS = HELD + "\nfig.savefig = lambda *_, **__: [None for _ in iter(int, 1)]"


def shown(run) -> list[dict]:
    return [
        output["data"]
        for output in run.outputs
        if output["output_type"] in {"display_data", "execute_result"}
    ]


def test_the_picture_stands_where_the_figure_was_shown(run) -> None:
    taken = run(
        "import matplotlib.pyplot as plt",
        "print('before')\nplt.plot([1, 2])\nplt.show()\nprint('after')",
        pictures=True,
    )
    kinds = [output["output_type"] for output in taken.cells[1].outputs]
    assert kinds == ["stream", "display_data", "stream"]
    assert base64.b64decode(shown(taken.cells[1])[0]["image/png"]) == taken.figures[0].png


def test_a_figure_changed_later_is_judged_as_shown_and_says_that_its_picture_is_newer(run) -> None:
    taken = run(
        HELD,
        "ax.set_xlabel('too late')",
        HELD.replace("fig, ax", "fig2, ax2").replace("ax.plot", "ax2.plot"),
        pictures=True,
    )
    assert taken.figures[0].axes[0].xlabel == ""
    assert "changed after it was shown" in shown(taken.cells[0])[0]["text/plain"]
    assert "changed" not in shown(taken.cells[2])[0]["text/plain"]
    assert all(figure.png for figure in taken.figures)


def test_without_pictures_nothing_is_drawn_and_nothing_stands_for_them(run) -> None:
    taken = run(HELD, "fig")
    assert [figure.png for figure in taken.figures] == [None] * 2
    assert all("image/png" not in data for cell in taken.cells for data in shown(cell))


def test_a_picture_that_takes_for_ever_or_kills_costs_no_answer_and_no_trouble(run) -> None:
    for deed in (ENDLESS, HELD + "\nimport os\nfig.savefig = lambda *_, **__: os._exit(1)"):
        taken = run("a = 1.5", deed, "b = 2.5", pictures=True)
        assert taken.trouble == ""
        assert [cell.status for cell in taken.cells] == ["ok"] * 3
        assert {name: value.value for name, value in taken.values.items()} == {"a": 1.5, "b": 2.5}
        assert taken.figures[0].axes[0].lines[0].y == (1.0, 2.0)
        assert taken.figures[0].png is None
        assert "image/png" not in shown(taken.cells[1])[0]


def test_what_looks_like_a_kept_place_is_none(run) -> None:
    forged = "from IPython.display import display\nfor word in ('figure 7', 'figure 99999999999999999999', 'figure x'):\n"
    taken = run(forged + "    display({'image/png': word, 'text/plain': 'mine'}, raw=True)", pictures=True)
    assert [data.get("image/png") for data in shown(taken.cells[0])] == [None, None, "figure x"]


def test_only_so_many_figures_are_kept_to_be_drawn(run) -> None:
    many = "import matplotlib.pyplot as plt\nfor n in range(15):\n    plt.plot([n])\n    plt.show()"
    taken = run(many, many, many, pictures=True)
    assert len(taken.figures) == 45
    assert [figure.png is None for figure in taken.figures] == [False] * 40 + [True] * 5


def test_a_picture_has_few_colours_and_looks_as_drawn(run) -> None:
    drawn = "import io\nsink = io.BytesIO()\nfig.savefig(sink, format='png', dpi=72)\nprint(len(sink.getvalue()))\nplt.show()"
    many = "import matplotlib.pyplot as plt\nfig, ax = plt.subplots()\nfor n in range(1, 9):\n    ax.plot([0, n], [n, 1], linewidth=5)\n"
    taken = run(many + drawn, pictures=True)
    whole = int(taken.cells[0].outputs[0]["text"])
    picture = taken.figures[0].png
    assert len(picture) < whole / 2
    with Image.open(io.BytesIO(picture)) as seen:
        colours = {colour for _, colour in seen.convert("RGB").getcolors(1 << 20)}
    assert len(colours) <= 256
    blue = (31, 119, 180)  # matplotlib's first
    assert min(max(abs(a - b) for a, b in zip(each, blue, strict=True)) for each in colours) < 12
