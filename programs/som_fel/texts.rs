//! What SOM_FEL says, in Hungarian and English.

use crate::file;
use crate::geometry::cloud::CloudShape;
use crate::geometry::fit::Report;
use crate::geometry::kohonen::{End, Topology, Weighting};
use crate::ui::{KeyHelp, Phrase, Words, line};

pub(super) const NO_DOCUMENT: Words = Words(
    "Ebben a fájlban nincs háló és nincs pontfelhő: .SOM, .XYZ, .CSV, .PLY, .OBJ vagy .STL kell",
    "This file holds no net and no cloud of points: .SOM, .XYZ, .CSV, .PLY, .OBJ or .STL is needed",
);
pub(super) const WHICH_FILES: Words = Words(
    "Olvasható: háló (.SOM) és pontfelhő (.XYZ, .CSV, .PLY, .OBJ, .STL)",
    "What can be read are nets (.SOM) and clouds (.XYZ, .CSV, .PLY, .OBJ, .STL)",
);
pub(super) const FILE_NAME: Words = Words("Fájl neve kiterjesztéssel:", "File name with extension:");
pub(super) const NO_CLOUD: Words = Words(
    "Nincs pontfelhő: F fájlból olvas, K készít egyet",
    "There is no cloud: F reads one from a file, K makes one",
);
pub(super) const ONE_PLACE: Words = Words(
    "A felhő minden pontja egy helyen van: legalább két különböző pont kell",
    "All points of the cloud are in one place: two different ones are needed at least",
);
pub(super) const STRAIGHT: Words = Words(
    "A felhő pontjai egy egyenesen vannak: m x 1-es háló kell (H)",
    "The points of the cloud are on a straight line: take a net of m x 1 (H)",
);
pub(super) const NO_GROWTH: Words = Words(
    "Az m x 1-es háló nem nő: H más hálót ad, T ezt tanítja",
    "A net of m x 1 does not grow: H takes another net, T makes this one learn",
);
pub(super) const NO_NET: Words =
    Words("Nincs háló: T megtanítja, N növeli", "There is no net: T makes one learn, N makes one grow");
pub(super) const NO_SURFACE: Words = Words(
    "Nincs felület: S a hálóból készíti, I a pontokra illeszti",
    "There is no surface: S makes it of the net, I fits it to the points",
);
pub(super) const A_CURVE: Words = Words(
    "Az m x 1-es háló görbét ad: zebra és metszet csak felületen van",
    "A net of m x 1 gives a curve: zebra and sections are for surfaces",
);
pub(super) const NO_ERRORS: Words =
    Words("Hibák az illesztés után vannak: előbb I", "Errors are known after the fit: press I first");
pub(super) const NO_MIRROR: Words = Words(
    "Felhőt nem tükrözünk: a mért pontok maradnak, ahol vannak",
    "Clouds are not mirrored: measured points stay where they are",
);
pub(super) const COLLAPSED: Words = Words(
    "A háló egy vonalba vagy egy pontba esett: a felületnek nincs területe; H kisebb hálót vagy más összefűzést ad",
    "The net has collapsed to a line or a point and has no area; H takes a smaller net or another topology",
);
pub(super) const SAVED: Words = Words(
    "A hálót mentettem; a felületet F10 menti (STEP, CSF, STL, OBJ, PLY)",
    "The net is saved; F10 saves the surface (STEP, CSF, STL, OBJ, PLY)",
);
pub(super) const STOPPED: Words =
    Words("Megállt; amit eddig tanult, megmarad", "Stopped; what has been learnt is kept");
pub(super) const FIT_STOPPED: Words =
    Words("Az illesztés megállt; a felület megmarad", "The fit has stopped; its surface is kept");
pub(super) const READING_STOPPED: Words =
    Words("Az olvasás megállt; a felhő az előző maradt", "Reading has stopped; the cloud is the one before");
