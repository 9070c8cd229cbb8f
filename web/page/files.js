// The page's list of files: open, download, rename, delete; and files that come from outside.

import { freeName } from "./store.js";
import { note, button } from "./notes.js";
import { say } from "./words.js";

const dialog = document.getElementById("files");
const list = document.getElementById("file-list");

export function download(name, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type: "application/octet-stream" }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const size = (bytes) => (bytes < 10000 ? `${bytes} B` : bytes < 1e7 ? `${Math.round(bytes / 1000)} kB` : `${Math.round(bytes / 1e6)} MB`);

/** Connects the list with the files, the module and what opens one. */
export class Shelf {
  constructor(app, files, open) {
    Object.assign(this, { app, files, open });
    document.getElementById("close-files").onclick = () => dialog.close();
    document.getElementById("all").onclick = () => download("grafika.zip", app.zip());
    const chooser = document.getElementById("chooser");
    document.getElementById("choose").onclick = () => chooser.click();
    document.getElementById("open").onclick = () => chooser.click();
    chooser.onchange = () => {
      this.take([...chooser.files]);
      chooser.value = "";
    };
    for (const name of ["dragover", "dragenter"]) {
      addEventListener(name, (event) => {
        event.preventDefault();
        document.body.classList.add("over");
      });
    }
    addEventListener("dragleave", (event) => event.relatedTarget || document.body.classList.remove("over"));
    addEventListener("drop", (event) => {
      event.preventDefault();
      document.body.classList.remove("over");
      this.take([...event.dataTransfer.files]);
    });
  }

  show() {
    this.fill();
    if (!dialog.open) dialog.showModal();
  }

  refresh() {
    if (dialog.open) this.fill();
  }

  fill() {
    const rows = this.files.list().map(({ name, size: bytes, time }) => {
      const row = document.createElement("li");
      const title = document.createElement("b");
      title.textContent = name;
      const about = document.createElement("small");
      about.textContent = `${size(bytes)} · ${new Date(time).toLocaleString()}`;
      const named = (word, action) => {
        const made = button(say(word), action);
        made.setAttribute("aria-label", `${say(word)}: ${name}`);
        return made;
      };
      row.append(title, about);
      if (this.opens(name)) row.append(named("openOne", () => this.openFile(name)));
      row.append(
        named("download", () => download(name, this.app.file(name))),
        named("rename", () => this.rename(name)),
        named("remove", () => this.remove(name)),
      );
      return row;
    });
    list.replaceChildren(...rows);
    if (!rows.length) list.textContent = say("nothingKept");
    document.getElementById("all").disabled = !rows.length;
  }

  opens(name) {
    try {
      return Boolean(this.app.programOf(name));
    } catch {
      return false;
    }
  }

  openFile(name) {
    try {
      const program = this.app.programOf(name);
      dialog.close();
      this.open({ program, open: name });
    } catch (error) {
      note(String(error), { wrong: true });
    }
  }

  rename(name) {
    const wanted = prompt(say("newName"), name)?.trim();
    if (!wanted || wanted === name) return;
    try {
      this.app.checkName(wanted);
    } catch (error) {
      note(String(error), { wrong: true });
      return;
    }
    const same = wanted.toLowerCase() === name.toLowerCase();
    if (!same && this.files.has(wanted)) {
      note(say("taken") + wanted, { wrong: true });
      return;
    }
    const content = this.app.file(name);
    this.app.removeFile(name);
    this.files.remove(name);
    this.app.setFile(wanted, content);
    this.files.save(wanted, content);
    this.fill();
  }

  remove(name) {
    if (!confirm(say("reallyRemove") + name)) return;
    this.app.removeFile(name);
    this.files.remove(name);
    this.fill();
  }

  /** Files from the user's machine: kept, never over others, and the first that a program opens is opened. */
  async take(given) {
    const names = [];
    for (const file of given) {
      try {
        const content = new Uint8Array(await file.arrayBuffer());
        this.app.checkName(file.name);
        let name = file.name;
        const there = this.app.file(name);
        const same = there && there.length === content.length && there.every((byte, at) => byte === content[at]);
        if (there && !same) name = freeName(name, (free) => this.files.has(free));
        if (!same) {
          this.app.setFile(name, content);
          this.files.save(name, content);
        }
        names.push(name);
      } catch (error) {
        note(`${file.name}: ${error.message ?? error}`, { wrong: true });
      }
    }
    this.refresh();
    if (!names.length) return;
    const first = names.find((name) => this.opens(name));
    if (first) this.openFile(first);
    else {
      note(say("took") + names.join(", "));
      try {
        this.app.programOf(names[0]);
      } catch (error) {
        note(String(error), { wrong: true });
      }
    }
  }
}
