//! Forms of a PDF: drawings that are written once and placed by reference.

use pdf_writer::{Filter, Finish, Pdf, Rect, Ref};

/// What is there as often as this is a form; below, its repetition costs less than what a form has around it.
pub(super) const OFTEN: usize = 16;

/// Drawings around their origins.
#[derive(Default)]
pub(super) struct Forms(Vec<(f32, Vec<u8>)>);

impl Forms {
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Adds a drawing that reaches no farther from its origin; returns its number.
    pub(super) fn add(&mut self, reach: f32, drawn: Vec<u8>) -> usize {
        self.0.push((reach, drawn));
        self.0.len() - 1
    }

    /// What a form is called in the page.
    pub(super) fn name(&self, number: usize) -> String {
        format!("f{number}")
    }

    pub(super) fn names(&self) -> impl Iterator<Item = (String, usize)> {
        (0..self.0.len()).map(|number| (self.name(number), number))
    }

    /// Writes the forms with the references of their numbers.
    pub(super) fn write(&self, pdf: &mut Pdf, level: u8, reference: impl Fn(usize) -> Ref) {
        for (number, (reach, drawn)) in self.0.iter().enumerate() {
            let packed = miniz_oxide::deflate::compress_to_vec_zlib(drawn, level);
            let mut form = pdf.form_xobject(reference(number), &packed);
            form.bbox(Rect::new(-reach, -reach, *reach, *reach)).filter(Filter::FlateDecode);
            form.resources().finish();
        }
    }
}
