// Answers one item in a QTI player: texts go into the fields that a student types into, and what the player then makes of them
// comes back. `attempts` is a list of {identifier: text or option}; returned is a list of {outcome: value}, one for each attempt.
async (attempts) => {
  const container = document.querySelector("item-container");
  const item = container.shadowRoot.querySelector("qti-assessment-item");
  const found = (name) => container.shadowRoot.querySelector(`[response-identifier="${name}"]`);
  const typed = (field, text) => {
    const input = field.shadowRoot.querySelector("input");
    input.value = text;
    for (const event of ["input", "keyup", "change"]) input.dispatchEvent(new Event(event, { bubbles: true }));
  };
  const names = [...container.shadowRoot.querySelectorAll("[response-identifier]")].map((each) => each.getAttribute("response-identifier"));
  const given = [];
  let before = names; // the fields that may hold something
  for (const attempt of attempts) {
    for (const name of new Set([...before, ...Object.keys(attempt)])) {
      const field = found(name);
      if (field.localName === "qti-text-entry-interaction") typed(field, attempt[name] ?? "");
      else item.updateResponseVariable(name, null);
    }
    for (const [name, text] of Object.entries(attempt)) {
      const field = found(name);
      if (field.localName === "qti-choice-interaction" && text)
        field.querySelector(`qti-simple-choice[identifier="${text}"]`).click();
    }
    for (const name of new Set([...before, ...Object.keys(attempt)]))
      if ((attempt[name] ?? "") === "") item.updateResponseVariable(name, null);
    before = Object.keys(attempt);
    item.processResponse();
    given.push(Object.fromEntries(item.variables.filter((each) => each.type === "outcome").map((each) => [each.identifier, each.value])));
  }
  return given;
}
