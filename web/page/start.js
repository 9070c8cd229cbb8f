// The start page: the programs by groups with pictures, found by typing.

import { of, say } from "./words.js";

const groups = document.getElementById("groups");
const search = document.getElementById("search");
const found = document.getElementById("found");

/** A text as it is searched in: small letters without accents. */
const folded = (text) => text.toLowerCase().normalize("NFD").replace(/\p{M}/gu, "");

const link = (parts) => `#${new URLSearchParams(parts)}`;

function tile(program) {
  const item = document.createElement("li");
  const anchor = document.createElement("a");
  anchor.className = "tile";
  anchor.href = link({ program: program.name });
  const picture = document.createElement("img");
  Object.assign(picture, { src: `pictures/${program.name}.png`, alt: "", loading: "lazy", decoding: "async", width: 640, height: 480 });
  const name = document.createElement("b");
  name.textContent = program.name.toUpperCase();
  const about = document.createElement("span");
  about.textContent = of(program.about);
  anchor.title = of(program.intro);
  anchor.append(picture, name, about);
  item.append(anchor);
  if (program.samples.length) {
    const samples = document.createElement("div");
    samples.className = "samples";
    samples.append(`${say("samples")} `);
    for (const sample of program.samples) {
      const open = document.createElement("a");
      open.href = link({ program: program.name, open: sample });
      open.textContent = sample;
      samples.append(open, " ");
    }
    item.append(samples);
  }
  return item;
}

/** Fills the page with the module's table, as far as it has what is searched for. */
export function show(catalog) {
  const words = folded(search.value).split(/\s+/).filter(Boolean);
  let count = 0;
  const sections = [];
  for (const group of catalog) {
    const has = (program) => {
      const text = folded([program.name, ...program.about, ...program.intro, ...group.name, ...program.samples].join("\n"));
      return words.every((word) => text.includes(word));
    };
    const programs = group.programs.filter(has);
    if (!programs.length) continue;
    count += programs.length;
    const section = document.createElement("section");
    section.setAttribute("aria-labelledby", `group-${group.id}`);
    const title = document.createElement("h2");
    title.id = `group-${group.id}`;
    title.textContent = of(group.name);
    const about = document.createElement("p");
    about.textContent = of(group.about);
    const tiles = document.createElement("ul");
    tiles.className = "tiles";
    tiles.append(...programs.map(tile));
    section.append(title, about, tiles);
    sections.push(section);
  }
  if (!words.length) {
    const menu = document.createElement("p");
    const anchor = document.createElement("a");
    anchor.href = link({ program: "grafika" });
    anchor.textContent = say("menu");
    menu.append(anchor);
    sections.push(menu);
  }
  groups.replaceChildren(...sections);
  found.textContent = words.length ? (count ? `${count} ${say("found")}` : say("nothing")) : "";
}

export function listen(catalog) {
  search.oninput = () => show(catalog);
  search.onkeydown = (event) => {
    // Enter opens the first that is found.
    if (event.key === "Enter") groups.querySelector("a.tile")?.click();
    if (event.key === "Escape") {
      search.value = "";
      show(catalog);
    }
  };
}
