"use strict";
// Answers in the order of the page; the one in hand has the focus, so that readers of screens follow.
const answers = [...document.querySelectorAll("article.answered")];
let at = -1;

function go(to) {
  if (!answers.length) return;
  at = Math.max(0, Math.min(answers.length - 1, to));
  answers[at].focus({preventScroll: true});
  answers[at].scrollIntoView({block: "nearest"});
}
function goPart(by) {
  const parts = [...document.querySelectorAll("section.to-mark")];
  const here = at < 0 ? -1 : parts.indexOf(answers[at].closest("section"));
  const next = parts[Math.max(0, Math.min(parts.length - 1, here + by))];
  if (next) go(answers.indexOf(next.querySelector("article")));
}
function progress() {
  const line = document.querySelector(".progress");
  if (!line) return;
  const done = answers.filter(each => each.querySelector(".score").value.trim() !== "").length;
  line.textContent = `${done} of ${answers.length} marked`;
}
// One after the other: what was given last must be what stands.
let sending = Promise.resolve();
function save(article) {
  sending = sending.then(() => send(article));
}
async function send(article) {
  const score = article.querySelector(".score"), state = article.querySelector(".state");
  const text = score.value.trim().replace(",", ".");
  const number = text === "" ? null : Number(text);
  if (number !== null && !(number >= 0 && number <= Number(article.dataset.outOf))) {
    score.setAttribute("aria-invalid", "true");
    state.textContent = `from 0 to ${article.dataset.outOf}`;
    return;
  }
  score.removeAttribute("aria-invalid");
  state.textContent = "saving";
  try {
    const answer = await fetch("give", {
      method: "POST",
      headers: {"Content-Type": "application/json"},
      body: JSON.stringify({group: article.dataset.group, points: number, comment: article.querySelector("textarea").value}),
    });
    state.textContent = answer.ok ? (number === null ? "open" : "saved") : await answer.text();
  } catch (error) {
    state.textContent = "not saved: corollary mark has ended";
  }
  progress();
}
function fromRubric(article) {
  const items = [...article.querySelectorAll("[data-item]")];
  const held = items.filter(each => each.getAttribute("aria-pressed") === "true").length;
  article.querySelector(".score").value = String(Math.round(100 * article.dataset.outOf * held / items.length) / 100);
  save(article);
}
function toggle(article, item) {
  const button = article.querySelector(`[data-item="${item}"]`);
  if (!button) return;
  button.setAttribute("aria-pressed", String(button.getAttribute("aria-pressed") !== "true"));
  fromRubric(article);
}
function give(article, number) {
  article.querySelector(".score").value = String(number);
  save(article);
}
for (const [place, article] of answers.entries()) {
  article.addEventListener("focusin", () => { at = place; });
  article.addEventListener("click", event => {
    const button = event.target.closest("[data-item]");
    if (button) toggle(article, button.dataset.item);
    if (event.target.closest(".accept")) give(article, article.dataset.outOf);
  });
  article.addEventListener("change", event => { if (event.target.matches(".score, textarea")) save(article); });
}
document.addEventListener("keydown", event => {
  const typing = event.target.matches("input, textarea");
  if (typing && (event.key === "Escape" || (event.key === "Enter" && event.target.matches("input")))) {
    event.preventDefault();
    event.target.blur();
    return go(at);
  }
  if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
  const article = answers[at];
  const keys = {
    j: () => go(at + 1), k: () => go(at - 1), n: () => goPart(1), p: () => goPart(-1),
    f: () => article && give(article, article.dataset.outOf), 0: () => article && give(article, 0),
    c: () => article && article.querySelector("textarea").focus(),
  };
  const act = keys[event.key] || (/^[1-9]$/.test(event.key) && article ? () => toggle(article, event.key) : null);
  if (act) {
    event.preventDefault();
    act();
  }
});
progress();
