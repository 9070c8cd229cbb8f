//! Words of the curve editors: beta-splines, tangents, space, Fourier curves, arcs, the workshop.

use super::{Hot, Phrase, Words, in_line};
use crate::geometry::{GeometryError, Residuals};

// Beta-splines and their joints.
pub(crate) const HELP_SHAPE: Words =
    Words("eltolás, feszültség az egész görbén", "bias, tension of the whole curve");
pub(crate) const HELP_CURVE_FORM: Words = Words("görbe: nyitott vagy zárt", "draw a curve: open or closed");
pub(crate) const HELP_JOINTS: Words =
    Words("egy csatlakozás eltolása, feszültsége (2.68)", "bias, tension of one joint (2.68)");
pub(crate) const HELP_JOINTS_OFF: Words =
    Words("minden csatlakozás újra egyforma", "make all joints alike again");
pub(crate) const JOINT_ENTRY: Words = Words("Csatl.:", "Joint:");
pub(crate) const JOINT_BIAS: Words = Words("elt.=", "bias=");
pub(crate) const JOINT_TENSION: Words = Words("fesz.=", "tens.=");
pub(crate) const JOINTS_ALIKE: Words = Words("Minden csatlakozás egyforma", "All joints are alike");

// Tangents.
pub(crate) const POINT: Hot = Hot::new('P', "ont", "-oint");
pub(crate) const TANGENT: Hot = Hot::new('E', "rintő", "-tang.");
pub(crate) const LENGTH: Hot = Hot::new('H', "ossz", "-len.");
pub(crate) const ANGLE: Hot = Hot::new('S', "zög", "-angle");
// The accented capitals of the ROM font are hard to read; the original draws commas over plain ones.
pub(crate) const COONS_TITLE: Words = Words("COONS INTERPOLACIO", "COONS INTERPOLATION");
pub(crate) const COONS_ACCENTS: Words = Words(",  ,", "");
pub(crate) const ASK_AUTOMATIC: Words = Words(" Önműködő érintőszámítás ?", "    Automatic tangents?");
pub(crate) const TANGENT_LENGTH: Words = Words("Érintő hossza", "Tangent length");
pub(crate) const TANGENT_ANGLE: Words = Words("Érintő iránya", "Tangent angle");
pub(crate) const NEW_VALUE: Words = Words("új:", "new:");
pub(crate) const NO_TANGENTS: Words = Words(
    "Nincs hozzá .EC2: az érintőket a szomszédos pontok adják, k0 = 0.5",
    "There is no .EC2 file: tangents are computed from the neighbouring points, k0 = 0.5",
);
pub(crate) const HELP_CHANGE_TANGENT: Words =
    Words("változtatás: pont vagy érintő (hossz, szög)", "change: point or tangent (length, angle)");
pub(crate) const HELP_DRAG_TANGENT: Words =
    Words("pont vagy érintő húzása", "drag a point or the tip of a tangent");

/// The value of a number before it is changed.
pub(crate) fn now_it_is(number: f64) -> Phrase {
    Phrase::new(format!("most: {number}"), format!("now: {number}"))
}

// Beta-splines.
pub(crate) const BIAS_BUTTON: Hot = Hot::new('A', " - elt.", " - bias");
pub(crate) const TENSION_BUTTON: Hot = Hot::new('C', " - fesz", " - tens");
pub(crate) const BIAS_ENTRY: Words = Words("Eltolás:", "Bias:");
pub(crate) const TENSION_ENTRY: Words = Words("Feszültség:", "Tension:");
pub(crate) const BIAS_NAME: Words = Words("Eltolás", "Bias");
pub(crate) const TENSION_NAME: Words = Words("Feszültség", "Tension");
pub(crate) const K0_NAME: Words = Words("k0", "k0");
pub(crate) const BIAS_VALUE: Words = Words("Eltolás = ", "Bias = ");
pub(crate) const TENSION_VALUE: Words = Words("Feszültség = ", "Tension = ");

/// Why there is no curve.
pub(crate) fn no_curve(error: &GeometryError) -> Phrase {
    let GeometryError::CriticalTension { bias, critical, .. } = error else { return Phrase::plain(error) };
    let number = |value: &f64| format!("{value:.4}").trim_end_matches('0').trim_end_matches('.').to_string();
    let (bias, critical) = (number(bias), number(critical));
    Phrase::new(
        format!(
            "{bias} eltolásnál a {critical} feszültség kritikus: a görbe pontjai a végtelenbe mennek. Más feszültség kell: C"
        ),
        format!(
            "With bias {bias} the tension {critical} is critical: the points of the curve go to infinity. Choose another tension (C)"
        ),
    )
}

// The space editor.
pub(crate) const PLACE_3D: Words = Words("Hely", "Place");
pub(crate) const LEAVE: Words = Words("ESC - kilép", "ESC - back");
pub(crate) const ESC_ENDS: Words = Words("ESC - kilép", "ESC - quit");
pub(crate) const HELP_DRAG_3D: Words =
    Words("pont húzása a kép síkjában", "drag a point in the plane of the picture");
