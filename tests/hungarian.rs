//! What the library and the command line say in English has its Hungarian: every sentence in their sources, and what
//! the command line answers in both languages.

#[path = "hungarian/literals.rs"]
mod literals;

use grafika::ui::hungarian;
use std::path::{Path, PathBuf};

/// Where sentences come from that reach the user through the list.
const ROOMS: [&str; 13] = [
    "src/geometry",
    "src/algebra",
    "src/puzzle",
    "src/table",
    "src/pascal",
    "src/file",
    "src/design",
    "src/figure",
    "src/machine",
    "src/disk",
    "src/launch",
    "src/display",
    "programs/bin",
];
const FILES: [&str; 3] =
    ["programs/telepit/job.rs", "programs/telepit/plan.rs", "programs/telepit/journal.rs"];
/// Sources whose texts are files, not sentences, or are in both languages already.
const OTHERS: [&str; 13] = [
    "src/figure/svg.rs",
    "src/figure/screen_shapes.rs",
    "src/figure/mesh.rs",
    "src/figure/step.rs",
    "src/file/cloud/write.rs",
    "src/file/format.rs",
    "src/machine/record.rs",
    "src/display/terminal/input.rs",
    "src/display/terminal/mod.rs",
    "src/launch/language.rs",
    "src/machine/pointing.rs",
    "programs/bin/grafika/page.rs",
    "programs/bin/grafika/reference.rs",
];
/// Parts of sentences that stand in the list as a whole, and what nobody is told.
const PARTS: &[&str] = &[
    " (os error",
    "; did you mean 7?",
    "did you mean",
    "no data file has this extension7; there are 7 .json .csv, and for reading .7",
    "7: no data file has this extension7; there are 7 .json .csv, and for reading .7",
    "no data file has this extension7; there are 7",
    "if [[ ${funcstack[1]} == _7 ]]; then _clap_dynamic_completer_7 \"$@\"; fi",
    "built-in sample",
    "is not a finite number",
    "divides by zero",
    "has a root of what is negative",
    "7 of root 7",
    "7 7 is covered by the others",
    "7s 7 and 7 meet",
    "7s 7 and 7 meet outside 7 7",
    "7s 7, 7 and 7 leave no hole in the ring",
    "game of billiards, 7 7 balls",
    "7 7s; there may be 7 at most",
    "there is no 7 7; 7 count 7s from 0 to 7",
    "7 7: centre 7, radius 7",
    "joined by 7",
    "in a ring",
    "in a chain",
    "is empty",
    "holds a bead",
    "ring 7 7; with the drawer at 7 rings 1 to 7 hold beads",
    "not solved",
    "position of the bead wheel, 7",
    "curve7, {7} on 77",
    "patch7, {7} on 7 by {7} on 77",
    "7polynomial, ascending 7",
    "7interval 7, length 7",
    "7critical length for design l' = 7",
    "7critical length l = 7",
    " at line ",
    "7 is none of 7",
    "rational curve of the plane: 7 span7",
    "7 of span 7",
    "crossing: 7 and 7",
    "kept: 7 to 7",
    "the file has 7 7; 7 has 7",
    "7 x 7 points",
    "B-spline curve",
    "of the plane",
    "in space",
    "B-spline surface",
    "7: 7 x 7 control points, orders 7 and 7",
    // What serde and clap say, which is told in other words.
    "invalid type",
    "invalid type: ",
    "invalid value: ",
    "invalid length ",
    "an array of length ",
    "a tuple of size ",
    "floating point `",
    "missing field ",
    "duplicate field ",
    "unknown field ",
    "unknown variant ",
    "control character",
    " is not in ",
    "one of ",
    "7 7 has a number that is not finite",
    "7 7 has the radius 7; it must be larger than 0",
    "7 7 names number 7, but there are 7, numbered from 0",
    "7 7, the first in 7",
    "points with NaN, infinite or huge coordinates",
    "lines with too few coordinates",
    "; left out: 7",
    "the plane",
    "begins no line of STL",
    "record 0, yp",
    "one for every point",
    "the finished cube",
    "not finished",
    "position of the Csángó cube, 7",
    "7 7; this piece has 7",
    "a setting is a value",
    "press left|right|middle|shift|ctrl",
    "release left|right|middle|shift|ctrl",
    "click X Y [left|right|middle]",
    "drag X1 Y1 X2 Y2 [left|right|middle]",
    "shot FILE.png",
    "dump FILE.json",
    "pointer on|off",
    "lang hu|en",
    "manner today|1997",
    "pointing mouse|keys",
    "For more information",
    "7: 7 x 7 neurons after 7 steps7",
    "absolute rotation",
    "curvature extremum",
    "radius 7 at 7 of span 7",
    "at 7 of span 7",
    "outer of span 7",
    "pair:7 of knot 7",
    "7, r1 7, r2 7",
    "standard input: 7",
    "proven shortest",
    "not proven shortest; at least 7 are needed",
    "7 77, 7 of the pieces in their places",
];

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let for_tests = ["tests", "tests.rs", "testing.rs", "examples.rs"].contains(&name.as_str());
        match path.is_dir() {
            _ if for_tests => {}
            true => sources(&path, found),
            false if name.ends_with(".rs") => found.push(path),
            false => {}
        }
    }
}

