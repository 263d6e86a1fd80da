"""Exercises of R/exams, in Markdown and in LaTeX: what is read of each, and why the others are not."""

from __future__ import annotations

import pytest

from corollary.audit.readers.rexams import rexams_records

MARKDOWN = (
    "```{{r data generation, echo = FALSE}}\n{code}\n```\n\nQuestion\n========\nHow far?\n\n"
    "Meta-information\n================\nexname: fall\nextype: num\nexsolution: `r {key}`\nextol: 0.01\n"
)
LATEX = "<<echo=FALSE, results=hide>>=\n{code}\n@\n\\begin{{question}}\nHow far?\n\\end{{question}}\n\\exname{{fall}}\n\\extype{{num}}\n\\exsolution{{\\Sexpr{{{key}}}}}\n"
READ = [
    ("m <- sample(1:10, 1)\nF <- m * 9.81", "F", "m*981/100"),
    ("m <- runif(1, 2, 5)\nsol <- m/2", "round(sol, 2)", "m/2"),
    ("m <- runif(1, min = 2, max = 5)\nsol <- m/2", "fmt(sol, 3)", "m/2"),
    ("v <- sample(c(2, 4, 8), 1) # m/s\nsol <- v^2", "sol", "v^2"),
    ("v <- sample(seq(2, 8, by = 0.5), size = 1)\nsol <- v^2", "sol", "v^2"),
    ("v <- sample(seq(from = 2, to = 8, by = 0.5), 1)", "3*v", "3*v"),
    ("library(exams)\nset.seed(1)\na <- sample(10:80, 1)\nh <- sin(a*pi/180)", "h", "sin(a*pi/180)"),
    ("a = sample(2:9, 1); b = sample(2:9, 1)\ns = sqrt(a^2 + b^2)", "s", "sqrt(a^2 + b^2)"),
    ("my.mass <- sample(2:9, 1)\nw <- my.mass * 10", "w", "my_mass*10"),
    ("m <- round(runif(1, 2, 5), 1)\nsol <- exp(-m)", "sol", "exp(-m)"),
    ("m <- sample(2:9, 1)\ntext <- paste('a', m)\nsol <- m + 1", "sol", "m + 1"),
    ("t <- sample(2:9, 1)\ns <- 0.5 *\n  9.8 * (t^2\n  )", "s", None),
    ("t <- sample(2:9, 1)\ns <- (0.5 *\n  9.8 * t^2)", "s", "1/2*49/5*t^2"),
    ("t <- sample(2:9, 1)\ns <- log(t)", "s", "ln(t)"),
    ("t <- sample(2:9, 1)\ns <- t^2L", "s", "t^2"),
    ("t <- sample(2:9, 1)\ng <- 9.81\ns <- g*t^2/2", "signif(s, 3)", "981/100*t^2/2"),
]
READ += [
    ("sample(2:9, 1) -> m\nsol <- m\nsol <- sol*2", "sol", "m*2"),
]
NOT_READ = [
    ("sin <- function(x) cos(x)\nx <- sample(2:9, 1)\ns <- sin(x)", "s", "sin"),
    ("pi <- 3\nx <- sample(2:9, 1)\ns <- pi*x", "s", "a pi of its own, 3"),
    ("x <- sample(2:9, 1)\ns <- x", "round(s, -1)", "before the decimal point"),
    ("x <- sample(2:9, 3)\ns <- x", "s", "more than one number"),
    ("x <- rnorm(1)\ns <- x", "s", ""),
    ("x <- 1\nif (x > 0) x <- 2\ns <- x", "s", "not an assignment"),
    ("x <- sample(2:9, 1)\nwhile (x < 4) x <- x + 1", "x", "not an assignment"),
    ("x <- sample(2:9, 1)\nx <- x + 1", "x", "twice"),
    ("x <- sample(2:9, 1)", "y", "y is not known"),
    ("x <- sample(2:9, 1)", "mean(x)", ""),
]


@pytest.mark.parametrize(("shell", "ending"), [(MARKDOWN, "Rmd"), (LATEX, "Rnw")])
@pytest.mark.parametrize(("code", "key", "published"), READ)
def test_what_is_read(tmp_path, same, shell, ending, code, key, published):
    path = tmp_path / f"fall.{ending}"
    path.write_text(shell.format(code=code, key=key), encoding="utf-8")
    (record,) = rexams_records(path)
    if published is None:  # a statement that goes on without a bracket is not made out, and not guessed
        assert record.unread
        return
    assert not record.unread
    assert same(*record.published, published)


@pytest.mark.parametrize(("code", "key", "why"), NOT_READ)
def test_what_is_not_read_is_said(tmp_path, code, key, why):
    path = tmp_path / "fall.Rmd"
    path.write_text(MARKDOWN.format(code=code, key=key), encoding="utf-8")
    (record,) = rexams_records(path)
    assert record.unread
    assert why in record.unread


def test_a_number_and_another_type(tmp_path):
    path = tmp_path / "a.Rmd"
    path.write_text("Meta-information\n====\nextype: num\nexsolution: 4.9\n", encoding="utf-8")
    assert rexams_records(path)[0].published == ("4.9",)
    path.write_text("Meta-information\n====\nextype: string\nexsolution: up\n", encoding="utf-8")
    assert "type string" in rexams_records(path)[0].unread


