//! Two patches beside each other in one net (3.2), and what is kept at their joint.
//!
//! The net of two Bézier patches has the rows of the first, then those of the second without the common border, which is
//! the middle row. That of two Hermite patches has the places at the beginning, the joint and the end, then the
//! derivatives by u at the beginning, at the joint in the first patch, there in the second, and at the end.

use super::net::{FARTHEST, MOST};
use super::{DesignError, NetDesign};
use crate::file::{Method, Net, NetKind, RATIOS};
use crate::geometry::{
    Contact, Joined, Joint, ParamSurface, Point, RefineDirection, Scheme, Surface, Topology, refine,
};

type Rows = Vec<Vec<Point<3>>>;

impl NetDesign {
    /// What is kept at the joint of two patches; `None` for one patch.
    pub fn joint(&self) -> Option<Joint> {
        let patches = match self.net.kind {
            NetKind::Fhc => true,
            NetKind::Fpb => self.method() == Method::Bezier,
            _ => false,
        };
        self.net.settings.joint.filter(|_| patches)
    }

    /// How long the derivatives of the second patch are by those of the first, where the tangent plane is kept.
    pub fn ratio(&self) -> f64 {
        self.net.settings.ratio.unwrap_or(1.0).clamp(*RATIOS.start(), *RATIOS.end())
    }

    /// The two patches as a surface; `None` for one patch.
    ///
    /// # Errors
    /// Those of [`Joined::bezier`] and [`Joined::hermite`].
    pub fn joined(&self) -> Result<Option<Joined>, DesignError> {
        if self.joint().is_none() {
            return Ok(None);
        }
        if !self.is_matrix() {
            return Ok(Some(Joined::bezier(&self.net.points)?));
        }
        let rows: Option<Vec<[Point<3>; 4]>> =
            self.net.points.iter().map(|row| row.as_slice().try_into().ok()).collect();
        let rows: Option<[[Point<3>; 4]; 7]> = rows.and_then(|rows| rows.try_into().ok());
        Ok(Some(Joined::hermite(&rows.ok_or(DesignError::NoMatrix)?)?))
    }

    /// How smoothly two patches meet.
    pub fn contact(&self) -> Option<Contact> {
        self.joined().ok().flatten().as_ref().map(Contact::of)
    }

    /// The control points of the Bézier form, which the surface stays in the hull of; those of other nets are the points
    /// themselves.
    pub fn frame(&self) -> Vec<(Vec<Point<3>>, bool)> {
        if !self.is_matrix() {
            return self.polygons();
        }
        let rows: Rows = match (self.joined(), self.matrix().map(|matrix| Surface::hermite(&matrix))) {
            (Ok(Some(joined)), _) => {
                let nets = joined.halves().iter().filter_map(ParamSurface::to_bspline).map(|form| form.net);
                nets.enumerate().flat_map(|(half, net)| net.into_iter().skip(half)).collect()
            }
            (_, Ok(Ok(surface))) => surface.to_bspline().map(|form| form.net).unwrap_or_default(),
            _ => Rows::new(),
        };
        let columns = rows.first().map_or(0, Vec::len);
        let across = (0..columns).map(|l| rows.iter().filter_map(|row| row.get(l).copied()).collect());
        across.chain(rows.iter().cloned()).map(|line| (line, false)).collect()
    }

    /// Whether a second patch can be put beside the net.
    pub fn may_join(&self) -> bool {
        let rows = self.shape()[0];
        self.joint().is_none()
            && match self.net.kind {
                NetKind::Fhc => true,
                NetKind::Fpb => self.method() == Method::Bezier && rows >= 3 && 2 * rows - 1 <= MOST,
                _ => false,
            }
    }

    /// The net with a second patch where u goes on: the first one turned round the points of the common border, so that
    /// every line across it goes on straight, and C1 is kept.
    #[must_use]
    pub fn with_second_patch(&self) -> NetDesign {
        if !self.may_join() {
            return self.clone();
        }
        let mut design = self.with_settings(|settings| settings.joint = Some(Joint::C1));
        let turned = |border: &[Point<3>], row: &[Point<3>]| -> Vec<Point<3>> {
            let about = |(b, p): (&Point<3>, &Point<3>)| std::array::from_fn(|axis| 2.0 * b[axis] - p[axis]);
            border.iter().zip(row).map(about).collect()
        };
        let points = &self.net.points;
        design.net.points = match points.as_slice() {
            [start, end, from, to] if self.is_matrix() => {
                vec![start, end, &turned(end, start), from, to, to, from].into_iter().cloned().collect()
            }
            [inner @ .., border] => {
                points.iter().cloned().chain(inner.iter().rev().map(|row| turned(border, row))).collect()
            }
            [] => Rows::new(),
        };
        design.stay_near();
        design
    }

