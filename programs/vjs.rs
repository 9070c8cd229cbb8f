//! VJS: the virtual joystick (chapter 1.5.2). A stick is dragged with the mouse in its square and gives a
//! point on its track the acceleration; numbers tell time, place, velocity and acceleration.

mod motion;
mod panel;

use super::groups;
use crate::machine::{Asked, Button, Key, Machine, Mouse, Tick};
use crate::ui::{
    Command, CommandLine, Commands, Demo, Desk, KeyHelp, Lesson, Manual, Program, Words, line,
    without_document,
};
use motion::{Motion, STEPS_PER_SECOND};
use panel::{HANDLE_RADIUS, Panel, STICK};
use serde::Serialize;
use std::time::Duration;

/// What a command does.
#[derive(Clone, Copy)]
pub(super) enum Action {
    Tilt(i32, i32),
    Upright,
    Restart,
    Back,
    End,
}

const DRAG: KeyHelp = (
    Words("egér", "mouse"),
    Words("a fogantyú húzása; elengedve visszaugrik", "drag the stick; released, it springs back"),
);
const TILT_IT: KeyHelp = (Words("nyilak", "arrows"), Words("a fogantyú döntése", "tilt the stick"));
const UPRIGHT: KeyHelp = line("Home", "a fogantyú középre", "stick upright");
const RESTART: KeyHelp = (Words("szóköz", "space"), Words("minden az elejéről", "start again"));
const END: KeyHelp = line("Q Esc", "kilépés", "quit");

pub(super) const COMMANDS: Commands<Action> = Commands(&[
    Command::told(DRAG),
    Command::key(Key::Left, TILT_IT, Action::Tilt(-TILT_STEP, 0)),
    Command::also(Key::Right, Action::Tilt(TILT_STEP, 0)),
    Command::also(Key::Up, Action::Tilt(0, TILT_STEP)),
    Command::also(Key::Down, Action::Tilt(0, -TILT_STEP)),
    Command::key(Key::Home, UPRIGHT, Action::Upright),
    Command::key(Key::Char(' '), RESTART, Action::Restart),
    Command::key(Key::Char('Q'), END, Action::End),
    Command::also(Key::Esc, Action::Back),
]);

const MANUAL: Manual = Manual {
    name: "vjs",
    about: Words("Virtuális joystick: gyorsulás egérrel", "A virtual joystick: acceleration by mouse"),
    intro: Words(
        "Egy joystick az egérrel: a fogantyú egy pont gyorsulását adja meg. Húzza ki a fogantyút, \
         figyelje a számokat, aztán engedje el. Állandó gyorsulásnál a sebesség egyenletesen, az út az \
         idő négyzetével nő; elengedve a pont megtartja a sebességét, és visszapattan a falról.",
        "A joystick made of the mouse: its stick gives a point its acceleration. Drag the stick, watch \
         the numbers, then let go. Under a constant acceleration the velocity grows evenly, the distance \
         with the square of time; let go, the point keeps its velocity until a wall.",
    ),
    keys: &COMMANDS.help::<{ COMMANDS.lines() }>(),
    lesson: &[
        Lesson::Line(Words(
            "A fogantyú helye a pont gyorsulása, a. Minden tau időlépésben (1.1):",
            "The stick gives the point its acceleration a. Every step of time tau:",
        )),
        Lesson::Line(Words(
            "    v = v0 + a tau        x = x0 + (v0 + v) tau / 2",
            "    v = v0 + a tau        x = x0 + (v0 + v) tau / 2        (1.1)",
        )),
        Lesson::Line(Words(
            "külön x és y irányban. Falnál a sebesség rá merőleges összetevője",
            "in x and y apart. At a wall the component of the velocity across it",
        )),
        Lesson::Line(Words("előjelet vált, az energia megmarad.", "turns round, and the energy is kept.")),
    ],
};

/// The program.
pub const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "1.5.2",
    group: &groups::CURSORS,
    opens: &[],
    demo: Demo { file: "", script: "key Up\nkey Up\nkey Left", motion: None },
    start: |document| without_document(document, |machine| Box::pin(run(machine))),
    command_line: CommandLine::Usual,
};

