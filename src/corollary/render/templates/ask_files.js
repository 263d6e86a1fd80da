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
let python = null;
function reader() {
  python ??= (async () => {
    await Promise.all(["pyodide.js", "program.js", "binary.js", "library.js", "lock.js", "reading.js"].map(name => load(`pyodide/${name}`)));
    const given = {"pyodide.asm.wasm": [pyodideData.binary, "application/wasm"], "python_stdlib.zip": [pyodideData.library, "application/zip"]};
    globalThis.fetch = async address => {
      const [text, type] = given[String(address.url || address).split("/").pop()] || [];
      return text ? new Response(bytes(text), {headers: {"Content-Type": type}}) : new Response("", {status: 404});
    };
    const made = await loadPyodide({indexURL: "memory:/", stdLibURL: "memory:/python_stdlib.zip", createPyodideModule: pyodideProgram, lockFileContents: pyodideData.lock, checkAPIVersion: false});
    pyodideData.binary = pyodideData.library = null;
    made.runPython(pyodideData.reading.start);
    return made.globals.get("begin")(JSON.stringify(pyodideData.reading));
  })();
  return python;
}
const escaped = text => { const node = document.createElement("p"); node.textContent = text; return node.outerHTML; };

async function ask(what) {
  await load(`exercises/${what.code}.js`);
  const all = exercises[what.code], its = all[what.turn % all.length];
  const part = its.parts[what.part];
  switch (what.ask) {
    case "exercise":
      setTimeout(reader, 50);
      return {html: its.html, judged: its.judged};
    case "motion": return {html: its.motion};
    case "step": return {html: its.steps[what.place], last: what.place + 1 >= its.steps.length};
    case "hint": {
      const order = Object.keys(its.parts), known = order.findIndex(each => !what.right.includes(each));
      const hints = part.hints[known < 0 ? order.length : known];
      return {html: hints[what.place] || ""};
    }
    case "read": {
      if (!part.asked) return {ok: true, text: ""};
      return JSON.parse((await reader())("read", JSON.stringify(part.asked), JSON.stringify(what.answer)));
    }
    case "judge": {
      if (!part.asked) return {html: verdicts.compare, right: false, person: true};
      const got = JSON.parse((await reader())("judge", JSON.stringify(part.asked), JSON.stringify(what.answers[what.part] ?? "")));
      const said = got.word === "right" ? "" : part.said[got.text] || escaped(got.text);
      return {html: verdicts[got.word].replace("</div>", `${said}</div>`), right: got.word === "right", person: got.word === "unmarked"};
    }
  }
}
