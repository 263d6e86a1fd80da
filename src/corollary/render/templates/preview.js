"use strict";
// Two texts and what is found of them. A text leaves this page only by Save; nothing here loads the page again by itself.
const byId = id => document.getElementById(id);
const desk = document.querySelector(".desk"), shown = byId("shown"), state = byId("state"), list = byId("complaints");
const SIDES = ["problem", "solution"], PAUSE = 150, QUICK = 90, SLOW = 300, IDLE = 600;
const LABELS = {problem: "Problem", solution: "Solution", "": ""};
const texts = Object.fromEntries(SIDES.map(side => [side, {
  area: document.querySelector(`textarea[data-side="${side}"]`), panel: byId(`${side}-panel`), saved: "", fingerprint: "", locked: "", name: "", other: null,
}]));
let open = "", edition = "", number = 0, has = 0, running = false, ended = false, typed = 0, waiting = 0, findings = {complaints: [], notes: []};

async function ask(what, more = {}) {
  const answer = await fetch("give", {
    method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify({ask: what, problem: open, ...more}),
  });
  if (!answer.ok) throw Object.assign(new Error(await answer.text()), {refused: answer.status !== 404});
  return answer.json();
}
const unsaved = side => texts[side].area.value !== texts[side].saved;
const anyUnsaved = () => SIDES.some(unsaved);

// Texts

function lines(side) {
  const {area, panel} = texts[side], mirror = panel.querySelector(".mirror");
  const wrong = new Map();
  for (const each of findings.complaints) if (each.side === side && each.line) wrong.set(each.line, [...(wrong.get(each.line) ?? []), each.sentence]);
  const rows = area.value.split("\n").map((text, place) => {
    const row = document.createElement("div");
    row.dataset.line = place + 1;
    row.textContent = text;
    if (wrong.has(place + 1)) row.className = "wrong";
    return row;
  });
  mirror.replaceChildren(...rows);
  for (const [line, sentences] of wrong) if (rows[line - 1]) beside(mirror, rows, line - 1, sentences.join(" · "));
}
// Behind the end of the line where there is room, else in the empty line below.
function beside(mirror, rows, place, sentence) {
  const row = rows[place], end = document.createElement("span"), note = document.createElement("span");
  row.append(end);
  const left = end.offsetLeft + 20, room = row.clientWidth - left, below = rows[place + 1] && !rows[place + 1].textContent;
  const top = end.offsetTop;
  end.remove();
  if (room < 110 && !below) return;
  note.className = "beside";
  note.textContent = sentence;
  note.style.cssText = room < 110 ? `left: 0; top: ${row.clientHeight}px; max-width: ${row.clientWidth}px` : `left: ${left}px; top: ${top}px; max-width: ${room}px`;
  row.append(note);
}
function put(side, text) {
  const {area, panel} = texts[side], at = [area.selectionStart, area.selectionEnd], top = panel.scrollTop;
  area.value = text;
  area.setSelectionRange(...at);
  panel.scrollTop = top;
}
// As if it were typed, so that Ctrl-Z takes it back.
function type(area, text) {
  area.focus({preventScroll: true});
  if (!document.execCommand("insertText", false, text)) area.setRangeText(text, area.selectionStart, area.selectionEnd, "end");
}
function go(side, line) {
  choose(side);
  const {area, panel} = texts[side], before = area.value.split("\n").slice(0, line - 1).join("\n");
  const at = Math.min(area.value.length, line > 1 ? before.length + 1 : 0);
  area.focus({preventScroll: true});
  area.setSelectionRange(at, at);
  const row = panel.querySelector(".mirror").children[line - 1];
  if (row) panel.scrollTop = Math.max(0, row.offsetTop - panel.clientHeight / 3);
}
function choose(panel) {
  desk.dataset.panel = panel;
  for (const tab of document.querySelectorAll("[role=tab]")) {
    tab.setAttribute("aria-selected", String(tab.dataset.panel === panel));
    tab.tabIndex = tab.dataset.panel === panel ? 0 : -1;
  }
  if (SIDES.includes(panel)) lines(panel);
}
function mark() {
  for (const side of SIDES) {
    const tab = byId(`tab-${side}`), count = tab.querySelector(".count"), wrong = findings.complaints.filter(each => each.side === side).length;
    tab.classList.toggle("unsaved", unsaved(side));
    count.textContent = wrong ? String(wrong) : "";
    count.hidden = !wrong;
  }
  const locked = SIDES.every(side => texts[side].locked);
  byId("save").hidden = locked;
  byId("save").disabled = !anyUnsaved();
  document.title = `${anyUnsaved() ? "● " : ""}${byId("problem").selectedOptions[0]?.textContent ?? "Preview"}`;
}
function say(sentence) { state.textContent = sentence; }
function rest() { say(SIDES.every(side => texts[side].locked) ? "read only" : anyUnsaved() ? "not saved" : "saved"); }

