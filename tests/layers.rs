//! A module may use only modules before it in the list of the crate's documentation; `search` uses only `error`.
#![cfg(not(target_arch = "wasm32"))]

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

/// Everything that a file's code names from the crate's root: by `use`, which may be grouped, and in place.
fn used_by(code: &str, module: &[String]) -> Vec<String> {
    let mut paths = Vec::new();
    let mut rest = code;
    while let Some(at) = rest.find("use ") {
        let is_word = rest[..at].chars().last().is_none_or(|c| c.is_whitespace() || c == ')');
        let tail = &rest[at + 4..];
        let end = tail.find(';').unwrap_or(tail.len());
        if is_word {
            paths.extend(paths_of(&tail[..end]));
        }
        rest = &tail[if is_word { end } else { 0 }..];
    }
    for root in ["crate::", "super::"] {
        let in_place = code.match_indices(root).filter(|(at, _)| !code[..*at].ends_with([':', '$']));
        paths.extend(in_place.map(|(at, _)| {
            let path = code[at..].chars().take_while(|&c| c.is_alphanumeric() || c == '_' || c == ':');
            path.collect()
        }));
    }
    paths.iter().filter_map(|path| first_module(path, module)).filter(|name| !name.is_empty()).collect()
}

/// The crate's module at the root of a path that is written in `module`.
fn first_module(path: &str, module: &[String]) -> Option<String> {
    let mut steps = path.split("::").peekable();
    if steps.next_if_eq(&"crate").is_some() {
        return steps.next().map(str::to_owned);
    }
    let mut outer = module.len();
    steps.peek().filter(|&&step| step == "super")?;
    while steps.next_if_eq(&"super").is_some() {
        outer = outer.checked_sub(1)?;
    }
    if outer == 0 { steps.next().map(str::to_owned) } else { module.first().cloned() }
}

/// The path of a file's module below the crate's root.
fn module_of(inside: &Path) -> Vec<String> {
    let mut module: Vec<String> = inside.iter().map(|step| stem(Path::new(step))).collect();
    module.pop_if(|last| last == "mod");
    module
}

#[test]
fn imports_point_one_way() {
    let (layers, source) = (layers(), root().join("src"));
    let rank = |module: &str| layers.iter().position(|layer| layer == module);
    let mut files = Vec::new();
    rust_files(&source, &mut files);
    let (mut seen, mut wrong) = (0, Vec::new());
    for file in files {
        let inside = file.strip_prefix(&source).unwrap();
        let module = module_of(inside);
        let Some(own) = rank(&module[0]) else { continue };
        for used in used_by(&code_of(&read(&file)), &module) {
            let Some(other) = rank(&used) else { continue };
            seen += 1;
            let is_allowed = other <= own && (module[0] != "search" || used == "search" || used == "error");
            if !is_allowed {
                wrong.push(format!("{}: {} uses {used}", inside.display(), module[0]));
            }
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
    assert!(seen > 500, "found only {seen} uses: is the test looking in the right place?");
}

/// The files beside a file that its code names by `super::…`.
fn siblings_used(code: &str, names: &BTreeSet<String>) -> BTreeSet<String> {
    let after = code.split("super::").skip(1).flat_map(|rest| {
        let tree = rest.split(';').next().unwrap_or_default();
        if let Some(group) = tree.strip_prefix('{') {
            paths_of(group.trim_end_matches('}'))
        } else {
            vec![rest.chars().take_while(|&c| c.is_alphanumeric() || c == '_').collect()]
        }
    });
    let first = |path: String| path.split([':', ',', ' ']).next().unwrap_or_default().trim().to_owned();
    after.map(first).filter(|name| names.contains(name)).collect()
}

#[test]
fn files_of_a_folder_use_each_other_one_way() {
    let source = root().join("src");
    let mut files = Vec::new();
    rust_files(&source, &mut files);
    let mut folders: BTreeMap<PathBuf, Vec<PathBuf>> = BTreeMap::new();
    for file in files.into_iter().filter(|file| !["mod", "lib", "tests"].contains(&stem(file).as_str())) {
        folders.entry(file.parent().unwrap().to_owned()).or_default().push(file);
    }
    let (mut seen, mut wrong) = (0, Vec::new());
    for (folder, files) in folders {
        let names: BTreeSet<String> = files.iter().map(|file| stem(file)).collect();
        let mut uses: BTreeMap<String, BTreeSet<String>> =
            files.iter().map(|file| (stem(file), siblings_used(&code_of(&read(file)), &names))).collect();
        seen += uses.values().map(BTreeSet::len).sum::<usize>();
        // Whoever uses nothing that is left is in no circle.
        while let Some(free) = uses.iter().find(|used| used.1.is_empty()).map(|used| used.0.clone()) {
            uses.remove(&free);
            for used in uses.values_mut() {
                used.remove(&free);
            }
        }
        let place = folder.strip_prefix(&source).unwrap().display().to_string();
        if !uses.is_empty() {
            wrong.push(format!("{place}: {uses:?}"));
        }
    }
    assert_eq!(wrong, Vec::<String>::new());
    assert!(seen > 150, "found only {seen} uses: is the test looking in the right place?");
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
    let module = ["map".to_owned(), "risk".to_owned()];
    assert_eq!(used_by(&code, &module), ["map", "search"], "{code}");
    assert_eq!(first_module("super::super::plan::x", &module).as_deref(), Some("plan"));
    assert_eq!(first_module("super::layer", &module).as_deref(), Some("map"));
    assert_eq!(first_module("std::fmt", &module), None);
}
