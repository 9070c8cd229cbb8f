//! What BURKOLO says, in Hungarian and English.

use crate::geometry::skin::{MAX_BALLS, Violation};
use crate::ui::{Hot, Phrase, Words, hungarian};

pub(super) const NO_DOCUMENT: Words = Words(
    "Ebben a fájlban nincsenek körök, gömbök: .KOR, .GOM",
    "This file holds no circles or spheres: .KOR, .GOM",
);
pub(super) const NO_CIRCLES: Words = Words("Nincs még kör", "No circles yet");
pub(super) const NO_SPHERES: Words = Words("Nincs még gömb", "No spheres yet");
pub(super) const NO_SPHERE_HERE: Words = Words("Az egér alatt nincs gömb", "No sphere under the mouse");
pub(super) const NO_SPHERE_SKIN: Words =
    Words("Legalább két gömb kell a burkolóhoz", "A skin needs two spheres at least");
pub(super) const ASK_SPHERES: Words = Words("   Gömbök is látszanak ?", "     Show the spheres?");
pub(super) const ASK_SKIN: Words = Words("       A burkoló útja ?", "      Which way round?");
pub(super) const PLAIN_SHORT: Hot = Hot::new('P', "-sima", "-plain");
pub(super) const CLEARED_SHORT: Hot = Hot::new('T', "iszta", "-clear");
pub(super) const PLACE_ENTRY: Words = Words("Hely: x y z", "Place: x y z");
pub(super) const HINT_EMPTY_SPACE: Words = Words("B: új gömb. F1: segítség", "B: a sphere. F1: help");
pub(super) const HINT_SPACE: Words = Words("Húzza. Görgő: sugár. F6 F7", "Drag. Wheel: radius. F6 F7");
pub(super) const NOTHING_HERE: Words = Words("Az egér alatt nincs kör", "No circle under the mouse");
pub(super) const NO_SKIN: Words =
    Words("Legalább két kör kell a burkolóhoz", "A skin needs two circles at least");
pub(super) const RADIUS: Hot = Hot::new('R', "-sugár", "-radius");
pub(super) const RADIUS_ENTRY: Words = Words("Sugár:", "Radius:");
pub(super) const ASK_CIRCLES: Words = Words("   Körök is látszanak ?", "     Show the circles?");
pub(super) const OPEN: Hot = Hot::new('N', "yitott", "-open");
pub(super) const CAPS: Hot = Hot::new('S', "apkás", "-caps");
pub(super) const FILLED: Hot = Hot::new('K', "itölt.", "-fill");
pub(super) const PLAIN: Hot = Hot::new('P', "-sima út", "-plain");
pub(super) const CLEARED: Hot = Hot::new('T', "iszta út", "-cleared");
pub(super) const PICK: Words = Words("Kattintson két körre", "Click on two circles");
pub(super) const PICK_KEYS: Words = Words("Enter: sorszámok  Esc", "Enter: numbers  Esc");
pub(super) const WHICH_TWO: Words = Words("Két sorszám, pl. 2 3:", "Two numbers, as in 2 3:");
pub(super) const LINKED: Words = Words("Összekötve", "Linked");
pub(super) const UNLINKED: Words = Words("Szétválasztva", "No longer linked");
pub(super) const RING: Words = Words("Gyűrű", "A ring");
pub(super) const TREE: Words = Words("Fa", "A tree");
pub(super) const CHAIN: Words = Words("Lánc", "A chain");
pub(super) const RING_OF_THREE: Words =
    Words("Gyűrűhöz legalább három kör kell", "A ring needs three circles at least");
pub(super) const ADMISSIBLE: Words = Words("megengedett", "admissible");
pub(super) const NOT_ADMISSIBLE: Words = Words("nem megengedett", "not admissible");
pub(super) const IS_ADMISSIBLE: Words = Words("Már most is megengedett", "They are admissible already");
pub(super) const NEVER: Words = Words(
    "Közös középponttal semmilyen sugár nem megengedett",
    "With a common centre no radii are admissible",
);
pub(super) const HINT_EMPTY: Words = Words("Kattintson: kör. F1", "Click: a circle. F1");
pub(super) const HINT_HELD: Words = Words("Engedje el. Esc: mégsem", "Release it there. Esc: no");
pub(super) const HINT_EDIT: Words = Words("Húzza. Görgő: sugár.  G L M R", "Drag. Wheel: radius.  G L M R");

/// No room for more circles.
pub(super) fn full() -> Phrase {
    Phrase::new(format!("Legfeljebb {MAX_BALLS} kör lehet"), format!("No more than {MAX_BALLS} circles"))
}

/// There is no circle of a number.
pub(super) fn no_such(count: usize) -> Phrase {
    Phrase::new(format!("Nincs ilyen kör: 1...{count}"), format!("No such circle: 1...{count}"))
}

