//! How fast the spaces of the thesis's table 3.1 are computed, beside the thesis's own times.

use super::studio::Studio;
use super::texts;
use crate::geometry::ec::{EcBasis, Space};
use crate::geometry::{Basis, Blend, ParamCurve, Weave};
use crate::machine::{Asked, Key, Language};
use crate::screen::{Color, Screen};
use crate::ui::{Desk, Picture};
use std::f64::consts::FRAC_PI_2;
use std::time::Duration;

/// A row of the table: space, roots, interval, and the thesis's milliseconds for 1000 points of a curve and 50 x 50 of a
/// surface.
const ROWS: [(&str, &str, f64, [f64; 2]); 6] = [
    ("P5", "0^6", 1.0, [4.164, 8.582]),
    ("P11", "0^12", 1.0, [22.887, 47.753]),
    ("T11", "0,i,2i,3i,4i,5i", FRAC_PI_2, [24.204, 126.817]),
    ("AT13", "0,i^3,2i^3", FRAC_PI_2, [66.364, 534.541]),
    ("AE10", "0,1^3,2^3,3^3", 1.0, [52.468, 222.778]),
    ("AET13", "0,1+i^2,1+2i^2,2+i^2", 1.0, [195.819, 4044.96]),
];

/// A measurement lasts at least so long.
const LONG: Duration = Duration::from_millis(60);

struct Page {
    /// Milliseconds of the set-up, of the curve and of the surface.
    measured: Vec<[f64; 3]>,
}

impl Picture for Page {
    fn draw(&self, screen: &mut Screen, language: Language) {
        screen.clear(Color::Black);
        screen.text(40, 40, texts::TIMES.of(language), Color::Yellow);
        let header = match language {
            Language::Hungarian => "tér      előkészítés   1000 görbepont        50x50 felületpont",
            Language::English => "space         set-up   1000 curve points     50x50 surface points",
        };
        screen.text(40, 70, header, Color::LightCyan);
        for (row, (name, _, _, thesis)) in ROWS.iter().enumerate() {
            let y = 90 + 18 * i32::try_from(row).unwrap_or(0);
            let text = match self.measured.get(row) {
                Some([setup, curve, surface]) => format!(
                    "{name:<8} {setup:>11.3}   {curve:>8.3} ({:>8.3})   {surface:>8.3} ({:>8.3})",
                    thesis[0], thesis[1]
                ),
                None => format!("{name:<8} ..."),
            };
            screen.text(40, y, &text, Color::White);
        }
        screen.text(40, 440, "Esc", Color::LightGray);
    }
}

/// Measures row after row, and shows the page until Esc.
///
/// # Errors
/// [`Stop::Closed`](crate::machine::Stop::Closed) when the display is being closed.
pub(super) async fn measure(studio: &mut Studio, desk: &mut Desk<'_>) -> Asked<()> {
    let _ = studio;
    let mut page = Page { measured: Vec::new() };
    let rows = if runs(desk, &page).await? { &ROWS[..] } else { &[] };
    for &(_, roots, end, _) in rows {
        let Ok(space) = roots.parse::<Space>() else { continue };
        let Ok(basis) = EcBasis::new(&space, [0.0, end]) else { continue };
        let count = basis.points();
        let zigzag: Vec<[f64; 3]> = (0..count).map(|k| [k as f64, (k % 3) as f64, (k % 4) as f64]).collect();
        let Ok(curve) = Blend::new(&basis, zigzag.clone()) else { continue };
        let Ok(surface) = Weave::new(&basis, &basis, vec![zigzag; count]) else { continue };
        let setup = || drop(EcBasis::formal(&space, [0.0, end]));
        let points = || drop(curve.polyline(999));
        let mesh = || drop(surface.mesh([49, 49]));
        let works: [&dyn Fn(); 3] = [&setup, &points, &mesh];
        let mut times = [0.0; 3];
        for (time, work) in times.iter_mut().zip(works) {
            let Some(measured) = timed(desk, &page, work).await? else { return Ok(()) };
            *time = measured;
        }
        page.measured.push(times);
    }
    while !matches!(desk.event(&page).await?.key(), Some(Key::Esc | Key::Enter)) {}
    Ok(())
}

/// Whether the clock runs while something is computed: in a script time is virtual, and nothing can be measured.
async fn runs(desk: &mut Desk<'_>, page: &Page) -> Asked<bool> {
    let begun = desk.machine.now();
    let heaviest = ROWS.last().and_then(|(_, roots, end, _)| Some((roots.parse::<Space>().ok()?, *end)));
    if let Some((space, end)) = heaviest {
        (0..4).for_each(|_| drop(EcBasis::formal(&space, [0.0, end])));
    }
    desk.event_before(page, begun).await?;
    Ok(desk.machine.now() > begun)
}

/// The milliseconds of some work, repeated until it takes long enough; `None` after Esc.
async fn timed(desk: &mut Desk<'_>, page: &Page, work: &dyn Fn()) -> Asked<Option<f64>> {
    let mut times = 1_u32;
    loop {
        let begun = desk.machine.now();
        (0..times).for_each(|_| work());
        let tick = desk.event_before(page, begun).await?;
        if tick.pressed(Key::Esc) {
            return Ok(None);
        }
        let taken = desk.machine.now().saturating_sub(begun);
        if taken >= LONG || times >= 1 << 12 {
            return Ok(Some(taken.as_secs_f64() * 1000.0 / f64::from(times)));
        }
        times *= 4;
    }
}
