//! Two patches beside each other: the key J, and the line that says how smoothly they meet.

use super::Nets;
use crate::design::NetDesign;
use crate::editor::Editor;
use crate::file::RATIOS;
use crate::geometry::{BoundingBox, Contact, Joint, Order};
use crate::machine::{Asked, Language, Manner};
use crate::screen::{Color, Screen};
use crate::ui::words::{Hot, Words};
use crate::ui::{Area, Caption, Choices, Desk, Field, Form, Number, Stay, TOP};
use serde::Serialize;

const SECOND_PATCH: Words =
    Words("Második folt, C1: a közös perem után simán folytatódik", "A second patch goes on smoothly (C1)");
const ONE_PATCH: Words = Words("Ismét egy folt", "One patch again");
const NO_ROOM: Words = Words("Ekkora háló mellett nincs hely", "There is no room beside so large a net");
const ASK: Words = Words("Mi marad meg a közös peremen?", "What is kept at the border?");
const RATIO: Words = Words("Deriváltak aránya:", "Derivatives 1 :");
const C0: Hot = Hot::new('0', " - C0", " - C0");
const PLANE: Hot = Hot::new('S', "ík", "-plane");
const C1: Hot = Hot::new('1', " - C1", " - C1");
const C2: Hot = Hot::new('2', " - C2", " - C2");
const ONE: Hot = Hot::new('E', "gy folt", " one patch");

/// How two patches are joined, as `dump` writes it.
#[derive(Serialize)]
pub(super) struct JointDump {
    kept: Joint,
    ratio: f64,
    measured: Option<Contact>,
}

impl JointDump {
    pub(super) fn of(net: &NetDesign) -> Option<JointDump> {
        Some(JointDump { kept: net.joint()?, ratio: net.ratio(), measured: net.contact() })
    }
}

impl Editor<Nets, 3> {
    /// Puts a second patch beside the first; if it is there, asks what is kept at the joint. The originals have one.
    pub(super) async fn join(&mut self, desk: &mut Desk<'_>) -> Asked<()> {
        if self.manner == Manner::Original {
            return Ok(());
        }
        let now = self.history.now().clone();
        let Some(kept) = now.joint() else {
            if !now.may_join() {
                desk.tell(NO_ROOM, Stay::Briefly);
                return Ok(());
            }
            self.change_surface(desk, now.with_second_patch());
            self.frame_joined();
            desk.tell(SECOND_PATCH, Stay::Briefly);
            return Ok(());
        };
        let design = match self.ask_joint(desk, kept).await? {
            None => {
                desk.tell(ONE_PATCH, Stay::Briefly);
                now.with_one_patch()
            }
            Some(Joint::Plane) => {
                let field = Field {
                    area: Area::new(370, 19, 425, 32),
                    at: (374, 22),
                    longest: 5,
                    kind: Number::Real(RATIOS),
                };
                let form = Form::new(vec![Caption::new((220, 22), RATIO)], [field]);
                let [ratio] = desk.numbers_or(self, &form, [now.ratio().to_string()]).await?;
                now.with_joint(Joint::Plane, Some(ratio))
            }
            Some(joint) => now.with_joint(joint, None),
        };
        self.change_surface(desk, design);
        Ok(())
    }

    /// Shows both patches.
    pub(super) fn frame_joined(&mut self) {
        let net = self.history.now();
        if net.joint().is_some()
            && let Some(bounds) = net.surface().ok().and_then(|surface| surface.bounding_box())
        {
            self.lens.look = self.lens.look.framing(&BoundingBox { min: bounds.min, max: bounds.max });
        }
    }

    /// Asks what is kept; `None` takes the second patch away.
    async fn ask_joint(&self, desk: &mut Desk<'_>, kept: Joint) -> Asked<Option<Joint>> {
        let [top, below] = [16, 31];
        let window = |column: i32, y: i32| {
            let x = 214 + 78 * column;
            Area::new(x, y, x + 70, y + 13)
        };
        let choices = Choices {
            place: TOP,
            captions: vec![Caption::new((214, 7), ASK)],
            answers: vec![
                (window(0, top), C0, Some(Joint::C0)),
                (window(1, top), PLANE, Some(Joint::Plane)),
                (window(2, top), C1, Some(Joint::C1)),
                (window(0, below), C2, Some(Joint::C2)),
                (Area::new(292, below, 440, below + 13), ONE, None),
            ],
        };
        desk.choose_or(self, &choices, Some(Some(kept))).await
    }

