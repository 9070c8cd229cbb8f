//! What PH_GORBE says, in Hungarian and English.

use super::plane::Options;
use crate::design::DesignError;
use crate::geometry::GeometryError;
use crate::geometry::ph::Place;
use crate::ui::{Desk, Hot, Phrase, Stay, Words};

pub(super) const TITLE: Words = Words("PH görbék", "PH curves");
pub(super) const SPLINE: Hot = Hot::new('1', " spline", " spline");
pub(super) const HERMITE: Hot = Hot::new('2', " Hermite", " Hermite");
pub(super) const CUBIC: Hot = Hot::new('3', " köbös", " cubic");
pub(super) const ASK_METHOD: Words = Words("        PH görbe ?", "         PH curve?");
pub(super) const NO_CUBIC: Words = Words(" Nincs PH köbös. Ötödfokú ?", "  No PH cubic. A quintic?");
pub(super) const DISTANCE: Words = Words("Távolság d =", "Distance d =");
pub(super) const BOTH: Hot = Hot::new('M', "-kettő", "-both");
pub(super) const TRIM: Hot = Hot::new('C', "-vágás", "-trim");
pub(super) const NONE: Hot = Hot::new('N', "incs", "one");
pub(super) const FIRST_A_CURVE: Words = Words("Előbb görbe kell: G", "First a curve: G");
pub(super) const TOO_FAR: Words = Words("Itt túl messze van", "Too far out to compute");
pub(super) const NO_OFFSET: Words = Words("Nincs párhuzamos: P", "No offset: P");
pub(super) const VANISHED: Words = Words("Semmi sem marad belőle", "Nothing of it is left");
pub(super) const SPEED_LEGEND: Words = Words(
    "sebesség az út fölött: fehér PH, szürke köbös spline",
    "speed over length: white PH, grey cubic spline",
);
pub(super) const HINT_CURVE: Words = Words("G: görbe      F1: segítség", "G: curve        F1: help");
pub(super) const HINT_EDIT: Words = Words("Húzza. Görgő: d  P S K J  F1", "Drag. Wheel: d  P S K J  F1");
pub(super) const HINT_COMB: Words = Words("+ -: fésű. Mutasson a görbére", "+ -: comb. Point at the curve");
pub(super) const HINT_SPEED: Words = Words("Mutasson a csíkra, a görbére", "Point at the strip or curve");
pub(super) const HINT_HELD: Words = Words("Engedje el a helyén. Esc: nem", "Release it there. Esc: no");
pub(super) const HINT_GRIP: Words = Words("A távolság az egérnél", "The distance at the mouse");

/// A number of the page: as many decimals as are worth reading, but no more than fit.
pub(super) fn number(value: f64, decimals: usize) -> String {
    if value.abs() < 1e6 { format!("{value:.decimals$}") } else { format!("{value:.3e}") }
}

/// The first line of the page.
pub(super) fn distance_and_length(options: &Options, length: f64) -> Phrase {
    let length = number(length, 3);
    let unit = if options.unit == 1.0 { String::new() } else { " px".to_owned() };
    let text = match options.distance {
        Some(d) if options.both => format!("d = ±{:.1}  L = {length}{unit}", d.abs()),
        Some(d) => format!("d = {d:.1}  L = {length}{unit}"),
        None => format!("L = {length}{unit}"),
    };
    Phrase::new(text.clone(), text)
}

/// The safe range of distances.
pub(super) fn limits(limits: [Option<f64>; 2]) -> Phrase {
    let [low, high] = limits.map(|limit| limit.map(|it| number(it, 2)));
    let text = match (low, high) {
        (Some(low), Some(high)) => format!("{low} < d < {high}"),
        (Some(low), None) => format!("{low} < d"),
        (None, Some(high)) => format!("d < {high}"),
        (None, None) => return Words("d: bármekkora", "d: any").into(),
    };
    Phrase::new(text.clone(), text)
}

/// Cusps and loops.
pub(super) fn counts((cusps, crossings): (usize, Option<usize>)) -> Phrase {
    let loops = crossings.map_or(String::from("?"), |it| it.to_string());
    Phrase::new(
        format!("{cusps} csúcs, {loops} hurok"),
        format!("{cusps} {}, {loops} {}", plural(cusps, "cusp"), plural(crossings.unwrap_or(2), "loop")),
    )
}