// Notices

function notice(id, sentence, tools = [], text = null) {
  byId(id)?.remove();
  const note = document.createElement("div"), words = document.createElement("p");
  note.id = id;
  note.className = "note trouble";
  note.setAttribute("role", "alert");
  words.textContent = sentence;
  note.append(words);
  if (text !== null) {
    const details = document.createElement("details"), summary = document.createElement("summary"), pre = document.createElement("pre");
    summary.textContent = "Show the text on the disk";
    pre.textContent = text;
    pre.tabIndex = 0;
    details.append(summary, pre);
    note.append(details);
  }
  if (tools.length) {
    const row = document.createElement("p");
    row.className = "tools";
    for (const [label, act] of tools) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = label;
      button.addEventListener("click", () => { note.remove(); act(); });
      row.append(button);
    }
    note.append(row);
  }
  byId("notices").append(note);
}
function conflict(side, found) {
  const one = texts[side];
  notice(`conflict-${side}`, `${one.name} was changed on the disk since you opened it. Nothing is overwritten: choose which text to go on with.`, [
    ["Take the text on the disk", () => {
      choose(side);
      one.area.focus();
      one.area.select();
      type(one.area, found.text);
      Object.assign(one, {saved: found.text, fingerprint: found.fingerprint});
      changed();
    }],
    ["Keep mine", () => { Object.assign(one, {saved: found.text, fingerprint: found.fingerprint}); mark(); say("not saved: Save writes your text over the other"); }],
  ], found.text);
}
function locks() {
  const why = [...new Set(SIDES.map(side => texts[side].locked).filter(Boolean))];
  byId("locked")?.remove();
  if (why.length) notice("locked", `Read only: ${why.join("; ")}.`);
}

// From and to the server

async function load(problem) {
  const found = await ask("open", {problem});
  const other = found.problem !== open;
  open = found.problem;
  edition = found.edition;
  byId("new").hidden = !found.new;
  byId("problem").replaceChildren(...found.problems.map(each => {
    const option = document.createElement("option");
    option.value = each.name;
    option.textContent = each.code ? `${each.code} ${each.name}` : each.name;
    option.selected = each.name === open;
    return option;
  }));
  history.replaceState(null, "", `?problem=${encodeURIComponent(open)}${location.hash}`);
  for (const side of SIDES) {
    const one = texts[side], its = found.files[side];
    Object.assign(one, {name: its.name, locked: its.locked});
    one.area.readOnly = Boolean(its.locked);
    if (!other && its.fingerprint !== one.fingerprint && unsaved(side) && its.text !== one.area.value) {
      conflict(side, its);
      continue;
    }
    if (other || its.text !== one.area.value) put(side, its.text);
    Object.assign(one, {saved: its.text, fingerprint: its.fingerprint});
    byId(`conflict-${side}`)?.remove();
    if (other) one.panel.scrollTop = 0;
  }
  locks();
  rest();
  if (other) findings = {complaints: [], notes: []};
  SIDES.forEach(lines);
  mark();
  await check();
}
async function check() {
  clearTimeout(typed);
  const writes = side => texts[side].name.endsWith(".md") && (texts[side].area.value || !texts[side].locked);
  const drafts = Object.fromEntries(SIDES.filter(writes).map(side => [side, texts[side].area.value]));
  try {
    number = (await ask("check", {texts: drafts})).number;
    running = true;
    soon(QUICK);
  } catch (error) { failed(error); }
}
function soon(pause) {
  clearTimeout(waiting);
  waiting = setTimeout(look, pause);
}
async function look() {
  try {
    const found = await ask("look", {has});
    if (ended) { ended = false; rest(); }
    if (found.number === number) show(found);
    if (found.edition !== edition) return load(open);
    soon(!running ? IDLE : found.seconds > 3 ? SLOW : QUICK);
  } catch (error) { failed(error); soon(2 * IDLE); }
}
function failed(error) {
  if (error.refused) return say(error.message);
  ended = true;
  say(anyUnsaved() ? "corollary preview has ended: your text is in this page only, copy it" : "corollary preview has ended");
}
async function save() {
  const files = Object.fromEntries(SIDES.filter(side => unsaved(side) && !texts[side].locked).map(
    side => [side, {text: texts[side].area.value, fingerprint: texts[side].fingerprint}]));
  if (!Object.keys(files).length) return rest();
  say("saving");
  try {
    const found = await ask("save", {files});
    for (const side of found.conflict) conflict(side, found.files[side]);
    if (found.conflict.length) return say("not saved: changed on the disk");
    edition = found.edition;
    for (const side of Object.keys(files)) Object.assign(texts[side], {saved: files[side].text, fingerprint: found.files[side].fingerprint});
    mark();
    rest();
  } catch (error) {
    failed(error);
    if (error.refused) say(`not saved: ${error.message}`);
  }
}

