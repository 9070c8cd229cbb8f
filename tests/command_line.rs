//! The command line as people and scripts use it: answers as JSON, files that are there already, options that cannot
//! apply, names that are nearly right, and what is said when something is missing.
#![cfg(feature = "native")]

mod common;

use common::folder::Folder;
use serde_json::Value;
use std::fs;

#[test]
fn answers_are_json_too() {
    let folder = Folder::new();
    let list = folder.json("list --json");
    let programs = list.as_array().unwrap();
    assert_eq!(programs.len(), folder.done("list").lines().count());
    let curves = programs.iter().find(|program| program["name"] == "gb_2d_ip").unwrap();
    assert!(curves["opens"].as_array().unwrap().contains(&Value::from("IP2")), "{curves}");

    let info = folder.json("info A.IP2 A.ZMS --json");
    let facts = |index: usize| -> Vec<String> {
        let facts = info[index]["facts"].as_array().unwrap();
        facts.iter().map(|fact| fact.as_str().unwrap().to_owned()).collect()
    };
    assert_eq!([&info[0]["file"], &info[1]["format"]], ["A.IP2", "ZMS"]);
    // The same facts as in the text, under the name of each file.
    let text = folder.done("info A.IP2 A.ZMS");
    let expected = format!("A.IP2:\n{}\n\nA.ZMS:\n{}\n", facts(0).join("\n"), facts(1).join("\n"));
    assert_eq!(text, expected);
    assert_eq!(folder.done("info A.IP2"), format!("{}\n", facts(0).join("\n")));

    let told = folder.done("solve MCEM");
    let solved = folder.json("solve MCEM --json");
    assert_eq!(told.lines().next(), solved["moves"].as_str());
    assert_eq!([&solved["count"], &solved["proven"]], [&Value::from(4), &Value::from(true)]);
    let cube = folder.json("solve A.CSK --json");
    assert_eq!(cube["moves"].as_array().unwrap().len(), cube["count"].as_u64().unwrap() as usize);

    let smoothed = folder.json("smooth Y.IP2 -o y.csv --json");
    assert!(smoothed["rms"].as_f64() < smoothed["largest"].as_f64(), "{smoothed}");
    assert!(folder.refused(2, "smooth Y.IP2 -o - --json").contains("standard output"));

    let settings = folder.json("config --json");
    assert!(settings["palette"]["values"].as_array().unwrap().contains(&Value::from("amber")));
    assert_eq!(folder.json("config palette --json").as_object().unwrap().len(), 1);
}

#[test]
fn of_many_files_those_that_are_wrong_are_told_apart() {
    let folder = Folder::new();
    let output = folder.run("info A.IP2 none.ip2 B.IP2 none.zms");
    assert_eq!(output.status.code(), Some(1));
    let [told, said] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(told.contains("A.IP2:\n") && told.contains("B.IP2:\n"), "{told}");
    assert!(said.lines().count() == 2 && said.contains("none.ip2") && said.contains("none.zms"), "{said}");
}

#[test]
fn results_are_not_written_over_the_data() {
    let folder = Folder::new();
    for (sample, data, line) in [
        ("KIGYO.KOR", "mine.json", "skin mine.json -o mine.json --force"),
        ("A.IP2", "mine.json", "sample mine.json -o ./mine.json --force"),
        ("A.IP2", "mine.json", "measure mine.json --method phspline -o mine.json --force"),
        ("A.IP2", "mine.json", "offset mine.json --method phspline --distance 1 -o mine.json --force"),
        ("A.IP2", "mine.ip2", "render mine.ip2 -o mine.ip2 --to svg --force"),
        ("TEREP.XYZ", "mine.xyz", "fit mine.xyz -o a.csf --residuals mine.xyz --force"),
        ("Y.IP2", "mine.ip2", "smooth mine.ip2 -o mine.ip2 --force"),
    ] {
        folder.done(&format!("convert {sample} {data} --force"));
        let before = fs::read(folder.path(data)).unwrap();
        let said = folder.refused(2, line);
        assert!(said.contains("is the file that is read"), "{line}: {said}");
        assert_eq!(fs::read(folder.path(data)).unwrap(), before, "{line}");
    }
}

