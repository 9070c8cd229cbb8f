//! SOM_FEL as its user sees it: scripts, golden pictures, files, random input.

mod common;

use common::{Kept, SharedDisk, pictures, play_script, random, session, session_on};
use grafika::file::{CloudFormat, Document, Format};
use grafika::geometry::cloud::{Cloud, CloudShape};
use grafika::geometry::kohonen::{Learning, Net, Rule, Topology};
use grafika::machine::{Language, Machine, Memory, Script, Settings, Storage, play};
use grafika::programs::som_fel::PROGRAM;
use serde_json::Value;

/// Opens a file in the manner of 1997.
fn opened(name: &str) -> String {
    format!("key F\ntype {name}\nkey Enter\n")
}

fn run(script: &str) -> Kept {
    run_with(Memory::default(), script)
}

fn run_with(storage: Memory, script: &str) -> Kept {
    play_script(PROGRAM, storage, &format!("{script}\nshot end.png\ndump end.json\n"))
}

fn model(script: &str) -> Value {
    run(script).models["end.json"].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

fn points(model: &Value) -> Vec<Vec<[f64; 3]>> {
    serde_json::from_value(model["net"]["points"].clone()).expect("a net")
}

/// A program with a file in memory.
fn with_file(name: &str, content: &[u8]) -> Memory {
    let mut storage = Memory::default();
    storage.write(name, content).expect("memory takes all");
    storage
}

const LEARN: &str = "key T\nwait 3500\n";
const FIT: &str = "key I\nkey Enter\nwait 8000\n";

#[test]
fn the_net_learns_as_the_library_does() {
    let model = model(LEARN);
    assert_eq!(model["run"], "nothing");
    assert_eq!(model["learning"]["end"], "steps");
    assert_eq!(
        (&model["learning"]["step"], &model["learning"]["total"]),
        (&Value::from(14_400), &Value::from(14_400))
    );
    let cloud = Cloud::of_shape(CloudShape::Saddle, 2000, 0.02, 1).unwrap();
    let start = Net::random(&cloud, [12, 12], Topology::Open, 1).unwrap();
    let mut learning = Learning::new(&cloud, start, Rule::default()).unwrap();
    while learning.advance(1000).is_none() {}
    assert_eq!(points(&model), learning.net().rows());
    let wins: Vec<u64> = serde_json::from_value(model["learning"]["wins"].clone()).unwrap();
    assert_eq!(wins, learning.wins());
    let near = points(&model).concat().iter().all(|neuron| CloudShape::Saddle.distance(*neuron) < 0.03);
    assert!(near && number(&model["learning"]["rms"]) < 0.1);
}

#[test]
fn a_pause_changes_nothing() {
    let whole = model(LEARN);
    for stop in ["key T", "key Space", "key Esc"] {
        let paused = model(&format!("key T\nwait 500\n{stop}\nwait 1000"));
        let step = paused["learning"]["step"].as_u64().unwrap();
        assert!(paused["run"] == "nothing" && (1000..5000).contains(&step), "{stop}: {step}");
        let on = model(&format!("key T\nwait 500\n{stop}\nwait 1000\nkey Space\nwait 4000"));
        assert_eq!(points(&on), points(&whole), "{stop}");
    }
}

#[test]
fn learning_is_undone_and_goes_on_after_that() {
    let undone = model("key T\nwait 500\nkey T\nkey Ctrl+Z");
    assert_eq!((&undone["net"], &undone["learning"]), (&Value::Null, &Value::Null));
    let twice = "key T\nwait 500\nkey T\nkey T\nwait 500\nkey T\n";
    let first = model("key T\nwait 500\nkey T\n");
    assert_eq!(model(&format!("{twice}key Ctrl+Z"))["net"], first["net"]);
    let redone = model(&format!("{twice}key Ctrl+Z\nkey Ctrl+Y\nkey T\nwait 4000"));
    assert_eq!(redone["net"], model(LEARN)["net"]);
    // Undo ends what goes on first.
    assert_eq!(model("key T\nwait 500\nkey Ctrl+Z\nwait 500")["net"], Value::Null);
}

#[test]
fn a_step_is_shown_slowly() {
    let step = model("key L\nwait 700");
    assert_eq!((&step["run"], &step["learning"]["total"]), (&Value::from("step"), &Value::from(1)));
    let done = model("key L\nwait 2500");
    assert_eq!((&done["run"], &done["learning"]["step"]), (&Value::from("nothing"), &Value::from(1)));
    let three = model("key L\nkey L\nwait 900\nkey L\nwait 2500");
    assert_eq!(three["learning"]["total"], 3);
    // Steps are those of the whole learning.
    assert_eq!(model("key L\nkey L\nkey L\nwait 2500\nkey T\nwait 4000")["net"], model(LEARN)["net"]);
}

#[test]
fn the_fit_finds_the_noise() {
    let model = model(&format!("{LEARN}{FIT}"));
    let fit = &model["surface"]["fit"];
    assert_eq!(fit["points"], 2000);
    assert!((0.015..0.023).contains(&number(&fit["rms"])), "{fit}");
    assert!(fit["history"].as_array().unwrap().len() >= 2);
    assert!(model["options"]["errors"] == true && model["surface"]["kind"] == "surface");
    // Stopped early it keeps its last solution, without a report.
    let stopped = run(&format!("{LEARN}key I\nkey Enter\nwait 1200\nkey Esc")).models["end.json"].clone();
    assert!(stopped["surface"]["kind"] == "surface" && stopped["surface"]["fit"].is_null());
    assert_eq!(
        run(&format!("{LEARN}key I\nkey Enter\nwait 1200\nkey Esc\nkey Ctrl+Z")).models["end.json"]["surface"],
        Value::Null
    );
    // Corrections are counted.
    let none = run(&format!("{LEARN}key I\ntype 0\nkey Enter\nwait 3000")).models["end.json"].clone();
    assert_eq!(none["surface"]["fit"]["history"].as_array().unwrap().len(), 1);
}

#[test]
fn the_surface_of_the_net_comes_and_goes() {
    let base = model(&format!("{LEARN}key S"));
    assert!(base["surface"]["base"] == true && base["surface"]["fit"].is_null());
    assert_eq!(model(&format!("{LEARN}key S\nkey S"))["surface"], Value::Null);
    let seen = model(&format!("{LEARN}key S\nkey D\nkey F5\nkey F6\nkey F6\nkey +\nkey F3"));
    let options = &seen["options"];
    assert!(options["filled"] == true && options["colours"] == "zebra" && options["shown"] == "points");
    assert!(options["section"].as_str().unwrap().starts_with("y = "), "{options}");
}

#[test]
fn a_net_grows() {
    let model = model("key N\ntype 64\nkey Enter\nwait 12000");
    assert_eq!(model["learning"]["end"], "steps", "{}", model["learning"]);
    let size = model["net"]["size"].as_array().unwrap();
    let neurons = size[0].as_u64().unwrap() * size[1].as_u64().unwrap();
    assert!((40..=64).contains(&neurons), "{size:?}");
}

#[test]
fn the_picture_is_turned_and_stands_alone() {
    let turned = model("key Left\nwheel 4");
    assert_eq!(number(&turned["zoom"]), 2.0 * number(&model("")["zoom"]));
    assert!(turned["azimuth"] != model("")["azimuth"]);
    let alone = model(&format!("{LEARN}key S\nkey E\nkey T"));
    assert!(alone["options"]["alone"] == true && alone["options"]["filled"] == true);
    assert_eq!(model("key E\nkey Esc")["options"]["alone"], false);
    let dragged = model("manner today\ndrag 200 200 300 200");
    assert!(dragged["azimuth"] != model("")["azimuth"]);
}

#[test]
fn a_cloud_is_made_on_its_panel() {
    // The saddle is the first of the shapes; the torus is three further.
    let script = "key K\nkey Right\nkey Right\nkey Right\nkey Down\nkey Enter\ntype 500\nkey Enter\nkey Esc";
    let model = model(script);
    assert_eq!(model["cloud"]["points"], 500, "{}", model["cloud"]);
    assert_eq!(model["cloud"]["source"]["made"]["shape"], "torus");
    assert_eq!(
        (&model["settings"]["topology"], &model["settings"]["shaped"]),
        (&Value::from("torus"), &Value::from(true))
    );
    assert_eq!(run(&format!("{script}\nkey Ctrl+Z")).models["end.json"]["cloud"]["points"], 2000);
    let learnt = run(&format!("{script}\n{LEARN}")).models["end.json"].clone();
    assert_eq!(learnt["net"]["topology"], "torus");
    // Neurons lie inside where the surface bends.
    let neurons = points(&learnt).concat();
    let sum: f64 = neurons.iter().map(|neuron| CloudShape::Torus.distance(*neuron).powi(2)).sum();
    assert!((sum / neurons.len() as f64).sqrt() < 0.12);
}

#[test]
fn the_net_is_set_on_its_panel() {
    let script = "key H\nkey Enter\ntype 8\nkey Enter\nkey Down\nkey Enter\ntype 9\nkey Enter\nkey Down\nkey Right\nkey Down\nkey Right\nkey Esc";
    let settings = model(script)["settings"].clone();
    assert_eq!(settings["size"], serde_json::json!([8, 9]));
    assert_eq!(
        (&settings["topology"], &settings["weighting"]),
        (&Value::from("cylinder"), &Value::from("bubble"))
    );
    // A cylinder of two columns is no net: told, and as before.
    let refused = run(&format!("{script}\nkey H\nkey Down\nkey Enter\ntype 2\nkey Enter"));
    assert_eq!(refused.models["end.json"]["settings"]["size"], serde_json::json!([8, 9]));
    // Paused learning goes on only by the rules that it began with.
    let changed = model(&format!("key T\nwait 500\nkey T\n{script}"));
    assert!(changed["net"]["size"] == serde_json::json!([12, 12]) && changed["learning"].is_null());
}

#[test]
fn a_plane_cloud_is_put_in_order() {
    let model = model(&format!("{}{LEARN}key S", opened("NYOM")));
    assert_eq!(model["net"]["size"], serde_json::json!([40, 1]));
    assert_eq!(
        (&model["surface"]["kind"], &model["cloud"]["plane"]),
        (&Value::from("curve"), &Value::from(true))
    );
    // Neighbours are near each other, in the order of the letter.
    let line: Vec<[f64; 3]> = points(&model).concat();
    let longest = line.windows(2).map(|w| (w[1][0] - w[0][0]).hypot(w[1][1] - w[0][1])).fold(0.0, f64::max);
    assert!(longest < 0.35, "{longest}");
    let near = line.iter().all(|neuron| CloudShape::Letter.distance(*neuron) < 0.1);
    assert!(near);
}

#[test]
fn files_of_every_kind_are_read() {
    let cloud =
        grafika::file::Cloud::new(vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.5], [0.0, 1.0, 0.25], [1.0, 1.0, 2.0]]);
    for (name, format) in [
        ("A.XYZ", CloudFormat::Xyz),
        ("A.CSV", CloudFormat::Csv),
        ("A.PLY", CloudFormat::Ply),
        ("A.OBJ", CloudFormat::Obj),
    ] {
        let storage = with_file(name, &cloud.write(format).unwrap());
        let model = run_with(storage, &opened(name)).models["end.json"].clone();
        assert_eq!(model["cloud"]["points"], 4, "{name}");
        assert_eq!(model["cloud"]["source"]["file"], name);
    }
    let stl = b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 1\nendloop\nendfacet\nendsolid a\n";
    assert_eq!(run_with(with_file("A.STL", stl), &opened("A.STL")).models["end.json"]["cloud"]["points"], 3);
}

