// One exercise at a time. What is right or wrong is said by the program behind the page; what was done is kept by the browser.
const frame = document.querySelector(".practice"), sheet = document.getElementById("sheet");
const words = JSON.parse(frame.dataset.words);
const problems = [...frame.querySelectorAll("nav button")];
const KEPT = "corollary-practice", DAY = 86400e3;
const REST = [600e3, DAY, 3 * DAY, 7 * DAY, 16 * DAY, 35 * DAY]; // until it comes back: longer each time it is solved
let now = null;

function stored() {
  try { return JSON.parse(localStorage.getItem(KEPT)) || {}; } catch { return {}; }
}
function keep(code, change) {
  const all = stored();
  all[code] = {box: 0, turn: 0, due: 0, seen: 0, ...all[code], ...change};
  try { localStorage.setItem(KEPT, JSON.stringify(all)); } catch { say(document.getElementById("ending"), words.notKept); }
  overview();
}
function overview() {
  const all = stored();
  let done = 0;
  for (const button of problems) {
    const mine = all[button.dataset.code];
    const state = !mine ? "" : mine.box > 0 && mine.due > Date.now() ? "solved" : "open";
    done += state === "solved";
    button.dataset.state = state;
    button.querySelector(".state-text").textContent = state === "open" ? `, ${mine.box ? words.dueAgain : words.goOn}` : "";
    button.setAttribute("aria-current", String(now !== null && now.code === button.dataset.code));
  }
  document.getElementById("done").textContent = words.done.replace("{done}", done).replace("{count}", problems.length);
}
function say(place, text) { place.textContent = text; }

function trouble(place, error) {
  place.replaceChildren();
  const note = document.createElement("p");
  note.className = "note trouble";
  note.textContent = error.message;
  place.append(note);
}

async function begin(code, turn) {
  const kept = stored()[code] || {turn: 0, seen: 0};
  const which = turn === undefined ? kept.turn : turn;
  try {
    const got = await ask({ask: "exercise", code, turn: which});
    now = {code, turn: which, right: new Set(), judged: got.judged, wrong: {}, told: {}, hints: {}, steps: 0, helped: false, finished: false};
    sheet.innerHTML = got.html;
    wire();
    keep(code, {turn: which});
    document.getElementById("title").focus({preventScroll: true});
    window.scrollTo({top: Math.max(0, sheet.getBoundingClientRect().top + window.scrollY - 12)});
  } catch (error) { trouble(sheet, error); }
}

function value(section) {
  const kind = section.dataset.kind;
  if (kind === "options") return (section.querySelector("input:checked") || {value: ""}).value;
  const fields = [...section.querySelectorAll("input[type=text], textarea")].map(each => each.value);
  return fields.length === 1 ? fields[0] : fields.some(each => each.trim()) ? fields : "";
}
function answers() {
  const found = {};
  for (const section of sheet.querySelectorAll("section[data-part]")) {
    if (section.dataset.kind === "none") continue;
    const answer = value(section);
    if (answer !== "") found[section.dataset.part] = answer;
  }
  return found;
}

function wire() {
  for (const section of sheet.querySelectorAll("section[data-part]")) {
    const form = section.querySelector("form");
    if (!form) continue;
    const read = form.querySelector(".read");
    let waiting = 0;
    form.addEventListener("input", () => {
      clearTimeout(waiting);
      waiting = setTimeout(() => preview(section, read), 180);
    });
    form.addEventListener("submit", event => { event.preventDefault(); check(section); });
    form.querySelector(".hint").addEventListener("click", () => hint(section, true));
  }
  document.getElementById("step").addEventListener("click", showStep);
  const other = document.getElementById("other");
  if (other) other.addEventListener("click", () => begin(now.code, now.turn + 1));
}
async function preview(section, place) {
  const answer = value(section);
  if (section.dataset.kind === "options" || answer === "") return say(place, "");
  try {
    const got = await ask({ask: "read", code: now.code, turn: now.turn, part: section.dataset.part, answer});
    if (JSON.stringify(answer) !== JSON.stringify(value(section))) return; // typed on meanwhile
    say(place, got.text);
    place.classList.toggle("unreadable", !got.ok);
  } catch (error) { say(place, error.message); }
}
async function check(section) {
  const part = section.dataset.part, place = section.querySelector(".feedback");
  if (value(section) === "") return say(place, words.empty);
  say(place, words.checking);
  try {
    const got = await ask({ask: "judge", code: now.code, turn: now.turn, part, answers: answers(), wrongBefore: now.told[part] || 0});
    place.innerHTML = got.html;
    if (got.wrong) now.told[part] = (now.told[part] || 0) + 1;
    if (got.right) now.right.add(part);
    else {
      now.right.delete(part);
      now.wrong[part] = (now.wrong[part] || 0) + 1;
      if (!got.person && now.wrong[part] > 2) now.helped = true;
    }
    if (got.person) document.getElementById("step").focus();
    for (const other of sheet.querySelectorAll("section[data-part]")) if (other !== section) hint(other, false);
    finish();
  } catch (error) { trouble(place, error); }
}
function finish() {
  if (now.finished || !now.judged.length || !now.judged.every(part => now.right.has(part))) return;
  now.finished = true;
  const mine = stored()[now.code] || {box: 0};
  const box = now.helped ? 0 : Math.min(REST.length - 1, mine.box + 1);
  keep(now.code, {box, due: Date.now() + REST[box], seen: (mine.seen || 0) + 1, turn: now.turn + 1});
  const count = Math.round(REST[box] / DAY);
  const days = count === 1 ? words.day : words.days.replace("{count}", count);
  say(document.getElementById("ending"), box ? words.solved.replace("{days}", days) : words.again);
  showMotion();
}
// What moves tells what is asked: it is shown to whom has found that, or read all of it.
async function showMotion() {
  const place = sheet.querySelector(".motion");
  if (!place || place.hasChildNodes()) return;
  try {
    const got = await ask({ask: "motion", code: now.code, turn: now.turn});
    if (!got.html || place.hasChildNodes()) return;
    place.innerHTML = got.html;
    animate(place.querySelector(".film"));
  } catch (error) { trouble(place, error); }
}
// One more hint; or, when another part became known, those that no longer fit are made anew. What is shown are always the first
// of the hints for what the student has by now.
async function hint(section, more) {
  const mine = now, part = section.dataset.part, list = section.querySelector(".hints"), shown = mine.hints[part] || [];
  if (!more && !shown.length) return;
  const right = [...mine.right].filter(each => each !== part);
  try {
    const {hints} = await ask({ask: "hints", code: mine.code, turn: mine.turn, part, right});
    if (mine !== now || shown !== (mine.hints[part] || shown)) return; // another exercise, or another press, came first
    const fit = shown.findIndex((each, place) => each !== hints[place]), kept = fit < 0 ? shown.length : fit;
    if (!more && kept === shown.length) return;
    for (const item of [...list.children].slice(kept)) item.remove();
    mine.hints[part] = hints.slice(0, kept + 1);
    const item = document.createElement("li");
    if (kept < hints.length) item.innerHTML = hints[kept];
    else {
      item.textContent = kept ? words.noMoreHints : words.noHint;
      item.className = "last";
    }
    list.append(item);
  } catch (error) { trouble(section.querySelector(".feedback"), error); }
}

