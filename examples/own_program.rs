//! A program of your own on this machine: Pascal's triangle, as deep as the user wants it. The guide
//! `docs/own_program.md` explains it step by step.
//!
//!     cargo run --example own_program
//!     cargo run --example own_program -- --display terminal

use grafika::machine::{Asked, Key, Language, Machine};
use grafika::programs::groups;
use grafika::screen::{Color, Screen};
use grafika::ui::{Area, CommandLine, Demo, Desk, Manual, Picture, Program, Words, sunken, without_document};
use serde::Serialize;
use std::process::ExitCode;

const MANUAL: Manual = Manual {
    name: "own_program",
    about: Words("Pascal háromszöge", "Pascal's triangle"),
    intro: Words(
        "Pascal háromszöge, a maradékok szerint színezve. M a modulust, Fel és Le a sorok számát változtatja. Modulo 2 \
         Sierpiński háromszöge látszik.",
        "Pascal's triangle, coloured by remainders. M changes the modulus, Up and Down the number of rows. Modulo 2 \
         shows the triangle of Sierpiński.",
    ),
    keys: &[
        (Words("Fel Le", "Up Down"), Words("kevesebb, több sor", "fewer, more rows")),
        (Words("M", "M"), Words("maradékok modulo 2, 3, ... 7", "remainders modulo 2, 3, ... 7")),
        (Words("Q", "Q"), Words("vége", "end")),
    ],
    lesson: &[],
};

const PROGRAM: Program = Program {
    manual: MANUAL,
    chapter: "4",
    group: &groups::GAMES,
    opens: &[],
    demo: Demo { file: "", script: "", motion: None },
    start: |document| without_document(document, |machine| Box::pin(run(machine))),
    command_line: CommandLine::Usual,
};

fn main() -> ExitCode {
    PROGRAM.main()
}

/// Everything that the program knows.
#[derive(Clone, Copy, Serialize)]
struct Triangle {
    rows: i32,
    modulus: u32,
}

const MOST_ROWS: i32 = 100;
const FIELD: Area = Area::new(20, 40, 619, 459);

impl Picture for Triangle {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::LightCyan);
        screen.bar(FIELD.x1, FIELD.y1, FIELD.x2, FIELD.y2, Color::Black);
        sunken(screen, FIELD, 4);
        let words = Words("sor, modulo", "rows, modulo").of(language);
        screen.text(20, 16, &format!("{} {words} {}", self.rows, self.modulus), Color::Black);
        let mut row = vec![1_u32];
        for n in 0..self.rows {
            for (k, number) in (0..).zip(&row) {
                let (x, y) = (320 + 4 * k - 2 * n, 50 + 4 * n);
                screen.bar(x, y, x + 2, y + 2, Color::from_index((number % 16) as u8));
            }
            row = self.below(&row);
        }
    }
}

impl Triangle {
    /// The row below another one: sums of neighbours, modulo.
    fn below(&self, row: &[u32]) -> Vec<u32> {
        let left = std::iter::once(0).chain(row.iter().copied());
        let right = row.iter().copied().chain(std::iter::once(0));
        left.zip(right).map(|(a, b)| (a + b) % self.modulus).collect()
    }
}

async fn run(machine: &mut Machine) -> Asked<()> {
    let mut desk = Desk::new(machine, MANUAL);
    let mut triangle = Triangle { rows: 64, modulus: 2 };
    loop {
        desk.machine.publish(triangle);
        let tick = desk.event(&triangle).await?;
        match tick.key() {
            Some(Key::Up) => triangle.rows = (triangle.rows - 1).max(1),
            Some(Key::Down) => triangle.rows = (triangle.rows + 1).min(MOST_ROWS),
            _ => match tick.letter() {
                Some('M') => triangle.modulus = triangle.modulus % 7 + 1,
                Some('Q') => return Ok(()),
                _ => {}
            },
        }
        triangle.modulus = triangle.modulus.max(2);
    }
}
