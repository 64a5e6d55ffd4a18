//! Whether a model fits into the memory there is.
//!
//! ```text
//!   model --> nodes, elements, couplings of contact --> bytes   before anything is prepared
//!   plan  --> factors of the symbolic analysis       --> bytes   before anything is factored
//! ```
//!
//! Bytes of the model are estimates on the low side: a model that is refused could not
//! have been run. Those of factors are counted. Linux tells how much memory can be had,
//! that of the machine, of the container and of a limit set for the process; elsewhere a
//! constant is taken.

use slideline_diag::{Code, Diagnostic};
use slideline_linalg::Description;
use slideline_model::{ContactPair, Master, Model};

/// Memory that is assumed where the system does not tell [bytes].
const ASSUMED: f64 = 8.0 * GIB;
/// Memory that is there wherever the program runs: the system is not asked [bytes].
const SURE: f64 = GIB / 64.0;
const GIB: f64 = 1024.0 * 1024.0 * 1024.0;

/// Bytes for each node: dof vectors of state, trial and iteration.
const NODE: f64 = 1_000.0;
/// Bytes for each element: stencil, section results, sparsity.
const ELEMENT: f64 = 1_500.0;
/// Bytes for each slave node and segment of a slide line that may meet: all
/// pairs of their dofs enter the sparsity pattern.
const COUPLING: f64 = 1_100.0;
/// Bytes for each contact point on a rigid surface.
const POINT: f64 = 2_500.0;
/// Bytes of a factor entry, work space of the factorisation included, of a linear system
/// that does not tell.
const FACTOR: f64 = 16.0;
/// Part of the memory that linear systems may take with those of other contact [1].
const KEPT: f64 = 0.5;
/// How many times the memory of the one at hand they may take together [1]: beside it the one that
/// a cutback comes back to. Large systems of other contact are hardly ever met again within a run.
const TOGETHER: f64 = 2.0;

/// Why a model is too large, if it is.
pub fn objection(model: &Model) -> Option<Diagnostic> {
    let joining = model.blocks.iter().filter(|block| block.kind.joins());
    let elements = joining.map(|block| block.elements.len()).sum::<usize>();
    let contact = model.contact_pairs.iter().map(couplings);
    let contact = contact.fold((0.0, None), |(sum, largest), (bytes, pair)| match largest {
        Some((most, _)) if most >= bytes => (sum + bytes, largest),
        _ => (sum + bytes, Some((bytes, pair))),
    });
    let bulk = NODE * model.nodes.len() as f64 + ELEMENT * elements as f64;
    let needed = bulk + contact.0;
    let said = too_large(needed, "the model")?;
    Some(match contact.1 {
        Some((bytes, pair)) if bytes > bulk => said.at(pair.interaction.origin).help(format!(
            "nearly all of it is for the contact of {}: any slave may touch any segment; use \
             fewer slave nodes, or a shorter slide line",
            pair.name
        )),
        _ => said
            .at(model.nodes.iter().next().map(|node| node.origin))
            .help("use fewer nodes and elements; check the counts of *NGEN and *ELGEN"),
    })
}

/// Why the factors of an analysed step are too large, if they are.
pub fn factors_objection(factors: &Description) -> Option<Diagnostic> {
    let said = too_large(bytes(factors), "the factorised tangent")?;
    Some(said.help(format!("use fewer nodes: the step has {} equations", factors.equations)))
}

/// Nodes of a face, those behind its edges and their neighbours.
const FACE_NODES: f64 = 32.0;

/// Memory that a linear system takes [bytes].
pub fn bytes(factors: &Description) -> f64 {
    if factors.bytes > 0.0 { factors.bytes } else { FACTOR * factors.predicted_entries }
}

/// How many of the linear systems that are kept, the oldest first, must go for one that needs
/// so many bytes.
pub fn to_drop(kept: impl Iterator<Item = f64> + Clone, needed: f64) -> usize {
    let all: f64 = kept.clone().sum();
    if all + needed < SURE {
        return 0;
    }
    surplus(kept, needed, available().unwrap_or(ASSUMED))
}

/// The same where so much memory can be had beside those that are kept.
fn surplus(kept: impl Iterator<Item = f64> + Clone, needed: f64, there: f64) -> usize {
    let all: f64 = kept.clone().sum();
    let most = (KEPT * (there + all)).min(TOGETHER * needed.max(SURE));
    let left = |so_far: &mut f64, own: f64| {
        let now = *so_far;
        *so_far -= own;
        Some(now)
    };
    kept.scan(all, left).take_while(|left| left + needed > most).count()
}

/// Bytes for what may touch in a pair.
fn couplings(pair: &ContactPair) -> (f64, &ContactPair) {
    let points = crate::contact::point_count(pair) as f64;
    let bytes = match &pair.master {
        Master::RigidSurface(_) => POINT * points,
        Master::SlideLine(line) => {
            let parts = crate::contact::coupled_parts(points, line.nodes.len() as f64);
            (POINT + COUPLING * parts) * points
        }
        Master::Itself(surface) => {
            let parts = crate::contact::coupled_parts(points, surface.nodes().count() as f64);
            (POINT + COUPLING * parts) * points
        }
        Master::Faces(_) => (POINT + COUPLING * FACE_NODES) * points,
    };
    (bytes, pair)
}

