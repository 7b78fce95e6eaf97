//! What a source file of Rust names: its parts, what it imports, each path in its code, and whose methods it writes and calls.

use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::str::FromStr;

/// A file, its tests left out.
#[derive(Debug, Default)]
pub(crate) struct Source {
    /// Modules that it declares in files of their own.
    pub(crate) parts: BTreeSet<String>,
    pub(crate) imports: Vec<Import>,
    /// Paths of two and more names.
    pub(crate) paths: BTreeSet<Vec<String>>,
    /// Types, functions, constants and macros that it defines.
    pub(crate) items: BTreeSet<String>,
    /// Methods that it writes, each with its type.
    pub(crate) methods: BTreeSet<(String, String)>,
    /// Methods that it calls on itself or on something else.
    pub(crate) calls: BTreeSet<String>,
    /// In how many modules written out in it the reader is: there `super` is a module of this file, or the file.
    inside: usize,
}

/// One name that a `use` brings.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Import {
    pub(crate) path: Vec<String>,
    /// The name here; `*` for all.
    pub(crate) name: String,
    /// Others may take it from here.
    pub(crate) public: bool,
}

/// Reads the text of a file.
pub(crate) fn read(text: &str) -> Source {
    let mut source = Source::default();
    let tokens = TokenStream::from_str(text).expect("a file that compiles");
    source.walk(&list(tokens));
    source
}

fn list(tokens: TokenStream) -> Vec<TokenTree> {
    tokens.into_iter().collect()
}

fn ident(tree: Option<&TokenTree>) -> Option<String> {
    match tree {
        Some(TokenTree::Ident(name)) => Some(name.to_string()),
        _ => None,
    }
}

fn is(tree: Option<&TokenTree>, sign: char) -> bool {
    matches!(tree, Some(TokenTree::Punct(one)) if one.as_char() == sign)
}

fn braced(tree: &TokenTree) -> Option<Vec<TokenTree>> {
    match tree {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
            Some(list(group.stream()))
        }
        _ => None,
    }
}

/// Where the block of a `mod` stands that is written out, its name in a macro or not.
fn written_out(trees: &[TokenTree]) -> Option<usize> {
    let block = |at: &usize| trees.get(*at).is_some_and(|tree| braced(tree).is_some());
    [2, 3].into_iter().find(block)
}

/// How many trees an item takes: to its block or its semicolon.
fn item(trees: &[TokenTree]) -> usize {
    let ends = |tree: &TokenTree| braced(tree).is_some() || is(Some(tree), ';');
    trees
        .iter()
        .position(ends)
        .map_or(trees.len(), |end| end + 1)
}

impl Source {
    fn walk(&mut self, trees: &[TokenTree]) {
        let mut at = 0;
        let mut public = false;
        while let Some(tree) = trees.get(at) {
            let rest = &trees[at..];
            let (word, next) = (ident(Some(tree)), ident(rest.get(1)));
            match (word.as_deref(), next) {
                (Some("pub"), _) => {
                    public = true;
                    at += 1;
                    if matches!(trees.get(at), Some(TokenTree::Group(_))) {
                        at += 1;
                    }
                    continue;
                }
                (Some("use"), _) => {
                    let end = item_of_use(rest);
                    self.import(&rest[1..end - 1], &[], public);
                    at += end;
                }
                (Some("mod"), Some(name)) if is(rest.get(2), ';') => {
                    self.parts.insert(name);
                    at += 3;
                }
                (Some("mod"), _) if let Some(end) = written_out(rest) => {
                    self.inside += 1;
                    self.walk(&braced(&rest[end]).unwrap_or_default());
                    self.inside -= 1;
                    at += end + 1;
                }
                (
                    Some("struct" | "enum" | "trait" | "type" | "fn" | "const" | "static"),
                    Some(name),
                ) => {
                    self.items.insert(name);
                    at += 2;
                }
                (Some("macro_rules"), _) => {
                    self.items.extend(ident(rest.get(2)));
                    at += 3;
                }
                (Some("impl"), _) => {
                    self.implement(rest);
                    at += 1;
                }
                (Some(_), _) if is(rest.get(1), ':') && is(rest.get(2), ':') => {
                    at += self.path(rest);
                }
                _ => {
                    at += self.other(rest);
                }
            }
            public = false;
        }
    }