#[test]
fn every_sentence_of_the_library_and_the_command_line_has_its_hungarian() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut paths = Vec::new();
    ROOMS.iter().for_each(|room| sources(&root.join(room), &mut paths));
    paths.extend(FILES.map(|file| root.join(file)));
    paths.retain(|path| OTHERS.iter().all(|other| *path != root.join(other)));
    let mut missing = Vec::new();
    let mut count = 0;
    for path in paths {
        for sentence in literals::sentences(&std::fs::read_to_string(&path).unwrap()) {
            count += 1;
            let lines = sentence.lines().filter(|line| line.contains(' '));
            if sentence.starts_with("Examples:") || PARTS.contains(&sentence.trim_end_matches('\n')) {
                continue;
            }
            for line in lines.filter(|line| !hungarian::knows(line)) {
                missing.push(format!("{}: {line}", path.strip_prefix(root).unwrap().display()));
            }
        }
    }
    assert!(count > 700, "only {count} sentences were found");
    assert!(missing.is_empty(), "no Hungarian for {}:\n{}", missing.len(), missing.join("\n"));
}

#[cfg(feature = "native")]
mod command_line {
    use super::hungarian;
    use std::process::{Command, Output};
    use tempfile::TempDir;

    /// Runs `grafika` in a folder of its own, whose user has these settings and this locale.
    fn run(settings: &str, locale: &str, line: &str) -> Output {
        run_words(settings, locale, &line.split(' ').collect::<Vec<_>>())
    }

    fn run_words(settings: &str, locale: &str, words: &[&str]) -> Output {
        let folder = TempDir::new().unwrap();
        let config = folder.path().join("config/grafika");
        std::fs::create_dir_all(&config).unwrap();
        std::fs::write(config.join("config.toml"), settings).unwrap();
        Command::new(env!("CARGO_BIN_EXE_grafika"))
            .current_dir(folder.path())
            .env("XDG_CONFIG_HOME", folder.path().join("config"))
            .env("LC_ALL", locale)
            .args(words)
            .output()
            .unwrap()
    }

    fn written(line: &str) -> String {
        String::from_utf8(run("", "C", line).stdout).unwrap()
    }