#[test]
fn what_is_wrong_keeps_the_cloud_that_is_there() {
    let wrong: [(&str, &[u8]); 5] = [
        ("A.XYZ", b""),
        ("A.XYZ", b"1 2 3\n1 two 3\n"),
        ("A.PLY", b"ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nend_header\n1\n2\n"),
        ("A.SOM", b"{\"format\":\"SOM\",\"topology\":\"open\",\"points\":[[[0,0,0]],[[0,0,0],[1,1,1]]]}"),
        ("A.DOC", b"1 2 3\n"),
    ];
    for (name, content) in wrong {
        let model = run_with(with_file(name, content), &opened(name)).models["end.json"].clone();
        assert_eq!(
            (&model["cloud"]["points"], &model["run"]),
            (&Value::from(2000), &Value::from("nothing")),
            "{name}"
        );
    }
    assert_eq!(model(&opened("NONE.XYZ"))["cloud"]["points"], 2000);
}

/// A table of many points.
fn large() -> Vec<u8> {
    (0..60_000).flat_map(|k| format!("{} {} {}\n", k % 251, k % 241, k % 97).into_bytes()).collect()
}

#[test]
fn a_large_file_shows_how_far_it_is_and_is_stopped() {
    let storage = || with_file("A.XYZ", &large());
    let reading = run_with(storage(), &opened("A.XYZ"));
    assert_eq!(reading.models["end.json"]["run"], "reading");
    let stopped = run_with(storage(), &format!("{}key Esc\nwait 1000", opened("A.XYZ")));
    assert_eq!(stopped.models["end.json"]["cloud"]["points"], 2000);
    let read = run_with(storage(), &format!("{}wait 1000", opened("A.XYZ")));
    assert_eq!(read.models["end.json"]["cloud"]["points"], 60_000);
}