CODE = "```{r}\nm <- sample(2:9, 1)\nF <- m*2\n```\n"
CHOICE = CODE + (
    "Question\n========\nHow much?\n\nAnswerlist\n----------\n%s\nSolution\n========\nSo.\n\nAnswerlist\n----------\n"
    "* no\n* yes\n\nMeta-information\n====\nextype: %s\nexsolution: %s\n"
)
LATEX_CHOICE = (
    "\\begin{question}\nHow much?\n\\begin{answerlist}\n  \\item $5$ N\n  \\item 10 N\n\\end{answerlist}\n\\end{question}\n"
    "\\begin{solution}\n\\begin{answerlist}\n\\item 3 N\n\\end{answerlist}\n\\end{solution}\n"
    "\\extype{schoice}\n\\exsolution{%s}\n"
)
CHOICES = [
    ("* 5 N\n* 10 N\n* 20 N\n", "schoice", "010", ["10 N"]),
    ("* 5 N\n- $10$ N\n", "mchoice", "01", ["10 N"]),
    ("* 5 N\n* 10 N\n", "mchoice", "11", ["2 of its options are marked"]),
    ("* 5 N\n* 10 N\n", "schoice", "010", ["which of its 2 options"]),
    ("* 5 N\n* `r F` N\n", "schoice", "01", ["m*2"]),
    ("* 5 N\n* `r F` apples\n", "schoice", "01", ["is not a unit"]),
    ("* 5 N\n* 10 N\n  or 12 N\n", "schoice", "01", ["10 N or 12 N"]),
    ("* up\n* down\n", "schoice", "01", ["is not a number"]),
    ("* 5 N\n* 10 N\n", "schoice", "`r mchoice2string(ok)`", ["does not say which"]),
    ("`r answerlist(F, m)`", "schoice", "01", ["which of its 0 options"]),
    ("", "cloze", "`r F`|`r m`|4.5\nexclozetype: num|num|num", ["m*2", "m", "4.5"]),
    (
        "* how much?\n* 5 N\n* 10 N\n* why?\n",
        "cloze",
        "`r F`|01|text\nexclozetype: num|schoice|string",
        ["m*2", "10 N", "of type string"],
    ),
    ("* 5 N\n* 10 N\n", "cloze", "`r F`|01\nexclozetype: num|schoice", ["m*2", "which of its 0 options"]),
    ("", "cloze", "`r F`|`r m`\nexclozetype: num", ["1 kinds of answers and 2 solutions"]),
    ("", "cloze", "`r paste(F, m, sep = '|')`\nexclozetype: num|num", ["2 kinds of answers and 1 solutions"]),
]


@pytest.mark.parametrize(("options", "kind", "solution", "expected"), CHOICES)
def test_choices_and_clozes(tmp_path, same, options, kind, solution, expected):
    path = tmp_path / "fall.Rmd"
    path.write_text(CHOICE % (options, kind, solution), encoding="utf-8")
    records = rexams_records(path)
    names = ["fall"] if len(expected) == 1 else [f"fall#{place}" for place in range(1, len(expected) + 1)]
    assert [each.id for each in records] == names
    for record, text in zip(records, expected, strict=True):
        assert (text in record.unread) if record.unread else same(*record.published, text)


def test_a_choice_in_latex(tmp_path):
    path = tmp_path / "fall.Rnw"
    path.write_text(LATEX_CHOICE % "10", encoding="utf-8")
    assert rexams_records(path)[0].published == ("5 N",)
    path.write_text(LATEX_CHOICE % "100", encoding="utf-8")
    assert "which of its 2 options" in rexams_records(path)[0].unread


def test_a_number_rounded_to_a_whole_one_is_not_its_formula(tmp_path):
    path = tmp_path / "fall.Rmd"
    path.write_text(MARKDOWN.format(code="m <- sample(2:9, 1)", key="round(m/2)"), encoding="utf-8")
    assert "to a whole one" in rexams_records(path)[0].unread


@pytest.mark.parametrize(
    ("shell", "ending", "parted"),
    [(MARKDOWN, "Rmd", "```\n\n```{r, eval=FALSE}"), (LATEX, "Rnw", "@\ntext\n<<eval=FALSE>>=")],
)
def test_a_chunk_that_is_not_evaluated_is_not_read(tmp_path, same, shell, ending, parted):
    code = f"m <- sample(2:9, 1)\nF <- m*2\n{parted}\nF <- m*3"
    path = tmp_path / f"fall.{ending}"
    path.write_text(shell.format(code=code, key="F"), encoding="utf-8")
    (record,) = rexams_records(path)
    assert same(*record.published, "m*2")


def test_meta_information_stands_in_comments_of_latex(tmp_path):
    path = tmp_path / "fall.Rnw"
    path.write_text("%% \\extype{num}\n%% \\exsolution{4.5}\n", encoding="utf-8")
    (record,) = rexams_records(path)
    assert record.published == ("4.5",)
