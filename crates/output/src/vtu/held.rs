//! Arrays of a state held in memory, as a file has them.

use super::array::Arrays;
use crate::reading::problem::{Problem, unreadable};
use crate::reading::state::State;
use std::path::Path;

/// Arrays by their names.
#[derive(Clone, Debug, Default)]
pub(crate) struct Held {
    floats: Vec<(String, Vec<f64>)>,
    long: Vec<(String, Vec<i64>)>,
    short: Vec<(String, Vec<i32>)>,
    types: Vec<u8>,
}

impl Arrays for Held {
    fn push_floats(&mut self, name: &str, _: usize, values: &[f64]) {
        self.floats.push((name.to_owned(), values.to_vec()));
    }

    fn push_long(&mut self, name: &str, values: impl Iterator<Item = u64>) {
        let values = values.map(|value| i64::try_from(value).unwrap_or(i64::MAX));
        self.long.push((name.to_owned(), values.collect()));
    }

    fn push_short(&mut self, name: &str, values: &[i32]) {
        self.short.push((name.to_owned(), values.to_vec()));
    }

    fn push_types(&mut self, values: &[u8]) {
        self.types = values.to_vec();
    }
}

impl State for Held {
    fn path(&self) -> &Path {
        Path::new("")
    }

    fn doubles(&self, name: &str) -> Result<Vec<f64>, Problem> {
        found(&self.floats, name)
    }

    fn long(&self, name: &str) -> Result<Vec<i64>, Problem> {
        found(&self.long, name)
    }

    fn short(&self, name: &str) -> Result<Vec<i32>, Problem> {
        found(&self.short, name)
    }

    fn tiny(&self, _: &str) -> Result<Vec<u8>, Problem> {
        Ok(self.types.clone())
    }
}

fn found<T: Clone>(list: &[(String, Vec<T>)], name: &str) -> Result<Vec<T>, Problem> {
    let own = list.iter().find(|(own, _)| own == name);
    let missing = || unreadable(Path::new(""), format!("its array {name} is missing"));
    own.map(|(_, values)| values.clone()).ok_or_else(missing)
}