// What was found

function show(found) {
  const before = JSON.stringify(findings);
  running = found.stage !== "";
  findings = {complaints: found.complaints, notes: found.notes};
  const line = byId("checked"), wrong = found.complaints.length, finished = found.ok !== null;
  const count = wrong === 1 ? "1 complaint" : `${wrong} complaints`, checks = `${found.checks.toLocaleString("en")} checks`;
  line.parentElement.className = `checked${wrong ? " bad" : found.ok ? " good" : ""}`;
  line.textContent = running ? `${wrong ? `${count}; ` : ""}${found.stage === "loading" ? "loading the verifier" : `verifying: ${found.stage}`}` : wrong ? `${count}, ${checks} in ${found.seconds.toFixed(1)} s`
    : finished ? `✓ verified: all hold, ${checks} in ${found.seconds.toFixed(1)} s` : `stopped after ${checks}`;
  byId("stop").hidden = !running;
  byId("again").hidden = running || finished;
  byId("variants").classList.toggle("old", found.shown === false && !running);
  byId("stale").hidden = found.shown || running || !shown.firstChild;
  if (found.html) {
    has = found.number;
    const pane = byId("variants"), top = pane.scrollTop;
    shown.innerHTML = found.html;
    pick(location.hash.slice(1));
    pane.scrollTop = top;
  }
  if (before === JSON.stringify(findings) && list.dataset.summary === found.summary) return;
  list.dataset.summary = found.summary;
  list.replaceChildren(...found.complaints.map(each => item(each, "")), ...found.notes.map(each => item(each, "remark")), ...(found.summary ? [told(found.summary)] : []));
  SIDES.forEach(lines);
  mark();
}
function item(each, kind) {
  const row = document.createElement("li"), button = document.createElement("button"), place = document.createElement("b"), words = document.createElement("span");
  row.className = kind;
  button.type = "button";
  place.textContent = each.side ? `${LABELS[each.side]}${each.line ? ` ${each.line}` : ""}` : "";
  words.textContent = each.sentence;
  button.append(...(each.side ? [place] : []), words);
  if (each.side) button.addEventListener("click", () => go(each.side, each.line || 1));
  row.append(button);
  return row;
}
function told(text) {
  const row = document.createElement("li"), [first, ...more] = text.split("\n");
  row.className = "told";
  if (!more.length) row.textContent = first;
  else {
    const details = document.createElement("details"), summary = document.createElement("summary");
    summary.textContent = first;
    details.append(summary, more.map(each => each.trim()).join("\n"));
    row.append(details);
  }
  return row;
}
function pick(id) {
  const sheets = [...shown.querySelectorAll(".sheet")], wanted = sheets.find(each => each.id === id) ?? sheets[0];
  for (const each of sheets) each.classList.toggle("chosen", each === wanted);
  for (const link of shown.querySelectorAll(".draws tbody a")) link.closest("tr").classList.toggle("chosen", wanted && link.hash === `#${wanted.id}`);
  return wanted;
}