/// Every command that writes files, with the file it writes as `OUT`.
const WRITING: [&str; 17] = [
    "convert A.IP2 OUT --to json",
    "render A.IP2 --method spline -o OUT --to svg",
    "sample A.IP2 --method spline -o OUT --to csv",
    "smooth Y.IP2 -o OUT --to csv",
    "measure A.IP2 --method phspline -o OUT --to txt",
    "offset A.IP2 --method phspline --distance 2 -o OUT --to json",
    "offset A.IP2 --method phspline --distance 2 --nc OUT",
    "poly x+1 -o OUT --to txt",
    "basis T1 --interval 0,1 -o OUT --to csv",
    "elevate HELIX.KCG --root 0 -o OUT --to json",
    "split HELIX.KCG --parts 2 -o OUT --to json",
    "exact SNAIL.KCE --parts-u 4 --parts-v 3 -o OUT --to json",
    "fit NYOM.XYZ --steps 200 --grid 30x1 -o OUT",
    "knots insert A.CSM --at 6.5 -o OUT",
    "shape elevate KOR.ALP --by 1 -o OUT",
    "shape interpolate A.IP2 --family han --value 0.5 -o OUT",
    "skin KIGYO.KOR -o OUT --to svg",
];

#[test]
fn files_that_are_there_stay_if_that_is_asked_for() {
    let folder = Folder::new();
    for (index, line) in WRITING.into_iter().enumerate() {
        // What fits depends on the extension.
        let name = format!("out{index}.{}", if line.starts_with("fit") { "csm" } else { "json" });
        let line = line.replace("OUT", &name);
        folder.write(&name, "mine");
        let said = folder.refused(1, &format!("{line} --no-clobber"));
        let _ = said
            .find(&format!("{name} is there already and stays as it is"))
            .unwrap_or_else(|| panic!("{said}"));
        assert_eq!(folder.read(&name), "mine", "{line}");
        // Without a terminal nobody is asked.
        folder.done(&line);
        let written = folder.bytes(&name);
        assert_ne!(written, b"mine", "{line}");
        folder.write(&name, "mine");
        folder.done(&format!("{line} --force"));
        assert_eq!(folder.bytes(&name), written, "{line}");
        fs::remove_file(folder.path(&name)).unwrap();
        folder.done(&format!("{line} --no-clobber"));
        assert_eq!(folder.bytes(&name), written, "{line}");
    }
    assert!(folder.refused(2, "poly x+1 --force").contains("--force is for files"));
    assert!(folder.refused(2, "convert A.IP2 - --to json -n").contains("--no-clobber is for files"));
    assert!(folder.refused(2, "poly x+1 -o a.txt --force --no-clobber").contains("--no-clobber"));
}

/// Both files of a conversion, and both of a fit.
#[test]
fn second_files_stay_too() {
    let folder = Folder::new();
    folder.write("b.ec2", "mine");
    assert!(folder.refused(1, "convert A.IC2 b.ic2 -n").contains("b.ec2 is there already"));
    assert_eq!(folder.read("b.ec2"), "mine");
    folder.write("errors.csv", "mine");
    let line = "fit TEREP.XYZ --steps 100 --grid 6x6 -o hill.csf --residuals errors.csv -n";
    assert!(folder.refused(1, line).contains("errors.csv is there already"));
    assert!(!folder.path("hill.csf").exists(), "it is said before the work");
}

