//! What ALAKPAR says, in Hungarian and English.

use super::form::Form;
use super::kinds::{Needs, of_name};
use crate::file::FamilyName;
use crate::geometry::GeometryError;
use crate::ui::words::no_curve;
use crate::ui::{Hot, Phrase, Words};

pub(super) const NO_DOCUMENT: Words = Words(
    "Ebben a fájlban nincs görbe: .ALP, .IP2, .IP3 vagy .GBP kell",
    "This file holds no curve: .ALP, .IP2, .IP3 or .GBP is needed",
);
pub(super) const EACH: Words = Words("pontonként", "by point");
pub(super) const WHICH_LAMBDA: Words = Words(
    "Minden pontnak saját lambdája van: F5 választ egyet, F6 egyformává teszi őket, A mindet beírja",
    "Every point has a lambda of its own: F5 chooses one, F6 makes them alike, A types one for all",
);
pub(super) const ALREADY_THROUGH: Words = Words(
    "A görbe most a pontokon megy át: H előtt I, hogy újra kontrollpontok legyenek",
    "The curve passes the points now: press I first, so that they are control points again",
);
pub(super) const CLICK_TARGET: Words = Words("Kattintson a célpontra", "Click on the target");
pub(super) const TARGET_KEYS: Words = Words("Enter: hely számmal  Esc", "Enter: type a place  Esc");
pub(super) const ASK_FAMILY: Words = Words("Melyik görbecsalád ?", "Which family of curves?");
pub(super) const FAMILY_KEYS: Words =
    Words("1-9 0 K vagy kattintás; Esc: vissza", "1-9 0 K or a click; Esc: back");
pub(super) const SIDES: Words = Words("n1, n2: pont két oldalt", "n1, n2: points beside");
pub(super) const ASK_PHI: Words = Words("     Paraméterezés, phi ?", "    Parametrization, phi?");
pub(super) const TRIG: Hot = Hot::new('T', "rig.", "rig.");
pub(super) const POWER: Hot = Hot::new('P', "-hatvány", "-power");
pub(super) const RATIONAL: Hot = Hot::new('R', "ac.", "at.");
pub(super) const ONLY_RATIONAL: Words = Words(
    "A racionális paraméterezés csak n1 = n2 = 2 mellett van: válasszon T-t vagy P-t",
    "The rational parametrization exists for n1 = n2 = 2 only: choose T or P",
);
pub(super) const NO_DATA: Words = Words(
    "Ez a család nem megy át adott pontokon; a 2, 4, 6, 7, 8, 9 család igen (G)",
    "This family does not go through given points; families 2, 4, 6, 7, 8 and 9 do (G)",
);
pub(super) const IS_DATA: Words = Words("A pontok: adatok", "The points are data");
pub(super) const IS_CONTROL: Words = Words("A pontok: kontrollpontok", "Control points again");
pub(super) const NOT_LOCAL: Words = Words(
    "Pontonként csak a Han- és a GB-spline lambdája más (G 6, G 8)",
    "Only Han's and the GB-spline have a lambda for every point (G 6, G 8)",
);
pub(super) const ALL_ALIKE: Words = Words("Minden lambda egyforma", "All lambdas are alike");
pub(super) const NOT_CYCLIC: Words = Words(
    "Fokot emelni ciklikus görbén lehet: G, K",
    "Only the degree of a cyclic curve can be elevated: G, K",
);
pub(super) const POINT_NUMBER: Words = Words("A pont sorszáma:", "Number of the point:");
pub(super) const HINT_EMPTY: Words = Words("Kattintson: pont. F1", "Click: a point. F1");
pub(super) const HINT_EMPTY_SPACE: Words = Words("B: új pont. F1: segítség", "B: a point. F1: help");
pub(super) const HINT_HELD: Words = Words("Engedje el. Esc: mégsem", "Release it there. Esc: no");
pub(super) const HINT_COMB: Words = Words("+ -: fésű. K: elrejti", "+ -: comb. K: hide it");
pub(super) const HINT_EDIT: Words = Words("Húzza. Görgő: A C.  P H S I", "Drag. Wheel: A C.  P H S I");

