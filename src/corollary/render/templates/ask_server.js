// What the page asks is answered by the program that serves it.
async function ask(what) {
  let answer;
  try {
    answer = await fetch("give", {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(what)});
  } catch { throw new Error(words.ended); }
  if (!answer.ok) throw new Error(await answer.text());
  return answer.json();
}
