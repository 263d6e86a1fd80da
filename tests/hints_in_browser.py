"""A student asks for hints to a part, and finds another part meanwhile: the same on the page of a program and on one of files."""

from __future__ import annotations

from playwright.sync_api import Page, expect

MOST = 20


def ask_for_hints(page: Page) -> None:
    """Two blocks that collide: B's velocity follows from A's. The page is open at S12.5el, 2 kg at 4 m/s against 3 kg."""
    first, second = page.locator("section[data-part=a]"), page.locator("section[data-part=b]")
    more, told = second.get_by_role("button", name="A hint"), second.locator(".hints li")
    more.click()
    expect(told).to_have_count(1)
    expect(told.first).to_contain_text("First find the answer to (a)")
    more.click()
    expect(told).to_have_count(2)
    field = first.locator("input[type=text]").first
    field.fill("vA (mA - mB)/(mA + mB)")
    field.press("Enter")
    expect(first.locator(".said.right")).to_be_visible()
    expect(told).to_have_text(["One step is left, and it starts from your answer in (a)."])
    more.click()
    expect(told).to_have_count(2)
    expect(told.last).to_contain_text("With A's velocity known, momentum gives B's")
    for count in range(3, MOST):
        more.click()
        expect(told).to_have_count(count)
        if "That was the last hint" in told.last.inner_text():
            break
    expect(told.last).to_contain_text("That was the last hint")
    expect(told).to_have_count(4)
    field.fill("3 m/s")
    field.press("Enter")
    expect(first.locator(".said.right")).to_have_count(0)
    expect(told.first).to_contain_text("First find the answer to (a)")
    expect(told).to_have_count(1)
