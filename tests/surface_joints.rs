//! Two patches with a common border, net and hull over a surface, the weight of a point, free poles and auxiliary borders:
//! the designs behind them, and the programs as their user sees them.

mod common;

use common::{Kept, play_script};
use grafika::design::{self, NetDesign, Part};
use grafika::file::{Document, FileKind, Format, Method, Net, NetKind, NetSettings};
use grafika::geometry::{Border, Contact, Joint, Order, ParamSurface, Point, dot, norm};
use grafika::machine::{Language, Machine, Manner, Memory, Script, Settings};
use grafika::programs::ALL;
use grafika::ui::Program;
use proptest::prelude::*;

fn sample(name: &str) -> NetDesign {
    let bytes = grafika::machine::sample(name).expect("it is a sample");
    let kind = FileKind::from_name(name).expect("it has a kind");
    match Document::decode(kind, bytes) {
        Ok(Document::Net(net)) => NetDesign::new(net),
        other => panic!("{name}: {other:?}"),
    }
}

fn program(name: &str) -> Program {
    *ALL.iter().find(|program| program.manual.name == name).expect("there is such a program")
}

/// Plays a script of today on a net; the end is kept as `end`.
fn play_on(name: &str, net: Net, rest: &str) -> Kept {
    let settings = Settings { manner: Manner::Today, language: Language::English, ..Settings::default() };
    let machine = Machine::new(Box::new(Memory::default()), settings);
    let mut session = common::session_on(program(name), machine, Some(Document::Net(net)));
    let script =
        Script::parse(&format!("{rest}\ndump end.json\nshot end.png\n")).expect("the script is right");
    let mut kept = Kept::default();
    grafika::machine::play(&mut session, &script, &mut kept).expect("the outlet takes all");
    kept
}

fn play(name: &str, net: &str, rest: &str) -> Kept {
    play_on(name, sample(net).net, rest)
}

fn order(kept: &Kept) -> (String, String) {
    let joint = &kept.models["end.json"]["joint"];
    let text = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_owned();
    (text(&joint["kept"]), text(&joint["measured"]["order"]))
}

/// The second derivatives across the border by the differences of values alone.
fn second(surface: &dyn ParamSurface, i: usize, v: f64) -> Point<3> {
    let h = 0.25;
    let at = |k: usize| {
        let t = h * k as f64;
        surface.eval([i, 0], [if i == 0 { 1.0 - t } else { t }, v]).expect("it is there")
    };
    let [a, b, c, d] = [at(0), at(1), at(2), at(3)];
    std::array::from_fn(|x| (2.0 * a[x] - 5.0 * b[x] + 4.0 * c[x] - d[x]) / (h * h))
}

