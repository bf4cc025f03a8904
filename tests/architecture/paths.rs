//! Rust source as far as its paths go: a tokenizer and a reader of paths, groups of imports expanded.

/// An identifier, `::`, or a single other character of the code.
#[derive(Debug, Clone, PartialEq)]
pub struct Token {
    pub text: String,
    pub line: usize,
}

/// The code without comments, strings, characters and numbers.
pub fn tokenize(source: &str) -> Vec<Token> {
    let text: Vec<char> = source.chars().collect();
    let starts = |at: usize, what: &str| what.chars().enumerate().all(|(k, c)| text.get(at + k) == Some(&c));
    let is_word = |c: &char| c.is_alphanumeric() || *c == '_';
    let (mut tokens, mut at, mut line) = (Vec::new(), 0, 1);
    while let Some(&c) = text.get(at) {
        let begin = at;
        if starts(at, "//") {
            at += text[at..].iter().take_while(|c| **c != '\n').count();
        } else if starts(at, "/*") {
            at = after_comment(&text, at);
        } else if c == '"' {
            at = after_string(&text, at);
        } else if c == '\'' {
            // A character, or else a lifetime, whose name may follow as a word.
            at += if text.get(at + 1) == Some(&'\\') {
                3 + text[at + 3..].iter().take_while(|c| **c != '\'').count() + 1
            } else if text.get(at + 2) == Some(&'\'') {
                3
            } else {
                1
            };
        } else if is_word(&c) {
            at += text[at..].iter().take_while(|c| is_word(c)).count();
            let word: String = text[begin..at].iter().collect();
            let hashes = text[at..].iter().take_while(|c| **c == '#').count();
            if ["r", "br", "cr"].contains(&word.as_str()) && text.get(at + hashes) == Some(&'"') {
                let end = format!("\"{}", "#".repeat(hashes));
                at += hashes + 1;
                while at < text.len() && !starts(at, &end) {
                    at += 1;
                }
                at += end.len();
            } else if !c.is_numeric() {
                tokens.push(Token { text: word, line });
            }
        } else if starts(at, "::") {
            tokens.push(Token { text: "::".to_owned(), line });
            at += 2;
        } else {
            if !c.is_whitespace() {
                tokens.push(Token { text: c.to_string(), line });
            }
            at += 1;
        }
        line += text[begin..at.min(text.len())].iter().filter(|c| **c == '\n').count();
    }
    tokens
}

/// The place after a block comment, which may hold others.
fn after_comment(text: &[char], start: usize) -> usize {
    let (mut at, mut open) = (start, 0);
    while at < text.len() {
        match text[at..].first_chunk() {
            Some(['/', '*']) => (open, at) = (open + 1, at + 2),
            Some(['*', '/']) => (open, at) = (open - 1, at + 2),
            _ => at += 1,
        }
        if open == 0 {
            break;
        }
    }
    at
}

/// The place after a string.
fn after_string(text: &[char], start: usize) -> usize {
    let mut at = start + 1;
    while at < text.len() && text[at] != '"' {
        at += if text[at] == '\\' { 2 } else { 1 };
    }
    at + 1
}

/// A path of at least two segments, a group of imports being several.
#[derive(Debug, PartialEq)]
pub struct CodePath {
    /// Starts with `crate` if it leads through the crate root.
    pub segments: Vec<String>,
    pub line: usize,
}

impl CodePath {
    /// The module right below the crate root that a path through the root leads to.
    pub fn inside_crate(&self) -> Option<&str> {
        let (first, rest) = self.segments.split_first()?;
        (first == "crate").then(|| rest.first().map_or("", String::as_str))
    }
}

/// All paths in the code of a module that lies `depth` below the crate root.
pub fn paths(tokens: &[Token], depth: usize) -> Vec<CodePath> {
    let text = |k: usize| tokens.get(k).map_or("", |token| token.text.as_str());
    let mut found = Vec::new();
    // Of every open brace, whether it is that of an inline module.
    let mut braces = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        let (here, next) = (text(at), text(at + 1));
        if here == "{" {
            braces.push(at >= 2 && text(at - 2) == "mod");
        } else if here == "}" {
            braces.pop();
        } else if next == "::" && here != "::" && here.starts_with(|c: char| c.is_alphabetic() || c == '_') {
            let first = found.len();
            at = expand(tokens, at, &[], &mut found);
            let module_depth = depth + braces.iter().filter(|is_module| **is_module).count();
            for path in &mut found[first..] {
                resolve_super(&mut path.segments, module_depth);
            }
            continue;
        }
        at += 1;
    }
    found
}

/// Follows a path from `at`, through groups, and returns the place after it.
fn expand(tokens: &[Token], mut at: usize, prefix: &[String], found: &mut Vec<CodePath>) -> usize {
    let mut segments = prefix.to_vec();
    let line = tokens.get(at).map_or(0, |token| token.line);
    while let Some(token) = tokens.get(at) {
        if token.text == "{" {
            at += 1;
            while tokens.get(at).is_some_and(|token| token.text != "}") {
                let is_item =
                    tokens[at].text != "," && ["{", ",", "::"].contains(&tokens[at - 1].text.as_str());
                at = if is_item { expand(tokens, at, &segments, found).max(at + 1) } else { at + 1 };
            }
            return at + 1;
        }
        if token.text != "*" && !token.text.starts_with(|c: char| c.is_alphabetic() || c == '_') {
            break;
        }
        segments.push(token.text.clone());
        at += 1;
        if tokens.get(at).is_none_or(|token| token.text != "::") {
            break;
        }
        at += 1;
    }
    found.push(CodePath { segments, line });
    at
}

/// Puts `crate` in place of as many leading `super` as lead to the crate root.
fn resolve_super(segments: &mut Vec<String>, depth: usize) {
    let own = usize::from(segments.first().is_some_and(|first| first == "self"));
    let ups = segments[own..].iter().take_while(|segment| *segment == "super").count();
    if ups > 0 && ups >= depth {
        segments.splice(..own + ups, ["crate".to_owned()]);
    }
}