#[test]
fn what_cannot_be_learnt_is_told() {
    for (content, net) in [("1 2 3\n1 2 3\n", Value::Null), ("1 2 3\n2 4 6\n3 6 9\n", Value::Null)] {
        let kept = run_with(with_file("A.XYZ", content.as_bytes()), &format!("{}{LEARN}", opened("A.XYZ")));
        assert_eq!(kept.models["end.json"]["net"], net, "{content}");
    }
    // On a straight line a polygon learns.
    let line: String = (0..50).map(|k| format!("{k} {} 1\n", 2 * k)).collect();
    let script =
        format!("{}key H\nkey Down\nkey Enter\ntype 1\nkey Enter\nkey Esc\n{LEARN}key S", opened("A.XYZ"));
    let model = run_with(with_file("A.XYZ", line.as_bytes()), &script).models["end.json"].clone();
    assert_eq!(
        (&model["net"]["size"], &model["surface"]["kind"]),
        (&serde_json::json!([12, 1]), &Value::from("curve"))
    );
    // Fewer points than control points.
    let few: String = (0..30).map(|k| format!("{} {} {}\n", k % 6, k / 6, k % 4)).collect();
    let kept = run_with(with_file("A.XYZ", few.as_bytes()), &format!("{}{LEARN}{FIT}", opened("A.XYZ")));
    assert_eq!(
        (&kept.models["end.json"]["surface"], &kept.models["end.json"]["run"]),
        (&Value::Null, &Value::from("nothing"))
    );
}

