//! The method and the degree of B-splines, as the curve editors ask for them.

use super::ask::ask_degree;
use crate::design::{Sketch, USUAL_DEGREE};
use crate::file::{KnotRule, Method};
use crate::geometry::knots::DEGREES;
use crate::machine::{Asked, Key, Language, Manner, Request, Stop};
use crate::screen::{Color, Screen};
use crate::ui::words;
use crate::ui::{Area, Desk, MIDDLE, Over, Picture, page};

/// A method as it is chosen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Chosen {
    pub(super) method: Method,
    /// The coefficient of the tangents, where the method has one.
    pub(super) k0: Option<f64>,
    /// The degree of a B-spline that has no method of its own.
    pub(super) degree: Option<usize>,
}

impl Chosen {
    /// A method without parameters.
    pub(super) fn of(method: Method) -> Chosen {
        Chosen { method, k0: None, degree: None }
    }

    /// The B-spline of a degree: 2 and 3 are methods that every program and file of this family knows.
    fn of_degree(degree: usize) -> Chosen {
        match degree {
            2 => Chosen::of(Method::BSpline2),
            3 => Chosen::of(Method::BSpline3),
            _ => Chosen { degree: Some(degree), ..Chosen::of(Method::BSpline) },
        }
    }

    /// Puts the method into a sketch. Knots, ends and degree that a file gave to another method do not go over.
    pub(super) fn put_into<const D: usize>(self, sketch: &mut Sketch<D>) {
        let settings = &mut sketch.settings;
        let degree = |method: Option<Method>, degree: Option<usize>| {
            (method == Some(Method::BSpline)).then(|| degree.unwrap_or(USUAL_DEGREE))
        };
        let other_degree = degree(settings.method, settings.degree) != degree(Some(self.method), self.degree);
        if settings.method != Some(self.method) {
            (settings.start, settings.end) = (None, None);
        }
        if settings.method != Some(self.method)
            || other_degree && matches!(settings.knots, Some(KnotRule::Given(_)))
        {
            settings.knots = None;
        }
        settings.method = Some(self.method);
        settings.degree = self.degree;
        settings.k0 = self.k0.or(settings.k0);
    }
}

/// Asks for the degree of a B-spline: in the manner of today from 1 to 5.
pub(super) async fn ask_b_spline(desk: &mut Desk<'_>, picture: &dyn Picture) -> Asked<Chosen> {
    if desk.machine.manner() != Manner::Today {
        return Ok(Chosen::of(ask_degree(desk, picture).await?));
    }
    let place = |degree: usize| (MIDDLE.0 + 46 + 32 * (degree as i32 - 1), MIDDLE.1 + 24); // a digit
    let over = Over::new(picture, |screen: &mut Screen, language: Language| {
        page(screen, MIDDLE);
        screen.text(MIDDLE.0 + 8, MIDDLE.1 + 9, words::ASK_DEGREE.of(language), Color::Black);
        for degree in DEGREES {
            let (x, y) = place(degree);
            screen.text(x, y, &degree.to_string(), Color::Red);
        }
    });
    loop {
        let tick = desk.event_asked(&over, Request::Number).await?;
        let clicked = tick.click().and_then(|(x, y)| {
            DEGREES.into_iter().find(|&degree| Area::of_line(place(degree), 1).holds(x, y))
        });
        let typed = tick.letter().and_then(|letter| letter.to_digit(10)).map(|digit| digit as usize);
        if let Some(degree) = clicked.or(typed).filter(|degree| DEGREES.contains(degree)) {
            return Ok(Chosen::of_degree(degree));
        }
        if tick.pressed(Key::Esc) {
            return Err(Stop::Cancelled);
        }
        if tick.pressed(Key::Enter) {
            return Ok(Chosen::of_degree(USUAL_DEGREE));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn degrees_are_methods() {
        assert_eq!(Chosen::of_degree(2).method, Method::BSpline2);
        assert_eq!(Chosen::of_degree(3).degree, None);
        assert_eq!(Chosen::of_degree(5), Chosen { degree: Some(5), ..Chosen::of(Method::BSpline) });
    }

    #[test]
    fn what_belongs_to_another_method_is_left() {
        let mut sketch = Sketch::<2>::default();
        sketch.settings.method = Some(Method::BSpline);
        sketch.settings.knots = Some(KnotRule::Given(vec![0.0; 9]));
        Chosen::of_degree(4).put_into(&mut sketch);
        assert_eq!((sketch.settings.degree, &sketch.settings.knots), (Some(4), &None));
        sketch.settings.knots = Some(KnotRule::Given(vec![0.0; 9]));
        Chosen::of_degree(4).put_into(&mut sketch);
        assert!(sketch.settings.knots.is_some());
        Chosen::of(Method::Spline).put_into(&mut sketch);
        assert_eq!((sketch.settings.degree, &sketch.settings.knots), (None, &None));
    }
}
