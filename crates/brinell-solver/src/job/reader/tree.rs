//! A JSON document as written, with the order of its members and repeated keys.
//!
//! `serde_json::Value` silently keeps the last of two equal keys and forgets the order of members.
//! The reader reports repeated keys and sorts its faults in the order of members.

use std::fmt;

use serde::de::{Deserialize, Deserializer, MapAccess, SeqAccess, Visitor};

/// One JSON value.
#[derive(Debug, Clone, PartialEq)]
pub enum Node {
    /// `null`.
    Null,
    /// `true` or `false`.
    Bool(bool),
    /// Any number; always finite.
    Number(f64),
    /// A string.
    Text(String),
    /// An array.
    Array(Vec<Node>),
    /// An object, its members as they were written.
    Object(Vec<(String, Node)>),
}

impl Node {
    /// Returns the type of this value with its article, as in "must be a number, got a string".
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Null => "null",
            Self::Bool(_) => "a boolean",
            Self::Number(_) => "a number",
            Self::Text(_) => "a string",
            Self::Array(_) => "an array",
            Self::Object(_) => "an object",
        }
    }

    /// Returns the value at a JSON pointer; of repeated keys, the first one.
    pub fn at(&self, pointer: &str) -> Option<&Self> {
        steps(pointer).try_fold(self, |node, step| node.child(&step).map(|(_, child)| child))
    }

    /// Returns the position of a pointer in the document: the positions of its steps among their
    /// siblings, which sort lexicographically in document order. A missing member sorts behind its
    /// siblings.
    pub fn position(&self, pointer: &str) -> Vec<usize> {
        let mut node = Some(self);
        steps(pointer)
            .map(|step| {
                let found = node.and_then(|node| node.child(&step));
                node = found.map(|(_, child)| child);
                found.map_or(usize::MAX, |(position, _)| position)
            })
            .collect()
    }

    fn child(&self, step: &str) -> Option<(usize, &Self)> {
        match self {
            Self::Object(members) => {
                let position = members.iter().position(|(key, _)| key == step)?;
                members.get(position).map(|(_, child)| (position, child))
            }
            Self::Array(items) => {
                let position = step.parse().ok()?;
                items.get(position).map(|child| (position, child))
            }
            _ => None,
        }
    }
}

/// Returns the unescaped steps of a JSON pointer.
fn steps(pointer: &str) -> impl Iterator<Item = String> {
    pointer.split('/').skip(1).map(|step| step.replace("~1", "/").replace("~0", "~"))
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_any(NodeVisitor)
    }
}

struct NodeVisitor;

impl<'de> Visitor<'de> for NodeVisitor {
    type Value = Node;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a JSON value")
    }

    fn visit_unit<E>(self) -> Result<Node, E> {
        Ok(Node::Null)
    }

    fn visit_bool<E>(self, value: bool) -> Result<Node, E> {
        Ok(Node::Bool(value))
    }

    fn visit_i64<E>(self, value: i64) -> Result<Node, E> {
        Ok(Node::Number(value as f64))
    }

    fn visit_u64<E>(self, value: u64) -> Result<Node, E> {
        Ok(Node::Number(value as f64))
    }

    fn visit_f64<E>(self, value: f64) -> Result<Node, E> {
        Ok(Node::Number(value))
    }

    fn visit_str<E>(self, value: &str) -> Result<Node, E> {
        Ok(Node::Text(value.to_owned()))
    }

    fn visit_string<E>(self, value: String) -> Result<Node, E> {
        Ok(Node::Text(value))
    }

    fn visit_seq<A: SeqAccess<'de>>(self, mut access: A) -> Result<Node, A::Error> {
        let mut items = Vec::new();
        while let Some(item) = access.next_element()? {
            items.push(item);
        }
        Ok(Node::Array(items))
    }

    fn visit_map<A: MapAccess<'de>>(self, mut access: A) -> Result<Node, A::Error> {
        let mut members = Vec::new();
        while let Some(member) = access.next_entry()? {
            members.push(member);
        }
        Ok(Node::Object(members))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn node(text: &str) -> Node {
        serde_json::from_str(text).unwrap()
    }

    #[test]
    fn keeps_order_and_duplicates() {
        let expected = [("b", 1.0), ("a", -2.0), ("b", 3.5)];
        let members = expected.map(|(key, value)| (key.to_owned(), Node::Number(value)));
        assert_eq!(node(r#"{"b": 1, "a": -2, "b": 3.5}"#), Node::Object(members.to_vec()));
    }

    #[test]
    fn pointers_are_unescaped() {
        let tree = node(r#"{"a/b": {"~1": [null, true]}}"#);
        assert_eq!(tree.at("/a~1b/~01/1"), Some(&Node::Bool(true)));
        assert_eq!(tree.at("/a~1b/~01/2"), None);
        assert_eq!(tree.at(""), Some(&tree));
    }

    #[test]
    fn positions_sort_in_document_order() {
        let tree = node(r#"{"z": {"k": 1}, "a": [1, 2]}"#);
        let mut pointers = ["/a/1", "/a/0", "/z/missing", "/z/k", "", "/a", "/z"];
        pointers.sort_by_key(|pointer| tree.position(pointer));
        assert_eq!(pointers, ["", "/z", "/z/k", "/z/missing", "/a", "/a/0", "/a/1"]);
    }
}
