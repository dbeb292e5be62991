//! Trajectories and paths as CSV, with errors that name the line and the column.
//!
//! The reader accepts numbers as Rust's `f64` parses them and spaces around them, no quotes and no comments. It stops
//! at the first error; nothing is repaired, because a judgement must be about the file as it is. Memory grows with the
//! rows, which are bounded; so is every line.

use super::{Submission, TimedRows};
use crate::error::{Error, ErrorCode, Message};
use crate::geometry::Pose;

/// Longest line, bytes.
const LONGEST: usize = 1000;
/// Most rows.
const MAX_ROWS: usize = 1_000_000;
/// The columns that are known. The controls a and omega follow from v and phi.
const COLUMNS: [&str; 9] = ["t", "x", "y", "theta", "v", "phi", "a", "omega", "gear"];

/// A place in the text: line and column in characters, both from 1.
fn at<T>(line: usize, column: usize, message: impl Into<Message>) -> Result<T, Error> {
    Err(Error::new(ErrorCode::Import, format!("{line}:{column}"), message))
}

/// A field of a line and the column where it begins. Columns count characters, not bytes, as editors do.
fn fields(line: &str) -> Vec<(usize, &str)> {
    let mut begin = 1;
    let split = line.split(',').map(|field| {
        let lead = field.chars().take_while(|c| c.is_whitespace()).count();
        let place = (begin + if field.trim().is_empty() { 0 } else { lead }, field.trim());
        begin += field.chars().count() + 1;
        place
    });
    split.collect()
}

/// Quotes a file's text, shortened for a message.
fn quoted(text: &str) -> String {
    let short: String = text.chars().take(40).collect();
    format!("{short:?}{}", if short.len() < text.len() { "…" } else { "" })
}

/// Which column each field is.
///
/// Columns may come in any order. Beside `t` there is no `gear`, because the sign of v tells it; without `t` there are
/// no columns in time.
fn header(line: &str) -> Result<Vec<&'static str>, Error> {
    let mut columns = Vec::new();
    for (place, name) in fields(line) {
        let Some(&column) = COLUMNS.iter().find(|known| **known == name) else {
            let known = COLUMNS.join(", ");
            return at(1, place, message!("must be one of {}, got {}", known, quoted(name)));
        };
        if columns.contains(&column) {
            return at(1, place, message!("must be named once, got {} again", column));
        }
        columns.push(column);
    }
    let is_timed = columns.contains(&"t");
    if let Some(missing) = ["x", "y", "theta"].iter().find(|name| !columns.contains(name)) {
        return at(1, 1, message!("must have a column {}", missing));
    }
    let strangers: &[&str] = if is_timed { &["gear"] } else { &["v", "phi", "a", "omega"] };
    match columns.iter().position(|name| strangers.contains(name)) {
        Some(i) if is_timed => at(1, fields(line)[i].0, "must have no column gear beside t"),
        Some(i) => at(1, fields(line)[i].0, message!("must have no column {} without t", columns[i])),
        None => Ok(columns),
    }
}

/// Reads `t,x,y,theta[,v,phi[,a,omega]]`, a trajectory, or `x,y,theta[,gear]`, a path; columns in any order, empty
/// lines at the end.
///
/// Controls in the file (a, omega) are checked to be numbers and then ignored: they follow from v and phi.
///
/// # Examples
/// ```
/// use parkade::referee::{Submission, read};
///
/// let path = read("x,y,theta,gear\n0,0,0,1\n1,0,0,1\n").unwrap();
/// assert!(matches!(path, Submission::Path { gears: Some(_), .. }));
/// assert!(read("x,y,theta\n0,0,0\n1,zero,0\n").unwrap_err().to_string().contains("3:3"));
/// ```
///
/// # Errors
/// [`ErrorCode::Import`] with `line:column` and the rule.
pub fn read(text: &str) -> Result<Submission, Error> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut lines = text.lines().zip(1..).collect::<Vec<_>>();
    while lines.last().is_some_and(|(line, _)| line.trim().is_empty()) {
        lines.pop();
    }
    if let Some(&(line, number)) = lines.iter().find(|(line, _)| line.len() > LONGEST) {
        return at(number, LONGEST, message!("must have at most {} bytes, got {}", LONGEST, line.len()));
    }
    let Some(&(first, _)) = lines.first() else { return at(1, 1, "must be a header, got an empty text") };
    let columns = header(first)?;
    if !(3..=MAX_ROWS + 1).contains(&lines.len()) {
        return at(lines.len(), 1, message!("must have 2 to {} rows, got {}", MAX_ROWS, lines.len() - 1));
    }
    let mut values = vec![Vec::with_capacity(lines.len() - 1); columns.len()];
    for &(line, number) in &lines[1..] {
        let fields = fields(line);
        if fields.len() != columns.len() {
            let place = fields.get(columns.len()).map_or(line.chars().count() + 1, |field| field.0);
            return at(number, place, message!("must have {} fields, got {}", columns.len(), fields.len()));
        }
        for ((&(place, field), name), column) in fields.iter().zip(&columns).zip(&mut values) {
            match field.parse::<f64>() {
                Ok(value) if value.is_finite() && (*name != "gear" || value.abs() == 1.0) => {
                    column.push(value);
                }
                _ if *name == "gear" => {
                    return at(number, place, message!("gear must be 1 or -1, got {}", quoted(field)));
                }
                _ => {
                    return at(
                        number,
                        place,
                        message!("{} must be a finite number, got {}", name, quoted(field)),
                    );
                }
            }
        }
    }
    let submission = submission(&columns, values);
    match submission.broken() {
        Some((row, name, rule)) => {
            let place = columns.iter().position(|c| *c == name).unwrap_or(0);
            let (line, number) = lines[row + 1];
            at(number, fields(line)[place].0, message!("{} {}", name, rule))
        }
        None => Ok(submission),
    }
}

