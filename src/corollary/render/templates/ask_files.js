// What the page asks is answered from files beside it, and by Python in the browser: nothing is fetched, nothing is sent.
globalThis.exercises = {};
globalThis.pyodideData = {};
const verdicts = JSON.parse(document.querySelector(".practice").dataset.verdicts), loaded = new Map();
function load(path) {
  if (!loaded.has(path)) loaded.set(path, new Promise((done, failed) => {
    const script = document.createElement("script");
    script.src = path;
    script.onload = done;
    script.onerror = () => failed(new Error(words.missing.replace("{file}", path)));
    document.head.append(script);
  }));
  return loaded.get(path);
}
function bytes(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const letters = atob(text), found = new Uint8Array(letters.length);
  for (let i = 0; i < found.length; i += 1) found[i] = letters.charCodeAt(i);
  return found;
}
const unpacked = text => new Blob([bytes(text)]).stream().pipeThrough(new DecompressionStream("gzip"));
let python = null;
// Python goes on from a memory in which it has begun already, where there is one beside the page; else it begins here.
function reader() {
  python ??= (async () => {
    const memory = load("pyodide/snapshot.js").then(() => new Response(unpacked(pyodideData.snapshot)).arrayBuffer()).catch(() => null);
    await Promise.all(["pyodide.js", "program.js", "binary.js", "library.js", "lock.js"].map(name => load(`pyodide/${name}`)));
    globalThis.fetch = async address => {
      const name = String(address.url || address).split("/").pop();
      if (name === "pyodide.asm.wasm") return new Response(unpacked(pyodideData.binary), {headers: {"Content-Type": "application/wasm"}});
      if (name === "python_stdlib.zip") return new Response(bytes(pyodideData.library), {headers: {"Content-Type": "application/zip"}});
      return new Response("", {status: 404});
    };
    const options = {indexURL: "memory:/", stdLibURL: "memory:/python_stdlib.zip", createPyodideModule: pyodideProgram, lockFileContents: pyodideData.lock, checkAPIVersion: false};
    const found = await memory;
    if (found) try {
      return (await loadPyodide({...options, _loadSnapshot: found})).globals.get("answered");
    } catch (error) { console.warn(error); } // a browser that cannot go on from it
    await load("pyodide/reading.js");
    const made = await loadPyodide(options);
    made.runPython(pyodideData.reading.start);
    return made.globals.get("begin")(JSON.stringify(pyodideData.reading));
  })();
  return python;
}
setTimeout(reader, 50); // while the reader still reads
const escaped = text => { const node = document.createElement("p"); node.textContent = text; return node.innerHTML; };

// What an author says stands in the file as HTML; the rest of a sentence is text, in which *a word* may be stressed.
function shown(text, said) {
  const found = Object.keys(said).filter(each => each && text.includes(each)).sort((one, two) => two.length - one.length)[0];
  if (!found) return escaped(text).replace(/\*([^*]+)\*/g, "<em>$1</em>");
  const at = text.indexOf(found);
  return shown(text.slice(0, at), said) + said[found] + shown(text.slice(at + found.length), said);
}

async function ask(what) {
  await load(`exercises/${what.code}.js`);
  const all = exercises[what.code], its = all[what.turn % all.length];
  const python = async (kind, given) => JSON.parse((await reader())(kind, its.key, what.part, JSON.stringify(given)));
  switch (what.ask) {
    case "exercise": return {html: its.html, judged: its.judged};
    case "motion": return {html: its.motion};
    case "step": return {html: its.steps[what.place], last: what.place + 1 >= its.steps.length};
    case "hints": {
      let hints = its.hints[what.part];
      while (hints.part) hints = what.right.includes(hints.part) ? hints.known : hints.unknown;
      return {hints};
    }
    case "read": return its.read.includes(what.part) ? python("read", what.answer) : {ok: true, text: ""};
    case "judge": {
      if (!its.judged.includes(what.part)) return {html: verdicts.compare, right: false, person: true};
      const got = await python("judge", what.answers);
      const told = got.word === "wrong" && its.advice[what.part] || [""]; // one wrong answer after the other is told something else
      const advice = told[Math.min(what.wrongBefore, told.length - 1)];
      const isSaid = verdicts[got.word].includes(`${escaped(got.text.replace(/\.$/, ""))}</span>`); // by the verdict above it
      const text = isSaid ? "" : shown(got.text, its.said);
      const said = got.word === "right" || !text && !advice ? "" : `<p>${text} ${advice}</p>`;
      return {html: verdicts[got.word].replace("</div>", `${said}</div>`), right: got.known, wrong: got.word === "wrong", person: got.word === "unmarked"};
    }
  }
}
