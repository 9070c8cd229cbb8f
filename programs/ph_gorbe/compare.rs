//! placeholder
use super::analysis::Analysis;
use super::plane::Options;
use crate::machine::Asked;
use crate::ui::{Desk, Picture};
pub(super) async fn show(_: &mut Desk<'_>, _: &dyn Picture, _: &Analysis, _: &Options) -> Asked<()> {
    Ok(())
}
