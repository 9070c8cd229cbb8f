//! The same curve with a higher degree.

use super::local::{Hom, blossom};
use super::{KnotCurve, KnotError, KnotVector, MAX_ORDER};

impl<const D: usize> KnotCurve<D> {
    /// The same curve with an order higher by one: every knot of the domain is there once more, and the control
    /// points are means of blossoms (Ramshaw 1987). Outside the domain as many knots are kept as the order needs.
    ///
    /// # Errors
    /// [`KnotError::OrderNeeded`] for the largest order.
    pub fn elevated(&self) -> Result<Self, KnotError> {
        let (old, order) = (self.vector(), self.vector().order() + 1);
        if order > MAX_ORDER {
            let given = old.order();
            return Err(KnotError::OrderNeeded { given, least: super::MIN_ORDER, most: MAX_ORDER - 1 });
        }
        let vector = match old.breaks() {
            Some(breaks) => {
                // The last break is the first again, and comes once.
                let last = breaks[breaks.len() - 1];
                let mut all = raised(&breaks[..breaks.len() - 1], |u| u != last);
                all.push(last);
                KnotVector::closed(order, &all)?
            }
            None => KnotVector::new(order, self.open_knots(order))?,
        };
        let count = vector.controls() - if old.breaks().is_some() { order - 1 } else { 0 };
        let points: Option<Vec<Hom<D>>> = (0..count)
            .map(|i| {
                // A function of a closed curve may end where the domain begins, and is then at its end again.
                let again = || old.breaks().and_then(|_| self.elevated_point(&vector, i + count));
                self.elevated_point(&vector, i).or_else(again)
            })
            .collect();
        Self::of_homogeneous(vector, &points.ok_or(KnotError::NoSpan)?, self.weights().is_some())
    }

    fn open_knots(&self, order: usize) -> Vec<f64> {
        let [from, to] = self.vector().domain();
        let all = raised(self.vector().knots(), |_| true);
        // `order` knots up to the last copy of the first, and as many from the first copy of the last.
        let begin = all.partition_point(|u| *u <= from).saturating_sub(order);
        let end = (all.partition_point(|u| *u < to) + order).min(all.len());
        all[begin..end].to_vec()
    }

    fn elevated_point(&self, vector: &KnotVector, i: usize) -> Option<Hom<D>> {
        let (order, knots) = (self.vector().order(), self.vector().knots());
        let span = self.arc_under(vector, i)?;
        let (arguments, local) = (&vector.knots()[i + 1..=i + order], self.local(span));
        let share = 1.0 / order as f64;
        (0..order).try_fold(Hom::ZERO, |sum, left_out| {
            let argument = |r: usize| arguments[if r < left_out { r } else { r + 1 }];
            Some(sum.mixed(1.0, share, blossom(knots, span, &local[..order], 0, 1.0, argument)?))
        })
    }
}

/// Knots in order, of each different one that is meant one more.
fn raised(knots: &[f64], meant: impl Fn(f64) -> bool) -> Vec<f64> {
    let mut all = Vec::with_capacity(2 * knots.len());
    for (i, &u) in knots.iter().enumerate() {
        all.push(u);
        if knots.get(i + 1) != Some(&u) && meant(u) {
            all.push(u);
        }
    }
    all
}
