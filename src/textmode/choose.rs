//! Choosing a line of a list by keys, wheel and clicks.

use super::TextEvent;
use super::page::{Hit, Row};
use crate::machine::Key;

/// Number of lines that Page Up and Page Down move.
const LEAP: isize = 10;

/// The line chosen by an event; `None` if it chooses nothing. Headings are skipped.
pub fn chosen_after(rows: &[Row], chosen: usize, event: TextEvent) -> Option<usize> {
    let last = rows.len() as isize;
    let by = match event {
        TextEvent::Click(Hit::Row(index)) => return is_item(rows, index).then_some(index),
        TextEvent::Wheel(steps) => -(steps.clamp(-100, 100) as isize),
        TextEvent::Key(Key::Up) => -1,
        TextEvent::Key(Key::Down) => 1,
        TextEvent::Key(Key::PageUp) => -LEAP,
        TextEvent::Key(Key::PageDown) => LEAP,
        TextEvent::Key(Key::Home) => -last,
        TextEvent::Key(Key::End) => last,
        _ => return None,
    };
    let items: Vec<usize> = (0..rows.len()).filter(|&index| is_item(rows, index)).collect();
    let at = items.partition_point(|&index| index < chosen) as isize;
    let to = at.saturating_add(by).clamp(0, (items.len() as isize - 1).max(0));
    items.get(to as usize).copied()
}

fn is_item(rows: &[Row], index: usize) -> bool {
    matches!(rows.get(index), Some(Row::Item(_) | Row::Mark(..)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_are_passed_over_and_ends_are_ends() {
        let heading = || Row::Heading(String::new());
        let item = || Row::Item(String::new());
        let rows = [heading(), item(), heading(), item(), item()];
        let after = |chosen, key| chosen_after(&rows, chosen, TextEvent::Key(key));
        assert_eq!(after(1, Key::Down), Some(3));
        assert_eq!(after(3, Key::Up), Some(1));
        assert_eq!(after(1, Key::Up), Some(1));
        assert_eq!(after(3, Key::PageDown), Some(4));
        assert_eq!(after(4, Key::Home), Some(1));
        assert_eq!(after(4, Key::Enter), None);
        let click = |row| chosen_after(&rows, 1, TextEvent::Click(Hit::Row(row)));
        assert_eq!((click(2), click(4), click(9)), (None, Some(4), None));
        assert_eq!(chosen_after(&rows, 4, TextEvent::Wheel(i32::MAX)), Some(1));
        assert_eq!(chosen_after(&[], 4, TextEvent::Wheel(i32::MIN)), None);
    }
}