    /// What is kept and what is measured, under the picture; red where what is kept does not hold.
    pub(super) fn draw_joint(&self, screen: &mut Screen, at: (i32, i32), language: Language) {
        let net = self.preview();
        let Some((kept, contact)) = net.joint().zip(net.contact()) else { return };
        let ink = if holds(kept, &contact) { Color::Black } else { Color::Red };
        screen.text(at.0, at.1, &told(kept, &contact, language), ink);
    }
}

/// What is kept and what is measured.
fn told(kept: Joint, contact: &Contact, language: Language) -> String {
    let name = match kept {
        Joint::C0 => Words("C0", "C0"),
        Joint::Plane => Words("sík", "plane"),
        Joint::C1 => Words("C1", "C1"),
        Joint::C2 => Words("C2", "C2"),
    };
    let mark = if holds(kept, contact) { Words("", "") } else { Words(", nem teljesül", ", broken") };
    let (kept, measured) = (name.of(language), measured(contact, language));
    match language {
        Language::Hungarian => format!("Kívánt: {kept}{}. Mért: {measured}", mark.0),
        Language::English => format!("Kept: {kept}{}. Measured: {measured}", mark.1),
    }
}

/// Whether a measured contact is at least what is kept.
fn holds(kept: Joint, contact: &Contact) -> bool {
    match kept {
        Joint::C0 => true,
        Joint::Plane => matches!(contact.order, Order::Plane | Order::C1 | Order::C2),
        Joint::C1 => matches!(contact.order, Order::C1 | Order::C2),
        Joint::C2 => contact.order == Order::C2,
    }
}

/// What was measured, in words.
fn measured(contact: &Contact, language: Language) -> String {
    let percent = |part: f64| short(100.0 * part);
    let words = |pair: Words, numbers: &[String]| {
        numbers.iter().fold(pair.of(language).to_owned(), |text, number| text.replacen("{}", number, 1))
    };
    match (contact.order, contact.angle) {
        (Order::C0, Some(angle)) => words(
            Words("C0, nincs érintősík: {} fok, v = {}", "C0, no tangent plane: {} degrees at v = {}"),
            &[short(angle.most.to_degrees()), format!("{:.2}", angle.at)],
        ),
        (Order::C0, None) => words(Words("C0, nincs normális", "C0, the border has no normals"), &[]),
        (Order::Fold, _) => words(
            Words("érintősík, de a 2. folt visszahajlik", "tangent plane, but the 2nd patch folds back"),
            &[],
        ),
        (Order::Plane, _) => words(
            Words("érintősík, nem C1 (deriváltak: {} %)", "tangent plane, not C1 (derivatives: {} %)"),
            &[percent(contact.first.most)],
        ),
        (Order::C1, _) => words(
            Words("C1, nem C2 (2. deriváltak: {} %)", "C1, not C2 (2nd derivatives: {} %)"),
            &[percent(contact.second.most)],
        ),
        (Order::C2, _) => "C2".to_owned(),
    }
}

/// A number with one decimal, or two digits that count where that would be zero.
fn short(value: f64) -> String {
    if value >= 0.05 { format!("{value:.1}") } else { format!("{value:.1e}") }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::JointDeviation;

    #[test]
    fn the_longest_line_fits_under_the_picture() {
        let deviation = JointDeviation { most: 1.234_567, at: 0.4 };
        for order in [Order::C0, Order::Fold, Order::Plane, Order::C1, Order::C2] {
            let contact = Contact { order, angle: Some(deviation), first: deviation, second: deviation };
            for language in [Language::Hungarian, Language::English] {
                for kept in Joint::ALL {
                    let line = told(kept, &contact, language);
                    assert!(line.chars().count() < 80, "{line}");
                    assert!(!line.contains("{}"), "{line}");
                }
            }
        }
    }
}