/// What was typed is no two numbers of circles.
pub(super) fn not_two(count: usize) -> Phrase {
    Phrase::new(
        format!("Két különböző sorszám kell, 1...{count}"),
        format!("Two different numbers are needed, 1...{count}"),
    )
}

/// The circles picked so far.
pub(super) fn picked(first: Option<usize>) -> Phrase {
    match first {
        Some(first) => {
            Phrase::new(format!("{}. kör és ...", first + 1), format!("Circle {} and ...", first + 1))
        }
        None => PICK.into(),
    }
}

/// Two circles are no neighbours.
pub(super) fn no_neighbours([a, b]: [usize; 2]) -> Phrase {
    Phrase::new(
        format!("A(z) {}. és {}. kör nem szomszéd (L köti össze)", a + 1, b + 1),
        format!("Circles {} and {} are no neighbours (L links them)", a + 1, b + 1),
    )
}

/// A circle has been deleted.
pub(super) fn deleted(number: usize) -> Phrase {
    Phrase::new(format!("{number}. kör törölve (Ctrl+Z)"), format!("Circle {number} deleted (Ctrl+Z)"))
}

/// Circles have shrunk until they were admissible.
pub(super) fn shrunk(count: usize) -> Phrase {
    Phrase::new(format!("{count} kör kisebb lett (Ctrl+Z)"), format!("{count} circles have shrunk (Ctrl+Z)"))
}

/// Circles of a file outside the field.
pub(super) fn outside(count: usize) -> Phrase {
    Phrase::new(
        format!("{count} kör közepe a mezőn kívül van; V helyezi át"),
        format!("{count} centres lie outside the field; V moves them"),
    )
}

/// What there is, in a line.
pub(super) fn facts(count: usize, arcs: usize, kind: Words) -> Phrase {
    Phrase::new(
        format!("{}: {count} kör, {arcs} ív", kind.0),
        format!("{}: {count} circles, {arcs} arcs", kind.1),
    )
}

/// Arcs that enter a disc.
pub(super) fn unclear([a, b]: [usize; 2], more: usize) -> Phrase {
    let rest = if more > 0 { format!(" (+{more})") } else { String::new() };
    let (a, b) = (a + 1, b + 1);
    Phrase::new(format!("{a}-{b} ív: körbe vág{rest}"), format!("arc {a}-{b}: not clear{rest}"))
}

/// A place of the outline that has no touching point.
pub(super) fn missing(circle: usize) -> Phrase {
    let number = circle + 1;
    Phrase::new(format!("A(z) {number}. körnél megszakad"), format!("It breaks off at circle {number}"))
}

/// The sentence about the first of the broken rules, and how many more there are.
fn broken(violations: &[Violation], noun: &str) -> Option<Phrase> {
    let violation = violations.first()?;
    let rest = if violations.len() > 1 { format!(" (+{})", violations.len() - 1) } else { String::new() };
    let said = violation.sentence(noun);
    let [hungarian, english] = [hungarian::told(&said), said].map(|mut said| {
        if let Some(first) = said.get_mut(..1) {
            first.make_ascii_uppercase();
        }
        said + &rest
    });
    Some(Phrase::new(hungarian, english))
}

/// The sentence about circles.
pub(super) fn rule(violations: &[Violation]) -> Option<Phrase> {
    broken(violations, "circle")
}

/// The sentence about spheres.
pub(super) fn sphere_rule(violations: &[Violation]) -> Option<Phrase> {
    broken(violations, "sphere")
}

/// A sphere has been deleted.
pub(super) fn sphere_deleted(number: usize) -> Phrase {
    Phrase::new(format!("{number}. gömb törölve (Ctrl+Z)"), format!("Sphere {number} deleted (Ctrl+Z)"))
}

/// Spheres have shrunk until they were admissible.
pub(super) fn spheres_shrunk(count: usize) -> Phrase {
    Phrase::new(format!("{count} gömb kisebb lett (Ctrl+Z)"), format!("{count} spheres have shrunk (Ctrl+Z)"))
}

/// What there is in space, in a line.
pub(super) fn space_facts(count: usize, tubes: usize, kind: Words) -> Phrase {
    Phrase::new(
        format!("{}: {count} gömb, {tubes} cső", kind.0),
        format!("{}: {count} spheres, {tubes} tubes", kind.1),
    )
}

/// A sphere that has no touching circle.
pub(super) fn missing_sphere(sphere: usize) -> Phrase {
    let number = sphere + 1;
    Phrase::new(format!("A(z) {number}. gömbnél megszakad"), format!("It breaks off at sphere {number}"))
}

/// What was typed is no place.
pub(super) fn not_a_place() -> Phrase {
    Phrase::new("Három szám kell, pl. 30 -20 5.5", "Three numbers are needed, as in 30 -20 5.5")
}
