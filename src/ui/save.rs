//! Saving what a program shows: F10 a figure, F12 the screen, Ctrl+F12 a film.
//!
//! A figure is the geometry of a picture, written as SVG, PNG or PDF with a title, a caption and axes. For a picture
//! without geometry the screen is written instead, in the same formats.

use super::ask::{Answer, Caption, Choices, Number, Question, TOP};
use super::desk::{Desk, Picture};
use super::entry::{Accepts, Entry};
use super::frame::Area;
use super::notice::Stay;
use super::words::{self, Hot, Phrase};
use crate::figure::{
    Axes, Figure, FigureError, MODEL_TOLERANCE, ModelFormat, ModelOptions, SMALLEST_WIDTH, screen_pdf,
    screen_png, screen_png_of_scale, screen_svg,
};
use crate::file::{Document, Format};
use crate::geometry::ParamSurface;
use crate::machine::{Asked, Manner, Storage, free_name};
use crate::screen::{Color, Screen, WIDTH};
use std::ops::RangeInclusive;

/// A format of figures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Svg,
    Png,
    Pdf,
}

/// What is saved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wanted {
    Figure(Kind),
    Model(ModelFormat),
    Document,
}

/// What can be saved, with its extension, its answer, and the left and right edge of the answer on the page.
type Offer = (Wanted, &'static str, Hot, (i32, i32));

/// The figures.
const FIGURES: [Offer; 3] = [
    (Wanted::Figure(Kind::Svg), "svg", words::SVG, (16, 66)),
    (Wanted::Figure(Kind::Png), "png", words::PNG, (86, 136)),
    (Wanted::Figure(Kind::Pdf), "pdf", words::PDF, (156, 226)),
];
/// The models, which stand above them.
const MODELS: [Offer; 4] = [
    (Wanted::Model(ModelFormat::Step), "step", Hot::new('E', "-STEP", "-STEP"), (4, 62)),
    (Wanted::Model(ModelFormat::Stl), "stl", Hot::new('L', "-STL", "-STL"), (66, 116)),
    (Wanted::Model(ModelFormat::Obj), "obj", Hot::new('O', "BJ", "BJ"), (122, 162)),
    (Wanted::Model(ModelFormat::Ply), "ply", Hot::new('Y', "-PLY", "-PLY"), (168, 226)),
];

/// The figures where there is a document too, and the document, whose extension is its own.
const FIGURE_EDGES: [(i32, i32); 3] = [(4, 46), (52, 94), (100, 174)];
const DOCUMENT_EDGES: (i32, i32) = (180, 226);

/// Steps a span of a model that is a mesh.
const STEPS: usize = 10;

/// The proposed width of a PNG in pixels.
const WIDTH_PROPOSED: &str = "1280";
/// The largest width in pixels, which is still written quickly. The command line allows larger ones.
const WIDEST: i32 = 4096;
/// Greatest lengths of a width, a title and a caption in characters.
const LONGEST_NUMBER: usize = 5;
const LONGEST_TITLE: usize = 80;
const LONGEST_CAPTION: usize = 400;

/// What is to be written.
enum Content {
    Figure(Box<Figure>),
    Screen(Box<Screen>),
}

impl Desk<'_> {
    /// The key F10: asks about the figure and saves it. Esc in any question saves nothing.
    pub(super) async fn ask_and_save_figure(&mut self, picture: &dyn Picture) -> Asked<()> {
        let mut content = match picture.figure() {
            Some(figure) => Content::Figure(Box::new(figure)),
            None => {
                let language = self.machine.language();
                picture.draw(self.machine.screen(), language);
                Content::Screen(Box::new(self.machine.screen().clone()))
            }
        };
        if let Content::Figure(figure) = &content
            && let Err(error) = figure.check()
        {
            self.tell(words::figure_problem(&error), Stay::UntilRead);
            return Ok(());
        }
        // The originals show no models: their questions stay as they are.
        let mut surfaces = picture.surfaces();
        surfaces.retain(|_| self.machine.manner() == Manner::Today);
        let document = picture.exported().filter(|_| self.machine.manner() == Manner::Today);
        let (wanted, extension) = self.ask_format(picture, !surfaces.is_empty(), document.as_ref()).await?;
        let kind = match wanted {
            Wanted::Document => return self.save_document(picture, document, extension).await,
            Wanted::Model(format) => return self.save_model(picture, format, &surfaces, extension).await,
            Wanted::Figure(kind) => kind,
        };
        let width = match kind {
            Kind::Png => self.ask_width(picture, content.widths()).await?,
            Kind::Svg | Kind::Pdf => 0,
        };
        if let Content::Figure(figure) = &mut content {
            self.ask_words(picture, figure).await?;
        }
        let name = self.ask_name(picture, extension).await?;
        let saved =
            content.encode(kind, width).map_err(|error| words::figure_problem(&error)).and_then(|file| {
                let written = self.machine.storage().write(&name, &file);
                written.map_err(|error| words::storage_problem(&error))
            });
        match saved {
            Ok(()) if content.lacks_axes() => {
                self.tell(words::figure_saved_without_axes(&self.located(&name)), Stay::UntilRead);
            }
            Ok(()) => self.tell(words::figure_saved(&self.located(&name)), Stay::Briefly),
            Err(problem) => self.tell(problem, Stay::UntilRead),
        }
        Ok(())
    }

    async fn save_model(
        &mut self,
        picture: &dyn Picture,
        format: ModelFormat,
        surfaces: &[Box<dyn ParamSurface>],
        extension: &str,
    ) -> Asked<()> {
        let name = self.ask_name(picture, extension).await?;
        let surfaces: Vec<&dyn ParamSurface> = surfaces.iter().map(|surface| &**surface).collect();
        let options = ModelOptions { steps: STEPS, tolerance: MODEL_TOLERANCE, name: stem(&name) };
        let made = format.encode(&surfaces, &options).map_err(|error| words::figure_problem(&error));
        let saved = made.and_then(|(file, warning)| {
            let written = self.machine.storage().write(&name, &file);
            written.map_err(|error| words::storage_problem(&error)).map(|()| warning)
        });
        match saved {
            Ok(None) => self.tell(words::figure_saved(&self.located(&name)), Stay::Briefly),
            Ok(Some(warning)) => self.tell(Phrase::plain(&warning), Stay::UntilRead),
            Err(problem) => self.tell(problem, Stay::UntilRead),
        }
        Ok(())
    }

    async fn save_document(
        &mut self,
        picture: &dyn Picture,
        document: Option<Document>,
        extension: &str,
    ) -> Asked<()> {
        let name = self.ask_name(picture, extension).await?;
        let Some(document) = document else { return Ok(()) };
        let saved = document.write(document.format()).map_err(|error| words::in_file(&name, &error));
        let saved = saved.and_then(|file| {
            let written = self.machine.storage().write(&name, &file);
            written.map_err(|error| words::storage_problem(&error))
        });
        match saved {
            Ok(()) => self.tell(words::figure_saved(&self.located(&name)), Stay::Briefly),
            Err(problem) => self.tell(problem, Stay::UntilRead),
        }
        Ok(())
    }

    async fn ask_format(
        &mut self,
        picture: &dyn Picture,
        models: bool,
        document: Option<&Document>,
    ) -> Asked<(Wanted, &'static str)> {
        let (x, y) = TOP;
        let answer = |top: i32| {
            move |(wanted, extension, text, (left, right)): Offer| {
                (Area::new(x + left, y + top, x + right, y + top + 13), text, (wanted, extension))
            }
        };
        let mut choices = Choices {
            place: TOP,
            captions: vec![Caption { at: (x + 7, y + 8), text: words::ASK_KIND.into(), color: Color::Black }],
            answers: FIGURES.map(answer(21)).into(),
        };
        if let Some(document) = document {
            for (figure, edges) in choices.answers.iter_mut().zip(FIGURE_EDGES) {
                (figure.0.x1, figure.0.x2) = (x + edges.0, x + edges.1);
            }
            let format = document.format();
            let text = match format {
                Format::Csm => words::CSM,
                _ => words::CSF,
            };
            choices.answers.push(answer(21)((Wanted::Document, format.extension(), text, DOCUMENT_EDGES)));
        }
        if models {
            // There is no room for the question besides; two rows of formats ask enough.
            choices.captions.clear();
            choices.answers.extend(MODELS.map(answer(4)));
        }
        self.choose_or(picture, &choices, Some((Wanted::Figure(Kind::Svg), "svg"))).await
    }

    /// Asks for the width of a PNG until it is a number, and clamps it to the range.
    async fn ask_width(&mut self, picture: &dyn Picture, range: RangeInclusive<i32>) -> Asked<u32> {
        let number = Number::Whole(range);
        loop {
            let entry = line_entry(LONGEST_NUMBER, Accepts::Number).proposing(WIDTH_PROPOSED);
            let text = self.type_line(picture, words::WIDTH_ENTRY, entry).await?;
            if let Some(width) = number.read(&text) {
                return Ok(width as u32);
            }
        }
    }

    /// Asks for title, caption and axes of a figure.
    async fn ask_words(&mut self, picture: &dyn Picture, figure: &mut Figure) -> Asked<()> {
        let title = line_entry(LONGEST_TITLE, Accepts::Text).proposing(self.title());
        let title = self.type_line(picture, words::TITLE_ENTRY, title).await?;
        let caption = line_entry(LONGEST_CAPTION, Accepts::Text);
        let caption = self.type_line(picture, words::CAPTION_ENTRY, caption).await?;
        let question = Question::new(TOP, words::ASK_AXES, [words::YES, words::NO]).choices();
        let answer = self.choose_or(picture, &question, Some(Answer::First)).await?;
        if !title.trim().is_empty() {
            figure.set_title(title);
        }
        if !caption.trim().is_empty() {
            figure.set_caption(caption);
        }
        match answer {
            // A picture of space has axes of its own.
            Answer::First => figure.set_axes(figure.axes().unwrap_or(Axes::Plane)),
            Answer::Second => figure.clear_axes(),
        }
        Ok(())
    }

    /// Asks for a name until it is free or may be overwritten.
    async fn ask_name(&mut self, picture: &dyn Picture, extension: &str) -> Asked<String> {
        let mut proposal = free_name(self.machine.storage(), self.manual.name, extension);
        loop {
            let stem = stem(&proposal).to_string();
            let name = self.name_proposed(picture, extension, &stem).await?;
            if self.machine.storage().find(&name).is_none() || self.yes(picture, words::exists(&name)).await?
            {
                return Ok(name);
            }
            proposal = name;
        }
    }

    /// A file's name with its folder, where that is told.
    pub(crate) fn located(&self, name: &str) -> String {
        self.machine.files().place().map_or_else(|| name.to_owned(), |folder| format!("{folder}/{name}"))
    }

    /// The proposed title: the name of the open file, else that of the program.
    fn title(&self) -> String {
        stem(self.machine.file().unwrap_or(self.manual.name)).to_uppercase()
    }

    /// The key F12: saves the screen as a PNG under the first free name and says so.
    pub(super) fn keep_picture(&mut self) {
        match self.save_picture() {
            Ok(name) => self.tell(words::picture_saved(&self.located(&name)), Stay::Briefly),
            Err(problem) => self.tell(problem, Stay::UntilRead),
        }
    }

    fn save_picture(&mut self) -> Result<String, Phrase> {
        let picture = screen_png(self.machine.screen()).map_err(|error| Phrase::plain(&error))?;
        let name = free_name(self.machine.storage(), self.manual.name, "png");
        let written = self.machine.storage().write(&name, &picture);
        written.map_err(|error| words::storage_problem(&error))?;
        Ok(name)
    }

    /// The key Ctrl+F12: starts a film, or ends the one being recorded.
    pub(super) fn switch_film(&mut self) {
        if self.machine.film_end().is_some() {
            return self.end_film(Stay::Briefly);
        }
        match self.machine.start_film(self.manual.name) {
            Ok(()) => {
                let name = free_name(self.machine.storage(), self.manual.name, "gif");
                self.tell_off_film(words::film_begun(&name), Stay::Briefly);
            }
            Err(error) => self.tell(words::storage_problem(&error), Stay::UntilRead),
        }
    }

    /// Ends and saves the film and says so. If the film ended by itself, the message stays until it is read.
    pub(super) fn end_film(&mut self, stay: Stay) {
        match (self.machine.stop_film(), stay) {
            (Ok(Some(name)), Stay::Briefly) => self.tell(words::film_saved(&self.located(&name)), stay),
            (Ok(Some(name)), Stay::UntilRead) => self.tell(words::film_full(&self.located(&name)), stay),
            (Ok(None), _) => {}
            (Err(error), _) => self.tell(words::storage_problem(&error), Stay::UntilRead),
        }
    }

    /// Adds the screen to the film. A film that fails is ended.
    pub(super) fn film_screen(&mut self) {
        if let Err(error) = self.machine.film_screen() {
            // What has been recorded is saved anyway.
            let _ = self.machine.stop_film();
            self.tell(words::storage_problem(&error), Stay::UntilRead);
        }
    }
}