#[test]
fn options_that_cannot_apply_are_refused() {
    let folder = Folder::new();
    folder.write("rational.rbc", &folder.done("offset A.IP2 --method phspline --distance 2"));
    for (line, option) in [
        ("render A.ZMS -o a.step --width 100", "--width"),
        ("render A.ZMS -o a.stl --width 100", "--width"),
        ("render A.ZMS -o a.step --per-span 4", "--per-span"),
        ("render A.ZMS -o a.obj --title Ball", "--title"),
        ("render A.ZMS -o a.ply --tolerance 0.1", "--tolerance"),
        ("render A.ZMS -o a.svg --tolerance 0.1", "--tolerance"),
        ("render A.ZMS -o a.step --tolerance 0.1", "--tolerance"),
        ("render A.ZMS -o a.svg --bias 2", "--bias"),
        ("render A.ZMS -o a.svg --k0-u 2", "--k0-u"),
        ("render A.CSM -o a.step --per-span 3", "--per-span"),
        ("render A.CSM -o a.svg --per-span 3", "--per-span"),
        ("render A.CSF -o a.svg --tolerance 0.1", "--tolerance"),
        ("render HELIX.KCG -o a.svg --per-span 3", "--per-span"),
        ("render rational.rbc -o a.svg --points", "--points"),
        ("render rational.rbc -o a.svg --bias 1", "--bias"),
        ("render A.GBP -o a.svg --closed", "--closed"),
        ("render A.GBP -o a.svg --k0 1", "--k0"),
        ("sample A.IP2 --method spline --k0 1", "--k0"),
        ("sample A.IP2 --method coons --tension 1", "--tension"),
        ("sample A.IC2 --k0 1", "--k0"),
        ("sample A.IP2 --method spline --items curves", "--items"),
        ("sample HELIX.KCG --items surfaces", "--items"),
        ("offset A.IP2 --method phspline --distance 2 --per-span 3 -o a.json", "--per-span"),
        ("offset A.IP2 --method phspline --distance 2 --tolerance 0.1 -o a.step", "--tolerance"),
        ("offset N.PN --distance 0.1 --tolerance 0.1 -o a.csv", "--tolerance"),
        ("offset N.PN --distance 0.1 --per-span 3 -o a.step", "--per-span"),
        ("offset N.PN --distance 0.1 --trim -o a.step", "--trim"),
        ("smooth Y.IP2 -o y.csv --stage bspline --density 3", "--density"),
        ("solve MCEM --threads 2", "--count"),
        ("solve MCEM --rigid", "--rigid"),
        ("solve --count --rigid", "--rigid"),
        ("knots through B.CSM --point 280,219 --by any --knot 5", "--knot"),
        ("knots through B.CSM --point 280,219 --by one --knot 5 --value 3", "--value"),
        ("knots through B.CSM --point 280,219 --by outer --span 4 --at 5 --weights 1,2", "--weights"),
        ("skin KIGYO.KOR --caps -o a.json", "--caps"),
        ("skin KIGYO.KOR --check --force", "--force"),
        ("info A.IP2 --columns 1,2", "columns"),
        ("gb_2d_ip --columns 1,2", "--columns"),
        ("gb_2d_ip --script a.txt --scale 2", "--scale"),
        ("gb_2d_ip --script a.txt --display window", "--display"),
        ("gb_2d_ip --display terminal --scale 2", "--scale"),
        ("install there --groups all --scale 2", "--scale"),
        ("install there --script a.txt", "DIR"),
        ("config palette amber --json", "--json"),
    ] {
        let said = folder.refused(2, line);
        assert!(said.contains(option), "{line}: {said}");
    }
    let names: Vec<_> = fs::read_dir(folder.path("")).unwrap().flatten().map(|it| it.file_name()).collect();
    assert_eq!(names, ["rational.rbc"], "nothing is written");
}