/// A number as a window has room for it.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    if text.len() <= 8 { text } else { format!("{value:.2e}") }
}

/// A number without needless zeros.
pub(super) fn short(value: f64) -> String {
    value.to_string()
}

/// A family has no parameter to turn.
pub(super) fn no_parameter(name: FamilyName) -> Phrase {
    let title = of_name(name).title;
    Phrase::new(
        format!("{}: nincs ilyen paraméter; a G más családot kínál", title.0),
        format!("{}: there is no such parameter; G offers other families", title.1),
    )
}

/// What is asked for: a new value of a parameter.
pub(super) fn ask_value(name: &str, [low, high]: [f64; 2]) -> Phrase {
    let text =
        format!("{name}: {} ... {}", short((1e4 * low).round() / 1e4), short((1e4 * high).round() / 1e4));
    Phrase::new(text.clone(), text)
}

/// A text is no number of a range.
pub(super) fn bad_number(name: &str, [low, high]: [f64; 2]) -> Phrase {
    Phrase::new(
        format!("{name}: szám kell {low} és {high} között"),
        format!("{name}: a number from {low} to {high} is needed"),
    )
}

/// The parameter that is looked for.
pub(super) fn aiming(name: &str) -> Phrase {
    Phrase::new(format!("{name} viszi oda a görbét"), format!("{name} takes the curve there"))
}

/// What came of a target.
pub(super) fn reached(name: &str, value: f64, position: f64) -> Phrase {
    let text = format!("{name} = {}  x = {position:.3}", number(value));
    Phrase::new(text.clone(), text)
}

/// A target cannot be reached.
pub(super) fn not_reached(distance: f64) -> Phrase {
    let far = number(distance);
    Phrase::new(format!("Nem érhető el; hiányzik {far}"), format!("Not reachable: {far} away"))
}

/// The first line of the page.
pub(super) fn facts(points: usize, spans: usize, length: f64, through: bool) -> Phrase {
    let length = if length.abs() < 1e6 { format!("{length:.1}") } else { format!("{length:.2e}") };
    let (hungarian, english) = if through { ("adat", "data") } else { ("pont", "pts") };
    Phrase::new(
        format!("{points} {hungarian}, {spans} ív, L = {length}"),
        format!("{points} {english}, {spans} arcs, L = {length}"),
    )
}

/// The title of the window of blending functions, with the arc's number.
pub(super) fn functions(arc: Option<usize>) -> Phrase {
    match arc {
        Some(arc) => Phrase::new(format!("bázis, {arc}. ív"), format!("basis, arc {arc}")),
        None => Words("bázisfüggvények", "basis functions").into(),
    }
}

/// The ends of the series.
pub(super) fn series([low, high]: [f64; 2]) -> Phrase {
    let (low, high) = (number(low), number(high));
    Phrase::new(format!("kék {low} ... lila {high}"), format!("blue {low} ... pink {high}"))
}

/// The middle point of a trigonometric curve has no influence.
pub(super) fn dead(number: usize) -> Phrase {
    Phrase::new(format!("A(z) {number}. pontnak nincs hatása"), format!("Point {number} has no influence"))
}

/// Points outside the field.
pub(super) fn outside(count: usize) -> Phrase {
    Phrase::new(
        format!("{count} pont a mezőn kívül van; V helyezi át"),
        format!("{count} points lie outside the field; V moves them"),
    )
}

/// The points of a cyclic curve lie far out.
pub(super) fn far_out(harmonics: usize) -> Phrase {
    Phrase::new(
        format!(
            "{harmonics} felharmonikus kontrollpontjai messze a mezőn kívül vannak: a legnagyobbak szorzója óriási. \
             Kevesebbel a pontok kézbe vehetők, de a görbe simább lesz."
        ),
        format!(
            "The control points of {harmonics} harmonics fly far out of the field: the highest are multiplied by huge \
             factors. With fewer the points can be held, but the curve is smoother."
        ),
    )
}

