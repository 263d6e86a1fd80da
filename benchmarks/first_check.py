"""How long the offline page takes in a browser, from a file, until its first verdict stands there, and each one after.

python benchmarks/first_check.py SITE/index.html [--code S12.5wall] [--answer "9 km"] [--reading 0] [--times 3]

It needs the extra `dev` and Chromium. `--reading`: seconds that the student reads before the answer is typed.
"""

from __future__ import annotations

import argparse
import os
import shutil
import statistics
import time
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

AFTER = 20
AGAIN = """async section => {
  const place = section.querySelector(".feedback"), start = performance.now();
  place.textContent = "";
  section.querySelector("form").requestSubmit();
  while (!place.querySelector(".said")) await new Promise(done => setTimeout(done, 0));
  return performance.now() - start;
}"""


def main() -> None:
    options = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    options.add_argument("page", type=Path)
    options.add_argument("--code", default="S12.5wall")
    options.add_argument("--answer", default="9 km")
    options.add_argument("--reading", type=float, default=0.0)
    options.add_argument("--times", type=int, default=3)
    given: Any = options.parse_args()
    program = os.environ.get("CHROMIUM") or shutil.which("chromium")
    with sync_playwright() as player:
        for _ in range(given.times):
            browser = player.chromium.launch(executable_path=program, args=["--no-sandbox", "--disable-gpu"])
            page = browser.new_context(offline=True).new_page()
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
            print(
                f"{said - opened:.2f} s from opening the file, {said - typed:.2f} s from asking; "
                f"after that {statistics.median(after):.0f} ms, at most {max(after):.0f} ms"
            )
            browser.close()


if __name__ == "__main__":
    main()
