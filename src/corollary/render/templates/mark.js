"use strict";
// Answers in the order of the page; the one in hand has the focus, so that readers of screens follow.
const answers = [...document.querySelectorAll("article.answered")];
const main = document.querySelector("main");
const bar = name => document.querySelector(`.marking-bar .${name}`);
let at = -1;

function current(to) {
  if (at >= 0) answers[at].classList.remove("current");
  at = to;
  answers[at].classList.add("current");
}
function go(to) {
  if (!answers.length) return;
  current(Math.max(0, Math.min(answers.length - 1, to)));
  answers[at].focus({preventScroll: true});
  answers[at].scrollIntoView({block: "nearest"});
}
function goPart(by) {
  const parts = [...document.querySelectorAll("section.to-mark")];
  const here = at < 0 ? -1 : parts.indexOf(answers[at].closest("section"));
  const next = parts[Math.max(0, Math.min(parts.length - 1, here + by))];
  if (next) go(answers.indexOf(next.querySelector("article")));
}
function isDone(article) {
  return "given" in article.dataset;
}
function progress() {
  const line = bar("progress");
  if (!line) return;
  const done = answers.filter(isDone), open = new Set(), here = new Set();
  for (const article of answers) {
    article.classList.toggle("marked", isDone(article));
    for (const student of article.dataset.students.split(" ").filter(Boolean)) {
      here.add(student);
      if (!isDone(article)) open.add(student);
    }
  }
  const before = Number(main.dataset.doneBefore), all = Math.max(Number(main.dataset.students), here.size + before);
  line.textContent = `${done.length} of ${answers.length} answers marked · ${before + here.size - open.size} of ${all} students done`;
  const count = queue.size + (sending ? 1 : 0);
  bar("pending").textContent = count && !broken ? `saving ${count}` : "";
}

// What was given waits here and is sent one after the other: what was given last must be what stands.
const queue = new Map();
let sending = null, broken = "";
async function post(what) {
  const answer = await fetch("give", {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(what)});
  const text = await answer.text();
  if (answer.status >= 500) throw new Error(text);
  if (!answer.ok) return {refused: text};
  return JSON.parse(text);
}
function say(article, text, failed = false) {
  article.querySelector(".state").textContent = text;
  article.classList.toggle("failed", failed);
}
function save(article, over = false) {
  const score = article.querySelector(".score"), text = score.value.trim().replace(",", ".");
  const number = text === "" ? null : Number(text);
  if (number !== null && !(number >= 0 && number <= Number(article.dataset.outOf))) {
    score.setAttribute("aria-invalid", "true");
    say(article, `from 0 to ${article.dataset.outOf}`, true);
    return;
  }
  score.removeAttribute("aria-invalid");
  if (number === null) delete article.dataset.given; else article.dataset.given = "";
  const ticked = [...article.querySelectorAll("[data-item][aria-pressed='true']")].map(each => each.dataset.item);
  const byRubric = ticked.length > 0 || article.dataset.by === "rubric";
  const others = article.querySelector(".others");
  queue.set(article, {
    group: article.dataset.group, points: number, comment: article.querySelector("textarea").value,
    items: byRubric ? ticked.map(id => [id, itemOf(article, id).points]) : null, over,
    others: Boolean(others && others.checked), stands: article.dataset.stands === "yes",
  });
  say(article, number === null ? "open" : "saving");
  progress();
  pump();
}
async function pump() {
  if (sending || !queue.size) return;
  const [article, what] = queue.entries().next().value;
  queue.delete(article);
  sending = article;
  progress();
  let wait = 0;
  try {
    const answer = await post(what);
    broken = "";
    if (answer.refused) {
      delete article.dataset.given;
      say(article, `not saved: ${answer.refused}`, true);
    } else if (answer.conflict) {
      delete article.dataset.given;
      conflict(article, answer.conflict);
    } else if (!queue.has(article)) {
      say(article, what.points === null && !what.stands ? "open" : "saved");
    }
  } catch (error) {
    // Nothing is lost: it goes back to where it was, before what was given later.
    const later = [...queue.entries()].filter(([each]) => each !== article);
    const newest = queue.get(article) || what;
    queue.clear();
    for (const [each, its] of [[article, newest], ...later]) queue.set(each, its);
    broken = error instanceof TypeError ? "corollary mark has ended, or cannot be reached" : error.message;
    for (const each of queue.keys()) say(each, "not saved yet", true);
    wait = 3000;
  }
  sending = null;
  failure();
  progress();
  if (wait) setTimeout(pump, wait); else pump();
}
function failure() {
  const line = bar("unsaved");
  if (!broken) { line.replaceChildren(); return; }
  const button = document.createElement("button");
  button.className = "again";
  button.textContent = "Try again";
  button.addEventListener("click", () => pump());
  line.replaceChildren(`${queue.size} not saved: ${broken} `, button);
}
addEventListener("beforeunload", event => { if (queue.size || sending) event.preventDefault(); });

