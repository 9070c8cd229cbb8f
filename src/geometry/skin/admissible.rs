//! Admissible circles, and the nearest ones by shrinking.

use super::rules::{Violation, covered_discs, violations};
use super::{Ball, Circles};

/// By which radii shrink in a step.
const STEP: f64 = 0.98;
/// Steps after which radii are below a billionth of a billionth of what they were.
const STEPS: usize = 2100;

impl Circles {
    /// The rules of definition 2.14 that the circles break, in the order of their numbers; none if they are
    /// admissible. (1) No disc is part of the union of the others. (2) Discs three or more places apart are disjoint;
    /// in a tree, all but neighbours. (3) The two neighbours of a circle of a chain or ring meet only inside it; in
    /// a ring of three, where all are neighbours, the three have no point in common. Discs are closed; all comparisons
    /// allow for 1e-12 of the largest coordinate or radius.
    #[must_use]
    pub fn violations(&self) -> Vec<Violation> {
        let circles = self.circles();
        let covered = |meeting: &[Vec<usize>], e| covered_discs(circles, meeting, e);
        violations(circles, self.links(), covered, |three| three.map(|circle| *circle))
    }

    /// Whether the circles are admissible.
    #[must_use]
    pub fn is_admissible(&self) -> bool {
        self.violations().is_empty()
    }

    /// Admissible circles with the same centres: in every step the discs that break a rule shrink by 2 %. Where one is
    /// covered, those that meet it do; where two meet, both. `None` where no radii are admissible, as with equal
    /// centres.
    #[must_use]
    pub fn nearest_admissible(&self) -> Option<Circles> {
        let shrunk = shrunk(self.circles(), |circles| {
            let new = Self::new(circles.to_vec(), self.links().clone()).ok()?;
            Some(new.violations())
        })?;
        Self::new(shrunk, self.links().clone()).ok()
    }
}

/// Balls with the same centres and smaller radii that break no rule.
pub(super) fn shrunk<const D: usize>(
    balls: &[Ball<D>],
    violations: impl Fn(&[Ball<D>]) -> Option<Vec<Violation>>,
) -> Option<Vec<Ball<D>>> {
    let mut balls = balls.to_vec();
    let e = super::tolerance(&balls);
    let apart = |(i, ball): (usize, &Ball<D>)| {
        balls.iter().skip(i + 1).all(|other| ball.distance(other.center) > 2.0 * e)
    };
    if !balls.iter().enumerate().all(apart) {
        return None;
    }
    for _ in 0..STEPS {
        let found = violations(&balls)?;
        if found.is_empty() {
            return Some(balls);
        }
        let mut shrinks = vec![false; balls.len()];
        for violation in found {
            match violation {
                Violation::Covered { number } => {
                    let Some(covered) = balls.get(number).copied() else { continue };
                    for (index, ball) in balls.iter().enumerate() {
                        shrinks[index] |= index != number && ball.meets(&covered, e);
                    }
                }
                Violation::Meet { numbers } | Violation::MeetOutside { numbers, .. } => {
                    numbers.into_iter().for_each(|number| shrinks[number] = true);
                }
                Violation::NoHole { numbers } => {
                    numbers.into_iter().for_each(|number| shrinks[number] = true);
                }
            }
        }
        for (ball, _) in balls.iter_mut().zip(shrinks).filter(|(_, shrinks)| *shrinks) {
            ball.radius *= STEP;
        }
    }
    None
}