pub(crate) const HELP_TURN_DRAG: Words = Words("forgatás húzással", "drag to turn");
pub(crate) const HELP_TURN_KEYS: Words = Words("forgatás 3 fokkal", "turn by 3 degrees");
pub(crate) const HELP_ZOOM: Words = Words("nagyítás, kicsinyítés", "zoom in, out");
pub(crate) const HELP_HOME: Words = Words("az eredeti nézet", "back to the first view");
pub(crate) const HELP_SIGHT: Words =
    Words("vetítés: párhuzamos, középpontos", "projection: parallel, central");
pub(crate) const NOT_IN_SPACE: Words =
    Words("Ebben a fájlban nem térbeli kontrollpontok vannak", "This file holds no control points in space");
pub(crate) const OUTSIDE_SPACE: Words =
    Words("99-nél több pont vagy túl nagy koordináta", "More than 99 points, or too large a coordinate");

/// The line under the picture: the place of a point, counted from 1.
pub(crate) fn place_of(number: usize, place: [f64; 3]) -> Phrase {
    let [x, y, z] = place.map(in_line);
    let line = |number_word: &str, place_word: &str| {
        format!("{number_word}: {number}   {place_word}: x = {x}   y = {y}   z = {z}")
    };
    Phrase::new(line("Sorszám", "Hely"), line("Number", "Place"))
}

// The Fourier editor.
pub(crate) const COEFFICIENT_NAME: Words = Words("Együttható:", "Coeff.:");
pub(crate) const LETTER: Words = Words("név", "name");
pub(crate) const DIGITS: Words = Words("szám", "no.");
pub(crate) const HARMONICS_ENTRY: Words = Words("harmonikusok:", "harmonics:");
pub(crate) const ASK_FIT_SHAPE: Words = Words("Mit közelítsen ?", "Fit to what?");
pub(crate) const POLYGON: Hot = Hot::new('P', "oligon", "olygon");
pub(crate) const SPLINE_SHAPE: Hot = Hot::new('S', "pline", "pline");
pub(crate) const OF_POLYGON: Words = Words("poligon", "polygon");
pub(crate) const OF_SPLINE: Words = Words("spline", "spline");
pub(crate) const NO_COEFFICIENTS: Words = Words(
    "Ebben a fájlban nem egy Fourier-görbe együtthatói vannak",
    "This file holds no coefficients of a Fourier curve",
);
pub(crate) const HELP_WINDOW: Words = Words("ablakra kattintás: új érték", "click a window: new value");
pub(crate) const HELP_COEFFICIENT: Words =
    Words("együttható neve és száma, új érték", "a coefficient by name and number, new value");
pub(crate) const HELP_STEP: Words =
    Words("az érték változtatása: a, b 1, p, q 0.01", "change the value: a, b by 1, p, q by 0.01");
pub(crate) const HELP_TEN_STEPS: Words = Words("ennek tízszerese", "ten times as much");
pub(crate) const HELP_OTHER_WINDOW: Words = Words("másik együttható", "another coefficient");
pub(crate) const HELP_TYPE: Words = Words("új érték beírása", "type a new value");
pub(crate) const HELP_FIT: Words =
    Words("közelítés egy .IP2 fájl pontjaihoz", "fit the curve to the points of an .IP2 file");

/// There is no coefficient of a number in this column.
pub(crate) fn no_such_coefficient(numbers: &std::ops::RangeInclusive<usize>) -> Phrase {
    let (first, last) = (numbers.start(), numbers.end());
    Phrase::new(format!("Nincs ilyen: {first}...{last}"), format!("No such number: {first}...{last}"))
}

// The workshop of measured points.
pub(crate) const HELP_WORKSHOP: Words =
    Words("mérési pontok simítása (2.3.8): Enter átveszi", "smooth measured points (2.3.8); Enter accepts");
pub(crate) const TAKE_OVER: Words = Words("Enter - átvesz  ESC - vissza", "Enter - accept ESC - back");

/// How far smoothed points are from the measured ones, with the number of the farthest.
pub(crate) fn residuals(residuals: &Residuals) -> Phrase {
    let ([rms, largest], at) = (residuals.texts(2), residuals.at);
    Phrase::new(format!("RMS {rms}, max. {largest} ({at}.)"), format!("RMS {rms}, max. {largest} (no. {at})"))
}

/// How many points Bézier arcs lack.
pub(crate) fn arcs_lack(count: usize) -> Phrase {
    let points = if count == 1 { "point" } else { "points" };
    Phrase::new(format!("Az ívekhez még {count} pont kell"), format!("The arcs need {count} more {points}"))
}

/// What a joint of Bézier arcs has become.
pub(crate) fn joint_is(number: usize, smooth: bool) -> Phrase {
    match smooth {
        true => Phrase::new(format!("A {number}. pont sima"), format!("Point {number} is smooth")),
        false => Phrase::new(format!("A {number}. pont sarok"), format!("Point {number} is a corner")),
    }
}

/// The value of a smoothed point and the slope of the curve there; in space, its two slopes. Short enough for a page.
pub(crate) fn value_and_slope(number: usize, point: &[f64], slopes: &[Option<f64>]) -> Phrase {
    let shown = |slope: &Option<f64>| slope.map_or("-".to_owned(), |slope| format!("{slope:.2}"));
    let text = match (point, slopes) {
        ([_, y], [slope]) => format!("{number}: y {y:.1}, dy/dx {}", shown(slope)),
        (_, [across, up]) => format!("{number}: dy/dx {} dz/dx {}", shown(across), shown(up)),
        _ => String::new(),
    };
    Phrase::new(text.clone(), text)
}