/// Plays a script on a disk, which is looked into afterwards.
fn on_disk(disk: &SharedDisk, script: &str) -> Kept {
    let mut kept = Kept::default();
    let script = Script::parse(&format!("{script}\ndump end.json")).expect("the test's script is right");
    play(&mut session(PROGRAM, disk.clone(), Settings::default()), &script, &mut kept).expect("all is taken");
    kept
}

#[test]
fn a_net_is_saved_opened_and_fitted() {
    let disk = SharedDisk::default();
    let saved = on_disk(&disk, &format!("{}{LEARN}key Ctrl+S\ntype TEREP\nkey Enter", opened("TEREP")));
    assert_eq!(saved.models["end.json"]["unsaved"], false);
    let document = Document::read(Format::Som, &disk.file("TEREP.SOM")).unwrap();
    let Document::Som(net) = &document else { panic!("{document:?}") };
    assert_eq!(net.points, points(&saved.models["end.json"]));
    // A net without a cloud has a surface; with its cloud it is fitted.
    let machine = Machine::new(Box::new(disk.clone()), Settings::default());
    let mut kept = Kept::default();
    let script =
        format!("key S\ndump alone.json\n{}key I\nkey Enter\nwait 8000\ndump end.json", opened("TEREP"));
    play(&mut session_on(PROGRAM, machine, Some(document)), &Script::parse(&script).unwrap(), &mut kept)
        .unwrap();
    let alone = &kept.models["alone.json"];
    assert!(alone["cloud"].is_null() && alone["surface"]["base"] == true);
    let rms = number(&kept.models["end.json"]["surface"]["fit"]["rms"]);
    assert!(rms < 0.024, "{rms}");
}

