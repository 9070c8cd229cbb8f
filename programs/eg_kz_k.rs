//! EG_KZ_K: the pointer of the mouse driver, made of two masks (chapter 1.4): first the four combinations
//! of mask bits, then a face whose eyes are shut by the mouse buttons.

use super::groups;
use crate::cursor::{self, Action, Ground, LEAVE, MOVE};
use crate::machine::{Asked, Button, Key, Machine, Manner, Mouse, Pointer};
use crate::screen::{HEIGHT, Masks, Screen, WIDTH};
use crate::ui::{
    Area, Command, CommandLine, Commands, Demo, Desk, KeyHelp, Lesson, Manual, Program, Words, line,
    without_document,
};
use serde::Serialize;

const POINTER: KeyHelp =
    (Words("egér, nyilak", "mouse, arrows"), Words("a kurzor mozgatása", "move the pointer"));
const WINK: KeyHelp = (Words("egérgombok", "mouse buttons"), Words("2. rész: kacsintás", "part 2: wink"));
const NEXT: KeyHelp =
    line("Enter", "1. rész: tovább; ma bármely más billentyű is", "part 1: go on; today any other key too");
const OTHERS: KeyHelp = (Words("bármi más", "any other"), Words("2. rész: vége", "part 2: end"));

pub(super) const COMMANDS: Commands<Action> = Commands(&[
    Command { help: Some(POINTER), ..MOVE[0] },
    MOVE[1],
    MOVE[2],
    MOVE[3],
    Command::told(WINK),
    Command::key(Key::Enter, NEXT, Action::Next),
    LEAVE,
    Command::told(OTHERS),
]);

const MANUAL: Manual = Manual {
    name: "eg_kz_k",
    about: Words("Az egérkurzor két maszkja", "The two masks of the mouse pointer"),
    intro: Words(
        "Az egérkurzor, ahogy az egérkezelő két 16x16 bites maszkból kirajzolja. Vigye végig a színeken, \
         aztán Enter után nyomja meg az egérgombokat: az arc kacsint. A képernyőmaszk megtartja vagy \
         törli a hátteret, a kurzormaszk átfordít: ez négyféle képpont.",
        "The mouse pointer as the driver draws it, by two masks of 16x16 bits. Move it over the colours; \
         then press Enter and the mouse buttons, and the face winks. The screen mask keeps or clears the \
         background, the cursor mask flips bits: that makes four kinds of pixels.",
    ),
    keys: &COMMANDS.help::<{ COMMANDS.lines() }>(),
    lesson: &[
        Lesson::Line(Words(
            "Az egérkezelő a kurzor minden képpontján ezt végzi el:",
            "The mouse driver does this to every pixel c under the pointer:",
        )),
        Lesson::Line(Words(
            "    c' = (c AND képernyőmaszk) XOR kurzormaszk",
            "    c' = (c AND screen mask) XOR cursor mask",
        )),
        Lesson::Line(Words(
            "A maszkok 16x16 bitesek; egy bit a szín mind a négy bitjére hat.",
            "The masks have 16x16 bits; each bit acts on all four bits of c.",
        )),
        Lesson::Pointer,
        Lesson::Masks(&FACES[0]),
    ],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "1.4",
    group: &groups::CURSORS,
    opens: &[],
    demo: Demo { file: "", script: "move 320 240", motion: None },
    start: |document| without_document(document, |machine| Box::pin(run(machine))),
    command_line: CommandLine::Usual,
};

/// Where the mouse may go; the edges belong to it.
const RANGE: Area = Area::new(2, 2, 638, 478);
/// The hot spot of all masks here: their middle.
const HOT: (i32, i32) = (8, 8);

/// The four combinations of mask bits, a quarter each: black and white above, the screen's own and its
/// inverse colours below.
static QUARTERS: Masks = Masks {
    screen: [0, 0, 0, 0, 0, 0, 0, 0, !0, !0, !0, !0, !0, !0, !0, !0],
    cursor: [0x00FF; 16],
    hot: HOT,
};

/// The face with both eyes open, the left one shut (on the viewer's left), the right one, both.
static FACES: [Masks; 4] =
    [face(0x33CC, 0x2DB4), face(0x3FCC, 0x3FB4), face(0x33FC, 0x2DFC), face(0x3FFC, 0x3FFC)];