    fn said(output: &Output) -> String {
        String::from_utf8(output.stderr.clone()).unwrap()
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn the_option_then_the_setting_then_the_locale_decides() {
        let english = "there is no such file";
        let hungarian = "nincs ilyen fájl";
        for (settings, locale, line, right) in [
            ("", "C", "info NINCS.IP2", english),
            ("", "", "info NINCS.IP2", english),
            ("", "hu_HU.UTF-8", "info NINCS.IP2", hungarian),
            ("language = \"en\"", "hu_HU.UTF-8", "info NINCS.IP2", english),
            ("language = \"hu\"", "C", "info NINCS.IP2", hungarian),
            ("language = \"hu\"", "C", "--lang en info NINCS.IP2", english),
            ("language = \"hu\"", "C", "info NINCS.IP2 --lang=en", english),
            ("", "C", "--lang=hu info NINCS.IP2", hungarian),
            ("", "C", "info --lang hu NINCS.IP2", hungarian),
            ("", "C", "--lang hu gb_2d_ip NINCS.IP2", hungarian),
            ("", "C", "gb_2d_ip NINCS.IP2 --lang hu", hungarian),
            // What goes wrong with a script is told as everything else.
            ("", "C", "gb_2d_ip NINCS.IP2 --script -", english),
            ("", "hu_HU.UTF-8", "gb_2d_ip NINCS.IP2 --script -", hungarian),
        ] {
            let said = said(&run(settings, locale, line));
            assert!(said.contains(right), "{settings} {locale} {line}: {said}");
            assert_eq!(said.lines().count(), 1, "{said}");
        }
    }

    /// Words that no Hungarian line has.
    const ENGLISH: [&str; 13] =
        ["the", "are", "must", "not", "there", "with", "of", "for", "this", "and", "that", "has", "needed"];

    #[track_caller]
    fn assert_hungarian(text: &str, what: &str) {
        for line in text.lines().filter(|line| !line.starts_with("  grafika")) {
            let words = line.split(|sign: char| !sign.is_alphanumeric() && sign != '.' && sign != '_');
            let english: Vec<&str> = words.filter(|word| ENGLISH.contains(word)).collect();
            assert!(english.is_empty(), "{what}: {line}");
        }
    }

    #[test]
    fn what_is_wrong_is_told_in_hungarian() {
        for line in [
            "info NINCS.IP2",
            "info X.DOC",
            "info .",
            "info 1,2",
            "info 0,,2",
            "info 0,1/0",
            "info",
            "render A.IP2 -o a.png",
            "render A.IP2",
            "render A.IP2 --method spline -o a.stl",
            "render A.IP2 --method spline --scale 3 -o a.svg",
            "render A.IP2 --method splin -o a.svg",
            "render A.ZMS --closed -o a.svg",
            "render A.GBP --method spline -o a.svg",
            "render A.IP2 --method hermite -o a.svg",
            "render A.IP2 --method spline -o a.png --width 7",
            "render A.IP2 --method spline -o /nowhere/a.png",
            "sample A.ZMS --method pn --derivatives 1",
            "sample A.IP2 --method spline --per-span 0",
            "sample A.IP2 --method spline --per-span x",
            "sample A.IP2 --method spline --k0",
            "sample A.IP2 --method spline --closed --closed",
            "sample A.CSM --at 99",
            "convert A.IP2 a.zms",
            "convert A.IP2",
            "convert A.IP2 - --to png",
            "convert A.IP2 nowhere/a.json",
            "convert - a.ip2",
            "convert A.ZMS a.stl",
            "knots",
            "knots path A.CSM --knot 99 --span 6 --at 6.5 --values 5",
            "knots limits A.ZMS --knot 1",
            "knots through B.CSM --point 1,2 --by one --knot 5",
            "knots through B.CSM --point 280,219 --by twist",
            "shape path FELKOR.ALP --at 0.5 --parameter alpha --values 9",
            "shape path FELKOR.ALP --at 9 --parameter alpha --values 1",
            "shape elevate HAN.ALP --by 2 -o b.alp",
            "shape elevate HAN.ALP --by -2 -o b.alp",
            "shape through HAN.ALP --parameter alpha --point 1,2",
            "shape through HAN.ALP --parameter lambda:99 --point 1,2",
            "shape interpolate A.IP2 --family han --value -5",
            "split HELIX.KCG",
            "skin A.IP2 -o a.svg",
            "skin VILLA.KOR -o a.stl",
            "measure A.IP2 --method spline",
            "measure A.ZMS",
            "offset A.IP2 --method phspline --distance 10 -o a.stl",
            "poly x+",
            "poly 1/0",
            "poly x^99999999999999999999",
            "smooth A.ZMS -o a.csv",
            "solve XYZ",
            "solve ABC9",
            "solve 0-1",
            "solve A.IP2",
            "fit A.ZMS -o a.som",
            "fit TEREP.XYZ -o a.doc",
            "fit TEREP.XYZ -o a.csf --corrections -1",
            "basis T3 --interval 0,9",
            "basis T3 --interval 2,1",
            "elevate A.IP2 --root 0 -o a.kcg",
            "config palette pink",
            "config colour",
            "config scale 99",
            "completions bash nobody",
            "install --groups nothing",
            "install",
            "open NINCS.IP2",
            "nobody",
            "gb_2d_ip --display none",
            "gb_2d_ip --scale 99",
            "gb_2d_ip A.ZMS",
            "gb_2d_ip A.IP2 more",
            "gb_2d_ip --script nowhere.txt",
        ] {
            let words: Vec<&str> = line.split(' ').chain(["--lang", "hu"]).collect();
            let output = run_words("", "C", &words);
            let said = said(&output);
            assert!(matches!(output.status.code(), Some(1 | 2)), "{line}: {said}");
            assert_eq!(said.lines().count(), 1, "{line}: {said}");
            assert_hungarian(&said, line);
        }
    }

    #[test]
    fn what_a_sample_holds_is_told_in_hungarian() {
        for (sample, _) in grafika::machine::SAMPLES {
            let english = written(&format!("info {sample}"));
            let told = written(&format!("info {sample} --lang hu"));
            assert_eq!(english.lines().count(), told.lines().count(), "{sample}");
            assert_hungarian(&told, sample);
            for (english, told) in english.lines().zip(told.lines()) {
                // Ranges of coordinates, values by their letters, names of formats.
                let mut words = english.split(|sign: char| !sign.is_alphabetic());
                let named = words.any(|word| word.len() > 2 && word.chars().all(char::is_lowercase));
                let value = ["alpha", "lambda", "omega", "beta", "x =", "y =", "z ="]
                    .iter()
                    .any(|name| english.starts_with(name));
                assert!(!named || value || english != told, "{sample}: {english}");
            }
        }
    }

    #[test]
    fn answers_are_told_in_hungarian() {
        assert!(written("--lang hu list").contains("gb_2d_ip   Síkgörbék: Coons, Bézier, spline, B-spline"));
        assert!(written("solve MCEM --lang hu").contains("lépés, bizonyítottan a legrövidebb"));
        assert!(written("--lang=hu smooth Y.IP2 -o y.csv").starts_with("Y.IP2: RMS maradék "));
        let measured = written("measure A.IP2 --method phspline --closed --lang hu");
        assert!(measured.starts_with("hossz             "), "{measured}");
        assert_hungarian(&measured, "measure");
        assert_hungarian(&written("measure N.PN --lang hu"), "measure");
        let installed = written("install --groups gb_2d --lang hu kurzus");
        assert!(installed.contains(": kész\n"), "{installed}");
    }

    #[test]
    fn help_is_in_hungarian_from_the_first_line_to_the_last() {
        for line in ["--help", "render --help", "knots path -h", "help fit", "gb_2d_ip --help", "install -h"]
        {
            let page = written(&format!("--lang hu {line}"));
            assert!(page.contains("\nHasználat: ") && page.contains("\nPéldák:\n"), "{line}: {page}");
            assert_hungarian(&page, line);
            let english = written(line);
            assert!(english.contains("\nUsage: ") && english.contains("\nOptions:\n"), "{line}: {english}");
            assert_eq!(hungarian::help("Options:").as_deref(), Some("Kapcsolók:"));
        }
        let version = written("--lang hu --version");
        assert_eq!(version, written("--version"));
    }
}