#[test]
fn surfaces_and_curves_are_exported() {
    let disk = SharedDisk::default();
    let figure = |letter: &str| format!("key F10\nkey {letter}\nkey Enter\nwait 2500\n");
    let script = format!("manner today\n{LEARN}key S\n{}{}{}", figure("C"), figure("E"), figure("Y"));
    on_disk(&disk, &script);
    assert_eq!(disk.names(), ["som_fel-1.CSF", "som_fel-1.ply", "som_fel-1.step"]);
    let document = Document::read(Format::Csf, &disk.file("som_fel-1.CSF")).unwrap();
    let Document::KnotNet(net) = document else { panic!("{document:?}") };
    assert_eq!((net.points.len(), net.order), (12, [4, 4]));
    let disk = SharedDisk::default();
    on_disk(&disk, &format!("{}manner today\n{LEARN}key S\n{}", opened("NYOM"), figure("C")));
    assert!(matches!(Document::read(Format::Csm, &disk.file("som_fel-1.CSM")), Ok(Document::Knots(_))));
}

#[test]
fn other_documents_are_refused() {
    let document = Document::read(Format::Ip2, grafika::machine::sample("A.IP2").unwrap()).unwrap();
    let refusal = (PROGRAM.start)(Some(document)).err().expect("it is no cloud");
    assert!(refusal.of(Language::English).contains(".SOM"), "{refusal:?}");
}

#[test]
fn pages_look_as_they_did() {
    for language in ["hu", "en"] {
        for (name, script) in [
            ("begin", String::new()),
            ("learning", "key T\nwait 1000".to_owned()),
            ("learnt", format!("{LEARN}wait 2500")),
            ("point", "key T\nwait 1500\nkey T\nkey L\nwait 300".to_owned()),
            ("movement", "key L\nwait 1900".to_owned()),
            ("growing", "key N\nkey Enter\nwait 3000".to_owned()),
            ("limit", "key N".to_owned()),
            ("surface", format!("{LEARN}key S\nkey D\nkey F3\nwait 2500")),
            ("fitting", format!("{LEARN}key I\nkey Enter\nwait 2000")),
            ("errors", format!("{LEARN}{FIT}key F4\nkey F4")),
            ("zebra", format!("{LEARN}{FIT}key F3\nkey F5\nkey F6")),
            ("alone", format!("{LEARN}{FIT}key E\nkey Left\nkey Left")),
            ("curve", format!("{}{LEARN}key S", opened("NYOM"))),
            (
                "torus",
                "key K\nkey Right\nkey Right\nkey Right\nkey Esc\nkey T\nwait 3500\nkey S\nkey D".to_owned(),
            ),
            ("cloud", "key K\nkey Right".to_owned()),
            ("net", "key H\nkey Down\nkey Down".to_owned()),
            ("too_small", "key H\nkey Enter\ntype 2\nkey Enter\nkey Esc\nkey T\nwait 3500\nkey I".to_owned()),
            ("refused", "key I".to_owned()),
            ("opened", opened("TEREP")),
            ("help", "key F1".to_owned()),
            ("today", "manner today".to_owned()),
            ("today_files", "manner today\nkey F".to_owned()),
            ("today_export", format!("manner today\n{LEARN}key S\nkey F10")),
        ] {
            let kept = run(&format!("lang {language}\n{script}"));
            pictures::assert_golden(&format!("som_fel_{name}_{language}"), &kept.pictures["end.png"]);
        }
    }
}

#[test]
fn recordings_replay() {
    random::assert_replays(PROGRAM, &random::script(11, random::part(1500)));
    random::assert_replays(PROGRAM, "key T\nwait 777\nkey L\nwait 500\nkey T\nwait 900\nkey F5\n");
}

#[test]
fn random_events_do_no_harm() {
    random::storm(PROGRAM, random::SOME);
}
