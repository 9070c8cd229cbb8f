//! The shortest way of one piece between the others: a breadth-first search over its places and attitudes.

use super::moves::{Action, Rules, Taken};
use super::position::{CubePiece, ROTATIONS, TABLE_CELLS, on_table};
use std::collections::VecDeque;

/// States of a piece: cell 1 and attitude.
const STATES: usize = TABLE_CELLS * ROTATIONS.len();

/// The number of a piece's state; `None` off the table.
fn number(piece: CubePiece) -> Option<usize> {
    let turned = ROTATIONS.iter().position(|rotation| *rotation == piece.rotation)?;
    Some(on_table(piece.cell)? * ROTATIONS.len() + turned)
}

/// The actions by which a piece comes to the nearest place that is right, with all other cells as they
/// are; `None` if there is no way.
pub(super) fn shortest(
    index: usize,
    from: CubePiece,
    others: &Taken,
    rules: Rules,
    is_right: impl Fn(CubePiece) -> bool,
) -> Option<Vec<Action>> {
    // What led to each state: the action, and the state before by its number.
    let mut came: Vec<Option<(Action, usize)>> = vec![None; STATES];
    let start = number(from)?;
    let mut queue = VecDeque::from([(from, start)]);
    while let Some((piece, state)) = queue.pop_front() {
        if is_right(piece) {
            return Some(traced(&came, start, state));
        }
        for action in Action::ALL {
            let after = action.apply(piece);
            let Some(next) = number(after).filter(|&next| next != start) else { continue };
            // Most places are known already; whether there is a way to one takes longer to find out.
            if let Some(slot) = came.get_mut(next)
                && slot.is_none()
                && others.allows(index, piece, action, rules)
            {
                *slot = Some((action, state));
                queue.push_back((after, next));
            }
        }
    }
    None
}

/// The actions that led from one state to another.
fn traced(came: &[Option<(Action, usize)>], start: usize, end: usize) -> Vec<Action> {
    let mut actions = Vec::new();
    let mut state = end;
    while state != start
        && let Some(&Some((action, before))) = came.get(state)
    {
        actions.push(action);
        state = before;
    }
    actions.reverse();
    actions
}