#[test]
fn what_was_meant_is_told() {
    let folder = Folder::new();
    for (status, line, meant) in [
        (2, "rneder A.IP2", "\"render\""),
        (2, "bilard", "\"biliard\""),
        (2, "help rendr", "\"render\""),
        (2, "help gb2d_ip", "\"gb_2d_ip\""),
        (2, "knots pth A.CSM", "\"path\""),
        (1, "info A.IPP", "\".IP2\""),
        (1, "info TERP.XYZ", "\"TEREP.XYZ\""),
        (1, "convert A.IP2 a.jsn", "\".json\""),
        (2, "convert A.IP2 a --to jsn", "\"json\""),
        (2, "info a --from xzy", "\"xyz\""),
        (2, "render A.IP2 --method splin -o a.svg", "\"spline\""),
        (2, "render A.IP2 --method spline -o a.svgg", "\"svg\""),
        (2, "sample A.IP2 --metod spline", "\"--method\""),
        (2, "config palete", "\"palette\""),
        (2, "config palette ambre", "\"amber\""),
        (2, "completions bsh", "\"bash\""),
        (2, "completions bash gb2d_ip", "\"gb_2d_ip\""),
        (2, "install there --groups gb2d", "\"gb_2d\""),
        (2, "knots through B.CSM --point 280,219 --by paire:outer", "\"pair:outer\""),
        (2, "shape path KOR.ALP --parameter alpa --at 1 --values 1", "\"alpha\""),
    ] {
        let said = folder.refused(status, line);
        assert!(said.contains(&format!("did you mean {meant}")), "{line}: {said}");
    }
    assert!(!folder.refused(2, "xylophone").contains("did you mean"));
}

#[test]
fn folders_and_missing_files_are_told_in_words() {
    let folder = Folder::new();
    fs::create_dir(folder.path("there")).unwrap();
    fs::create_dir(folder.path("there.svg")).unwrap();
    folder.write("file", "a file");
    for (status, line, words) in [
        (1, "info there", "this is a folder, not a file"),
        (1, "solve there.svg", "this is a folder, not a file"),
        (1, "render A.IP2 --method spline -o there", "this is a folder, not a file"),
        (1, "render A.IP2 --method spline -o there.svg", "this is a folder, not a file"),
        (1, "convert A.IP2 there --to json", "this is a folder, not a file"),
        (2, "gb_2d_ip --script there", "this is a folder, not a file"),
        (1, "gb_2d_ip there", "this is a folder, not a file"),
        (1, "info none.ip2", "there is no such file"),
        (1, "info none/none.ip2", "there is no such file"),
        (2, "gb_2d_ip --script none", "there is no such file"),
        (1, "render A.IP2 --method spline -o none/a.svg", "there is no folder none"),
        (1, "man file", "file"),
        (1, "install file --groups gb_2d", "it is a file, not a folder"),
        (1, "uninstall there", "nothing was installed here"),
    ] {
        let said = folder.refused(status, line);
        assert!(said.contains(words) && !said.contains("os error"), "{line}: {said}");
    }
}

#[test]
fn help_knows_commands_and_programs() {
    let folder = Folder::new();
    for (line, same) in [
        ("help render", "render --help"),
        ("help gb_2d_ip", "gb_2d_ip --help"),
        ("help BILIARD", "biliard --help"),
        ("help telepit", "telepit --help"),
        ("help knots path", "knots path --help"),
        ("help", "--help"),
    ] {
        assert_eq!(folder.done(line), folder.done(same), "{line}");
    }
}

#[cfg(unix)]
mod installed {
    use super::*;
    use std::os::unix::fs::MetadataExt;
    use std::path::Path;
    use std::process::Command;

    /// The bytes that all files below a folder take, links not followed.
    fn size(folder: &Path) -> u64 {
        let entries = fs::read_dir(folder).unwrap().flatten();
        entries
            .map(|entry| match fs::symlink_metadata(entry.path()).unwrap() {
                about if about.is_dir() => size(&entry.path()),
                about => about.size(),
            })
            .sum()
    }

