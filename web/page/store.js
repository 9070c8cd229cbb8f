// What outlives the page: files and unsaved work in IndexedDB, settings and best results in localStorage. Several pages may be
// open; none overwrites what it has not seen, and none takes the unsaved work of another that lives.

const NAME = "grafika";
const FILES = "files";
const WORK = "work";

const done = (request) =>
  new Promise((resolve, reject) => {
    request.onsuccess = () => resolve(request.result);
    request.onerror = () => reject(request.error);
  });

const finished = (transaction) =>
  new Promise((resolve, reject) => {
    transaction.oncomplete = () => resolve();
    transaction.onabort = transaction.onerror = () => reject(transaction.error);
  });

function openBase() {
  return new Promise((resolve, reject) => {
    const request = indexedDB.open(NAME, 1);
    request.onupgradeneeded = () => {
      request.result.createObjectStore(FILES, { keyPath: "key" });
      request.result.createObjectStore(WORK, { keyPath: "id" });
    };
    request.onsuccess = () => {
      // A later version of the page may want to change the stores.
      request.result.onversionchange = () => request.result.close();
      resolve(request.result);
    };
    request.onerror = () => reject(request.error);
    request.onblocked = () => reject(new Error("blocked"));
  });
}

/** Names that differ in case only are one file. */
const keyOf = (name) => name.toLowerCase();
const some = () => crypto.getRandomValues(new Uint32Array(4)).join("-");

/** A name beside this one that `has` does not know: A-2.IP2. */
export function freeName(name, has) {
  const dot = name.lastIndexOf(".");
  const [stem, end] = dot > 0 ? [name.slice(0, dot), name.slice(dot)] : [name, ""];
  for (let number = 2; ; number++) {
    const free = `${stem}-${number}${end}`;
    if (!has(free)) return free;
  }
}

/**
 * The files of this browser. `told` gets what changes elsewhere: `arrived(name, content)`, `gone(name)`, `conflict(name)`,
 * `trouble(error)`.
 */
export class Files {
  constructor(told) {
    this.told = told;
    /** By key: name, size, time, and the revision that this page has seen. */
    this.known = new Map();
    this.base = null;
    this.line = Promise.resolve();
    this.others = "BroadcastChannel" in globalThis ? new BroadcastChannel("grafika-files") : null;
    if (this.others) this.others.onmessage = ({ data }) => this.look(data);
    document.addEventListener("visibilitychange", () => document.hidden || this.lookAtAll());
  }

  async load() {
    this.base = await openBase();
    await this.lookAtAll();
  }

  has(name) {
    return this.known.has(keyOf(name));
  }

  list() {
    return [...this.known.values()].sort((one, other) => one.name.localeCompare(other.name));
  }

  /** Keeps a file that the program has saved; the program has it already. */
  save(name, content) {
    const key = keyOf(name);
    const seen = this.known.get(key)?.revision ?? null;
    const record = { key, name, content, revision: some(), time: Date.now() };
    this.note(record);
    return this.queue(() => this.put(record, seen));
  }

  remove(name) {
    const key = keyOf(name);
    this.known.delete(key);
    return this.queue(async () => {
      const transaction = this.base.transaction(FILES, "readwrite");
      transaction.objectStore(FILES).delete(key);
      await finished(transaction);
      this.others?.postMessage(key);
    });
  }

  note({ key, name, content, revision, time }) {
    this.known.set(key, { name, size: content.length, time, revision });
  }

  /** One after the other, in the order of the program. */
  queue(work) {
    const run = async () => {
      try {
        if (!this.base) throw new Error("IndexedDB");
        await work();
        return true;
      } catch (error) {
        this.told.trouble(error);
        return false;
      }
    };
    this.line = this.line.then(run);
    return this.line;
  }

  async put(record, seen) {
    const transaction = this.base.transaction(FILES, "readwrite");
    const store = transaction.objectStore(FILES);
    const there = await done(store.get(record.key));
    if (there && there.revision !== seen) {
      // Another page was quicker. Both are kept.
      const keys = new Set(await done(store.getAllKeys()));
      const name = freeName(record.name, (free) => keys.has(keyOf(free)));
      const kept = { ...record, name, key: keyOf(name) };
      store.put(kept);
      await finished(transaction);
      this.note(there);
      this.note(kept);
      this.told.arrived(there.name, there.content);
      this.told.arrived(kept.name, kept.content);
      this.told.conflict(name);
      this.others?.postMessage(kept.key);
      return;
    }
    store.put(record);
    await finished(transaction);
    this.others?.postMessage(record.key);
  }

  /** Another page has changed a file. */
  look(key) {
    return this.queue(async () => {
      const there = await done(this.base.transaction(FILES).objectStore(FILES).get(key));
      this.take(key, there);
    });
  }

