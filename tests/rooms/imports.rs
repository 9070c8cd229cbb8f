//! What a Rust source imports, as far as rooms need it: every path from `crate`, `super`, `self` or the
//! library's own name, in `use` and anywhere else. Comments and strings are left out.

/// A path that a source names, from the root of its crate.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Import {
    /// Names from the root on: `["screen", "Color"]`. A star stands for all names.
    pub(crate) path: Vec<String>,
    /// What the source calls it: the last name of the path, or the one after `as`.
    pub(crate) name: String,
    /// Whether the path began with the library's name, so that it cannot mean a module of a program.
    pub(crate) by_name: bool,
    /// Whether it stands in a module that is there for unit tests only.
    pub(crate) in_tests: bool,
}

/// What a source imports. `module` is its own path from the root; `children` are modules that a `use`
/// may begin with, because they are declared here.
pub(crate) fn imports(source: &str, module: &[String], children: &[String]) -> Vec<Import> {
    let tokens = tokens(source);
    let mut reader = Reader { tokens: &tokens, at: 0, nested: Vec::new(), found: Vec::new() };
    reader.read(module, children);
    reader.found
}

/// Names, `::`, and single characters for all the rest.
fn tokens(source: &str) -> Vec<String> {
    let text: Vec<char> = source.chars().collect();
    let mut tokens = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        at += match rest {
            ['/', '/', ..] => rest.iter().position(|&c| c == '\n').unwrap_or(rest.len()),
            ['/', '*', ..] => comment(rest),
            ['"', ..] => string(rest),
            ['\'', '\\', _, tail @ ..] => 4 + tail.iter().position(|&c| c == '\'').unwrap_or(tail.len()),
            ['\'', _, '\'', ..] => 3,
            // A lifetime.
            ['\'', ..] => 1,
            [':', ':', ..] => {
                tokens.push("::".to_string());
                2
            }
            [first, ..] if is_name(*first) => {
                let length = rest.iter().position(|&c| !is_name(c)).unwrap_or(rest.len());
                let name: String = rest[..length].iter().collect();
                match raw_string(&name, &rest[length..]) {
                    Some(string) => length + string,
                    None => {
                        tokens.push(name);
                        length
                    }
                }
            }
            [space, ..] if space.is_whitespace() => 1,
            [other, ..] => {
                tokens.push(other.to_string());
                1
            }
            [] => break,
        };
    }
    tokens
}

fn is_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The length of a block comment, which may hold others.
fn comment(text: &[char]) -> usize {
    let (mut depth, mut at) = (0, 0);
    loop {
        match text[at..] {
            ['/', '*', ..] => (depth, at) = (depth + 1, at + 2),
            ['*', '/', ..] => (depth, at) = (depth - 1, at + 2),
            [] => return at,
            _ => at += 1,
        }
        if depth == 0 {
            return at;
        }
    }
}

/// The length of a string with its quotes.
fn string(text: &[char]) -> usize {
    let mut at = 1;
    while at < text.len() && text[at] != '"' {
        at += if text[at] == '\\' { 2 } else { 1 };
    }
    at + 1
}

/// The length of a raw string after its `r` or `br`, if there is one.
fn raw_string(name: &str, text: &[char]) -> Option<usize> {
    let hashes = text.iter().take_while(|&&c| c == '#').count();
    if !matches!(name, "r" | "br" | "cr") || text.get(hashes) != Some(&'"') {
        return None;
    }
    let is_end =
        |at: &usize| text[*at] == '"' && text[at + 1..].iter().take_while(|&&c| c == '#').count() >= hashes;
    let end = (hashes + 1..text.len()).find(is_end).unwrap_or(text.len());
    Some(end + 1 + hashes)
}

/// A module written inside a file.
#[derive(Clone)]
struct Inner {
    name: String,
    tests: bool,
}

struct Reader<'t> {
    tokens: &'t [String],
    at: usize,
    /// The braces that are open; those of modules have a name.
    nested: Vec<Option<Inner>>,
    found: Vec<Import>,
}

impl Reader<'_> {
    fn token(&self, ahead: usize) -> &str {
        self.tokens.get(self.at + ahead).map_or("", String::as_str)
    }

    fn read(&mut self, module: &[String], children: &[String]) {
        // Whether the item to come is for tests only.
        let mut tests = false;
        while self.at < self.tokens.len() {
            let behind_path =
                self.at > 1 && self.tokens[self.at - 1] == "::" && is_word(&self.tokens[self.at - 2]);
            let in_use = self.at > 0 && self.tokens[self.at - 1] == "use";
            match self.token(0) {
                "#" if (2..6).map(|ahead| self.token(ahead)).eq(["cfg", "(", "test", ")"]) => {
                    (tests, self.at) = (true, self.at + 7);
                }
                "mod" if self.token(2) == "{" => {
                    let outer = self.nested.iter().flatten().any(|inner| inner.tests);
                    self.nested.push(Some(Inner { name: self.token(1).to_string(), tests: tests || outer }));
                    (tests, self.at) = (false, self.at + 3);
                }
                "{" => {
                    self.nested.push(None);
                    self.at += 1;
                }
                "}" => {
                    self.nested.pop();
                    (tests, self.at) = (false, self.at + 1);
                }
                ";" => (tests, self.at) = (false, self.at + 1),
                "crate" | "grafika" if self.token(1) == "::" && !behind_path => {
                    let by_name = self.token(0) == "grafika";
                    self.at += 2;
                    self.tree(&[], by_name, tests);
                }
                "super" | "self" if self.token(1) == "::" && !behind_path => self.relative(module, tests),
                name if in_use && children.iter().any(|child| child == name) => {
                    let prefix = self.module(module);
                    self.tree(&prefix, false, tests);
                }
                _ => self.at += 1,
            }
        }
    }

    /// The module that is read now.
    fn module(&self, file: &[String]) -> Vec<String> {
        file.iter().cloned().chain(self.nested.iter().flatten().map(|inner| inner.name.clone())).collect()
    }

    /// A path that goes up first.
    fn relative(&mut self, file: &[String], tests: bool) {
        let mut prefix = self.module(file);
        while matches!(self.token(0), "super" | "self") && self.token(1) == "::" {
            if self.token(0) == "super" {
                prefix.pop();
            }
            self.at += 2;
        }
        self.tree(&prefix, false, tests);
    }

    /// What stands behind a prefix: a name, a path, or several in braces.
    fn tree(&mut self, prefix: &[String], by_name: bool, tests: bool) {
        let mut path = prefix.to_vec();
        loop {
            match self.token(0) {
                "{" => {
                    self.at += 1;
                    while !matches!(self.token(0), "}" | "") {
                        self.tree(&path, by_name, tests);
                        while !matches!(self.token(0), "," | "}" | "") {
                            self.at += 1;
                        }
                        if self.token(0) == "," {
                            self.at += 1;
                        }
                    }
                    self.at += 1;
                    return;
                }
                "super" => {
                    path.pop();
                    self.at += 1;
                }
                "self" => self.at += 1,
                name if name == "*" || is_word(name) => {
                    path.push(name.to_string());
                    self.at += 1;
                }
                _ => break,
            }
            if self.token(0) != "::" {
                break;
            }
            self.at += 1;
        }
        let in_tests = tests || self.nested.iter().flatten().any(|inner| inner.tests);
        let last = path.last().map_or("", String::as_str);
        let name = if self.token(0) == "as" { self.token(1) } else { last }.to_string();
        self.found.push(Import { path, name, by_name, in_tests });
    }
}

fn is_word(token: &str) -> bool {
    token.starts_with(is_name)
}
