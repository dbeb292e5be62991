//! Every setting and every planner of the registry.

use super::*;

#[test]
fn every_setting_is_listed_once_with_its_default() {
    for info in planners() {
        let config = default_config(info.id).unwrap();
        let mut names: Vec<_> = info.parameters.iter().map(|p| p.name).collect();
        names.sort_unstable();
        let mut expected: Vec<_> = config.keys().map(String::as_str).collect();
        expected.sort_unstable();
        assert_eq!(names, expected, "{}", info.id);
    }
}

#[test]
fn planners_take_whatever_a_form_offers() {
    for row in &ROWS {
        let id = row.id;
        for Parameter { name, kind: form, choices, min, max, default, .. } in PlannerId(row).parameters() {
            let ends = [min, max].into_iter().flatten();
            let ends = ends.map(|end| if form == "integer" { (end as u64).into() } else { Value::from(end) });
            for value in ends.chain(choices.iter().map(|&word| word.into())).chain([default]) {
                let fields = Map::from_iter([(name.to_owned(), value.clone())]);
                let mut settings = (row.settings)();
                overlay(settings.parameters().fields(), &fields).unwrap_or_else(|e| panic!("{id}: {e}"));
                check(settings.parameters().fields()).unwrap_or_else(|e| panic!("{id}: {e}"));
                assert_eq!(written(settings.parameters().fields())[name], value, "{id}: {name}");
            }
        }
    }
}

#[test]
fn a_planner_is_found_by_its_id() {
    for row in &ROWS {
        assert!(std::ptr::eq(PlannerId::of(row.id).unwrap().0, row), "{} is there twice", row.id);
    }
}

#[test]
fn an_unknown_planner_is_named() {
    let error = PlannerId::of("prm").err().unwrap();
    assert!(error.message().starts_with("no planner \"prm\"; there are four, eight"), "{error}");
}
