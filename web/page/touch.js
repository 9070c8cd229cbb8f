// The strip of keys under the picture: those of the program, and what is asked for.

import { button } from "./notes.js";
import { say } from "./words.js";

const strip = document.getElementById("strip");
const typing = document.getElementById("typing");
const toggle = document.getElementById("keys");

/** Signs on the buttons of keys. */
const SIGNS = { Left: "←", Right: "→", Up: "↑", Down: "↓", Backspace: "⌫", Enter: "⏎", Space: "␣", PageUp: "PgUp", PageDown: "PgDn", Delete: "Del" };
const NUMBER = ["1", "2", "3", "4", "5", "6", "7", "8", "9", "0", ".", "-", "Backspace", "Enter", "Esc"];

/** `press(name)` gives the program a key. */
export class Strip {
  constructor(app, press) {
    Object.assign(this, { app, press, last: "", open: matchMedia("(pointer: coarse)").matches });
    toggle.onclick = () => {
      this.open = !this.open;
      this.draw(true);
    };
    typing.addEventListener("beforeinput", (event) => {
      event.preventDefault();
      if (event.inputType === "deleteContentBackward") press("Backspace");
      else if (event.inputType === "insertLineBreak") press("Enter");
      else for (const sign of event.data ?? "") press(sign === " " ? "Space" : sign);
    });
    typing.addEventListener("keydown", (event) => {
      if (!["Enter", "Escape"].includes(event.key)) return;
      event.preventDefault();
      event.stopPropagation();
      press(event.key === "Enter" ? "Enter" : "Esc");
      typing.blur();
    });
  }

  /** Shows what is right now; cheap when nothing has changed. */
  draw(anew = false) {
    toggle.setAttribute("aria-expanded", String(this.open));
    const now = this.open ? this.app.strip() : "null";
    if (now === this.last && !anew) return;
    this.last = now;
    const shown = JSON.parse(now);
    const was = strip.hidden;
    strip.hidden = !shown;
    if (shown) this.fill(shown);
    if (was !== strip.hidden) dispatchEvent(new Event("resize"));
  }

  fill({ asked, answers, lines }) {
    strip.classList.toggle("asking", Boolean(asked));
    if (asked === "number") {
      strip.replaceChildren(...NUMBER.map((key) => this.key(key)));
    } else if (asked === "text") {
      const type = button(say("type"), () => typing.focus());
      strip.replaceChildren(type, ...["Backspace", "Enter", "Esc"].map((key) => this.key(key)));
    } else if (asked) {
      strip.replaceChildren(...[...answers, "Enter", "Esc"].map((key) => this.key(key)));
    } else {
      const groups = lines.map(({ keys, about }) => {
        const group = document.createElement("div");
        const row = document.createElement("p");
        row.append(...keys.map((key) => this.key(key, about)));
        const words = document.createElement("span");
        words.textContent = about;
        group.append(row, words);
        return group;
      });
      strip.replaceChildren(this.key("Enter"), this.key("Esc"), ...groups);
    }
    strip.scrollLeft = 0;
  }

  key(name, about = "") {
    const made = button(SIGNS[name] ?? name, () => this.press(name));
    made.title = about;
    made.setAttribute("aria-label", about ? `${name}: ${about}` : name);
    // The picture keeps the keyboard.
    made.onpointerdown = (event) => event.preventDefault();
    return made;
  }
}