fn kinds() -> impl Strategy<Value = &'static str> {
    prop::sample::select(vec!["A.FPB", "A.FHC"])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]
    /// Whatever part of whatever point changes, the condition stays as measured, and nothing else breaks.
    #[test]
    fn a_kept_condition_is_kept_while_points_move(
        kind in kinds(), joint in prop::sample::select(&Joint::ALL[..]), ratio in 1.2..3.0_f64,
        moves in prop::collection::vec((0_usize..7, 0_usize..4, 0_usize..4, prop::array::uniform3(-200.0..200.0)), 1..8),
    ) {
        let mut design = sample(kind).with_second_patch().with_joint(joint, Some(ratio));
        for (k, l, part, to) in moves {
            let [rows, columns] = design.choices();
            let part = if kind == "A.FHC" { Part::ALL[part] } else { Part::Place };
            let index = [k % rows, l % columns];
            design = design.with_part(index, part, to);
            prop_assert_eq!(design.part(index, part), Some(to));
        }
        let contact = design.contact().unwrap();
        let least = match joint {
            Joint::C0 => [Order::C0, Order::C0],
            Joint::Plane => [Order::Plane, Order::Plane],
            Joint::C1 => [Order::C1, Order::C2],
            Joint::C2 => [Order::C2, Order::C2],
        };
        // A chance move may make a surface that touches itself; the derivatives tell for sure.
        let surface = design.surface().unwrap();
        if joint != Joint::C0 && contact.angle.is_some_and(|angle| angle.most < 1e-6) {
            prop_assert!(least.contains(&contact.order), "{joint:?}: {contact:?}");
        }
        for v in [0.0, 0.3, 1.0] {
            let [one, other] = [surface.at([0, 0], [1.0, v]).unwrap(), surface.at([1, 0], [0.0, v]).unwrap()];
            let near = |a: Point<3>, b: Point<3>| {
                norm::<3>(std::array::from_fn(|x| a[x] - b[x])) < 1e-7
            };
            prop_assert!(near(one.point, other.point));
            let r = match joint { Joint::C0 => continue, Joint::Plane => ratio, _ => 1.0 };
            prop_assert!(near(one.u.map(|x| r * x), other.u));
            if joint == Joint::C2 {
                prop_assert!(near(second(&*surface, 0, v), second(&*surface, 1, v)));
            }
        }
    }

    /// A finer net of two patches is the same surface, with the same contact.
    #[test]
    fn a_finer_net_of_two_patches_is_the_same_surface(direction in 0_usize..2, u in 0.0..1.0_f64, v in 0.0..1.0_f64) {
        let coarse = sample("KETBEZ.JSON").with_joint(Joint::C2, None);
        let fine = coarse.refined(direction).unwrap();
        prop_assert_eq!(fine.shape(), if direction == 0 { [9, 4] } else { [7, 5] });
        prop_assert_eq!(fine.contact().unwrap().order, Order::C2);
        let (one, other) = (coarse.surface().unwrap(), fine.surface().unwrap());
        for i in 0..2 {
            let [a, b] = [one.eval([i, 0], [u, v]).unwrap(), other.eval([i, 0], [u, v]).unwrap()];
            prop_assert!((0..3).all(|x| (a[x] - b[x]).abs() < 1e-9));
        }
    }

    /// Weights sum to 1 everywhere, and the points by their weights are the surface.
    #[test]
    fn the_points_by_their_weights_are_the_surface(
        name in prop::sample::select(vec!["A.FPS", "A.FBS", "A.FPB", "A.FEM", "K1.ZMS", "K1.ZMB", "A.ZYS", "A.ZYB", "KETBEZ.JSON"]),
        method in prop::sample::select(vec![None, Some(Method::Local), Some(Method::BSpline2), Some(Method::Beta)]),
        border in prop::sample::select(vec![Border::Doubled, Border::Reached, Border::Free, Border::Inner]),
        spans in (0_usize..8, 0_usize..8), uv in prop::array::uniform2(0.0..1.0_f64),
    ) {
        let patch = name == "A.FPB" || name == "KETBEZ.JSON";
        let design = sample(name).with_border(border).with_settings(|settings| {
            settings.method = method.filter(|_| !patch);
            settings.bias = Some([1.5, 0.7]);
            settings.tension = Some([2.0, 5.0]);
        });
        let surface = design.surface().unwrap();
        let spans = [spans.0 % surface.spans()[0], spans.1 % surface.spans()[1]];
        let (mut sum, mut point) = (0.0, [0.0; 3]);
        for (index, place) in design.discs() {
            let [weight, ..] = design.influence(index).unwrap().eval(spans, uv).unwrap();
            sum += weight;
            point = std::array::from_fn(|x| point[x] + weight * place[x]);
        }
        let found = surface.eval(spans, uv).unwrap();
        prop_assert!((sum - 1.0).abs() < 1e-9, "{sum}");
        prop_assert!((0..3).all(|x| (found[x] - point[x]).abs() < 1e-6), "{found:?} {point:?}");
    }
}

#[test]
fn a_second_patch_comes_and_goes() {
    for name in ["A.FPB", "A.FHC"] {
        let one = sample(name);
        let two = one.with_second_patch();
        assert_eq!((two.joint(), two.shape()), (Some(Joint::C1), [7, 4]));
        assert!(matches!(two.contact(), Some(Contact { order: Order::C1 | Order::C2, .. })));
        let (alone, both) = (one.surface().unwrap(), two.surface().unwrap());
        assert_eq!((both.spans(), both.eval([0, 0], [0.3, 0.6])), ([2, 1], alone.eval([0, 0], [0.3, 0.6])));
        assert_eq!(two.with_one_patch(), one);
        assert_eq!(two.with_second_patch(), two, "there is no third");
        // It is a net that JSON holds, and only JSON.
        let document = Document::Net(two.net.clone());
        let text = document.to_json().unwrap();
        assert_eq!(Document::from_json(&text), Ok(document.clone()));
        let error = document.write(one.net.kind.format()).unwrap_err().to_string();
        assert!(error.ends_with("two joined patches; only JSON holds both"), "{error}");
        assert!(design::lost(&document, one.net.kind.format(), None).contains(&"joint".to_owned()));
    }
    assert!(!sample("A.FPS").may_join());
}

