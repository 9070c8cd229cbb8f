//! The commands that change control points by their numbers: insert, change, delete. They are the same
//! in every editor; what a place is asked for with is the editor's own.

use super::choice::{ask_existing, ask_index};
use super::drawing::{Drawing, Edit, Place};
use crate::file::MAX_POINTS;
use crate::machine::Asked;
use crate::ui::{Answer, Desk, Question, Stay, TOP, words};
use crate::work::Configuration;

/// An editor of control points.
pub(super) trait PointEditor: Configuration {
    /// A control point.
    type Place: Place;

    /// The control points.
    fn drawing(&self) -> &Drawing<Self::Place>;

    /// Asks for the place of a point.
    async fn ask_place(&self, desk: &mut Desk<'_>) -> Asked<Self::Place>;

    /// Carries out an edit by number.
    fn edit(&mut self, edit: Edit<Self::Place>);

    /// Shows which point is about to be changed, until there is none any more.
    fn point_out(&mut self, _index: Option<usize>) {}
}

/// How many points there are.
fn count<E: PointEditor>(editor: &E) -> usize {
    editor.drawing().points().len()
}

/// The command B: a new point with a number and a place.
pub(super) async fn insert<E: PointEditor>(editor: &mut E, desk: &mut Desk<'_>) -> Asked<()> {
    if editor.drawing().full() {
        desk.tell(words::FULL, Stay::Briefly);
        return Ok(());
    }
    let index = ask_index(desk, editor).await?;
    let place = editor.ask_place(desk).await?;
    editor.edit(Edit::Insert(index, place));
    Ok(())
}

/// The command V: another number or another place for a point.
pub(super) async fn change<E: PointEditor>(editor: &mut E, desk: &mut Desk<'_>) -> Asked<()> {
    let count = count(editor);
    let index = ask_existing(desk, editor, count).await?;
    change_at(editor, desk, index).await
}

/// The command V for a point whose number is known.
pub(super) async fn change_at<E: PointEditor>(
    editor: &mut E,
    desk: &mut Desk<'_>,
    index: usize,
) -> Asked<()> {
    editor.point_out(Some(index));
    let edit = ask_edit(editor, desk, index).await;
    editor.point_out(None);
    editor.edit(edit?);
    Ok(())
}

async fn ask_edit<E: PointEditor>(
    editor: &mut E,
    desk: &mut Desk<'_>,
    index: usize,
) -> Asked<Edit<E::Place>> {
    let what = Question::new(TOP, words::ASK_CHANGE, [words::NUMBER, words::PLACE]);
    Ok(match desk.ask(editor, &what).await? {
        Answer::First => {
            let count = count(editor);
            Edit::Renumber(index, ask_existing(desk, editor, count).await?)
        }
        Answer::Second => Edit::Move(index, editor.ask_place(desk).await?),
    })
}

/// The command T: a point goes.
pub(super) async fn delete<E: PointEditor>(editor: &mut E, desk: &mut Desk<'_>) -> Asked<()> {
    let count = count(editor);
    let index = ask_existing(desk, editor, count).await?;
    editor.edit(Edit::Delete(index));
    Ok(())
}

// The prompt for a point's number has room for two digits.
const _: () = assert!(MAX_POINTS <= 99);