/// Largest displacement of the handle from the middle of its square, in pixels.
const TILT: i32 = 40;
/// Displacement by an arrow key, in pixels.
const TILT_STEP: i32 = 5;

/// The stick and the point that it drives.
#[derive(Default)]
struct Joystick {
    motion: Motion,
    /// Offset of the handle from the middle of its square, in pixels; x to the right, y upwards.
    handle: (i32, i32),
    held: bool,
    /// When the motion began, by the desk's clock.
    begun: Duration,
}

/// The joystick for `dump`.
#[derive(Serialize)]
struct Model {
    #[serde(flatten)]
    motion: motion::Model,
    handle: (i32, i32),
    held: bool,
}

impl Joystick {
    /// Advances the motion to a moment of the desk's clock. Returns the fraction of the next step that has passed by
    /// then, 0 to 1.
    fn run_to(&mut self, now: Duration) -> f64 {
        let step = Duration::from_secs(1) / STEPS_PER_SECOND;
        let time = now.saturating_sub(self.begun).as_nanos();
        let steps = u64::try_from(time / step.as_nanos()).unwrap_or(u64::MAX);
        self.motion.run_to(steps);
        (time % step.as_nanos()) as f64 / step.as_nanos() as f64
    }

    fn tilt(&mut self, x: i32, y: i32) {
        self.handle = (x.clamp(-TILT, TILT), y.clamp(-TILT, TILT));
        self.motion.acceleration = [f64::from(self.handle.0), f64::from(self.handle.1)];
    }

    fn let_go(&mut self) {
        self.held = false;
        self.tilt(0, 0);
    }

    /// Whether a pixel of the screen is on the handle.
    fn is_on_handle(&self, (x, y): (i32, i32)) -> bool {
        let (dx, dy) = (x - STICK.0 - self.handle.0, STICK.1 - self.handle.1 - y);
        dx * dx + dy * dy <= HANDLE_RADIUS * HANDLE_RADIUS
    }

    /// The handle follows the mouse that holds it.
    fn follow(&mut self, tick: &Tick) {
        if tick.click().is_some_and(|place| self.is_on_handle(place)) {
            self.held = true;
        }
        let Mouse { x, y, .. } = tick.mouse;
        match (self.held, tick.mouse.holds(Button::Left)) {
            (true, true) => self.tilt(x - STICK.0, STICK.1 - y),
            (true, false) => self.let_go(),
            (false, _) => {}
        }
    }
}

async fn run(machine: &mut Machine) -> Asked<()> {
    machine.put_mouse(STICK.0, STICK.1);
    let mut desk = Desk::new(machine, MANUAL);
    let mut panel = Panel::new();
    let mut joystick = Joystick { begun: desk.clock(), ..Joystick::default() };
    loop {
        let part = joystick.run_to(desk.clock());
        desk.machine.publish(Model {
            motion: joystick.motion.model(),
            handle: joystick.handle,
            held: joystick.held,
        });
        let stick = (joystick.handle, joystick.held);
        panel.show(joystick.motion.place(part), stick, joystick.motion.readings());
        let tick = desk.frame(&panel).await?;
        joystick.run_to(desk.clock());
        joystick.follow(&tick);
        let (x, y) = joystick.handle;
        match COMMANDS.find(&tick) {
            Some(Action::Back) if joystick.held => joystick.let_go(),
            Some(Action::Back | Action::End) => return Ok(()),
            Some(Action::Restart) => joystick = Joystick { begun: desk.clock(), ..Joystick::default() },
            // While the mouse holds the handle, keys do not move it.
            Some(Action::Tilt(dx, dy)) if !joystick.held => joystick.tilt(x + dx, y + dy),
            Some(Action::Upright) if !joystick.held => joystick.tilt(0, 0),
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn no_key_has_two_meanings() {
        assert_eq!(super::COMMANDS.shared_keys(), []);
        assert_eq!(super::COMMANDS.too_wide(), [""; 0]);
    }
}
