//! Messages about curves and surfaces that do not exist.

use crate::design::DesignError;
use crate::ui::words::{self, Phrase};

/// Why an editor cannot show a curve.
pub(crate) fn of_curve(error: &DesignError) -> Phrase {
    match error {
        DesignError::Outside(number, place) => match place.as_slice() {
            &[x, y] => words::outside_field(*number, [x, y]),
            _ => words::OUTSIDE_SPACE.into(),
        },
        DesignError::TooMany(count) => words::too_many_points(*count),
        DesignError::Geometry(error) => words::no_curve(error),
        other => Phrase::plain(other),
    }
}

/// Why an editor cannot show a surface.
pub(crate) fn of_surface(error: &DesignError) -> Phrase {
    match error {
        DesignError::OtherNet { wanted, found } => words::other_net(*wanted, *found),
        DesignError::NetSize { found, least, most } => words::net_size(*found, *least, *most),
        DesignError::Geometry(error) => words::no_surface(error),
        other => Phrase::plain(other),
    }
}

/// Why a net has no finer one.
pub(crate) fn of_refining(error: &DesignError) -> Phrase {
    match error {
        DesignError::Geometry(error) => Phrase::plain(error),
        other => of_surface(other),
    }
}
