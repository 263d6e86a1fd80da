// Python begun beforehand: what its memory holds once everything is imported and has been used once, for a browser to go on from.
// node snapshot.mjs FOLDER OUTPUT < JSON [what Python begins with, [what it is then asked, …]]
import { readFileSync, writeFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [folder, output] = process.argv.slice(2);
const { loadPyodide } = await import(pathToFileURL(`${folder}/pyodide.mjs`));
const [given, asked] = JSON.parse(readFileSync(0, "utf8"));
const python = await loadPyodide({ indexURL: folder, _makeSnapshot: true });
python.FS.writeFile("/tmp/begin.json", JSON.stringify(given));
python.FS.writeFile("/tmp/asked.json", JSON.stringify(asked));
python.runPython(given.start); // no object of JavaScript's may be held: it would not be there any more
python.runPython(`
import gc, json
with open("/tmp/begin.json") as file:
    answered = begin(file.read())
with open("/tmp/asked.json") as file:
    for each in json.load(file):
        answered(*each)
gc.collect()
`);
for (const name of ["begin", "asked"]) python.FS.unlink(`/tmp/${name}.json`);
writeFileSync(output, python.makeMemorySnapshot());
