// Short messages in the corner of the page.

const notes = document.getElementById("notes");

/** Shows a message; `parts` are nodes behind it, such as buttons. It goes after a while, or with a click on ×. */
export function note(text, { parts = [], wrong = false, stay = 9000 } = {}) {
  const box = document.createElement("div");
  if (wrong) box.className = "wrong";
  const words = document.createElement("span");
  words.textContent = text;
  const shut = document.createElement("button");
  shut.type = "button";
  shut.textContent = "×";
  shut.onclick = () => box.remove();
  box.append(words, ...parts, shut);
  notes.append(box);
  while (notes.children.length > 4) notes.firstChild.remove();
  if (stay) setTimeout(() => box.remove(), stay);
  return box;
}

export function button(text, action) {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = text;
  made.onclick = action;
  return made;
}