fn plural(count: usize, of: &str) -> String {
    if count == 1 { of.to_owned() } else { format!("{of}s") }
}

/// What is known at a place of the curve.
pub(super) fn at_place(place: Place, s: f64, speed: f64, curvature: Option<f64>) -> Phrase {
    let bend = curvature.map_or(String::from("-"), |it| format!("{it:.5}"));
    let facts = format!("u {:.3}  s {s:.2}  sigma {speed:.1}  kappa {bend}", place.u);
    Phrase::new(format!("{}. ív  {facts}", place.span + 1), format!("span {}  {facts}", place.span + 1))
}

/// Why there is no curve.
pub(super) fn refusal(error: &DesignError) -> Phrase {
    let DesignError::Geometry(geometry) = error else { return Phrase::plain(error) };
    match geometry {
        GeometryError::EqualNeighbours { number, next } => Phrase::new(
            format!("A {number}. és a {next}. pont egybeesik: húzza el az egyiket, vagy törölje (T)"),
            format!("Points {number} and {next} are equal: drag one away or delete it (T)"),
        ),
        GeometryError::NoPhCubic { number } => Phrase::new(
            format!("A {number}. ponttól S alakú az ív: nincs PH köbös. G 2: ötödfokú, az mindig van"),
            format!("An S from point {number}: no PH cubic. G 2 gives quintics, which take any"),
        ),
        GeometryError::NoDirection { number } => Phrase::new(
            format!("A {number}. érintő nulla: nincs iránya. Húzza ki a végét, vagy V"),
            format!("Tangent {number} is zero: it has no direction. Drag its tip out, or V"),
        ),
        GeometryError::TooFewPoints { given, needed } => Phrase::new(
            format!("{given} pont van, ehhez a görbéhez legalább {needed} kell"),
            format!("{given} points; this curve needs at least {needed}"),
        ),
        GeometryError::NotSolved { .. } => Words(
            "A spline egyenletei nem oldódtak meg: tegyen pontot az éles fordulóhoz",
            "The spline's equations were not solved: add a point at the sharp turn",
        )
        .into(),
        other => Phrase::plain(other),
    }
}

/// Says why there is no curve.
pub(super) fn tell_refusal(desk: &mut Desk<'_>, error: &DesignError) {
    desk.tell(refusal(error), Stay::UntilRead);
}

pub(super) const FEED: Words = Words("Előtolás px/s:", "Feed in px/s:");
pub(super) const TRAVEL_KEYS: Words = Words("Szóköz: áll, indul  + -  Esc", "Space: stop, go  + -  Esc");

/// What the page says while a tool travels: feed, way, and how even the steps are.
pub(super) fn travel(options: &Options, way: f64, [even, by_parameter]: [[f64; 2]; 2]) -> [Phrase; 3] {
    let feed = number(options.feed, 0);
    let first = match options.unit {
        1.0 => format!("V = {feed} px/s  s = {way:.1}"),
        unit => format!("F = {} mm/min  s = {way:.1}", number(60.0 * unit * options.feed, 0)),
    };
    let steps = |[low, high]: [f64; 2]| format!("{low:.3} ... {high:.3}");
    let (white, red) = (steps(even), steps(by_parameter));
    [
        Phrase::new(first.clone(), first),
        Phrase::new(format!("egyenlő s: {white}"), format!("equal s: {white}")),
        Phrase::new(format!("egyenlő u: {red}"), format!("equal u: {red}")),
    ]
}

pub(super) const ALL_KNOTS: Words = Words("Csomók: 1-3 választ   Esc", "Knots: 1-3 chooses   Esc");

/// The name of a rule for the knots.
pub(super) fn knots(knots: crate::geometry::ph::Knots) -> Phrase {
    use crate::geometry::ph::Knots;
    match knots {
        Knots::Chord => Words("1 húr", "1 chord"),
        Knots::Uniform => Words("2 egyen", "2 unif."),
        Knots::Centripetal => Words("3 gyök", "3 root"),
    }
    .into()
}

