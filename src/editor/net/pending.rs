use crate::geometry::*;
pub(super) enum RefineDirection {
    U,
    V,
}
pub(super) fn refine(
    _: Scheme,
    net: &[Vec<Point<3>>],
    _: RefineDirection,
) -> Result<Vec<Vec<Point<3>>>, GeometryError> {
    Ok(net.to_vec())
}
pub(super) struct Plane {
    pub(super) normal: Point<3>,
    pub(super) offset: f64,
}
pub(super) fn section(_: &Surface, plane: Plane, _: usize) -> Result<Vec<Vec<Point<3>>>, GeometryError> {
    let _ = (plane.normal, plane.offset);
    Ok(vec![])
}