    /// The first of two patches alone.
    #[must_use]
    pub fn with_one_patch(&self) -> NetDesign {
        if self.joint().is_none() {
            return self.clone();
        }
        let mut design = self.with_settings(|settings| (settings.joint, settings.ratio) = (None, None));
        let points = &self.net.points;
        design.net.points = match points.as_slice() {
            [p0, p1, _, u0, u1, ..] if self.is_matrix() => {
                vec![p0.clone(), p1.clone(), u0.clone(), u1.clone()]
            }
            all => all.iter().take(all.len() / 2 + 1).cloned().collect(),
        };
        design
    }

    /// The design that keeps another condition at the joint. The second patch is changed so that it holds.
    #[must_use]
    pub fn with_joint(&self, joint: Joint, ratio: Option<f64>) -> NetDesign {
        let mut design = self.with_settings(|settings| {
            settings.joint = Some(joint);
            settings.ratio = ratio.filter(|_| joint == Joint::Plane);
        });
        let ratio = design.ratio();
        for column in 0..design.shape()[1] {
            design.across(column, |matrix, points| match matrix {
                Some(column) => joint.impose_hermite(ratio, column),
                None => joint.impose_bezier(ratio, points),
            });
        }
        design.stay_near();
        design
    }

    /// Keeps what is kept at the joint after an entry of the net has changed from a value.
    pub(super) fn keep_joint(&mut self, [row, column]: [usize; 2], from: Point<3>) {
        let (Some(joint), ratio) = (self.joint(), self.ratio()) else { return };
        self.across(column, |matrix, points| match matrix {
            Some(column) => joint.keep_hermite(ratio, column, row),
            None => joint.keep_bezier(ratio, points, row, from),
        });
        self.stay_near();
    }

    /// Changes the line of the net across the joint: the seven entries of a Hermite column, or the points.
    fn across(&mut self, column: usize, change: impl Fn(Option<&mut [Point<3>; 7]>, &mut [Point<3>])) {
        let mut line: Vec<Point<3>> =
            self.net.points.iter().filter_map(|row| row.get(column).copied()).collect();
        match (self.is_matrix(), <[Point<3>; 7]>::try_from(line.as_slice())) {
            (true, Ok(mut entries)) => {
                change(Some(&mut entries), &mut []);
                line = entries.to_vec();
            }
            (true, Err(_)) => return,
            (false, _) => change(None, &mut line),
        }
        for (row, point) in self.net.points.iter_mut().zip(line) {
            if let Some(place) = row.get_mut(column) {
                *place = point;
            }
        }
    }

    /// Keeps all points where an editor has room for them.
    fn stay_near(&mut self) {
        for value in self.net.points.iter_mut().flatten().flatten() {
            *value = value.clamp(-FARTHEST, FARTHEST);
        }
    }

    /// The net refined along u (0) or v (1): the same surface by more points. A Hermite patch has no finer net and stays.
    ///
    /// # Errors
    /// Those of [`NetDesign::scheme`], of [`refine`], and [`DesignError::NetSize`] where there is no room.
    pub fn refined(&self, direction: usize) -> Result<NetDesign, DesignError> {
        let Some(scheme) = self.scheme()? else { return Ok(self.clone()) };
        let direction = if direction == 0 { RefineDirection::U } else { RefineDirection::V };
        let all = &self.net.points;
        let points = match self.joint() {
            Some(_) => {
                let patch = Scheme::new(scheme.u, Topology::Open);
                let middle = all.len() / 2;
                let first = refine(patch, all.get(..=middle).unwrap_or_default(), direction)?;
                let second = refine(patch, all.get(middle..).unwrap_or_default(), direction)?;
                first.into_iter().chain(second.into_iter().skip(1)).collect()
            }
            None => refine(scheme, all, direction)?,
        };
        NetDesign { net: Net { points, ..self.net.clone() }, implied: self.implied }.fitting()
    }
}
