//! The programs: what each has of its own, and the list of them all. A program is a file here, a line in
//! [`ALL`], and a `main` of one line in `programs/bin/`.

pub mod alakpar;
pub mod biliard;
pub mod burkolo;
pub mod csango_k;
pub mod csav_gy;
pub mod csomo;
pub mod eg_kz_k;
pub mod f_em_spl;
pub mod f_p_bets;
pub mod f_p_bezr;
pub mod f_p_bspl;
pub mod f_p_herm;
pub mod f_p_hspl;
pub mod f_p_spln;
pub mod gb_2d_bt;
pub mod gb_2d_ch;
pub mod gb_2d_ip;
pub mod gb_3d_bt;
pub mod gb_3d_ip;
pub mod gb_p_2d;
pub mod gr_kz_o;
pub mod gr_kz_x;
pub mod groups;
pub mod gyongy_k;
pub mod kc_ter;
pub mod menu;
pub mod ph_gorbe;
pub mod pn_felul;
mod puzzles;
pub mod som_fel;
#[cfg(feature = "native")]
pub mod telepit;
pub mod vjs;
pub mod zm_betsp;
pub mod zm_bspl;
pub mod zm_hspl;
pub mod zm_spln;
pub mod zy_betsp;
pub mod zy_bspl;
pub mod zy_hspl;
pub mod zy_spln;

use crate::file::Format;
use crate::ui::Program;

/// Every program, in the order of the book.
pub const ALL: &[Program] = &[
    gr_kz_x::PROGRAM,
    gr_kz_o::PROGRAM,
    eg_kz_k::PROGRAM,
    vjs::PROGRAM,
    gb_p_2d::PROGRAM,
    gb_2d_ch::PROGRAM,
    gb_2d_ip::PROGRAM,
    gb_2d_bt::PROGRAM,
    gb_3d_ip::PROGRAM,
    gb_3d_bt::PROGRAM,
    csav_gy::PROGRAM,
    f_p_herm::PROGRAM,
    f_p_spln::PROGRAM,
    f_em_spl::PROGRAM,
    f_p_bezr::PROGRAM,
    f_p_bspl::PROGRAM,
    f_p_bets::PROGRAM,
    f_p_hspl::PROGRAM,
    zm_spln::PROGRAM,
    zm_bspl::PROGRAM,
    zm_betsp::PROGRAM,
    zm_hspl::PROGRAM,
    zy_spln::PROGRAM,
    zy_bspl::PROGRAM,
    zy_betsp::PROGRAM,
    zy_hspl::PROGRAM,
    kc_ter::PROGRAM,
    ph_gorbe::PROGRAM,
    pn_felul::PROGRAM,
    csomo::PROGRAM,
    alakpar::PROGRAM,
    som_fel::PROGRAM,
    burkolo::PROGRAM,
    biliard::PROGRAM,
    gyongy_k::PROGRAM,
    csango_k::PROGRAM,
    #[cfg(feature = "native")]
    telepit::PROGRAM,
];

/// The program of a name, in whatever case.
pub fn by_name(name: &str) -> Option<&'static Program> {
    ALL.iter().find(|program| program.manual.name.eq_ignore_ascii_case(name))
}

/// The program that files of a format belong to.
pub fn of_format(format: Format) -> Option<&'static Program> {
    ALL.iter().find(|program| program.opens.contains(&format))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machine::Language;

    #[test]
    fn programs_have_names_of_their_own_and_stand_in_the_chapters_of_their_groups() {
        for (at, program) in ALL.iter().enumerate() {
            let name = program.manual.name;
            assert!(ALL[..at].iter().all(|earlier| earlier.manual.name != name), "{name}");
            assert!(groups::GROUPS.contains(&program.group), "{name}");
            assert!(program.chapter.starts_with(program.group.chapter), "{name}: {}", program.chapter);
        }
    }

    #[test]
    fn no_key_has_two_meanings() {
        assert_eq!([vjs::COMMANDS.shared_keys(), eg_kz_k::COMMANDS.shared_keys()].concat(), []);
    }

    #[test]
    fn every_program_is_introduced_and_its_help_page_fits() {
        for program in ALL {
            let name = program.manual.name;
            for language in [Language::Hungarian, Language::English] {
                assert_eq!(program.manual.misfits(language), [""; 0], "{name}");
                assert!(program.manual.tells_what_is_seen(language), "{name}");
                let intro = program.manual.intro.of(language);
                let sentences = intro.split_inclusive(['.', '!']).filter(|it| it.len() > 8).count();
                assert!(sentences >= 3, "{name}: {intro}");
            }
        }
    }

    #[test]
    fn every_format_belongs_to_a_program() {
        // Rational curves and patches are made for other programs; `grafika render` shows them.
        let made = |format: Format| [Format::Rbc, Format::Rbs].contains(&format);
        let opened = Format::ALL.iter().filter(|&&format| !made(format));
        assert!(opened.into_iter().all(|&format| of_format(format).is_some()));
    }
}
