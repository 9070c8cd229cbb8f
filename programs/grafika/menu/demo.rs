//! What every program shows in its small picture of the menu.

use grafika::machine::Key;

/// How a program is brought to show what it is for.
pub(super) struct Demo {
    /// The program's name.
    pub(super) name: &'static str,
    /// The built-in sample that it opens; empty for none.
    pub(super) file: &'static str,
    /// The script that leads to the picture.
    pub(super) script: &'static str,
    /// The key that it gets at every step while the program is chosen. Programs that move by themselves need
    /// none.
    pub(super) motion: Option<Key>,
}

const fn demo(name: &'static str, file: &'static str, script: &'static str, motion: Option<Key>) -> Demo {
    Demo { name, file, script, motion }
}

/// The closed or open spline of a curve editor, without the editor.
const CURVE: &str = "type gn3\nkey E\nkey N";
/// A filled surface without the editor.
const SURFACE: &str = "type ftet";
/// The same where the degree is asked for.
const CUBIC: &str = "type f3tet";
/// One step around.
const TURN: Option<Key> = Some(Key::Left);

/// Every program in the order of the book.
pub(super) const DEMOS: &[Demo] = &[
    demo("gr_kz_x", "", "move 320 240", Some(Key::Right)),
    demo("gr_kz_o", "", "move 320 240", Some(Key::Right)),
    demo("eg_kz_k", "", "move 320 240", None),
    demo("vjs", "", "key Up\nkey Up\nkey Left", None),
    demo("gb_p_2d", "A.GBP", "key E", None),
    demo("gb_2d_ch", "A.IC2", "key N\ntype gz\nkey N\nkey E\nkey N", None),
    demo("gb_2d_ip", "A.IP2", "type gz3\nkey E\nkey N", None),
    demo("gb_2d_bt", "B.IP2", "type gz\nkey E\nkey N", None),
    demo("gb_3d_ip", "A.IP3", CURVE, TURN),
    demo("gb_3d_bt", "B.IP3", "type gn\nkey E\nkey N", TURN),
    demo("csav_gy", "", "key T", TURN),
    demo("f_p_herm", "A.FHC", SURFACE, TURN),
    demo("f_p_spln", "A.FPS", SURFACE, TURN),
    demo("f_em_spl", "A.FEM", "type fe", TURN),
    demo("f_p_bezr", "A.FPB", SURFACE, TURN),
    demo("f_p_bspl", "A.FBS", CUBIC, TURN),
    demo("f_p_bets", "Z.FBS", SURFACE, TURN),
    demo("f_p_hspl", "A.FPS", SURFACE, TURN),
    demo("zm_spln", "A.ZMS", SURFACE, TURN),
    demo("zm_bspl", "K1.ZMB", CUBIC, TURN),
    demo("zm_betsp", "K2.ZMB", SURFACE, TURN),
    demo("zm_hspl", "B.ZMS", SURFACE, TURN),
    demo("zy_spln", "A.ZYS", SURFACE, TURN),
    demo("zy_bspl", "A.ZYB", CUBIC, TURN),
    demo("zy_betsp", "A.ZYB", SURFACE, TURN),
    demo("zy_hspl", "A.ZYS", SURFACE, TURN),
    demo("biliard", "", "drag 60 240 560 246", None),
    demo("gyongy_k", "", "key T\nkey A\nkey K", None),
    demo("csango_k", "A.CSK", "", TURN),
    demo("telepit", "", "", None),
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::PROGRAMS;

    #[test]
    fn every_program_has_its_picture() {
        let named: Vec<&str> = DEMOS.iter().map(|demo| demo.name).collect();
        let known: Vec<&str> = PROGRAMS.iter().map(|program| program.manual.name).collect();
        assert_eq!(named, known);
    }
}
