//! Search and gap put together for chains: the gap of a point against the piece that faces it.

use super::super::gap::Order;
use super::super::gap::curve::{Along, Weights, overclosure};
use super::super::gap::offset::Offset;
use super::super::search::chain::{Chain, Piece, PieceKind, flat};
use super::super::search::sharp::reach;
use super::super::search::through::CONTROLS;
use super::stencil::{AnyGap, StencilAttachments, curve_gap};
use crate::rigid::Attachment;

/// Gap of `point`, or of the surface that stands off it, against the piece of a chain that faces it;
/// variables (slave, nodes of [`Piece::nodes`]). `None` for degenerate positions.
#[inline]
pub fn chain_gap<O: Order>(
    chain: &Chain,
    piece: &Piece,
    positions: &[[f64; 3]],
    (point, offset): ([f64; 3], Offset),
) -> Option<AnyGap<O>> {
    let (k, xi, point) = (piece.index, piece.parameter, flat(point));
    let at = |node: usize| positions.get(node).copied().map(flat);
    match piece.kind {
        PieceKind::Straight => {
            let control = [at(k)?, at(k + 1)?];
            let along = Along::straight(chain.arc_coordinate(k), chain.reference_length(k), xi);
            let weights = Weights::straight(xi);
            curve_gap((point, offset), &control, &weights, &along, xi).map(AnyGap::Straight)
        }
        PieceKind::Curve { first } => {
            let control =
                positions.get(first..first + CONTROLS)?.first_chunk::<CONTROLS>()?.map(flat);
            let curve = chain.curve(k)?;
            let along = Along::straight(chain.arc_coordinate(k), chain.reference_length(k), xi);
            let weights = Weights::through(xi, curve.begin, &curve.tangents);
            curve_gap((point, offset), &control, &weights, &along, xi).map(AnyGap::Cubic)
        }
        PieceKind::Corner => {
            let before = k.checked_sub(1)?;
            let control = [at(before)?, at(k)?, at(k + 1)?];
            let f = chain.corner_fraction();
            let (a1, a2) = (f * chain.reference_length(before), f * chain.reference_length(k));
            let along = Along::corner(chain.arc_coordinate(k), a1, a2, xi);
            let weights = Weights::corner(xi, f);
            curve_gap((point, offset), &control, &weights, &along, xi).map(AnyGap::Curved)
        }
        PieceKind::Nose { ahead } => {
            let before = k.checked_sub(1)?;
            let control = [at(before)?, at(k)?, at(k + 1)?];
            let (weights, along) = nose(chain, k, ahead, xi);
            curve_gap((point, offset), &control, &weights, &along, xi).map(AnyGap::Curved)
        }
    }
}

/// Overclosure and coordinate along the master of that gap [L], without its derivatives.
pub fn chain_overclosure(
    chain: &Chain,
    piece: &Piece,
    positions: &[[f64; 3]],
    point: [f64; 3],
) -> Option<[f64; 2]> {
    let (xi, point, control) = (piece.parameter, flat(point), positions.get(piece.nodes())?);
    let length = |index| chain.reference_length(index);
    let (over, along) = match *control {
        [a, b] => (
            overclosure(point, &[a, b].map(flat), &Weights::straight(xi)),
            Along::straight(chain.arc_coordinate(piece.index), length(piece.index), xi),
        ),
        [a, b, c] => {
            if let PieceKind::Nose { ahead } = piece.kind {
                let (weights, along) = nose(chain, piece.index, ahead, xi);
                let over = overclosure(point, &[a, b, c].map(flat), &weights);
                return Some([over?, along.value]);
            }
            let f = chain.corner_fraction();
            let (before, behind) = (f * length(piece.index - 1), f * length(piece.index));
            let node = chain.arc_coordinate(piece.index);
            let weights = Weights::corner(xi, f);
            (
                overclosure(point, &[a, b, c].map(flat), &weights),
                Along::corner(node, before, behind, xi),
            )
        }
        [a, b, c, d] => {
            let curve = chain.curve(piece.index)?;
            let weights = Weights::through(xi, curve.begin, &curve.tangents);
            (
                overclosure(point, &[a, b, c, d].map(flat), &weights),
                Along::straight(chain.arc_coordinate(piece.index), length(piece.index), xi),
            )
        }
        _ => return None,
    };
    Some([over?, along.value])
}

/// Weights of the nose at an edge, and the coordinate along it.
fn nose(chain: &Chain, node: usize, ahead: bool, xi: f64) -> (Weights<3>, Along) {
    let (way, fractions) = reach(chain, node);
    let shift = if ahead { 2.0 * way } else { -2.0 * way };
    let along = Along::corner(chain.arc_coordinate(node) + shift, way, way, xi);
    (Weights::nose(xi, fractions, ahead), along)
}

/// Attachments of a chain stencil: the slave, then the piece's nodes, given in order.
#[inline]
pub fn chain_attachments(slave: Attachment, nodes: &[Attachment]) -> StencilAttachments {
    let mut attachments = StencilAttachments::new(slave);
    for node in nodes {
        attachments.push(*node);
    }
    attachments
}
