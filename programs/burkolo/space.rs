//! The page of space: spheres on a chain, and the surface over them.

mod commands;
mod craft;
mod items;
mod layers;
mod model;
mod obey;
mod strings;

pub(super) use commands::SPACE_KEYS;
pub(super) use craft::{Strings, of_circles};
