//! How PrePoMax and FreeCAD read the files of ccx, as rules in code of our own: what they would
//! throw at or refuse is an error here.

#![allow(clippy::unwrap_used, clippy::panic)] // a test may fail where it stands

use std::collections::{BTreeMap, BTreeSet};

/// What PrePoMax holds after reading `.frd`.
#[derive(Debug, Default)]
pub struct Results {
    pub heading: Vec<String>,
    pub nodes: BTreeMap<i64, [f64; 3]>,
    /// Type and nodes of every element.
    pub elements: BTreeMap<i64, (u32, Vec<i64>)>,
    pub fields: Vec<Field>,
}

#[derive(Debug)]
pub struct Field {
    pub name: String,
    /// Increment in the step, step, increment of the run.
    pub at: [i64; 3],
    pub time: f64,
    pub components: Vec<String>,
    pub rows: BTreeMap<i64, Vec<f64>>,
}

impl Results {
    pub fn read(text: &str) -> Self {
        assert!(text.len() >= 300, "PrePoMax calls a shorter file a failed run");
        let mut results = Self::default();
        for block in blocks(text) {
            match block[0] {
                key if key.starts_with("    1C") => {
                    results.heading = block.iter().map(|line| (*line).to_owned()).collect();
                }
                key if key.starts_with("    2C") => results.nodes = nodes(&block),
                key if key.starts_with("    3C") => results.elements = elements(&block),
                key if key.starts_with("    1PSTEP") => results.fields.push(field(&block)),
                key => panic!("a block that begins with {key}"),
            }
        }
        results.hold_together();
        results
    }

    /// What the readers look up without asking whether it is there.
    fn hold_together(&self) {
        let drawn = self.elements.values().flat_map(|(_, nodes)| nodes);
        assert!(drawn.into_iter().all(|node| self.nodes.contains_key(node)));
        let mut names = BTreeSet::new();
        for field in &self.fields {
            assert!(names.insert((field.at, field.name.clone())), "{} twice", field.name);
            assert!(field.rows.keys().all(|node| self.nodes.contains_key(node)), "{}", field.name);
        }
    }

    pub fn field(&self, name: &str, increment: i64) -> &Field {
        let mut fields = self.fields.iter();
        fields.find(|own| own.name == name && own.at[2] == increment).unwrap()
    }

    /// The part behind that key of the heading.
    pub fn named(&self, key: &str) -> Option<&str> {
        let mut parts = self.heading.iter().flat_map(|line| line.split(','));
        parts.find_map(|part| part.split_once(key)).map(|(_, value)| value.trim())
    }
}

/// Blocks end with exactly ` -3`; nodes and elements begin new ones, too.
fn blocks(text: &str) -> Vec<Vec<&str>> {
    let (mut blocks, mut block) = (Vec::new(), Vec::new());
    let mut rest = "";
    for line in text.lines() {
        let is_mesh = line.starts_with("    2C") || line.starts_with("    3C");
        if line == " -3" || (is_mesh && !block.is_empty()) {
            blocks.push(std::mem::take(&mut block));
        }
        if line != " -3" {
            block.push(line);
        }
        rest = line;
    }
    assert_eq!((rest, block.as_slice()), (" 9999", &[" 9999"][..]));
    blocks
}

/// Lines of one length: number in ten places, values in twelve.
fn values(line: &str, width: usize) -> (i64, Vec<f64>) {
    assert!(line.starts_with(" -1") && line.len() == width, "{line}");
    let number = line[3..13].trim().parse().unwrap();
    let places = line.as_bytes()[13..].chunks(12);
    (number, places.map(|place| number_in(std::str::from_utf8(place).unwrap())).collect())
}

/// .NET and Python read one number in the places, and no more.
fn number_in(text: &str) -> f64 {
    text.trim().parse().unwrap_or_else(|_| panic!("`{text}` is no number"))
}

