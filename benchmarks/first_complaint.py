"""How long an author of `corollary preview` waits for the first complaint, and whether typing waits for anything.

python benchmarks/first_complaint.py [--code Q1 --code X12.4] [--times 5] [--markdown FILE]

It needs the extra `dev` and Chromium. Nothing is saved. `rest`: the text was verified before; `typing`: the full verification
of the text before is still running, and is killed. The time runs from the change of the text to the complaint on the page.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from playwright.sync_api import Page, sync_playwright

NEW = "Q1"  # the problem that `corollary new` writes
DONE = re.compile(r"verified: all hold|complaints?, ")
FAULTS = {
    "a word that is none": lambda text: text.replace("- law:", "- low:", 1),
    "a letter without a meaning": lambda text: re.sub(r"(- law: [^`]*`\w+ = )", r"\1qq*", text, count=1),
    "a wrong dimension": lambda text: re.sub(
        r"(- law: [^`]*`(\w+) = )([^`]*)", r"\1\2*\2*(\3)", text, count=1
    ),
    "a heading without a part": lambda text: re.sub(
        r"^## \(a\)", "## (zz)", text, count=1, flags=re.MULTILINE
    ),
}
CHANGE = """([area, text]) => new Promise(done => {
  const list = document.querySelector("#complaints"), start = performance.now();
  list.replaceChildren();
  new MutationObserver((_, watch) => {
    if (list.querySelector("li:not(.remark) b")) { watch.disconnect(); done(performance.now() - start); }
  }).observe(list, {childList: true});
  area.value = text;
  area.dispatchEvent(new Event("input", {bubbles: true}));
})"""
TYPED = """area => new Promise(done => {
  const times = [];
  let left = 60;
  const key = () => {
    const start = performance.now();
    area.setRangeText("x", area.value.length, area.value.length, "end");
    area.dispatchEvent(new Event("input", {bubbles: true}));
    requestAnimationFrame(() => setTimeout(() => {
      times.push(performance.now() - start);
      if (--left) setTimeout(key, 60); else done(times);
    }));
  };
  key();
})"""


@dataclass(frozen=True, slots=True)
class Row:
    """Milliseconds until the first complaint of a kind of fault."""

    code: str
    state: str
    fault: str
    times: list[float]


@contextmanager
def served(code: str, bank: str) -> Iterator[str]:
    corollary = str(Path(sys.executable).with_name("corollary"))
    if code == NEW:
        subprocess.run([corollary, "new", NEW, "ride", "--bank", bank], check=True, stdout=subprocess.DEVNULL)
    command = [corollary, "preview", code, "--no-browser", *(["--bank", bank] if code == NEW else [])]
    running = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True)
    assert running.stdout is not None
    try:
        yield running.stdout.readline().strip()
    finally:
        running.terminate()
        running.wait()


def measured(page: Page, code: str, times: int) -> tuple[list[Row], list[float]]:
    """The rows of one problem, and how long each letter typed takes until it is drawn, in ms."""
    area = page.locator("textarea[data-side=solution]")
    page.locator("#tab-solution").click()
    page.locator("#checked").filter(has_text=DONE).wait_for()
    right, rows = area.input_value(), list[Row]()
    for state in ("rest", "typing"):
        for fault, bent in FAULTS.items():
            wrong, found = bent(right), list[float]()
            if wrong == right:
                continue
            for turn in range(times):
                area.fill(right + "\n" * turn)
                if state == "rest":
                    page.locator("#checked").filter(has_text=re.compile("verified: all hold")).wait_for()
                else:
                    page.locator("#checked").filter(
                        has_text=re.compile("verifying: (laws|obli|var|sce|bent)")
                    ).wait_for()
                found.append(page.evaluate(CHANGE, [area.element_handle(), wrong + "\n" * turn]))
            rows.append(Row(code, state, fault, found))
    area.fill(right)
    return rows, page.evaluate(TYPED, area.element_handle())


def table(rows: list[Row], letters: dict[str, list[float]], load: float) -> str:
    lines = [
        f"The page of `corollary preview` in Chromium; {os.cpu_count()} cores, load {load:.1f} on average meanwhile.",
        "",
        "| problem | before | fault | tried | first complaint, s: median | at most |",
        "|---|---|---|---|---|---|",
        *(
            f"| {each.code} | {each.state} | {each.fault} | {len(each.times)} | {statistics.median(each.times) / 1000:.2f} | {max(each.times) / 1000:.2f} |"
            for each in rows
        ),
        "",
        "| problem | letters typed while it verifies | drawn after, ms: median | at most |",
        "|---|---|---|---|",
        *(
            f"| {code} | {len(times)} | {statistics.median(times):.0f} | {max(times):.0f} |"
            for code, times in letters.items()
        ),
        "",
        "The pause of 150 ms that the page waits for the next letter is part of the first complaint.",
    ]
    return "\n".join(lines) + "\n"


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--code", action="append")
    parser.add_argument("--times", type=int, default=5)
    parser.add_argument("--markdown", type=Path)
    given: Any = parser.parse_args()
    program = os.environ.get("CHROMIUM") or shutil.which("chromium")
    rows, letters, loads = list[Row](), dict[str, list[float]](), list[float]()
    with sync_playwright() as player:
        browser = player.chromium.launch(executable_path=program, args=["--no-sandbox", "--disable-gpu"])
        for code in given.code or [NEW, "X12.4"]:
            with TemporaryDirectory() as bank, served(code, bank) as address:
                page = browser.new_page(viewport={"width": 1280, "height": 800})
                page.set_default_timeout(300_000)
                page.goto(address)
                found, letters[code] = measured(page, code, given.times)
                rows += found
                loads.append(os.getloadavg()[0])
                page.close(run_before_unload=False)
        browser.close()
    text = table(rows, letters, statistics.mean(loads))
    if given.markdown:
        given.markdown.write_text(text, encoding="utf-8")
    print(text, end="")


if __name__ == "__main__":
    start = time.perf_counter()
    main()
    print(f"{time.perf_counter() - start:.0f} s", file=sys.stderr)
