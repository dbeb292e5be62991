//! Answers summed up.

use crate::answer::{Answer, Ending};

pub(crate) const HEAD: &str = "\
| kind | solved | boxed in | too narrow | no way, searched | budget spent | failed | also by a single member | \
gear changes: median, most | least margin, cm | CPU ms: p50, p95 | without a path: p50, most | \
work against the best member: p50, p95 |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |";

#[derive(Default)]
pub(crate) struct Tally {
    pub(crate) answers: Vec<Answer>,
    /// For each scene without a path: whether a single member finds one.
    pub(crate) members: Vec<bool>,
    /// For each scene with a path: the work for each of the best single member's.
    pub(crate) work: Vec<f64>,
}

impl Tally {
    pub(crate) fn add(&mut self, other: Self) {
        self.answers.extend(other.answers);
        self.members.extend(other.members);
        self.work.extend(other.work);
    }

    pub(crate) fn count(&self, ending: Ending) -> usize {
        self.answers.iter().filter(|answer| answer.ending == ending).count()
    }

    /// Neither a path nor a proof that there is none.
    pub(crate) fn undecided(&self) -> usize {
        self.count(Ending::BudgetSpent) + self.count(Ending::Failed)
    }

    /// The value below which this share of the answers lies; of those with a path, or those without.
    pub(crate) fn quantile(
        &self,
        share: f64,
        is_solved: bool,
        value: impl Fn(&Answer) -> f64,
    ) -> Option<f64> {
        let own = self.answers.iter().filter(|answer| answer.is_solved() == is_solved);
        quantile(own.map(value).collect(), share)
    }

    pub(crate) fn milliseconds(&self, share: f64) -> Option<f64> {
        quantile(self.answers.iter().map(|answer| answer.milliseconds).collect(), share)
    }

    pub(crate) fn changes(&self, share: f64) -> Option<f64> {
        self.quantile(share, true, |answer| f64::from(answer.changes))
    }

    /// The least margin of a path, metres.
    pub(crate) fn margin(&self) -> Option<f64> {
        self.quantile(0.0, true, |answer| answer.margin)
    }

    pub(crate) fn row(&self, name: &str) -> String {
        let text = |value: Option<f64>, digits| value.map_or("–".to_owned(), |v| format!("{v:.digits$}"));
        let two = |[a, b]: [Option<f64>; 2], digits| format!("{}, {}", text(a, digits), text(b, digits));
        let endings =
            [Ending::BoxedIn, Ending::TooNarrow, Ending::Searched, Ending::BudgetSpent, Ending::Failed];
        let solved = format!("{}/{}", self.count(Ending::Solved), self.answers.len());
        let solvable = self.members.iter().filter(|&&is_solved| is_solved).count();
        let mut cells = vec![name.to_owned(), solved];
        cells.extend(endings.map(|ending| self.count(ending).to_string()));
        cells.push(if self.members.is_empty() { "–".to_owned() } else { solvable.to_string() });
        cells.push(two([0.5, 1.0].map(|share| self.changes(share)), 0));
        cells.push(text(self.margin().map(|margin| margin * 100.0), 1));
        cells.push(two([0.5, 0.95].map(|share| self.milliseconds(share)), 1));
        cells.push(two([0.5, 1.0].map(|share| self.quantile(share, false, |a| a.milliseconds)), 1));
        cells.push(two([0.5, 0.95].map(|share| quantile(self.work.clone(), share)), 2));
        format!("| {} |", cells.join(" | "))
    }
}

fn quantile(mut values: Vec<f64>, share: f64) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let last = values.len().checked_sub(1)?;
    Some(values[(last as f64 * share).round() as usize])
}