#[test]
fn nets_that_are_no_two_patches_are_refused() {
    let net = |kind: NetKind, rows: usize| {
        let settings = NetSettings { joint: Some(Joint::C1), ..NetSettings::default() };
        Document::Net(Net { settings, ..Net::new(kind, vec![vec![[0.0; 3]; 4]; rows]) })
    };
    for (kind, rows, good) in [
        (NetKind::Fpb, 7, true),
        (NetKind::Fpb, 5, true),
        (NetKind::Fpb, 4, false),
        (NetKind::Fpb, 3, false),
        (NetKind::Fhc, 7, true),
        (NetKind::Fhc, 4, false),
        (NetKind::Fps, 7, false),
    ] {
        assert_eq!(net(kind, rows).check().is_ok(), good, "{kind:?} {rows}");
    }
    let ratio = |ratio: f64| NetSettings { ratio: Some(ratio), ..NetSettings::default() };
    let with =
        |settings| Document::Net(Net { settings, ..Net::new(NetKind::Fpb, vec![vec![[0.0; 3]; 4]; 4]) });
    assert!(with(ratio(2.0)).check().is_ok() && with(ratio(0.0)).check().is_err());
}

#[test]
fn free_meridians_end_at_the_poles_without_curvature() {
    let design = sample("B.ZMS");
    let free = design.with_border(Border::Free);
    let (joined, surface) = (design.surface().unwrap(), free.surface().unwrap());
    let pole = design.point([0, 0]).unwrap();
    for i in 0..8 {
        let at = surface.at([i, 0], [0.4, 0.0]).unwrap();
        assert!((0..3).all(|x| (at.point[x] - pole[x]).abs() < 1e-9 && at.vv[x].abs() < 1e-9));
        assert!(norm(joined.at([i, 0], [0.4, 0.0]).unwrap().vv) > 1.0);
    }
    // The poles of a joined surface have one tangent plane for opposite meridians, those of a free one have not.
    let break_at = |surface: &dyn ParamSurface| {
        let v = |i: usize| surface.at([i, 0], [0.0, 0.0]).unwrap().v;
        let [a, b] = [v(0), v(4)];
        1.0 + dot(a, b) / (norm(a) * norm(b))
    };
    assert!(break_at(&*joined) < 1e-9 && break_at(&*surface) > 1e-3);
    // The finer net is the same surface.
    let fine = free.refined(1).unwrap().surface().unwrap();
    let [a, b] = [surface.eval([3, 0], [0.5, 0.25]).unwrap(), fine.eval([3, 0], [0.5, 0.5]).unwrap()];
    assert!((0..3).all(|x| (a[x] - b[x]).abs() < 1e-9));
    // An odd number of meridians has no opposite ones.
    let mut odd = free.clone();
    odd.net.points.pop();
    assert!(odd.surface().is_ok() && odd.with_border(Border::Doubled).surface().is_err());
}

#[test]
fn triple_poles_of_a_cubic_are_reached() {
    let design = sample("K2.ZMB").with_border(Border::Free);
    let surface = design.surface().unwrap();
    assert_eq!(surface.spans(), [8, 6]);
    for (end, l) in [(0, 0), (5, 4)] {
        let pole = design.point([0, l]).unwrap();
        let at = surface.eval([2, end], [0.5, if end == 0 { 0.0 } else { 1.0 }]).unwrap();
        assert!((0..3).all(|x| (at[x] - pole[x]).abs() < 1e-9));
    }
    assert!(design.solid().unwrap().spans() == [8, 6], "a model has the poles of the picture");
}

#[test]
fn auxiliary_border_points_leave_the_inner_patches() {
    let grid = |n: usize| (0..n).map(|k| (0..n).map(|l| [k as f64, l as f64, 0.0]).collect()).collect();
    for (method, n, from) in [(Method::BSpline2, 3, 0.5), (Method::BSpline3, 4, 1.0)] {
        let settings = NetSettings { method: Some(method), inner: Some(true), ..NetSettings::default() };
        let design = NetDesign::new(Net { settings, ..Net::new(NetKind::Fbs, grid(n)) });
        let surface = design.surface().unwrap();
        assert_eq!(surface.spans(), [1, 1]);
        for (t, to) in [(0.0, from), (1.0, from + 1.0)] {
            let at = surface.eval([0, 0], [t, t]).unwrap();
            assert!((at[0] - to).abs() < 1e-12 && (at[1] - to).abs() < 1e-12, "{at:?}");
        }
        assert!(design.refined(0).is_err());
    }
}