// Whoever has seen the steps of a topic often gets them with less in them: first without the result, then without the equations.
function faded(step, seen) {
  const formulas = [...step.querySelectorAll(".formula, pre")];
  const hidden = seen >= 3 ? formulas : seen >= 1 ? formulas.slice(-1) : [];
  if (!hidden.length) return;
  const fold = document.createElement("details"), title = document.createElement("summary");
  title.textContent = `${words.try} ${hidden.length > 1 ? words.equations : words.result}`;
  hidden[0].before(fold);
  fold.append(title, ...hidden);
}
function topicSeen() {
  const all = stored(), topic = problems.find(each => each.dataset.code === now.code).dataset.topic;
  return problems.filter(each => each.dataset.topic === topic).reduce((sum, each) => sum + ((all[each.dataset.code] || {}).shown || 0), 0);
}
async function showStep() {
  const button = document.getElementById("step"), place = sheet.querySelector(".worked");
  try {
    const got = await ask({ask: "step", code: now.code, turn: now.turn, place: now.steps});
    const step = document.createElement("div");
    step.innerHTML = got.html;
    faded(step, topicSeen());
    place.append(step);
    place.hidden = false;
    now.steps += 1;
    now.helped = true;
    if (got.last) {
      button.hidden = true;
      step.tabIndex = -1;
      step.focus({preventScroll: true}); // where the button was that goes: a keyboard begins no page anew
      showMotion();
      const mine = stored()[now.code] || {};
      keep(now.code, {box: 0, due: Date.now() + REST[0], shown: (mine.shown || 0) + 1});
    }
  } catch (error) { trouble(place, error); place.hidden = false; }
}

// What is due comes first, the longest due before the others; then what is new; and each time of another topic than the last, if there is one.
function next() {
  if (waiting.length) return open(...waiting.shift());
  const all = stored(), at = Date.now();
  const topic = now && problems.find(each => each.dataset.code === now.code).dataset.topic;
  const others = list => {
    const elsewhere = list.filter(each => each.dataset.topic !== topic);
    return elsewhere.length ? elsewhere : list;
  };
  const left = problems.filter(each => !now || each.dataset.code !== now.code);
  const due = left.filter(each => all[each.dataset.code] && all[each.dataset.code].due <= at)
    .sort((one, two) => all[one.dataset.code].due - all[two.dataset.code].due);
  const fresh = left.filter(each => !all[each.dataset.code])
    .sort((one, two) => one.dataset.difficulty - two.dataset.difficulty);
  const chosen = others(due)[0] || others(fresh)[0];
  if (!chosen) return say(document.getElementById("done"), words.noneDue);
  open(chosen.dataset.code);
}
// An exercise with these numbers (those that come next where it is left out).
function open(code, turn) {
  const button = problems.find(each => each.dataset.code === code);
  if (!button) return;
  button.closest("details").open = true;
  begin(code, turn);
}
// A practice sheet names exercises by code and number, X12.6/17: in the command that opens the page, or behind its address.
const waiting = JSON.parse(frame.dataset.sheet || "[]");
function linked() {
  const [, code, turn] = /^#([^/]+)\/(\d+)$/.exec(decodeURIComponent(location.hash)) || [];
  if (code) open(code, Number(turn));
}
addEventListener("hashchange", linked);

addEventListener("beforeprint", () => { for (const words of sheet.querySelectorAll(".motion details")) words.open = true; }); // paper moves nothing
for (const button of problems) button.addEventListener("click", () => begin(button.dataset.code));
document.getElementById("next").addEventListener("click", next);
document.getElementById("forget").addEventListener("click", () => {
  try { localStorage.removeItem(KEPT); } catch { /* nothing was kept */ }
  overview();
});
overview();
if (waiting.length) next();
else linked();