// What the author does

function changed() {
  mark();
  rest();
  clearTimeout(typed);
  typed = setTimeout(check, PAUSE);
}
for (const side of SIDES) texts[side].area.addEventListener("input", () => { lines(side); changed(); });
new ResizeObserver(() => SIDES.forEach(lines)).observe(document.querySelector(".write"));
for (const tab of document.querySelectorAll("[role=tab]")) tab.addEventListener("click", () => choose(tab.dataset.panel));
document.querySelector(".tabs").addEventListener("keydown", event => {
  const tabs = [...document.querySelectorAll("[role=tab]")].filter(each => each.offsetParent), by = {ArrowRight: 1, ArrowLeft: -1}[event.key];
  if (!by) return;
  const next = tabs[(tabs.indexOf(document.activeElement) + by + tabs.length) % tabs.length];
  choose(next.dataset.panel);
  next.focus();
});
byId("save").addEventListener("click", save);
document.addEventListener("keydown", event => {
  if ((event.ctrlKey || event.metaKey) && !event.altKey && event.key.toLowerCase() === "s") {
    event.preventDefault();
    save();
  }
});
addEventListener("beforeunload", event => { if (anyUnsaved()) event.preventDefault(); });
byId("stop").addEventListener("click", async () => { await ask("cancel"); look(); });
byId("again").addEventListener("click", check);
byId("problem").addEventListener("change", async event => {
  const wanted = event.target.value;
  if (anyUnsaved() && !confirm("Your text is not saved. Leave it?")) {
    event.target.value = open;
    return;
  }
  document.querySelectorAll("[id^=conflict-]").forEach(each => each.remove());
  history.replaceState(null, "", location.pathname + location.search);
  await load(wanted).catch(failed);
});
shown.addEventListener("click", event => {
  const link = event.target.closest('a[href^="#"]');
  if (!link) return;
  event.preventDefault();
  history.replaceState(null, "", `${location.search}${link.hash}`);
  pick(link.hash.slice(1))?.scrollIntoView({block: "start"});
});

// Words

byId("words-panel").addEventListener("click", event => {
  const button = event.target.closest(".insert");
  if (!button) return;
  const {side, inline} = button.closest(".group").dataset, {area, locked} = texts[side];
  if (locked) return say(locked);
  const example = button.closest("li").querySelector("pre").textContent;
  choose(side);
  const at = area.selectionEnd, next = area.value.indexOf("\n", at), end = next < 0 ? area.value.length : next;
  if (inline) return type(area, example);
  area.setSelectionRange(end, end);
  const empty = end === 0 || area.value[end - 1] === "\n";
  type(area, `${empty ? "" : example.startsWith("#") ? "\n\n" : "\n"}${example}`);
});
byId("find").addEventListener("input", event => {
  const wanted = event.target.value.trim().toLowerCase();
  let count = 0;
  for (const group of document.querySelectorAll(".group")) {
    let any = false;
    for (const each of group.querySelectorAll("li")) {
      each.hidden = !each.textContent.toLowerCase().includes(wanted);
      any ||= !each.hidden;
      count += !each.hidden;
    }
    group.hidden = !any;
  }
  byId("found").textContent = wanted ? (count === 1 ? "1 word" : `${count} words`) : "";
});

// A new problem

const creating = byId("creating"), form = creating.querySelector("form"), trouble = creating.querySelector(".trouble");
byId("new").addEventListener("click", () => { trouble.textContent = ""; creating.showModal(); });
creating.querySelector("[value=cancel]").addEventListener("click", () => creating.close());
form.addEventListener("submit", async event => {
  event.preventDefault();
  if (anyUnsaved()) {
    trouble.textContent = "Your text is not saved: save it first.";
    return;
  }
  try {
    const found = await ask("new", {code: form.elements.code.value, name: form.elements.name.value});
    creating.close();
    form.reset();
    await load(found.problem);
    choose("problem");
  } catch (error) { trouble.textContent = error.message; }
});

choose("problem");
pick(location.hash.slice(1));
load(new URLSearchParams(location.search).get("problem") ?? "").catch(error =>
  error.refused && open === "" ? load("").catch(failed) : failed(error));