/// Whether fewer harmonics are right.
pub(super) fn keep_harmonics(harmonics: usize) -> Phrase {
    Phrase::new(format!("   Csak {harmonics} felharmonikus ?"), format!("    Only {harmonics} harmonics?"))
}

/// Whether only the first points are to stay.
pub(super) fn keep_first(needed: usize) -> Phrase {
    Phrase::new(format!("  Az első {needed} pont marad ?"), format!("   Keep the first {needed} points?"))
}

/// A family needs fewer points.
pub(super) fn too_many(name: FamilyName, needed: usize, count: usize) -> Phrase {
    let title = of_name(name).title;
    Phrase::new(
        format!(
            "{}: pontosan {needed} pont kell, most {count} van. A többi Ctrl+Z-vel visszahozható.",
            title.0
        ),
        format!(
            "{}: exactly {needed} points are needed, there are {count}. Ctrl+Z brings the others back.",
            title.1
        ),
    )
}

/// A point has been added so that their number is odd.
pub(super) fn made_odd(number: usize) -> Phrase {
    Phrase::new(
        format!("Páratlan számú pont kell: a(z) {number}. az utolsó és az első közé került (Ctrl+Z)"),
        format!("An odd number is needed: point {number} was put between the last and the first (Ctrl+Z)"),
    )
}

/// The degree of a cyclic curve has been elevated.
pub(super) fn elevated(points: usize) -> Phrase {
    Phrase::new(format!("{points} pont, ugyanaz a görbe"), format!("{points} points, the same curve"))
}

/// No more points than this.
pub(super) fn no_elevation(most: usize) -> Phrase {
    Phrase::new(
        format!("Legfeljebb {most} pont lehet: tovább nem emelhető a fok"),
        format!("There may be {most} points at most: the degree cannot be elevated further"),
    )
}

/// Why there is no curve; `None` where there is one, or no point yet.
pub(super) fn problem<const D: usize>(form: &Form<D>) -> Option<Phrase> {
    let (count, title, needs) = (form.points.len(), of_name(form.family()).title, Needs::of(form));
    if count == 0 {
        return None;
    }
    if !needs.met(count) {
        return Some(match needs {
            Needs::Exactly(needed) => Phrase::new(
                format!("{}: pontosan {needed} pont kell, most {count}", title.0),
                format!("{}: exactly {needed} points, now {count}", title.1),
            ),
            Needs::AtLeast(needed) => Phrase::new(
                format!("{}: legalább {needed} pont kell, most {count}", title.0),
                format!("{}: at least {needed} points, now {count}", title.1),
            ),
            Needs::Odd => Phrase::new(
                format!("{}: páratlan számú pont kell (3, 5, ...), most {count}", title.0),
                format!("{}: an odd number of points (3, 5, ...), now {count}", title.1),
            ),
        });
    }
    form.curve().err().map(|error| refusal(form.through, &error))
}

fn refusal(through: bool, error: &GeometryError) -> Phrase {
    match error {
        GeometryError::Parameter { name: "the number of lambdas", .. } if through => Phrase::new(
            "Átmenő Han-görbének egy lambdája van: F6",
            "Han's curve through points has one lambda: F6",
        ),
        GeometryError::Parameter { name: "lambda", value, .. } if through && *value == 0.0 => Phrase::new(
            "0 lambdával nem megy át a pontokon: más lambda kell (A)",
            "With lambda 0 it does not pass the points: another lambda (A)",
        ),
        GeometryError::Parameter { name: "lambda", .. } if through => Phrase::new(
            "Átmenő Han-görbéhez -2-nél nagyobb lambda kell (A)",
            "Han's curve through points needs a lambda above -2 (A)",
        ),
        GeometryError::Parameter { name: "omega", .. } if through => Phrase::new(
            "alpha = pi-vel nem megy át a pontokon: kisebb kell (A)",
            "With alpha = pi it does not pass the points: a smaller one (A)",
        ),
        other => no_curve(other),
    }
}
