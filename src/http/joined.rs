//! The modules of the page as one. A browser whose requests take 100 ms asks once in place of 130
//! times, six at a time.
//!
//! Each module is a function that runs when it is first imported and answers with its exports, so
//! modules run in the order that the standard has. The formatter keeps imports and exports at the
//! beginning of their lines; modules have no circles, no `export default` and no `await` of their
//! own. Lines of a module stay lines.

use std::fmt::Write as _;

/// What stands before and behind the modules.
const BEGIN: &str = "const $modules = {}, $made = {};\n\
                     const $load = (path) => ($made[path] ??= $modules[path]());\n\
                     const $later = async (path) => $load(path);\n";
const END: &str = "$load('main.js');\n";

/// Joins modules, given by their paths and texts.
pub(super) fn joined(modules: &[(String, String)]) -> String {
    let mut sent = BEGIN.to_owned();
    for (path, text) in modules {
        let _ = writeln!(sent, "$modules['{path}'] = () => {{");
        let mut exports = Vec::new();
        let mut import = false;
        for line in text.lines() {
            import |= line.starts_with("import ");
            if import {
                import = !line.ends_with(';');
                sent.push_str(&imported(path, line));
            } else if let Some(declared) = line.strip_prefix("export ") {
                exports.extend(name_of(declared));
                sent.push_str(&within(path, if declared == "{};" { "" } else { declared }));
            } else {
                sent.push_str(&within(path, line));
            }
            sent.push('\n');
        }
        let _ = writeln!(sent, "return {{ {} }};\n}};", exports.join(", "));
    }
    sent + END
}

/// A line of an import, as one of a declaration.
fn imported(path: &str, line: &str) -> String {
    let line = line.replacen("import * as ", "const ", 1).replacen("import {", "const {", 1);
    let line = line.replace(" as ", ": ");
    let quoted = |text: &str| text.trim_end_matches(';').trim_matches('\'').to_owned();
    if let Some((names, from)) = line.split_once(" from ") {
        return format!("{names} = $load('{}');", resolved(path, &quoted(from)));
    }
    match line.strip_prefix("import ") {
        Some(from) => format!("$load('{}');", resolved(path, &quoted(from))),
        None => line,
    }
}

/// A line of a body, with the places that it names in those of the whole.
fn within(path: &str, line: &str) -> String {
    let own = format!("new URL('{path}', import.meta.url)");
    let line = line.replace("import.meta.url", &own);
    let Some((before, rest)) = line.split_once("import('") else { return line };
    let Some((from, behind)) = rest.split_once('\'') else { return line };
    format!("{before}$later('{}'{behind}", resolved(path, from))
}

/// The name that a declaration declares.
fn name_of(declared: &str) -> Option<&str> {
    let words = declared.trim_start_matches("async ");
    let kinds = ["function* ", "function ", "class ", "const ", "let "];
    let rest = kinds.iter().find_map(|kind| words.strip_prefix(kind))?;
    rest.split(|sign: char| !sign.is_alphanumeric() && sign != '_' && sign != '$').next()
}

/// The path that a module at `path` means by `from`.
fn resolved(path: &str, from: &str) -> String {
    let mut parts: Vec<_> = path.split('/').collect();
    parts.pop();
    for part in from.split('/') {
        match part {
            "." => {}
            ".." => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    parts.join("/")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn modules_become_functions_that_load_each_other() {
        let own = |path: &str, text: &str| (path.to_owned(), text.to_owned());
        let text = "import { b as c } from '../lib/b.js';\nimport {\n  d,\n} from './d.js';\n\
                    import * as e from './e.js';\nimport './f.js';\nexport class A {}\n\
                    export const x = () => import('./g.js');\nexport async function* y() {}\n\
                    export {};\nnew Worker(new URL('w.js', import.meta.url));";
        let sent = joined(&[own("setup/a.js", text)]);
        for part in [
            "$modules['setup/a.js'] = () => {\nconst { b: c } = $load('lib/b.js');\n",
            "const {\n  d,\n} = $load('setup/d.js');\nconst e = $load('setup/e.js');\n",
            "$load('setup/f.js');\nclass A {}\n",
            "const x = () => $later('setup/g.js');\n",
            "new URL('w.js', new URL('setup/a.js', import.meta.url))",
            "return { A, x, y };\n};\n$load('main.js');\n",
        ] {
            assert!(sent.contains(part), "{part} of {sent}");
        }
    }
}
