//! A module may use only modules before it in the list of the crate's documentation; `search` uses only `error`.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).to_path_buf()
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(root().join(path)).unwrap()
}

/// The names of `code spans` in a text that `is_known`, and of all in a span that lists several.
fn listed(text: &str, is_known: impl Fn(&str) -> bool) -> Vec<String> {
    let spans = text.split('`').skip(1).step_by(2);
    spans
        .flat_map(|span| span.split([',', ' ', '\n']))
        .filter(|name| is_known(name))
        .map(str::to_owned)
        .collect()
}

/// The layers, lowest first: the one list, in the crate's documentation.
fn layers() -> Vec<String> {
    let text = read("src/lib.rs").replace("\n//!", "\n");
    let section = text.split("# Layers").nth(1).unwrap().split("# Determinism").next().unwrap().to_owned();
    let modules: BTreeSet<String> =
        fs::read_dir(root().join("src")).unwrap().map(|e| stem(&e.unwrap().path())).collect();
    let layers = listed(&section, |name| modules.contains(name));
    let named: BTreeSet<String> = layers.iter().cloned().chain(["lib".to_owned()]).collect();
    assert_eq!(named, modules, "the crate's documentation lists every module");
    assert_eq!(layers.len(), named.len() - 1, "once each");
    layers
}

fn stem(path: &Path) -> String {
    path.file_stem().unwrap().to_str().unwrap().to_owned()
}

fn rust_files(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            rust_files(&path, files);
        } else if path.extension().is_some_and(|e| e == "rs") {
            files.push(path);
        }
    }
}

/// Code without comments, and without the modules of tests, which may use whatever they test with.
fn code_of(text: &str) -> String {
    let lines: Vec<&str> = text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect();
    let text = lines.join("\n");
    let mut code = String::new();
    let mut rest = text.as_str();
    while let Some(at) = rest.find("#[cfg(test)]\nmod ") {
        code += &rest[..at];
        let item = &rest[at..];
        rest = match (item.find(';'), item.find('{')) {
            (Some(end), open) if open.is_none_or(|open| end < open) => &item[end + 1..],
            // Modules of tests are at the margin, as rustfmt puts them.
            _ => item.find("\n}").map_or("", |end| &item[end + 2..]),
        };
    }
    code + rest
}

/// The paths of a tree such as `a::{b, c::{d, e}}`.
fn paths_of(tree: &str) -> Vec<String> {
    let Some((prefix, group)) = tree.split_once('{') else { return vec![tree.trim().to_owned()] };
    let (mut paths, mut depth, mut start) = (Vec::new(), 0, 0);
    let group = group.trim_end().strip_suffix('}').unwrap_or(group);
    for (at, letter) in group.char_indices().chain([(group.len(), ',')]) {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let inner = paths_of(&group[start..at]);
                paths.extend(
                    inner.into_iter().filter(|p| !p.is_empty()).map(|p| format!("{}{p}", prefix.trim())),
                );
                start = at + 1;
            }
            _ => {}
        }
    }
    paths
}

/// What a file of the crate names.
struct Source {
    /// The name that each binds, and the path from the crate's root.
    imports: Vec<(String, Vec<String>)>,
    /// Every path from the crate's root that the file names, by `use` or in place. Not those that it only passes on.
    used: Vec<Vec<String>>,
}

impl Source {
    fn new(code: &str, module: &[String], is_module: &dyn Fn(&[String]) -> bool) -> Self {
        let absolute = |path: &str| absolute(path, module, is_module);
        let (mut imports, mut body, mut rest) = (Vec::new(), String::new(), code);
        while let Some(at) = rest.find("use ") {
            let before = &rest[..at];
            let is_word = before.chars().last().is_none_or(|c| c.is_whitespace() || c == ')');
            body += before;
            let tail = &rest[at + 4..];
            let end = if is_word { tail.find(';').unwrap_or(tail.len()) } else { 0 };
            let line = before.rsplit('\n').next().unwrap_or_default();
            let is_passed_on = line.trim_start().starts_with("pub");
            for path in paths_of(&tail[..end]) {
                let (path, alias) = path.split_once(" as ").unwrap_or((&path, ""));
                let path = path.strip_suffix("::self").unwrap_or(path);
                let name =
                    if alias.is_empty() { path.rsplit("::").next().unwrap_or_default() } else { alias };
                imports.extend(absolute(path).map(|path| (name.to_owned(), path, is_passed_on)));
            }
            rest = &tail[end..];
        }
        body += rest;
        let words: BTreeSet<&str> = body.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
        let named = imports.iter().filter(|(name, _, is_passed_on)| !is_passed_on || words.contains(&**name));
        let mut used: Vec<_> = named.map(|(_, path, _)| path.clone()).collect();
        // Where a name may be seen is no use of it.
        let body = body.replace("(in crate::", "(in ");
        let tokens = body.split(|c: char| !c.is_alphanumeric() && !"_:$".contains(c));
        used.extend(tokens.filter(|token| token.contains("::")).filter_map(absolute));
        let imports = imports.into_iter().map(|(name, path, _)| (name, path)).collect();
        Self { imports, used }
    }
}