fn too_large(needed: f64, what: &str) -> Option<Diagnostic> {
    if needed < SURE {
        return None;
    }
    let there = available().unwrap_or(ASSUMED);
    (needed > there).then(|| {
        let (needed, there) = (needed / GIB, there / GIB);
        let message = format!(
            "{what} needs about {needed:.1} GiB of memory, and {there:.1} GiB are \
                     available"
        );
        Diagnostic::error(Code("SL0415"), message)
    })
}

/// Memory that can be had [bytes].
fn available() -> Option<f64> {
    let read = |path: &str| std::fs::read_to_string(path).unwrap_or_default();
    let machine = kibibytes(&read("/proc/meminfo"), "MemAvailable:");
    let container = "/sys/fs/cgroup/memory";
    let [most, used] = ["max", "current"].map(|end| number(&read(&format!("{container}.{end}"))));
    let limit = address_space(&read("/proc/self/limits"));
    let taken = kibibytes(&read("/proc/self/status"), "VmSize:");
    let left = |most: Option<f64>, used: Option<f64>| Some((most? - used?).max(0.0));
    let all = [machine, left(most, used), left(limit, taken)];
    all.into_iter().flatten().reduce(f64::min)
}

/// The number of a file that holds one; none: no number.
fn number(text: &str) -> Option<f64> {
    text.split_whitespace().next()?.parse().ok()
}

/// The size that a line `NAME  number kB` tells [bytes].
fn kibibytes(text: &str, name: &str) -> Option<f64> {
    Some(1024.0 * number(text.lines().find_map(|line| line.strip_prefix(name))?)?)
}

/// The limit of a process's address space, where one is set [bytes].
fn address_space(limits: &str) -> Option<f64> {
    number(limits.lines().find_map(|line| line.strip_prefix("Max address space"))?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Requirement: contact that no memory holds is told, with the pair's card
    /// and a remedy: 150 GB of points along the elements of one pair.
    #[test]
    fn contact_that_does_not_fit_is_told() {
        let at = slideline_diag::Span { file: slideline_diag::FileId(0), start: 5, end: 9 };
        let lumping = slideline_model::Lumping::Halves;
        let element =
            slideline_model::ContactElement { label: 1, nodes: [0, 1], lumping, origin: at };
        let interaction = slideline_model::Interaction {
            width: 1.0,
            normal: slideline_model::NormalLaw::Hard,
            friction: slideline_model::Friction::Frictionless,
            origin: at,
            no_separation: false,
            normal_origin: None,
            friction_origin: None,
        };
        let surface = slideline_model::RigidSurface {
            reference: 0,
            start: [0.0; 2],
            segments: vec![],
            extension: 0.0,
            origin: at,
        };
        let pair = ContactPair {
            profile: None,
            of_solids: false,
            adjust: slideline_model::Adjust::Nothing,
            axes: [None; 2],
            left_out: Vec::new(),
            corners: Vec::new(),
            offset: slideline_model::Offset::NONE,
            slaves: Vec::new(),
            counts_sides: false,
            name: "P".to_owned(),
            is_piece: false,
            formulation: slideline_model::Formulation::SurfaceToSurface,
            vocabulary: slideline_model::Vocabulary::Elements,
            faces: Vec::new(),
            elements: vec![element; 2_500_000],
            master: Master::RigidSurface(surface),
            interaction,
            origin: at,
        };
        let model = Model { contact_pairs: vec![pair], ..Model::default() };
        let said = objection(&model).unwrap();
        assert_eq!((said.code, said.span), (Code("SL0415"), Some(at)));
        assert!(said.message.contains("GiB"), "{said:?}");
        assert!(said.help.unwrap().contains("fewer slave nodes"));
    }

    /// Requirement: the oldest systems go until half of the memory holds the others and the
    /// new one; all go before that is refused, none of small ones; of large ones what is as large as
    /// the new one stays, however much memory there is.
    #[test]
    fn the_oldest_systems_are_dropped() {
        let kept = [3.0, 1.0, 2.0].into_iter();
        for (needed, there, dropped) in
            [(1.0, 14.0, 0), (4.0, 8.0, 1), (3.0, 5.0, 2), (9.0, 2.0, 3)]
        {
            assert_eq!(surplus(kept.clone(), needed, there), dropped, "{needed} {there}");
        }
        assert_eq!(to_drop(kept, 1.0), 0);
        let huge = 1024.0 * 1024.0 * GIB;
        assert_eq!(to_drop([1.0, huge, huge].into_iter(), huge), 3);
        assert_eq!(surplus([SURE; 4].into_iter(), SURE, huge), 3);
    }

    /// Requirement: limits are read as Linux writes them; what is unlimited or not there is
    /// none.
    #[test]
    fn limits_are_read() {
        assert_eq!(
            kibibytes("MemFree:  7 kB\nMemAvailable:    12 kB\n", "MemAvailable:"),
            Some(12288.0)
        );
        assert_eq!(kibibytes("", "MemAvailable:"), None);
        assert_eq!(number("max\n"), None);
        assert_eq!(number("4096\n"), Some(4096.0));
        let limits = |soft: &str| {
            format!("Max cpu time  unlimited\nMax address space  {soft}  unlimited  bytes\n")
        };
        assert_eq!(address_space(&limits("300000")), Some(3e5));
        assert_eq!(address_space(&limits("unlimited")), None);
    }

    #[test]
    fn a_small_model_fits_and_a_pebibyte_does_not() {
        assert!(objection(&Model::default()).is_none());
        let said = too_large(1024.0 * 1024.0 * GIB, "the model").unwrap();
        assert_eq!(said.code, Code("SL0415"));
        assert!(said.message.contains("1048576.0 GiB"), "{}", said.message);
    }
}
