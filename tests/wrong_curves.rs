//! Shows that the comparison with the originals' screens refuses a wrong curve: a script is played with
//! another last command for the curve than its own, and the picture must not pass.

mod common;

use common::reference::{Allowance, Reference};
use common::shared_out;
use grafika::programs::{gb_2d_bt, gb_2d_ip, gb_3d_bt, gb_3d_ip};
use grafika::ui::Program;

const PLANE: Program = gb_2d_ip::PROGRAM;
const PLANE_BETA: Program = gb_2d_bt::PROGRAM;
const SPACE: Program = gb_3d_ip::PROGRAM;
const SPACE_BETA: Program = gb_3d_bt::PROGRAM;

/// A screen of the original, the end of its script that draws the curve, and other ends.
type Case = (Program, &'static str, &'static str, &'static [&'static str]);

/// No curve at all: as every change, one that is taken back and made again takes the curve away.
const NONE: &str = "key Ctrl+Z\nkey Ctrl+Y";

const CASES: &[Case] = &[
    (
        PLANE,
        "GB_2D_IP_click_spline",
        "click 580 10\nclick 270 32\nclick 150 28",
        &["type gz3", "type gn2", "type gn43"],
    ),
    (
        PLANE,
        "GB_2D_IP_fresh_spline",
        "key G\ntype n3",
        &["type gz3", "type gn2", "type gn42", "type gn1.5\nkey Enter"],
    ),
    (
        PLANE,
        "GB_2D_IP_gauss_bspline3",
        "key G\ntype n43",
        &["type gz43", "type gn2", "type gn42", "type gn3", "type gn1.5\nkey Enter"],
    ),
    (PLANE, "GB_2D_IP_open_bezier", "type gn\nkey 2", &["type gz2", "type gn3", "type gn42", "type gn43"]),
    (
        PLANE,
        "GB_2D_IP_three_closed_bspline2",
        "type gz\nkey 4\nkey 2",
        &["type gn42", "type gz43", "type gz3"],
    ),
    (
        PLANE,
        "GB_2D_IP_three_closed_spline",
        "type gz\nkey 3",
        &["type gn3", "type gz2", "type gz1.5\nkey Enter"],
    ),
    (SPACE, "GB_3D_IP_closed_bspline2", "type gz\nkey 4\nkey 2", &["type gn42", "type gz43", "type gz3"]),
    (SPACE, "GB_3D_IP_closed_spline", "type gz\nkey 3", &["type gn3", "type gz42", "type gz43"]),
    (SPACE, "GB_3D_IP_open_bezier", "type gn\nkey 2", &["type gz2", "type gn42", "type gn43"]),
    (
        SPACE,
        "GB_3D_IP_open_coons_k05",
        "type gn\nkey 1\ntype .5\nkey Enter",
        &["type gz1.5\nkey Enter", "type gn3", "type gn12\nkey Enter"],
    ),
    (PLANE_BETA, "GB_2D_BT_closed_b1_1_b2_5", "type gz", &["type gn", "key C\ntype 20\nkey Enter\ntype gz"]),
    (PLANE_BETA, "GB_2D_BT_open_b1_1_b2_-4", "type gn", &["type gz", "key C\ntype 5\nkey Enter\ntype gn"]),
    (SPACE_BETA, "GB_3D_BT_closed_1_-4", "type gz", &["type gn", "key C\ntype 5\nkey Enter\ntype gz"]),
    (SPACE_BETA, "GB_3D_BT_open_1_0", "type gn", &["type gz", "key A\ntype 9\nkey Enter\ntype gn"]),
];

/// Pairs that no comparison of pixels can tell apart: the screen and what is drawn instead. The points of
/// `gauss` are so dense that the curves of these methods lie within a pixel of each other.
const ALIKE: &[(&str, &str)] = &[
    ("GB_2D_IP_gauss_bspline3", "type gn42"),
    ("GB_2D_IP_gauss_bspline3", "type gn3"),
    ("GB_2D_IP_gauss_bspline3", "type gn1.5\nkey Enter"),
];

/// Whether a screen passes when the end of its script is another one.
fn passes((program, name, end, _): &Case, other: &str) -> bool {
    let reference = Reference::read("reference/curves", name);
    let (end, other) = (format!("\n{end}\nwait 600\n"), format!("\n{other}\nwait 600\n"));
    assert!(reference.script.contains(&end), "{name} does not end so: {end}");
    let script = reference.script.replace(&end, &other);
    reference.problem(*program, &script, Allowance::Curve).is_none()
}

#[test]
fn a_wrong_curve_is_refused() {
    let wrong = shared_out(CASES, |case| {
        let (_, name, end, others) = case;
        assert!(passes(case, end), "{name}: the right curve is refused");
        let all = others.iter().chain([&NONE]);
        let wrong = all.filter(|other| passes(case, other) != ALIKE.contains(&(*name, **other)));
        wrong.map(|other| format!("{name} with {other:?}")).collect::<Vec<_>>()
    });
    let wrong = wrong.concat();
    assert!(wrong.is_empty(), "they pass, or do not and should:\n{}", wrong.join("\n"));
}