function conflict(article, about) {
  say(article, "changed meanwhile; not saved", true);
  article.querySelector(".conflict")?.remove();
  const box = document.createElement("div");
  box.className = "conflict";
  box.setAttribute("role", "alert");
  for (const each of about) {
    const line = document.createElement("p");
    line.textContent = each;
    box.append(line);
  }
  const choices = document.createElement("p");
  choices.className = "choices";
  for (const [text, act] of [["Save mine instead", () => save(article, true)], ["Leave it as it is now", () => say(article, "left as it is; reload to see it")]]) {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = text;
    button.addEventListener("click", () => { box.remove(); act(); });
    choices.append(button);
  }
  box.append(choices);
  article.querySelector(".give").after(box);
}

// The rubric of each part: ticks add up.
const rubrics = new Map();
function itemsOf(article) { return rubrics.get(article.closest("section")); }
function itemOf(article, id) { return itemsOf(article).find(each => each.id === id); }
function fromRubric(article) {
  const ticked = [...article.querySelectorAll("[data-item][aria-pressed='true']")].map(each => each.dataset.item);
  const outOf = Number(article.dataset.outOf), items = itemsOf(article);
  // All items that add together are all points, whatever the hundredths say.
  const all = items.filter(each => each.points > 0).every(each => ticked.includes(each.id)) && !items.some(each => each.points < 0 && ticked.includes(each.id));
  const sum = items.filter(each => ticked.includes(each.id)).reduce((total, each) => total + each.share, 0);
  const whole = items.filter(each => each.share > 0).reduce((total, each) => total + each.share, 0);
  const share = all && Math.abs(whole - 1) < .01 ? 1 : sum;
  article.querySelector(".score").value = String(Math.round(100 * Math.min(outOf, Math.max(0, outOf * share))) / 100);
  article.dataset.by = "rubric";
  save(article);
}
function toggle(article, button) {
  if (!button) return;
  button.setAttribute("aria-pressed", String(button.getAttribute("aria-pressed") !== "true"));
  fromRubric(article);
}
function give(article, number) {
  article.querySelector(".score").value = String(number);
  delete article.dataset.by;
  for (const each of article.querySelectorAll("[data-item]")) each.setAttribute("aria-pressed", "false");
  save(article);
}
function element(name, about, ...children) {
  const made = Object.assign(document.createElement(name), about);
  made.append(...children);
  return made;
}
function editor(section) {
  const box = section.querySelector(".rubric-editor");
  const list = box.querySelector("ol"), moves = box.querySelector(".moves"), apply = box.querySelector(".apply");
  const outOf = Number(section.dataset.outOf);
  const changed = () => { apply.hidden = true; moves.replaceChildren(); };
  const add = item => {
    const text = element("textarea", {className: "text", rows: 2, value: item.text});
    text.setAttribute("aria-label", "Item");
    const worth = element("input", {className: "worth", inputMode: "decimal", value: String(item.points)});
    worth.setAttribute("aria-label", "Points of the item; negative takes off");
    const remove = element("button", {type: "button", textContent: "Remove"});
    const line = element("li", {}, text, worth, remove);
    line.dataset.id = item.id;
    remove.addEventListener("click", () => { line.remove(); changed(); });
    line.addEventListener("input", changed);
    list.append(line);
    return text;
  };
  const fill = () => { list.replaceChildren(); rubrics.get(section).forEach(add); };
  const wanted = preview => ({
    part: section.dataset.part, preview,
    items: [...list.children].map(line => ({
      id: line.dataset.id, text: line.querySelector(".text").value.trim(), points: line.querySelector(".worth").value.replace(",", "."),
    })),
  });
  fill();
  box.querySelector(".add").addEventListener("click", () => { add({id: "", text: "", points: 0}).focus(); changed(); });
  box.querySelector(".preview").addEventListener("click", async () => {
    const answer = await attempt(wanted(true), moves);
    if (!answer) return;
    table(moves, answer.moves, answer.moves.length ? "" : "No mark that was given moves.", outOf);
    apply.hidden = false;
  });
  apply.addEventListener("click", async () => {
    const answer = await attempt(wanted(false), moves);
    if (!answer) return;
    setItems(section, answer.items, answer.scores);
    fill();
    apply.hidden = true;
    moves.textContent = `The rubric is changed; ${answer.moves.length === 1 ? "1 mark" : `${answer.moves.length} marks`} moved.`;
  });
}
async function attempt(what, place) {
  while (sending || queue.size) { if (broken) { place.textContent = broken; return null; } await new Promise(done => setTimeout(done, 50)); }
  try {
    const answer = await post(what);
    if (!answer.refused) return answer;
    place.textContent = answer.refused;
  } catch (error) { place.textContent = error.message; }
  return null;
}
function table(place, moves, nothing) {
  const words = value => value === null ? "–" : String(value);
  place.replaceChildren(nothing);
  if (!moves.length) return;
  const shown = moves.slice(0, 10).map(each => element("tr", {}, ...[each.who, words(each.before), words(each.after)].map(text => element("td", {textContent: text}))));
  const head = element("thead", {}, element("tr", {}, ...["student", "has", "gets"].map(text => element("th", {textContent: text}))));
  place.append(element("table", {}, head, element("tbody", {}, ...shown)), moves.length > 10 ? `and ${moves.length - 10} more` : "");
}
function setItems(section, items, scores) {
  rubrics.set(section, items);
  for (const article of section.querySelectorAll("article")) {
    const held = new Set([...article.querySelectorAll("[data-item][aria-pressed='true']")].map(each => each.dataset.item));
    article.querySelector(".items").replaceChildren(...items.map((item, place) => {
      const label = element("span", {innerHTML: item.html});  // made harmless by the server, as every text on this page
      const button = element("button", {type: "button"}, element("span", {className: "worth", textContent: item.words}), element("kbd", {textContent: String(place + 1)}), " ", label);
      button.dataset.item = item.id;
      button.setAttribute("aria-pressed", String(held.has(item.id)));
      return button;
    }));
    if (article.dataset.group in scores) {
      article.querySelector(".score").value = String(scores[article.dataset.group]);
      say(article, "follows the rubric");
    }
  }
}
async function load(details) {
  const place = details.querySelector(".loaded");
  if (!details.open || details.dataset.loaded) return;
  details.dataset.loaded = "yes";
  place.textContent = "…";
  try {
    const answer = await post({details: details.dataset.details, what: details.dataset.what});
    if (answer.refused) throw new Error(answer.refused);
    place.innerHTML = answer.html;
  } catch (error) {
    place.textContent = error.message;
    delete details.dataset.loaded;
  }
}
for (const section of document.querySelectorAll("section.to-mark")) {
  rubrics.set(section, JSON.parse(section.querySelector(".rubric-items").textContent));
  editor(section);
}
for (const details of document.querySelectorAll("details.loads")) details.addEventListener("toggle", () => load(details));
for (const [place, article] of answers.entries()) {
  article.addEventListener("focusin", () => { current(place); });
  article.addEventListener("click", event => {
    const button = event.target.closest("[data-item]"), number = event.target.closest("[data-give]");
    if (button) toggle(article, button);
    if (number) give(article, number.dataset.give);
    if (event.target.closest(".accept")) give(article, article.dataset.outOf);
    if (event.target.closest(".stands")) {
      const words = article.querySelector("textarea");
      if (!words.value.trim()) { say(article, "say why the mark stands, in the comment", true); words.focus(); return; }
      article.dataset.stands = "yes";
      save(article);
      article.dataset.given = "";
      delete article.dataset.stands;
      progress();
    }
  });
  article.addEventListener("change", event => {
    if (event.target.matches(".score")) save(article);
    // A comment alone does not answer a request: the marker says whether the mark stands.
    if (event.target.matches(".words textarea") && (isDone(article) || !article.querySelector(".request"))) save(article);
  });
}
document.addEventListener("keydown", event => {
  const typing = event.target.matches("input, textarea");
  if (typing && (event.key === "Escape" || (event.key === "Enter" && event.target.matches("input.score")))) {
    event.preventDefault();
    event.target.blur();
    return go(at);
  }
  if (typing || event.ctrlKey || event.metaKey || event.altKey) return;
  const article = answers[at];
  const model = () => {
    const own = article.querySelector("details.loads") || article.closest("section").querySelector(".question details.loads");
    own.open = !own.open;
  };
  const keys = {
    j: () => go(at + 1), k: () => go(at - 1), n: () => goPart(1), p: () => goPart(-1),
    f: () => article && give(article, article.dataset.outOf), 0: () => article && give(article, 0),
    c: () => article && article.querySelector(".words textarea").focus(), m: () => article && model(),
  };
  const digit = /^[1-9]$/.test(event.key) && article;
  const act = keys[event.key] || (digit ? () => toggle(article, article.querySelectorAll("[data-item]")[Number(event.key) - 1]) : null);
  if (act) {
    event.preventDefault();
    act();
  }
});
progress();