/// The title of the solutions of a span.
pub(super) fn all_of_span(span: usize, spans: usize) -> Phrase {
    Phrase::new(
        format!("{span}/{spans} ív   Bal Jobb: másik  Esc"),
        format!("Span {span}/{spans}  Left Right, Esc"),
    )
}

/// The name of a Hermite quintic, by its signs; or of a cubic.
pub(super) fn solution(at: usize, cubic: bool) -> Phrase {
    let names = if cubic { ["1", "2", "3", "4"] } else { ["+ +", "+ -", "- +", "- -"] };
    let name = names.get(at).copied().unwrap_or("?");
    Phrase::new(name, name)
}

/// Bending energy, rotation and length of a solution.
pub(super) fn facts(energy: Option<f64>, rotation: f64, length: f64) -> String {
    let energy = energy
        .map_or("inf".to_owned(), |it| if it < 10.0 { format!("{it:.4}") } else { format!("{it:.1e}") });
    format!("E {energy} R {rotation:.2} L {length:.0}")
}

/// The title of the formulas of a span.
pub(super) fn formulas_of(span: usize, spans: usize) -> Phrase {
    Phrase::new(
        format!("{span}/{spans}. ív: w = m + i n,  r' = h w²,  |r'| = h |w|²"),
        format!("Span {span}/{spans}: w = m + i n,  r' = h w²,  |r'| = h |w|²"),
    )
}

pub(super) const FORMULA_KEYS: Words = Words(
    "Bal Jobb: másik ív   B: hatvány- vagy Bernstein-alak   Esc: vissza",
    "Left Right: another span   B: power or Bernstein form   Esc: back",
);
pub(super) const W_PICTURE: Words = Words("w(t) = m + i n", "w(t) = m + i n");
pub(super) const HODOGRAPH: Words = Words("hodográf x', y'", "hodograph x', y'");

pub(super) const UNIT: Words = Words("1 képpont, mm:", "1 pixel in mm:");
pub(super) const ASK_NC: Words = Words("  NC-program mentése ?", "   Save an NC program?");

/// An NC program has been saved.
pub(super) fn nc_saved(name: &str, lines: usize) -> Phrase {
    Phrase::new(
        format!("NC-program: {name}, {lines} sor, húrhiba legfeljebb 0.01 mm"),
        format!("NC program: {name}, {lines} lines, chord error at most 0.01 mm"),
    )
}

pub(super) const NO_FILE: Words =
    Words("A PH_GORBE pontokat nyit meg: IP2, IC2, IP3", "PH_GORBE opens points: IP2, IC2, IP3");

pub(super) const SPACE_TITLE: Words = Words("PH térgörbék", "PH space curves");
pub(super) const HINT_SPACE: Words = Words("Forgassa. P cső  K keret  F1", "Turn it. P pipe  K frame  F1");
pub(super) const RADIUS: Words = Words("Cső sugara:", "Pipe radius:");
pub(super) const NO_FRAME: Words = Words("Keret: nincs (K)", "Frame: none (K)");
pub(super) const FRENET: Words = Words("Frenet-keret", "Frenet frame");
pub(super) const EULER: Words = Words("Euler-Rodrigues-keret", "Euler-Rodrigues frame");
pub(super) const MINIMAL: Words = Words("forgásmentes keret", "rotation-minimising frame");

/// The first lines of the page of space.
pub(super) fn length_and_energy(length: f64, energy: Option<f64>) -> Phrase {
    let energy = energy.map_or("inf".to_owned(), |it| format!("{it:.5}"));
    let text = format!("L = {}  E = {energy}", number(length, 3));
    Phrase::new(text.clone(), text)
}

/// The radius of the pipe, and how large it may be.
pub(super) fn pipe(radius: Option<f64>, most: Option<f64>) -> Phrase {
    let most = most.map_or(String::new(), |it| format!(" < {it:.2}"));
    match radius {
        Some(radius) => {
            Phrase::new(format!("cső: r = {radius:.1}{most}"), format!("pipe: r = {radius:.1}{most}"))
        }
        None => Phrase::new(format!("nincs cső (P), r{most}"), format!("no pipe (P), r{most}")),
    }
}