/// The columns as a submission: a trajectory where there are times.
fn submission(columns: &[&str], mut values: Vec<Vec<f64>>) -> Submission {
    let mut take =
        |name: &str| columns.iter().position(|c| *c == name).map(|i| std::mem::take(&mut values[i]));
    let [x, y, theta] = ["x", "y", "theta"].map(|name| take(name).unwrap_or_default());
    let poses = x.iter().zip(&y).zip(&theta).map(|((&x, &y), &theta)| Pose::new(x, y, theta)).collect();
    if let Some(t) = take("t") {
        return Submission::Timed(TimedRows { t, poses, speed: take("v"), steering: take("phi") });
    }
    let gears = take("gear").map(|gears| gears.iter().map(|&g| g as i8).collect());
    Submission::Path { poses, gears }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wrong(text: &str) -> String {
        read(text).unwrap_err().to_string()
    }

    #[test]
    fn both_forms_are_read_in_any_order_of_columns() {
        let timed = read("\u{feff}x, t ,theta,y\r\n1,0,0.5,2\r\n3,0.5,0.25,-4e-1\r\n\r\n").unwrap();
        let poses = vec![Pose::new(1.0, 2.0, 0.5), Pose::new(3.0, -0.4, 0.25)];
        let rows = TimedRows { t: vec![0.0, 0.5], poses: poses.clone(), speed: None, steering: None };
        assert_eq!(timed, Submission::Timed(rows));
        let path = read("x,y,theta,gear\n1,2,0.5,-1\n3,-0.4,0.25,1").unwrap();
        assert_eq!(path, Submission::Path { poses, gears: Some(vec![-1, 1]) });
    }

    #[test]
    fn what_is_wrong_is_named_by_line_and_column() {
        assert_eq!(wrong(""), "1:1: must be a header, got an empty text");
        assert_eq!(wrong("t,x,y\n0,0,0\n1,1,1"), "1:1: must have a column theta");
        assert_eq!(
            wrong("t,x,y,yaw\n"),
            "1:7: must be one of t, x, y, theta, v, phi, a, omega, gear, got \"yaw\""
        );
        assert_eq!(wrong("t,x,y,theta,x\n"), "1:13: must be named once, got x again");
        assert_eq!(wrong("x,y,theta,v\n"), "1:11: must have no column v without t");
        assert_eq!(wrong("t,x,y,theta\n0,0,0,0\n"), "2:1: must have 2 to 1000000 rows, got 1");
        assert_eq!(wrong("t,x,y,theta\n0,0,0,0\n1,2, 3m,0"), "3:6: y must be a finite number, got \"3m\"");
        assert_eq!(wrong("t,x,y,theta\n0,0,0,0\n1,2,inf,0"), "3:5: y must be a finite number, got \"inf\"");
        assert_eq!(wrong("t,x,y,theta\n0,0,0,0\n1,2,3"), "3:6: must have 4 fields, got 3");
        assert_eq!(wrong("t,x,y,theta\n0,0,0,0\n1,2,3,4,5"), "3:9: must have 4 fields, got 5");
        assert_eq!(
            wrong("t,x,y,theta\n0,0,0,0\n0,0,0,0"),
            "3:1: t must be greater than 0 in the row before, got 0"
        );
        assert_eq!(wrong("t,x,y,theta\n0.1,0,0,0\n1,0,0,0"), "2:1: t must be 0 in the first row, got 0.1");
        assert_eq!(wrong("x,y,theta,gear\n0,0,0,1\n1,0,0,2"), "3:7: gear must be 1 or -1, got \"2\"");
        assert_eq!(
            wrong("x,y,theta\n0,0,0\n1,-2e10,0"),
            "3:3: y must be between -1e10 and 1e10, got -20000000000"
        );
    }
}