/// A path that is written in `module`, from the crate's root; none where it leads to another crate or to a name of its
/// own.
fn absolute(path: &str, module: &[String], is_module: &dyn Fn(&[String]) -> bool) -> Option<Vec<String>> {
    let steps: Vec<&str> = path.split("::").map(str::trim).filter(|step| !step.is_empty()).collect();
    let outer = steps.iter().take_while(|&&step| step == "super").count();
    let (base, rest) = match *steps.first()? {
        "crate" => (&module[..0], &steps[1..]),
        "self" => (module, &steps[1..]),
        "super" => (&module[..module.len().checked_sub(outer)?], &steps[outer..]),
        child if is_module(&[module, &[child.to_owned()]].concat()) => (module, &steps[..]),
        _ => return None,
    };
    Some(base.iter().cloned().chain(rest.iter().map(|&step| step.to_owned())).collect())
}

/// The files of the crate by their modules, without those of tests.
fn sources() -> BTreeMap<Vec<String>, Source> {
    let folder = root().join("src");
    let mut files = Vec::new();
    rust_files(&folder, &mut files);
    let modules: BTreeMap<Vec<String>, PathBuf> = files
        .into_iter()
        .map(|file| (module_of(file.strip_prefix(&folder).unwrap()), file))
        .filter(|(module, _)| !module.iter().any(|step| step == "tests"))
        .collect();
    let is_module = |path: &[String]| modules.contains_key(path);
    let source = |(module, file): (&Vec<String>, &PathBuf)| {
        (module.clone(), Source::new(&code_of(&read(file)), module, &is_module))
    };
    modules.iter().map(source).collect()
}

/// The module whose file defines what a path from the crate's root leads to.
fn home(path: &[String], sources: &BTreeMap<Vec<String>, Source>) -> Vec<String> {
    let mut module = Vec::new();
    for (at, step) in path.iter().enumerate() {
        let inner = [&module[..], std::slice::from_ref(step)].concat();
        if sources.contains_key(&inner) {
            module = inner;
            continue;
        }
        let passed_on = sources[&module].imports.iter().find(|(name, _)| name == step);
        return passed_on.map_or(module, |(_, to)| home(&[to, &path[at + 1..]].concat(), sources));
    }
    module
}

/// The path of a file's module below the crate's root.
fn module_of(inside: &Path) -> Vec<String> {
    let mut module: Vec<String> = inside.iter().map(|step| stem(Path::new(step))).collect();
    module.pop_if(|last| last == "mod" || last == "lib");
    module
}

