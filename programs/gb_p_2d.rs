//! GB_P_2D: plane curves by Fourier coefficients (chapter 2.2). All of it is the Fourier editor.

use super::groups;
use crate::editor::fourier;
use crate::file::Format;
use crate::ui::{CommandLine, Demo, Manual, Program, Words};

const MANUAL: Manual = Manual {
    name: "gb_p_2d",
    about: Words("Síkgörbék Fourier-együtthatókkal", "Plane curves by Fourier coefficients"),
    intro: Words(
        "Zárt görbe húsz harmonikus összegeként, külön x-ben és y-ban. Válasszon ablakot a Tabbal, nyomja \
         meg a Fel nyilat: a görbe azonnal változik. Az a és b amplitúdó, a p és q fázis (pi egységben): \
         az alacsony harmonikusok adják az alakot, a magasak a részleteket.",
        "A closed curve as the sum of twenty harmonics, in x and in y. Choose a window with Tab, press \
         Up, and the curve changes at once. a and b are amplitudes, p and q phases in units of pi: low \
         harmonics give the curve its shape, high ones its details.",
    ),
    keys: fourier::KEYS,
    lesson: &[],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "2.2",
    group: &groups::PLANE_CURVES,
    opens: &[Format::Gbp],
    demo: Demo { file: "A.GBP", script: "key E", motion: None },
    start: |document| fourier::start(MANUAL, document),
    command_line: CommandLine::Usual,
};