    #[test]
    fn a_copy_lasts_by_itself_and_is_taken_back() {
        let folder = Folder::new();
        // The build folder of this test, which ends.
        fs::create_dir(folder.path("build")).unwrap();
        let built = folder.path("build/grafika");
        fs::copy(env!("CARGO_BIN_EXE_grafika"), &built).unwrap();
        let root = folder.path("root");
        let install = |options: &[&str]| {
            let mut command = Command::new(&built);
            command.arg("install").arg(&root).args(["--groups", "all"]).args(options);
            assert_eq!(command.output().unwrap().status.code(), Some(0));
        };
        install(&["--copy"]);
        let one = fs::metadata(&built).unwrap().len();
        fs::remove_dir_all(folder.path("build")).unwrap();
        let all = size(&root);
        assert!(all < one + one / 10, "all programs cost what one costs: {all} of {one}");
        for program in ["GB_2D/gb_2d_ip", "JATEK/biliard", "grafika"] {
            let help = Command::new(root.join(program)).arg("--help").output().unwrap();
            let name = program.rsplit('/').next().unwrap();
            assert!(String::from_utf8_lossy(&help.stdout).contains(&format!("Usage: {name}")), "{program}");
        }
        // What is moved goes on working.
        fs::rename(&root, folder.path("moved")).unwrap();
        let moved = Command::new(folder.path("moved/JATEK/biliard")).arg("--version").output().unwrap();
        assert_eq!(moved.status.code(), Some(0));
        fs::write(folder.path("moved/GB_2D/A.IP2"), "mine").unwrap();
        let told = folder.done("uninstall moved");
        assert!(told.contains("JATEK/biliard: removed\n"), "{told}");
        assert!(told.contains("GB_2D/A.IP2: is not what was installed, and stays\n"), "{told}");
        assert_eq!(fs::read_dir(folder.path("moved")).unwrap().count(), 1);
        assert_eq!(folder.read("moved/GB_2D/A.IP2"), "mine");
        assert!(folder.refused(1, "uninstall moved").contains("nothing was installed here"));
    }

    #[test]
    fn programs_alone_are_put_beside_the_executable() {
        let folder = Folder::new();
        fs::create_dir(folder.path("bin")).unwrap();
        let own = folder.path("bin/grafika");
        fs::copy(env!("CARGO_BIN_EXE_grafika"), &own).unwrap();
        let before = fs::read(&own).unwrap();
        for options in [&["--flat"][..], &["--flat", "--copy", "--yes"]] {
            let mut command = Command::new(&own);
            let command =
                command.arg("install").arg(folder.path("bin")).args(["--groups", "all"]).args(options);
            let done = command.output().unwrap();
            assert_eq!(done.status.code(), Some(0), "{}", String::from_utf8_lossy(&done.stderr));
            // The executable itself stays what it is.
            assert!(fs::symlink_metadata(&own).unwrap().is_file() && fs::read(&own).unwrap() == before);
            let help = Command::new(folder.path("bin/gb_2d_ip")).arg("--help").output().unwrap();
            assert!(String::from_utf8_lossy(&help.stdout).contains("Usage: gb_2d_ip"));
        }
        folder.done("uninstall bin");
        assert_eq!(fs::read_dir(folder.path("bin")).unwrap().count(), 1);
        assert_eq!(fs::read(&own).unwrap(), before);
    }

    #[test]
    fn no_link_leads_out_of_the_folder() {
        let folder = Folder::new();
        for name in ["root", "outside"] {
            fs::create_dir(folder.path(name)).unwrap();
        }
        std::os::unix::fs::symlink(folder.path("outside"), folder.path("root/GB_2D")).unwrap();
        let said = folder.refused(1, "install root --groups gb_2d --yes");
        assert!(said.contains("is a link that leads out of the folder"), "{said}");
        assert_eq!(fs::read_dir(folder.path("outside")).unwrap().count(), 0);
        assert_eq!(fs::read_dir(folder.path("root")).unwrap().count(), 1);
    }
}