pub(super) const LIMIT: Words = Words("Legfeljebb hány neuron ?", "How many neurons at most?");
pub(super) const CORRECTIONS: Words = Words("Paraméterjavítások száma:", "Corrections of parameters:");
pub(super) const NO_WHOLE: Words = Words("Egész szám kell", "A whole number is needed");
pub(super) const HINT_EMPTY: Words = Words("F: fájl, K: felhő. F1: segítség", "F: file, K: cloud. F1: help");
pub(super) const HINT_CLOUD: Words = Words(
    "T: a háló tanul. K: felhő. H: háló. F1: segítség",
    "T: the net learns. K: cloud. H: net. F1: help",
);
pub(super) const GAIN: Words = Words("ráta", "gain");
pub(super) const RADIUS: Words = Words("sugár", "radius");
pub(super) const READING: Words = Words("olvasás", "reading");
pub(super) const FITTING: Words = Words("illesztés", "fitting");
pub(super) const LARGEST: Words = Words("max", "max");
pub(super) const MEAN: Words = Words("átlag", "mean");
pub(super) const POINTS: Words = Words("pont", "points");
pub(super) const STEP_WORD: Words = Words("lépés", "step");
pub(super) const STEP_PARTS: [Words; 4] = [
    Words("1: egy pont a felhőből", "1: a point of the cloud"),
    Words("2: a legközelebbi győz", "2: the nearest wins"),
    Words("3: szomszédai a hálón", "3: its neighbours"),
    Words("4: mind közelebb lép", "4: all move towards it"),
];
pub(super) const SHOWN: [Words; 3] =
    [Words("pontok és háló", "points and net"), Words("pontok", "points"), Words("háló", "net")];
pub(super) const CLOUD_PANEL: Words = Words("Pontfelhő", "Cloud of points");
pub(super) const NET_PANEL: Words = Words("A háló", "The net");
pub(super) const PANEL_KEYS: Words =
    Words("nyilak: sor és érték  Enter: szám  Esc: kész", "arrows: row and value  Enter: number  Esc: done");
pub(super) const ROW_SHAPE: Words = Words("alak", "shape");
pub(super) const ROW_POINTS: Words = Words("pontok száma", "number of points");
pub(super) const ROW_NOISE: Words = Words("zaj (szórás)", "noise (deviation)");
pub(super) const ROW_SEED: Words = Words("véletlen kezdete", "seed");
pub(super) const ROW_ROWS: Words = Words("sorok (m)", "rows (m)");
pub(super) const ROW_COLUMNS: Words = Words("oszlopok (n)", "columns (n)");
pub(super) const ROW_TOPOLOGY: Words = Words("összefűzés", "topology");
pub(super) const ROW_WEIGHTING: Words = Words("szomszédok", "neighbours");
pub(super) const ROW_START: Words = Words("kezdet", "start");
pub(super) const AT_RANDOM: Words = Words("véletlen", "at random");
pub(super) const SHAPED: Words = Words("alakos, sugár 1", "in shape, radius 1");
pub(super) const ROW_STEPS: Words = Words("lépések, 0: 100 m n", "steps, 0: 100 m n");

pub(super) const HELP_FILE: KeyHelp = line(
    "F",
    "fájl: háló .SOM, felhő .XYZ .CSV .PLY .OBJ .STL",
    "file: net .SOM, cloud .XYZ .CSV .PLY .OBJ .STL",
);
pub(super) const HELP_CLOUD: KeyHelp =
    line("K", "felhő készítése: alak, pontok, zaj", "make a cloud: shape, points, noise");
pub(super) const HELP_NET: KeyHelp =
    line("H", "háló: sorok, oszlopok, összefűzés, lépések", "net: rows, columns, topology, steps");
pub(super) const HELP_LEARN: KeyHelp =
    (Words("T szóköz", "T space"), Words("tanulás, szünet, folytatás", "learn, pause, go on"));
pub(super) const HELP_STEP: KeyHelp =
    line("L", "egy lépés lassan: pont, győztes, szomszédok", "one step slowly: point, winner, neighbours");
pub(super) const HELP_GROW: KeyHelp = line(
    "N",
    "növekvő háló: sorok és oszlopok, ahol sokat nyer",
    "growing net: more rows and columns where it wins",
);
pub(super) const HELP_SURFACE: KeyHelp =
    line("S", "felület (m x 1: görbe) a hálóból", "surface (m x 1: curve) of the net");
pub(super) const HELP_FIT: KeyHelp =
    line("I", "felület illesztése K javítással", "fit the surface with K corrections");
pub(super) const HELP_RESULT: KeyHelp =
    line("E", "csak a kép; D drótváz, T tele", "the picture alone; D wires, T filled");
pub(super) const HELP_SHOWN: KeyHelp = line("F3", "pontok, háló vagy mindkettő", "points, net or both");
pub(super) const HELP_ERRORS: KeyHelp =
    line("F4", "hibák színe és jelmagyarázat", "colours of the errors, legend");
pub(super) const HELP_DISPLAY: KeyHelp = line("D", "felület drótvázzal, tele", "surface in wires, filled");
pub(super) const HELP_LOOK: KeyHelp = (
    Words("jobb gomb", "right button"),
    Words("forgatás, nyilak is; görgő: nagyítás; Home", "turn, as arrows do; wheel: zoom; Home"),
);
pub(super) const HELP_SAVE: Words =
    Words("a háló mentése (.SOM); F10: felület is", "save the net (.SOM); F10: the surface too");