  lookAtAll() {
    if (!this.base) return this.line;
    return this.queue(async () => {
      const all = await done(this.base.transaction(FILES).objectStore(FILES).getAll());
      const keys = new Set(all.map(({ key }) => key));
      for (const key of [...this.known.keys()]) if (!keys.has(key)) this.take(key, undefined);
      for (const record of all) this.take(record.key, record);
    });
  }

  take(key, there) {
    const known = this.known.get(key);
    if (!there) {
      if (!known) return;
      this.known.delete(key);
      this.told.gone(known.name);
    } else if (known?.revision !== there.revision) {
      this.note(there);
      this.told.arrived(there.name, there.content);
    }
  }
}

/**
 * Unsaved work of this page, and of pages that are gone. A page lives as long as it holds the lock of its work; without locks
 * it says so now and then.
 */
export class Work {
  constructor(trouble) {
    this.trouble = trouble;
    this.base = null;
    this.id = some();
    this.line = Promise.resolve();
    /** The newest work that is still to be written. */
    this.next = null;
    /** Work that was taken up, deleted with the next writing. */
    this.taken = [];
    /** What lets go of the lost work that is asked about, by its id. */
    this.reserved = new Map();
    try {
      // Loading again makes this page the heir of itself.
      this.before = sessionStorage.getItem("grafika-page");
      sessionStorage.setItem("grafika-page", this.id);
    } catch {
      this.before = null;
    }
    if (navigator.locks) {
      navigator.locks.request(lockOf(this.id), () => new Promise(() => {})).catch(() => {});
    } else {
      const beat = () => attempt(() => localStorage.setItem(lockOf(this.id), Date.now()));
      beat();
      setInterval(beat, 5000);
      addEventListener("pagehide", () => attempt(() => localStorage.removeItem(lockOf(this.id))));
    }
  }

  async load() {
    this.base = await openBase();
  }

  keep(program, file, content) {
    this.next = { id: this.id, program, file, content, time: Date.now() };
    this.write();
  }

  forget() {
    this.next = "nothing";
    this.write();
  }

  write() {
    this.line = this.line.then(async () => {
      const next = this.next;
      // A later one is written with the first.
      if (!next) return;
      this.next = null;
      try {
        if (!this.base) throw new Error("IndexedDB");
        const transaction = this.base.transaction(WORK, "readwrite", { durability: "strict" });
        const store = transaction.objectStore(WORK);
        if (next === "nothing") store.delete(this.id);
        else store.put(next);
        for (const id of this.taken.splice(0)) store.delete(id);
        await finished(transaction);
      } catch (error) {
        this.trouble(error);
      }
    });
    return this.line;
  }

  /** The work of pages that are gone, newest first, of one program or (without a name) of all. It is reserved for this page. */
  async lost(program) {
    if (!this.base) return [];
    const all = await done(this.base.transaction(WORK).objectStore(WORK).getAll());
    const mine = all.filter((work) => work.id !== this.id && (!program || work.program === program));
    const left = [];
    for (const work of mine.sort((one, other) => other.time - one.time)) {
      if (await this.reserve(work.id)) left.push({ ...work, age: Math.max(0, Date.now() - work.time), time: undefined });
    }
    return left;
  }

  async reserve(id) {
    if (!navigator.locks) {
      const beat = Number(attempt(() => localStorage.getItem(lockOf(id))));
      // Pages in the background are woken once a minute.
      return id === this.before || Date.now() - beat > 90000;
    }
    // The page that is loaded again may still be going.
    const patience = id === this.before ? { signal: AbortSignal.timeout(1500) } : { ifAvailable: true };
    return new Promise((resolve) => {
      const hold = (lock) => {
        resolve(Boolean(lock));
        return lock ? new Promise((release) => this.reserved.set(id, release)) : undefined;
      };
      navigator.locks.request(lockOf(id), patience, hold).catch(() => resolve(false));
    });
  }

  async settle(id, verdict) {
    if (verdict === "taken") this.taken.push(id);
    if (verdict === "deleted" || verdict === "broken") {
      const transaction = this.base.transaction(WORK, "readwrite");
      transaction.objectStore(WORK).delete(id);
      await finished(transaction).catch((error) => this.trouble(error));
    }
    this.release(id);
  }

  release(id) {
    this.reserved.get(id)?.();
    this.reserved.delete(id);
  }

  /** The program has ended: what it did not ask about is free again. */
  releaseAll() {
    for (const id of [...this.reserved.keys()]) this.release(id);
  }
}

const lockOf = (id) => `grafika-work-${id}`;

function attempt(work) {
  try {
    return work();
  } catch {
    return null;
  }
}

/** Texts of a few lines; a browser that keeps none still runs the programs. */
export const recall = (name) => attempt(() => localStorage.getItem(`grafika-${name}`)) ?? undefined;

export function remember(name, text) {
  try {
    localStorage.setItem(`grafika-${name}`, text);
  } catch (error) {
    throw error.message;
  }
}
