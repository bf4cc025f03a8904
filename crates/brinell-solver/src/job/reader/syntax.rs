//! Parsing of bytes into a tree, with readable syntax errors.

use serde_json::error::Category;

use super::text::Quoted;
use super::tree::Node;
use crate::job::JobError;

/// Parses JSON text. A leading byte order mark is skipped.
///
/// # Errors
/// [`JobError::Syntax`], with the line and the column in bytes.
pub fn parse(bytes: &[u8]) -> Result<Node, JobError> {
    let text = std::str::from_utf8(bytes).map_err(|error| not_utf8(bytes, error.valid_up_to()))?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() {
        return Err(JobError::Syntax {
            message: "the document is empty".to_owned(),
            line: 1,
            column: 1,
        });
    }
    serde_json::from_str(text).map_err(|error| explain(text, &error))
}

fn not_utf8(bytes: &[u8], valid: usize) -> JobError {
    let before = bytes.get(..valid).unwrap_or_default();
    let line_start =
        before.iter().rposition(|byte| *byte == b'\n').map_or(0, |newline| newline + 1);
    JobError::Syntax {
        message: "the text is not UTF-8".to_owned(),
        line: before.split(|byte| *byte == b'\n').count(),
        column: valid - line_start + 1,
    }
}

/// Translates an error of the parser into the terms of the wire format.
pub fn explain(text: &str, error: &serde_json::Error) -> JobError {
    let (line, column) = (error.line(), error.column().max(1));
    let full = error.to_string();
    let raw = full.split(" at line ").next().unwrap_or_default();
    let message = if let Some(literal) = non_finite_literal(text, line, column) {
        format!("{} is not a JSON number; only finite numbers can be written", Quoted(literal))
    } else if error.classify() == Category::Eof {
        format!("the text ends too early ({raw})")
    } else {
        match raw {
            "number out of range" => "a number is too large; magnitudes end at 1.8e308".to_owned(),
            "recursion limit exceeded" => "values are nested too deeply".to_owned(),
            "key must be a string" => "a key must be a string in double quotes".to_owned(),
            "trailing characters" => {
                "there is more text behind the end of the document".to_owned()
            }
            "trailing comma" => "there is a comma behind the last member".to_owned(),
            "expected ident" | "expected value" => {
                "expected a value: an object, an array, a string, a number, true, false or null"
                    .to_owned()
            }
            other => other.to_owned(),
        }
    };
    JobError::Syntax { message, line, column }
}

/// Returns `NaN`, `Infinity` or a similar word at the position of the parser's error.
fn non_finite_literal(text: &str, line: usize, column: usize) -> Option<&str> {
    let line = text.split('\n').nth(line.checked_sub(1)?)?;
    let is_word = |byte: &u8| byte.is_ascii_alphabetic() || matches!(byte, b'+' | b'-');
    let bytes = line.as_bytes();
    let at = column.min(bytes.len());
    let start = at - bytes.get(..at)?.iter().rev().take_while(|byte| is_word(byte)).count();
    let end = at + bytes.get(at..)?.iter().take_while(|byte| is_word(byte)).count();
    let word = line.get(start..end)?;
    let name = word.trim_start_matches(['+', '-']).to_ascii_lowercase();
    matches!(name.as_str(), "nan" | "inf" | "infinity").then_some(word)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn error(text: impl AsRef<[u8]>) -> String {
        parse(text.as_ref()).unwrap_err().to_string()
    }

    #[test]
    fn non_finite_literals_are_named() {
        for literal in ["NaN", "nan", "Infinity", "-Infinity", "inf", "-inf", "+Infinity", "INF"] {
            let message = error(format!("{{\n  \"force\": {literal}\n}}"));
            assert!(
                message.contains(&format!("\"{literal}\" is not a JSON number")),
                "{literal}: {message}"
            );
            assert!(message.contains("line 2"), "{literal}: {message}");
        }
    }

    #[test]
    fn messages() {
        insta::assert_snapshot!(error(""), @"not valid JSON: the document is empty (line 1, \
                                             column 1)");
        insta::assert_snapshot!(error(" \n"), @"not valid JSON: the document is empty (line 1, \
                                                column 1)");
        insta::assert_snapshot!(error("{\"a\": [1, \
                                       2"), @"not valid JSON: the text ends too early (EOF while \
                                              parsing a list) (line 1, column 11)");
        insta::assert_snapshot!(error("[1e400]"), @"not valid JSON: a number is too large; \
                                                    magnitudes end at 1.8e308 (line 1, column 6)");
        insta::assert_snapshot!(error("{a: 1}"), @"not valid JSON: a key must be a string in \
                                                   double quotes (line 1, column 2)");
        insta::assert_snapshot!(error("[nul]"), @"not valid JSON: expected a value: an object, an \
                                                  array, a string, a number, true, false or null \
                                                  (line 1, column 5)");
        insta::assert_snapshot!(error("[1,]"), @"not valid JSON: there is a comma behind the last \
                                                 member (line 1, column 4)");
        insta::assert_snapshot!(error("1 2"), @"not valid JSON: there is more text behind the end \
                                                of the document (line 1, column 3)");
        insta::assert_snapshot!(error(b"{\n \"a\": \
                                        \"\xff\"}"), @"not valid JSON: the text is not UTF-8 \
                                                       (line 2, column 8)");
    }

    #[test]
    fn deep_nesting_is_refused() {
        assert!(error("[".repeat(100_000)).contains("nested too deeply"));
        assert!(error("{\"a\":".repeat(100_000)).contains("nested too deeply"));
    }

    #[test]
    fn a_byte_order_mark_is_skipped() {
        assert_eq!(parse(b"\xef\xbb\xbf[]"), Ok(Node::Array(Vec::new())));
    }
}
