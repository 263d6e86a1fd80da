"""How long the offline page takes in a browser, from a file, until its first verdict stands there, and each one after.

python benchmarks/first_check.py SITE/index.html [--code S12.5wall] [--answer "9 km"] [--reading 0] [--times 3] [--markdown FILE]

It needs the extra `dev` and Chromium. Cold: a browser that has just been started; warm: the page opened again in the same browser.
`--reading`: seconds that the student reads before the answer is typed.
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from playwright.sync_api import BrowserContext, sync_playwright

AFTER = 20
AGAIN = """async section => {
  const place = section.querySelector(".feedback"), start = performance.now();
  place.textContent = "";
  section.querySelector("form").requestSubmit();
  while (!place.querySelector(".said")) await new Promise(done => setTimeout(done, 0));
  return performance.now() - start;
}"""


@dataclass(frozen=True, slots=True)
class Opened:
    """Seconds until the first verdict, from `opening` the file and from `asking`; milliseconds of each verdict `after` it."""

    state: str
    opening: float
    asking: float
    after: Sequence[float]


def open_once(context: BrowserContext, given: Any, state: str) -> Opened:
    """Open the page, answer the first part, and answer it again."""
    page = context.new_page()
    opened = time.perf_counter()
    page.goto(given.page.resolve().as_uri())
    button = page.locator(f'nav button[data-code="{given.code}"]')
    button.evaluate("each => { each.closest('details').open = true; each.click(); }")
    part = page.locator("section[data-part]").first
    field = part.locator("input[type=text]").first
    field.wait_for()
    time.sleep(given.reading)
    field.fill(given.answer)
    typed = time.perf_counter()
    field.press("Enter")
    part.locator(".feedback .said").wait_for(timeout=120_000)
    said = time.perf_counter()
    after = [part.evaluate(AGAIN) for _again in range(AFTER)]
    page.close()
    return Opened(state, said - opened, said - typed, after)


def table(found: Sequence[Opened], load: float) -> str:
    """In Markdown."""
    lines = [
        f"The page to practise on as files, in Chromium; {os.cpu_count()} cores, of which others wanted {load:.1f} meanwhile.",
        "",
        "| browser | opened | first verdict, seconds from opening | at most | each after it, ms | at most |",
        "|---|---|---|---|---|---|",
    ]
    for state in ("cold", "warm"):
        mine = [each for each in found if each.state == state]
        opening, after = [each.opening for each in mine], [one for each in mine for one in each.after]
        lines.append(
            f"| {state} | {len(mine)} | {statistics.median(opening):.2f} | {max(opening):.2f} "
            f"| {statistics.median(after):.0f} | {max(after):.0f} |"
        )
    return "\n".join(lines)


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("page", type=Path)
    options.add_argument("--code", default="S12.5wall")
    options.add_argument("--answer", default="9 km")
    options.add_argument("--reading", type=float, default=0.0)
    options.add_argument("--times", type=int, default=3)
    options.add_argument("--markdown", type=Path, help="a file for the table")
    given: Any = options.parse_args()
    program = os.environ.get("CHROMIUM") or shutil.which("chromium")
    found, load = list[Opened](), os.getloadavg()[0]
    with sync_playwright() as player:
        for _ in range(given.times):
            browser = player.chromium.launch(executable_path=program, args=["--no-sandbox", "--disable-gpu"])
            context = browser.new_context(offline=True)
            for state in ("cold", "warm"):
                found.append(open_once(context, given, state))
                print(
                    f"{state}: {found[-1].opening:.2f} s from opening the file, {found[-1].asking:.2f} s from asking; after "
                    f"that {statistics.median(found[-1].after):.0f} ms, at most {max(found[-1].after):.0f} ms"
                )
            browser.close()
    if given.markdown:
        given.markdown.write_text(table(found, load) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
