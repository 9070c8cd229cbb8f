//! What a program begins with: a file of this browser, a sample, a document in the address, a puzzle by its number or text.

use crate::share::unpacked;
use grafika::file::{BeadWheel, CloudFormat, CloudReader, Document, FileKind, Format, TableOptions};
use grafika::machine::Storage;
use grafika::programs::of_format;
use grafika::puzzle::cube::CsangoCube;
use grafika::puzzle::wheel::{Difficulty, Scramble, Wheel, moves_from_text};
use grafika::ui::{Phrase, Program};
use grafika::work::{with_json, with_twin};
use std::fmt::Display;

/// A document, and the file it is of, if any.
pub(crate) type Opened = (Document, Option<String>);

/// What is wrong with a text.
fn wrong(text: &str, error: &dyn Display) -> Phrase {
    Phrase::plain(&format!("{text}: {error}"))
}

/// Opens a file or a sample.
pub(crate) fn file(storage: &dyn Storage, name: &str, clouds: bool) -> Result<Opened, Phrase> {
    let content = storage.read(name).map_err(|error| Phrase::plain(&error))?;
    let document = document(name, &content, clouds)?;
    let (document, name) = with_twin(document, storage, name);
    if matches!(document, Document::Tangents(_)) {
        let problem = "holds tangents only; no .IC2 file with the points lies beside it";
        return Err(Phrase::plain(&format!("{name} {problem}")));
    }
    let document = with_json(document, storage, &name);
    Ok((document, Some(name)))
}

fn document(name: &str, content: &[u8], clouds: bool) -> Result<Document, Phrase> {
    let extension = name.rsplit_once('.').map(|(_, extension)| extension).unwrap_or_default();
    let Some(kind) = FileKind::from_input_extension(extension) else {
        return Err(Phrase::new(
            format!("{name}: ilyen kiterjesztése nincs adatfájlnak"),
            format!("{name}: no data file has this extension"),
        ));
    };
    let options = TableOptions::default();
    let cloud = match kind {
        FileKind::Dos(format) => CloudFormat::of(format),
        FileKind::Csv => clouds.then_some(CloudFormat::Csv),
        FileKind::Json => None,
    };
    let read = || match cloud {
        None => Document::decode_table(kind, content, &options),
        Some(format) => {
            let mut reader = CloudReader::new(format, &options)?;
            reader.feed(content)?;
            reader.finish().map(Document::Cloud)
        }
    };
    read().map_err(|error| wrong(name, &error))
}

/// The document packed into an address.
pub(crate) fn shared(packed: &str) -> Result<Opened, Phrase> {
    let text = unpacked(packed).ok_or_else(|| Phrase::new("sérült", "it is damaged"))?;
    Document::from_json(&text).map(|document| (document, None)).map_err(|error| Phrase::plain(&error))
}

/// A puzzle: for the wheel `8:123` (difficulty and number), a position or moves; for the cube a position.
pub(crate) fn puzzle(program: &Program, text: &str) -> Result<Opened, Phrase> {
    let opens = |format: Format| program.opens.contains(&format);
    if opens(Format::Gyk) {
        let wheel = wheel(text)?;
        return Ok((Document::BeadWheel(BeadWheel::from(&wheel)), None));
    }
    if opens(Format::Csk) {
        let cube = text.parse::<CsangoCube>().map_err(|error| wrong(text, &error))?;
        return Ok((Document::CsangoCube(cube), None));
    }
    let name = program.manual.name;
    Err(Phrase::new(
        format!("{name}: ebben a programban nincs feladvány"),
        format!("{name}: this program has no puzzles"),
    ))
}

fn wheel(text: &str) -> Result<Wheel, Phrase> {
    if let Some((difficulty, number)) = text.split_once(':') {
        let known = [
            ("4", Difficulty::Four),
            ("8", Difficulty::Eight),
            ("1", Difficulty::Sixteen),
            ("K", Difficulty::Book),
            ("V", Difficulty::Any),
        ];
        let difficulty = known.iter().find(|(letter, _)| letter.eq_ignore_ascii_case(difficulty));
        let number = number.parse::<u64>().ok().filter(|number| *number <= 999_999);
        let (Some((_, difficulty)), Some(number)) = (difficulty, number) else {
            return Err(Phrase::new(
                format!("{text}: nehézség (4, 8, 1, K, V), kettőspont, sorszám 999999-ig kell"),
                format!("{text}: give a difficulty (4, 8, 1, K, V), a colon, a number up to 999999"),
            ));
        };
        return Ok(Scramble::new(*difficulty, number).wheel);
    }
    if text.contains('-') {
        return text.parse::<Wheel>().map_err(|error| wrong(text, &error));
    }
    let moves = moves_from_text(text).map_err(|error| wrong(text, &error))?;
    let made = moves.into_iter().try_fold(Wheel::solved(), |wheel, step| wheel.after(step));
    made.ok_or_else(|| {
        Phrase::new(
            format!("{text}: bent lévő fiók nem tolható"),
            format!("{text}: a drawer that is in cannot be pushed"),
        )
    })
}

/// The program that a file belongs to: the one that is open if it can.
pub(crate) fn program_of(
    storage: &dyn Storage,
    name: &str,
    open: Option<&'static Program>,
) -> Result<&'static Program, Phrase> {
    let clouds = open.is_some_and(|program| program.opens.contains(&Format::Xyz));
    let (document, _) = file(storage, name, clouds)?;
    let fits = open.filter(|program| (program.start)(Some(document.clone())).is_ok());
    fits.or_else(|| of_format(document.format())).ok_or_else(|| {
        Phrase::new(
            format!("{name}: nincs program, amely megnyitná"),
            format!("{name}: no program opens this"),
        )
    })
}