#[test]
fn imports_point_one_way() {
    let layers = layers();
    let rank = |module: &str| layers.iter().position(|layer| layer == module);
    let (mut seen, mut wrong) = (0, Vec::new());
    for (module, source) in sources() {
        let Some(own) = module.first().and_then(|layer| rank(layer)) else { continue };
        for used in source.used.iter().filter_map(|path| path.first()) {
            let Some(other) = rank(used) else { continue };
            seen += 1;
            let is_allowed = other <= own && (module[0] != "search" || used == "search" || used == "error");
            if !is_allowed {
                wrong.push(format!("{} uses {used}", module.join("::")));
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
    assert!(seen > 500, "found only {seen} uses: is the test looking in the right place?");
}

/// All that a file uses, and what those use, and so on.
fn reach(file: &str, uses: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<String> {
    let (mut seen, mut todo) = (BTreeSet::new(), vec![file.to_owned()]);
    while let Some(file) = todo.pop() {
        let new: Vec<String> = uses[&file].difference(&seen).cloned().collect();
        seen.extend(new.iter().cloned());
        todo.extend(new);
    }
    seen
}

/// The groups of files of which each uses, by way of others, all of its group.
fn circles(uses: &BTreeMap<String, BTreeSet<String>>) -> BTreeSet<BTreeSet<String>> {
    let reaches: BTreeMap<&String, BTreeSet<String>> =
        uses.keys().map(|file| (file, reach(file, uses))).collect();
    let circle = |(file, used): (&&String, &BTreeSet<String>)| {
        used.iter().filter(|other| reaches[other].contains(*file)).cloned().collect::<BTreeSet<_>>()
    };
    reaches.iter().map(circle).filter(|circle| !circle.is_empty()).collect()
}

/// Which files each file uses.
fn uses(sources: &BTreeMap<Vec<String>, Source>) -> BTreeMap<String, BTreeSet<String>> {
    let used_by = |(module, source): (&Vec<String>, &Source)| {
        let homes = source.used.iter().map(|path| home(path, sources)).filter(|home| home != module);
        (module.join("::"), homes.map(|home| home.join("::")).collect())
    };
    sources.iter().map(used_by).collect()
}

#[test]
fn no_files_use_each_other_in_a_circle() {
    let uses = uses(&sources());
    let seen: usize = uses.values().map(BTreeSet::len).sum();
    assert_eq!(circles(&uses), BTreeSet::new());
    assert!(seen > 500, "found only {seen} uses: is the test looking in the right place?");
}

#[test]
fn documents_list_the_layers_as_the_crate_does() {
    let layers = layers();
    let is_layer = |name: &str| layers.iter().any(|layer| layer == name);
    let design = read("DESIGN.md");
    let sentence =
        design.split("A module uses only modules before it in").nth(1).unwrap().split(';').next().unwrap();
    assert_eq!(listed(sentence, is_layer), layers, "DESIGN.md");
    let readme = read("README.md");
    let map = readme.split("the crate: ").nth(1).unwrap().split("\nwww").next().unwrap();
    let names: Vec<&str> =
        map.split([',', ' ', '\n', ';', '(', ')', '.']).filter(|name| is_layer(name)).collect();
    assert_eq!(names, layers, "README.md");
}

#[test]
fn groups_are_read_and_test_modules_are_left_out() {
    let group = paths_of("crate::{a::{b, c}, d, e::f as g,}");
    assert_eq!(group, ["crate::a::b", "crate::a::c", "crate::d", "crate::e::f as g"]);
    let code = code_of(
        "use x;\n#[cfg(test)]\nmod tests {\n    use crate::plan;\n}\n#[cfg(test)]\nmod more;\nuse crate::{\n  map, // \
         crate::wasm\n  search,\n};\n",
    );
    let names = |text: &str| text.split("::").map(str::to_owned).collect::<Vec<String>>();
    let module = names("map::risk");
    let is_module = |path: &[String]| path == names("map::risk::field");
    let source = Source::new(&code, &module, &is_module);
    assert_eq!(source.used, ["map", "search"].map(names), "{code}");
    let absolute = |path: &str| absolute(path, &module, &is_module);
    assert_eq!(absolute("super::super::plan::x"), Some(names("plan::x")));
    assert_eq!(absolute("super::layer"), Some(names("map::layer")));
    assert_eq!(absolute("field::x"), Some(names("map::risk::field::x")));
    assert_eq!(absolute("std::fmt"), None);
}

#[test]
fn circles_are_found_through_what_a_module_passes_on() {
    let names = |text: &str| text.split("::").map(str::to_owned).collect::<Vec<String>>();
    let codes = [
        ("a", "mod b;\npub use b::B;\nstruct A;"),
        ("a::b", "use super::c;\nuse super::A;"),
        ("a::c", "use super::B;"),
    ];
    let is_module = |path: &[String]| codes.iter().any(|(module, _)| names(module) == path);
    let source =
        |(module, code): (&str, &str)| (names(module), Source::new(code, &names(module), &is_module));
    let sources: BTreeMap<_, _> =
        codes.into_iter().map(source).chain([(Vec::new(), Source::new("", &[], &is_module))]).collect();
    let uses = uses(&sources);
    // `a` only passes `B` on; `c` uses it, and `b` uses `c`.
    assert_eq!(circles(&uses), BTreeSet::from([BTreeSet::from(["a::b", "a::c"].map(str::to_owned))]));
}