pub(super) const HELP_STOP: KeyHelp =
    line("Esc", "megállít; ami megvan, megmarad", "stop; what there is stays");

/// The name of a known surface.
pub(super) fn shape(shape: CloudShape) -> Words {
    match shape {
        CloudShape::Saddle => Words("nyereg", "saddle"),
        CloudShape::Hemisphere => Words("félgömb", "hemisphere"),
        CloudShape::Sphere => Words("gömb", "sphere"),
        CloudShape::Torus => Words("tórusz", "torus"),
        CloudShape::Terrain => Words("terep", "terrain"),
        CloudShape::Ring => Words("gyűrű", "ring"),
        CloudShape::Letter => Words("S a síkban", "S in the plane"),
    }
}

/// How the net is joined.
pub(super) fn topology(topology: Topology) -> Words {
    match topology {
        Topology::Open => Words("nyitott", "open"),
        Topology::Cylinder => Words("henger", "cylinder"),
        Topology::Torus => Words("tórusz", "torus"),
        Topology::Sphere => Words("gömb", "sphere"),
    }
}

/// Who learns with the winner.
pub(super) fn weighting(weighting: Weighting) -> Words {
    match weighting {
        Weighting::Gauss => Words("Gauss", "gauss"),
        Weighting::Bubble => Words("buborék", "bubble"),
    }
}

/// A whole number with a blank between thousands.
pub(super) fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push(' ');
        }
        text.push(digit);
    }
    text
}

/// A number in few letters: three digits that mean something.
pub(super) fn short(value: f64) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e5).contains(&size) {
        return format!("{value:.1e}");
    }
    let decimals = match size {
        size if size >= 1000.0 => 0,
        size if size >= 100.0 => 1,
        size if size >= 10.0 => 2,
        size if size >= 1.0 => 3,
        _ => 4,
    };
    format!("{value:.decimals$}")
}

/// What a file held.
pub(super) fn file_told(name: &str, cloud: &file::Cloud) -> Phrase {
    let points = grouped(cloud.points.len() as u64);
    let how = cloud.encoding.map(|encoding| format!(", {encoding}")).unwrap_or_default();
    let skipped = &cloud.skipped;
    let (bad, lines) = (skipped.not_finite.count, skipped.short.count);
    let mut phrase = (format!("{name}: {points} pont{how}"), format!("{name}: {points} points{how}"));
    if bad > 0 {
        phrase.0 += &format!("; kimaradt {bad} pont, mert nem véges szám");
    }
    if lines > 0 {
        phrase.0 += &format!("; kimaradt {lines} rövid sor");
    }
    for told in skipped.told() {
        phrase.1 += &format!("; left out: {told}");
    }
    Phrase::new(phrase.0, phrase.1)
}

/// Why learning is over.
pub(super) fn learnt(end: End, steps: u64) -> Phrase {
    let steps = grouped(steps);
    match end {
        End::Steps => Phrase::new(
            format!("Kész {steps} lépés után; S felület, I illesztés"),
            format!("Done after {steps} steps; S surface, I fit"),
        ),
        End::Settled => Phrase::new(
            format!("A háló {steps} lépés után alig mozog: kész; S felület, I illesztés"),
            format!("The net hardly moves after {steps} steps: done; S surface, I fit"),
        ),
    }
}

/// What came of a fit.
pub(super) fn fitted(report: &Report) -> Phrase {
    let [rms, largest, mean, most] =
        [report.rms, report.largest, report.mean, report.percentile_95].map(short);
    let solutions = report.history.len();
    Phrase::new(
        format!("{solutions} megoldás: RMS {rms}, legnagyobb {largest}, átlag {mean}, 95 %: {most}"),
        format!("{solutions} solutions: RMS {rms}, largest {largest}, mean {mean}, 95 %: {most}"),
    )
}

/// A number is to be in a range.
pub(super) fn between(low: u64, high: u64) -> Phrase {
    Phrase::new(format!("{low} és {high} között kell"), format!("{low} to {high}, please"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short() {
        assert_eq!([0, 12, 1234, 1_234_567].map(grouped), ["0", "12", "1 234", "1 234 567"]);
        assert_eq!(
            [0.0, 0.03124, 2.34567, 45.6789, 123.45, 1e7, -1e-9].map(short),
            ["0.0000", "0.0312", "2.346", "45.68", "123.5", "1.0e7", "-1.0e-9"]
        );
    }

    #[test]
    fn what_stands_on_the_message_page_fits() {
        for Words(hungarian, english) in STEP_PARTS {
            assert!(hungarian.chars().count() <= 28 && english.chars().count() <= 28, "{hungarian}");
        }
    }
}