#[test]
fn the_key_joins_patches_and_keeps_what_is_chosen() {
    let chosen = |keys: &str| order(&play("f_p_bezr", "A.FPB", keys));
    assert_eq!(chosen("key J"), ("c1".into(), "c1".into()));
    assert_eq!(chosen("key J\nkey J\nkey 2"), ("c2".into(), "c2".into()));
    assert_eq!(
        chosen("key J\nkey J\nkey S\nkey Backspace\ntype 2\nkey Enter"),
        ("plane".into(), "plane".into())
    );
    let moved = "key V\nkey 4\nkey 1\ntype 90\nkey Enter\ntype -60\nkey Enter\ntype 300\nkey Enter";
    assert_eq!(chosen(&format!("key J\nkey J\nkey 0\n{moved}")), ("c0".into(), "c0".into()));
    assert_eq!(chosen(&format!("key J\nkey J\nkey 2\n{moved}")), ("c2".into(), "c2".into()));
    // One patch again, and undone.
    assert_eq!(chosen("key J\nkey J\nkey E"), (String::new(), String::new()));
    assert_eq!(chosen("key J\nkey J\nkey E\nkey Ctrl+Z"), ("c1".into(), "c1".into()));
    assert_eq!(chosen("key J\nkey Ctrl+Z"), (String::new(), String::new()));
    let hermite = order(&play(
        "f_p_herm",
        "A.FHC",
        "key J\nkey J\nkey 2\nkey V\nkey 2\nkey 0\nkey U\ntype 90\nkey Enter\ntype 0\nkey Enter\ntype 300\nkey Enter",
    ));
    assert_eq!(hermite, ("c2".into(), "c2".into()));
    // In the manner of 1997 there is one patch.
    let kept = play_script(program("f_p_bezr"), Memory::default(), "key U\nkey J\ndump end.json\n");
    assert_eq!(order(&kept), (String::new(), String::new()));
}

#[test]
fn a_broken_condition_is_told() {
    let mut net = sample("KETBEZ.JSON").net;
    net.points[4][1] = [70.0, -45.0, 200.0];
    let kept = play_on("f_p_bezr", net, "");
    assert_eq!(order(&kept), ("c1".into(), "c0".into()));
    let told: Vec<String> = kept.pictures["end.png"].texts().iter().map(|text| text.string()).collect();
    assert!(
        told.iter().any(|line| line.starts_with("Kept: C1, broken. Measured: C0, no tangent")),
        "{told:?}"
    );
}

#[test]
fn net_hull_and_weights_are_shown_and_hidden() {
    let last =
        |keys: &str| play("f_p_bspl", "Z.FBS", keys).models.remove("end.json").expect("it was written");
    assert_eq!(last("key K")["frame"], "hull");
    assert_eq!(last("key F\nkey 3\nkey D\nkey K")["frame"], "net");
    assert_eq!(last("key F\nkey 3\nkey D\nkey K\nkey K\nkey K").get("frame"), None);
    // The middle point of an open cubic net of 5 x 5: the square of 2/3.
    let shown = last("move 331 40\nkey W\nmove 70 20\nwait 100");
    assert_eq!(shown["weight"], serde_json::json!({ "point": [2, 2], "range": [0.0, 0.444] }));
    assert_eq!(last("key W\nkey W").get("weight"), None);
    // Figures have the lines of the hull; colours are no lines.
    let hull = play("zm_bspl", "K1.ZMB", "key K");
    assert_ne!(hull.pictures["end.png"], play("zm_bspl", "K1.ZMB", "").pictures["end.png"]);
}

#[test]
fn the_border_has_a_third_way() {
    let border = |name: &str, sample: &str, keys: &str| {
        let kept = play(name, sample, keys);
        let model = &kept.models["end.json"];
        (model["extended"].as_bool(), model["border"].as_str().map(str::to_owned))
    };
    let (free, inner) = (Some("free".to_owned()), Some("inner".to_owned()));
    assert_eq!(border("f_p_bspl", "A.FBS", "key F4"), (Some(true), None));
    assert_eq!(border("f_p_bspl", "A.FBS", "key F4\nkey F4"), (Some(false), inner));
    assert_eq!(border("f_p_bspl", "A.FBS", "key F4\nkey F4\nkey F4"), (Some(false), None));
    assert_eq!(border("zm_bspl", "A.ZMB", "key F4\nkey F4"), (Some(false), free.clone()));
    assert_eq!(border("zy_bspl", "A.ZYB", "key F4\nkey F4"), (Some(false), None));
    assert_eq!(border("zm_spln", "A.ZMS", "key F4"), (Some(false), free));
    assert_eq!(border("zm_spln", "A.ZMS", "key F4\nkey F4"), (Some(false), None));
    let document = Document::Net(sample("A.ZMS").with_border(Border::Free).net);
    assert_eq!(design::lost(&document, Format::Zms, Some(Method::Spline)), ["free_poles"]);
}