/// A line in the window of the page at the top.
pub(super) fn line_entry(longest: usize, accepts: Accepts) -> Entry {
    let (x, y) = TOP;
    Entry::new(Area::new(x + 6, y + 19, x + 234, y + 33), (x + 12, y + 23), longest, accepts)
}

/// A name without its extension.
fn stem(name: &str) -> &str {
    name.rsplit_once('.').map_or(name, |(stem, _)| stem)
}

impl Content {
    /// The widths of its PNG in pixels.
    fn widths(&self) -> RangeInclusive<i32> {
        let pixels = |width: u32| i32::try_from(width).unwrap_or(i32::MAX);
        match self {
            Content::Figure(_) => pixels(SMALLEST_WIDTH)..=WIDEST,
            Content::Screen(_) => WIDTH..=WIDEST,
        }
    }

    /// Whether axes were wanted that cannot be drawn.
    fn lacks_axes(&self) -> bool {
        matches!(self, Content::Figure(figure) if figure.lacks_axes())
    }

    /// The file; a PNG has this width in pixels, a screen the nearest whole multiple.
    fn encode(&self, kind: Kind, width: u32) -> Result<Vec<u8>, FigureError> {
        match (self, kind) {
            (Content::Figure(figure), Kind::Svg) => figure.to_svg().map(String::into_bytes),
            (Content::Figure(figure), Kind::Png) => figure.to_png(width),
            (Content::Figure(figure), Kind::Pdf) => figure.to_pdf(),
            (Content::Screen(screen), Kind::Svg) => Ok(screen_svg(screen).into_bytes()),
            (Content::Screen(screen), Kind::Png) => {
                let once = WIDTH.unsigned_abs();
                screen_png_of_scale(screen, (width + once / 2) / once)
            }
            (Content::Screen(screen), Kind::Pdf) => Ok(screen_pdf(screen)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::Words;

    #[test]
    fn titles_fit_on_the_page() {
        let entries = [words::WIDTH_ENTRY, words::TITLE_ENTRY, words::CAPTION_ENTRY];
        for Words(hungarian, english) in [words::ASK_KIND, words::ASK_AXES].into_iter().chain(entries) {
            assert!(hungarian.chars().count() <= 28 && english.chars().count() <= 28, "{hungarian}");
        }
    }

    #[test]
    fn names_lose_their_extension() {
        assert_eq!((stem("SIX.IP2"), stem("gb_2d_ip"), stem("a.b.svg")), ("SIX", "gb_2d_ip", "a.b"));
    }
}