/// The masks of the face by the two rows of its cursor mask with the eyes.
const fn face(brows: u16, eyes: u16) -> Masks {
    Masks {
        screen: [
            0xFC3F, 0xF00F, 0xE007, 0xC003, 0x8001, 0x8001, 0x0000, 0x0000, 0x0000, 0x0000, 0x8001, 0x8001,
            0xC003, 0xE007, 0xF00F, 0xFC3F,
        ],
        cursor: [
            0x0000, 0x03C0, 0x0FF0, 0x1FF8, brows, eyes, 0x6DB6, 0x73CE, 0x7FFE, 0x7FFE, 0x37EC, 0x3BDC,
            0x1C38, 0x0FF0, 0x03C0, 0x0000,
        ],
        hot: HOT,
    }
}

/// The two parts of the program.
#[derive(Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
enum Part {
    Quarters,
    Face,
}

impl Part {
    fn screen(self) -> Screen {
        match self {
            Part::Quarters => cursor::patchwork(40, 17, 1),
            Part::Face => cursor::patchwork(4, 163, 0),
        }
    }

    /// What can be done, by mouse and by keys.
    fn hint(self) -> [Words; 2] {
        match self {
            Part::Quarters => {
                [Words(
                    "Vigye az egérrel, nyilakkal. F1 súgó, Esc vége, más billentyű: tovább",
                    "Move it by mouse or arrows. F1 help, Esc end, other keys go on",
                ); 2]
            }
            Part::Face => [
                Words(
                    "Nyomja meg az egérgombokat: kacsint. F1 súgó, más billentyű: vége",
                    "Press the mouse buttons: it winks. F1 help, other keys end",
                ),
                Words(
                    "Ctrl+szóköz, Alt+R: kacsint. F1 súgó, más billentyű: vége",
                    "Ctrl+Space, Alt+R: it winks. F1 help, other keys end",
                ),
            ],
        }
    }

    fn masks(self, mouse: Mouse) -> &'static Masks {
        let [open, left, right, both] = &FACES;
        match (self, mouse.holds(Button::Left), mouse.holds(Button::Right)) {
            (Part::Quarters, ..) => &QUARTERS,
            (Part::Face, false, false) => open,
            (Part::Face, true, false) => left,
            (Part::Face, false, true) => right,
            (Part::Face, true, true) => both,
        }
    }

    /// Whether a key ends this part: any key, except those that move the pointer and those with a meaning in every
    /// program. In the original only Enter ends the first part, although the text has any key do so.
    fn ends(self, manner: Manner, key: Option<Key>, action: Option<Action>) -> bool {
        match (key, action) {
            _ if self == Part::Quarters && manner == Manner::Original => action == Some(Action::Next),
            (None | Some(Key::F(_)), _) | (_, Some(Action::Move(..))) => false,
            (Some(_), _) => true,
        }
    }
}

/// What is shown, for `dump`.
#[derive(Serialize)]
struct Model {
    part: Part,
    x: i32,
    y: i32,
    left_shut: bool,
    right_shut: bool,
}

async fn run(machine: &mut Machine) -> Asked<()> {
    let ended = both_parts(&mut Desk::new(machine, MANUAL)).await;
    machine.set_pointer(Pointer::Shown(&Masks::ARROW));
    ended
}

async fn both_parts(desk: &mut Desk<'_>) -> Asked<()> {
    desk.machine.put_mouse(WIDTH / 2, HEIGHT / 2);
    for part in [Part::Quarters, Part::Face] {
        let background = part.screen();
        loop {
            let mouse = desk.machine.mouse();
            desk.machine.set_pointer(Pointer::Shown(part.masks(mouse)));
            let [left_shut, right_shut] =
                [Button::Left, Button::Right].map(|button| part == Part::Face && mouse.holds(button));
            desk.machine.publish(Model { part, x: mouse.x, y: mouse.y, left_shut, right_shut });
            let ground = Ground { screen: &background, cursor: (mouse.x, mouse.y), hint: part.hint() };
            let tick = desk.event(&ground).await?;
            let action = COMMANDS.find(&tick);
            if action == Some(Action::End) {
                return Ok(());
            }
            if part.ends(desk.machine.manner(), tick.key(), action) {
                break;
            }
            let (x, y) = cursor::place(tick.mouse, action, RANGE);
            desk.machine.put_mouse(x, y);
        }
    }
    Ok(())
}