    /// Attributes, calls and groups; how many trees were taken.
    fn other(&mut self, rest: &[TokenTree]) -> usize {
        if is(rest.first(), '#')
            && let Some(TokenTree::Group(attribute)) = rest.get(1)
        {
            let text = attribute.stream().to_string().replace(' ', "");
            let test = text == "cfg(test)" || text == "test";
            return 2 + if test { item(&rest[2..]) } else { 0 };
        }
        if is(rest.first(), '.')
            && let Some(name) = ident(rest.get(1))
        {
            // Not `if here.field { … }`.
            let called = |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis);
            if rest.get(2).is_some_and(called) {
                self.calls.insert(name);
            }
            return 2;
        }
        if let Some(TokenTree::Group(group)) = rest.first() {
            self.walk(&list(group.stream()));
        }
        1
    }

    /// A path; how many trees it takes.
    fn path(&mut self, trees: &[TokenTree]) -> usize {
        let mut names = Vec::new();
        let mut at = 0;
        while let Some(name) = ident(trees.get(at)) {
            names.push(name);
            at += 1;
            if !(is(trees.get(at), ':') && is(trees.get(at + 1), ':')) {
                break;
            }
            at += 2;
        }
        self.seen_from_here(&mut names);
        self.paths.insert(names);
        at
    }

    /// What a module that is written out here calls `super` is found in this file.
    fn seen_from_here(&self, path: &mut [String]) {
        for name in path.iter_mut().take(self.inside) {
            if *name == "super" {
                *name = "self".to_owned();
            }
        }
    }

    /// The names of a `use`, without the word and the semicolon.
    fn import(&mut self, trees: &[TokenTree], before: &[String], public: bool) {
        let mut path = before.to_vec();
        let mut at = 0;
        while let Some(tree) = trees.get(at) {
            if let Some(inner) = braced(tree) {
                for one in inner.split(|tree| is(Some(tree), ',')) {
                    self.import(one, &path, public);
                }
                return;
            }
            if is(Some(tree), '*') {
                let name = "*".to_owned();
                self.bring(path, name, public);
                return;
            }
            match ident(Some(tree)).as_deref() {
                Some("as") => {
                    let name = ident(trees.get(at + 1)).unwrap_or_default();
                    self.bring(path, name, public);
                    return;
                }
                Some("self") if !path.is_empty() => {}
                Some(name) => path.push(name.to_owned()),
                None => {}
            }
            at += 1;
        }
        if let Some(name) = path.last().cloned() {
            self.bring(path, name, public);
        }
    }

    fn bring(&mut self, mut path: Vec<String>, name: String, public: bool) {
        self.seen_from_here(&mut path);
        self.imports.push(Import { path, name, public });
    }

    /// Notes the methods of an `impl` without a trait.
    fn implement(&mut self, trees: &[TokenTree]) {
        let Some(block) = trees.iter().position(|tree| braced(tree).is_some()) else {
            return;
        };
        let (mut depth, mut of) = (0, None);
        for tree in &trees[1..block] {
            match tree {
                TokenTree::Punct(sign) if sign.as_char() == '<' => depth += 1,
                TokenTree::Punct(sign) if sign.as_char() == '>' => depth -= 1,
                TokenTree::Ident(name) if depth == 0 && name == "for" => return,
                TokenTree::Ident(name) if depth == 0 && name != "where" => {
                    of = Some(name.to_string());
                }
                _ => {}
            }
        }
        let (Some(of), Some(inner)) = (of, braced(&trees[block])) else {
            return;
        };
        for pair in inner.windows(2) {
            if let (Some("fn"), Some(name)) = (ident(pair.first()).as_deref(), ident(pair.get(1))) {
                self.methods.insert((of.clone(), name));
            }
        }
    }
}

/// A `use` ends at its semicolon; its braces are no block.
fn item_of_use(trees: &[TokenTree]) -> usize {
    let end = trees.iter().position(|tree| is(Some(tree), ';'));
    end.map_or(trees.len(), |end| end + 1)
}

#[test]
fn what_a_file_names_is_read() {
    let source = read(
        "//! X.\nmod part;\npub use part::{A, b::C as D};\nuse super::*;\n#[cfg(test)]\nmod tests { use crate::never; }\n\
         pub(crate) struct Own;\nimpl<T> Own { fn made(&self) -> u8 { crate::x::y(self.call(1)); if self.field { 1 } } }\n\
         impl Other for Own { fn not(&self) {} }\nmod inner { use super::Own; use super::super::Above; }\n// crate::comment\nconst S: &str = \"crate::text\";\n",
    );
    let import = |path: &str, name: &str, public| Import {
        path: path.split("::").map(str::to_owned).collect(),
        name: name.to_owned(),
        public,
    };
    assert_eq!(
        source.imports,
        [
            import("part::A", "A", true),
            import("part::b::C", "D", true),
            import("super", "*", false),
            // Of what is written out here `super` is this file.
            import("self::Own", "Own", false),
            import("self::super::Above", "Above", false)
        ]
    );
    let paths: Vec<String> = source.paths.iter().map(|path| path.join("::")).collect();
    assert_eq!(paths, ["crate::x::y"]);
    assert!(source.parts.contains("part") && source.items.contains("Own"));
    let made = ("Own".to_owned(), "made".to_owned());
    assert_eq!(source.methods.into_iter().collect::<Vec<_>>(), [made]);
    assert_eq!(source.calls.into_iter().collect::<Vec<_>>(), ["call"]);
}