fn nodes(block: &[&str]) -> BTreeMap<i64, [f64; 3]> {
    let mut nodes = BTreeMap::new();
    for line in &block[1..] {
        let (number, place) = values(line, 49);
        assert!(nodes.insert(number, place.try_into().unwrap()).is_none(), "node {number} twice");
    }
    assert_eq!(word(block[0], 1), nodes.len() as i64);
    nodes
}

fn word(line: &str, place: usize) -> i64 {
    line.split_whitespace().nth(place).unwrap().parse().unwrap()
}

/// Types 1 to 11: PrePoMax throws at others. [CGX 2.20 manual: element types]
fn elements(block: &[&str]) -> BTreeMap<i64, (u32, Vec<i64>)> {
    const NODES: [usize; 11] = [8, 6, 4, 20, 15, 10, 3, 6, 4, 8, 2];
    let mut elements = BTreeMap::new();
    let mut lines = block[1..].iter();
    while let Some(line) = lines.next() {
        assert!(line.starts_with(" -1"), "{line}");
        // PrePoMax splits at blanks, FreeCAD takes these places
        let (number, kind) = (word(line, 1), word(line, 2) as u32);
        assert_eq!(number, line[4..13].trim().parse::<i64>().unwrap());
        assert_eq!(kind, line[14..18].trim().parse::<u32>().unwrap());
        let count = NODES[kind as usize - 1];
        let mut own: Vec<i64> = Vec::new();
        while own.len() < count {
            let line = lines.next().unwrap();
            assert!(line.starts_with(" -2"), "{line}");
            let places = line.as_bytes()[3..].chunks(10);
            own.extend(places.map(|place| number_in(std::str::from_utf8(place).unwrap()) as i64));
        }
        assert_eq!(own.len(), count);
        assert!(elements.insert(number, (kind, own)).is_none(), "element {number} twice");
    }
    assert_eq!(word(block[0], 1), elements.len() as i64);
    elements
}

fn field(block: &[&str]) -> Field {
    let (increment, step) = (word(block[0], 2), word(block[0], 3));
    let head = block[1];
    assert!(head.starts_with("  100CL"), "{head}");
    // five places of the number of the block, twelve of the time, twelve of the nodes
    let number: i64 = head[7..12].trim().parse().unwrap();
    let (time, count) = (number_in(&head[12..24]), head[24..36].trim().parse::<usize>().unwrap());
    let running: i64 = head[58..63].trim().parse().unwrap();
    assert_eq!(number - 100, running, "{head}");
    let name = block[2].strip_prefix(" -4  ").unwrap().split_whitespace().next().unwrap();
    let heads = block[3..].iter().take_while(|line| line.starts_with(" -5"));
    let components: Vec<String> =
        heads.map(|line| line.split_whitespace().nth(1).unwrap().to_owned()).collect();
    let given = components.iter().filter(|name| *name != "ALL").count();
    let lines = block[3 + components.len()..].iter();
    let rows: BTreeMap<i64, Vec<f64>> = lines.map(|line| values(line, 13 + 12 * given)).collect();
    assert_eq!(rows.len(), count, "{name}");
    Field { name: name.to_owned(), at: [increment, step, running], time, components, rows }
}

/// The tables of `.dat` by their titles, which PrePoMax knows by their first words; a table ends at
/// the first empty line behind its rows.
pub fn tables(text: &str) -> Vec<(String, Vec<Vec<f64>>)> {
    const KNOWN: [&str; 9] = [
        "displacements",
        "forces",
        "total force",
        "stresses",
        "strains",
        "internal energy",
        "total internal energy",
        "volume",
        "total volume",
    ];
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    let mut tables = Vec::new();
    for (place, title) in lines.iter().enumerate() {
        if !KNOWN.iter().any(|known| title.starts_with(known)) {
            continue;
        }
        let rest = lines[place + 1..].iter().skip_while(|line| line.is_empty());
        let rows = rest.take_while(|line| !line.is_empty());
        let rows = rows.map(|row| row.split_whitespace().map(number_in).collect()).collect();
        tables.push(((*title).to_owned(), rows));
    }
    tables
}
