// The page's own words, in Hungarian and English; those of the programs come from the programs.

const WORDS = {
  subtitle: ["Füzi János: Interaktív grafika (1997) — a könyv programjai a böngészőben", "János Füzi: Interaktív grafika (1997) — the book's programs in the browser"],
  search: ["Keresés:", "Search:"],
  other: ["English", "magyar"],
  files: ["Fájljaim", "My files"],
  about: [
    "Minden itt fut, az Ön gépén: semmi sem kerül máshová. Az első látogatás után hálózat nélkül is működik.",
    "Everything runs here, on your machine; nothing is sent anywhere. After the first visit it works without a network.",
  ],
  drop: [
    "Saját fájlt húzzon az oldalra, vagy a Fájljaim közt válasszon. F1: súgó, F2: nyelv, Shift+Tab: vissza az oldal gombjaihoz.",
    "Drop a file of your own on the page, or choose it under My files. F1: help, F2: language, Shift+Tab: back to the page's buttons.",
  ],
  menu: ["A menü, ahogy az asztalon", "The menu as on the desktop"],
  samples: ["Minták:", "Samples:"],
  back: ["← Programok", "← Programs"],
  share: ["Megosztás", "Share"],
  open: ["Megnyitás…", "Open…"],
  full: ["Teljes képernyő", "Full screen"],
  keys: ["Billentyűk", "Keys"],
  kept: [
    "Ezek a fájlok ebben a böngészőben vannak. Ha a böngésző adatait törli, elvesznek: ami fontos, azt töltse le.",
    "These files are kept in this browser. They are lost when its data is deleted: download what matters.",
  ],
  nothingKept: ["Még nincs itt fájl.", "There is no file here yet."],
  choose: ["Fájl a gépről…", "A file of this machine…"],
  all: ["Mind letöltése (ZIP)", "Download all (ZIP)"],
  close: ["Bezárás", "Close"],
  openOne: ["Megnyitás", "Open"],
  download: ["Letöltés", "Download"],
  rename: ["Átnevezés", "Rename"],
  remove: ["Törlés", "Delete"],
  newName: ["Az új név:", "The new name:"],
  reallyRemove: ["Végleg törli? ", "Delete for good? "],
  taken: ["Már van ilyen nevű fájl: ", "There is a file of this name already: "],
  saved: ["Mentve: ", "Saved: "],
  took: ["Átvéve: ", "Taken: "],
  found: ["találat", "found"],
  nothing: ["Nincs ilyen program.", "No such program."],
  copied: ["A cím a vágólapon van; aki megnyitja, ugyanezt látja:", "The address is on the clipboard; whoever opens it sees the same:"],
  copy: ["Ezt a címet adja tovább; aki megnyitja, ugyanezt látja:", "Pass this address on; whoever opens it sees the same:"],
  noShare: ["Itt most nincs mit megosztani: előbb legyen görbe, felület vagy játék.", "There is nothing to share now: first make a curve, a surface or a game."],
  longAddress: ["A cím hosszú ({n} jel): nem minden program adja tovább épen.", "The address is long ({n} characters): not every program passes it on whole."],
  wrongAddress: ["A cím nem érthető: ", "The address is not understood: "],
  conflict: ["Egy másik lap közben mást mentett ezen a néven; ez itt külön megvan: ", "Another page has saved something else under this name meanwhile; this one is kept apart: "],
  notKept: ["A böngésző nem őrzi meg a fájlokat ({why}): töltse le, ami fontos.", "The browser does not keep files ({why}): download what matters."],
  failed: ["A program megállt: ", "The program has stopped: "],
  noWasm: ["Ez a böngésző nem tudja futtatni a programokat: ", "This browser cannot run the programs: "],
  newer: ["Új változat érkezett; a következő betöltéskor ez indul.", "A new version has come; it starts when the page is loaded next."],
  number: ["szám", "number"],
  type: ["Írás…", "Type…"],
  larger: ["Nagyobb", "Larger"],
};

let language = "en";

export function speak(code) {
  language = code;
  document.documentElement.lang = code;
  for (const element of document.querySelectorAll("[data-say]")) element.textContent = say(element.dataset.say);
}

export const spoken = () => language;
export const say = (name) => WORDS[name][language === "hu" ? 0 : 1];
/** One of a pair [Hungarian, English], as the programs' tables have them. */
export const of = (pair) => pair[language === "hu" ? 0 : 1];
