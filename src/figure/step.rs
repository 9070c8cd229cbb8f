//! Exact surfaces for CAD programs: STEP (ISO 10303-21), application protocol AP214.
//!
//! The model is one face on one B-spline surface. Its borders are edges; a seam is one edge used twice, and a pole
//! has no edge. A closed surface is a solid, an open one a shell. One unit of the net is one millimetre.

use super::FigureError;
use super::mesh::Mesh;
use crate::geometry::{BSplineSurface, ParamSurface, Point, Rim};
use std::fmt::{self, Write};

/// The highest degree that Open CASCADE, the kernel of FreeCAD, reads.
pub(super) const MOST_DEGREES: usize = 25;
/// Samples per cell for telling the inside of a closed surface from the outside.
const LOOK: usize = 4;

/// A surface as the text of a STEP file with one product of the given name. Control points and knots are those of
/// [`ParamSurface::to_bspline`]; numbers read back as the same double. A closed surface becomes a solid whose face
/// is oriented outwards. The same surface gives the same text, as the file has no date.
///
/// # Errors
/// [`FigureError::NoExactForm`] for a surface that is no B-spline surface, [`FigureError::Degree`] for a Bézier net of more than 26 points a side, [`FigureError::NoArea`] for a
/// surface without area, [`FigureError::Flat`] for a closed one in a plane.
pub fn surface_step(surface: &dyn ParamSurface, name: &str) -> Result<String, FigureError> {
    let form = surface.to_bspline().ok_or(FigureError::NoExactForm)?;
    written(&[(form, surface)], name, "a surface by a net of control points")
}

/// Surfaces as the text of a STEP file, one face each. Those without an exact form are fitted by bicubic B-splines, to a
/// tolerance that is a part of their size and is said in the header of the file.
///
/// # Errors
/// Those of [`surface_step`], and [`FigureError::Geometry`] where the tolerance is too small.
pub fn surfaces_step(
    surfaces: &[&dyn ParamSurface],
    name: &str,
    tolerance: f64,
) -> Result<String, FigureError> {
    let mut exact = true;
    let mut forms = Vec::with_capacity(surfaces.len());
    for &surface in surfaces {
        let form = match surface.to_bspline() {
            Some(form) => form,
            None => {
                exact = false;
                let size = surface.bounding_box().map_or(0.0, |bounds| bounds.extent());
                surface.fitted_bspline(tolerance * size)?
            }
        };
        forms.push((form, surface));
    }
    let about = match exact {
        true => "a surface by a net of control points".to_owned(),
        false => format!("a surface, fitted within {tolerance:e} of its size"),
    };
    written(&forms, name, &about)
}

/// The file of B-spline surfaces with the surfaces that they stand for.
fn written(
    forms: &[(BSplineSurface, &dyn ParamSurface)],
    name: &str,
    about: &str,
) -> Result<String, FigureError> {
    let mut file = File::new(name, about);
    let mut shells = Vec::new();
    for (form, surface) in forms {
        if let Some(&given) = form.degrees.iter().find(|&&degree| degree > MOST_DEGREES) {
            return Err(FigureError::Degree { given, most: MOST_DEGREES });
        }
        // Nets are far smaller than what a grid can hold at these steps; a larger one is not looked at.
        let inside_out = match surface.grid(LOOK) {
            Ok(grid) => Mesh::welded(&grid)?.is_inside_out(),
            Err(_) => false,
        };
        let face = Face::new(form, surface.closed());
        let id = face.write(&mut file, inside_out);
        if forms.len() == 1 && face.is_whole() {
            let shell = file.add(format_args!("CLOSED_SHELL('',({id}))"));
            let solid = file.add(format_args!("MANIFOLD_SOLID_BREP('',{shell})"));
            return Ok(file.finish(solid, "ADVANCED_BREP_SHAPE_REPRESENTATION"));
        }
        shells.push(file.add(format_args!("OPEN_SHELL('',({id}))")));
    }
    let model = file.add(format_args!("SHELL_BASED_SURFACE_MODEL('',{})", List(&shells)));
    Ok(file.finish(model, "MANIFOLD_SURFACE_SHAPE_REPRESENTATION"))
}

/// The entities of a file: lines `#number=ENTITY(...);`.
pub(super) struct File {
    name: String,
    about: String,
    data: String,
    count: usize,
}

/// The entity that holds the shape.
pub(super) type Representation = &'static str;

impl File {
    pub(super) fn new(name: &str, about: &str) -> Self {
        Self { name: quoted(name), about: quoted(about), data: String::new(), count: 0 }
    }

    /// Adds an entity and returns its number.
    pub(super) fn add(&mut self, entity: impl fmt::Display) -> Id {
        self.count += 1;
        // Writing to a string cannot fail.
        let _ = writeln!(self.data, "#{}={entity};", self.count);
        Id(self.count)
    }

    pub(super) fn point(&mut self, [x, y, z]: Point<3>) -> Id {
        self.add(format_args!("CARTESIAN_POINT('',({},{},{}))", Real(x), Real(y), Real(z)))
    }

    /// Adds the product structure around the shape.
    pub(super) fn finish(mut self, item: Id, representation: Representation) -> String {
        let name = self.name.clone();
        let application =
            self.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        self.add(format_args!(
            "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})"
        ));
        let context = self.add(format_args!("PRODUCT_CONTEXT('',{application},'mechanical')"));
        let product = self.add(format_args!("PRODUCT({name},{name},'',({context}))"));
        self.add(format_args!("PRODUCT_RELATED_PRODUCT_CATEGORY('part','',({product}))"));
        let formation = self.add(format_args!("PRODUCT_DEFINITION_FORMATION('','',{product})"));
        let design =
            self.add(format_args!("PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')"));
        let definition = self.add(format_args!("PRODUCT_DEFINITION('design','',{formation},{design})"));
        let shape = self.add(format_args!("PRODUCT_DEFINITION_SHAPE('','',{definition})"));
        let length = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
        let angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        let solid_angle = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        let uncertainty = self.add(format_args!(
            "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-7),{length},'distance_accuracy_value','')"
        ));
        let space = self.add(format_args!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({uncertainty}))\
             GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid_angle}))REPRESENTATION_CONTEXT('',''))"
        ));
        let origin = self.point([0.0; 3]);
        let axis = self.add("DIRECTION('',(0.,0.,1.))");
        let reference = self.add("DIRECTION('',(1.,0.,0.))");
        let placement = self.add(format_args!("AXIS2_PLACEMENT_3D('',{origin},{axis},{reference})"));
        let shown = self.add(format_args!("{representation}({name},({placement},{item}),{space})"));
        self.add(format_args!("SHAPE_DEFINITION_REPRESENTATION({shape},{shown})"));
        format!(
            "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(({}),'2;1');\n\
             FILE_NAME({name},'1970-01-01T00:00:00',(''),(''),'grafika','grafika','');\n\
             FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\nENDSEC;\nDATA;\n{}ENDSEC;\n\
             END-ISO-10303-21;\n",
            self.about, self.data
        )
    }
}

/// A surface and its borders.
struct Face<'a> {
    form: &'a BSplineSurface,
    closed: [bool; 2],
    /// For direction d, whether the borders at its start and end degenerate to a point.
    poles: [[bool; 2]; 2],
}

impl<'a> Face<'a> {
    fn new(form: &'a BSplineSurface, closed: [bool; 2]) -> Self {
        let pole = |d: usize, rim: Rim| !closed[d] && form.is_pole(d, rim);
        let poles = [0, 1].map(|d| [Rim::First, Rim::Last].map(|rim| pole(d, rim)));
        Self { form, closed, poles }
    }

    /// Writes the face. If it is oriented against the surface, its boundary is reversed too.
    fn write(&self, file: &mut File, inside_out: bool) -> Id {
        let net: Vec<Vec<Id>> =
            self.form.net.iter().map(|row| row.iter().map(|&point| file.point(point)).collect()).collect();
        let surface = self.surface(file, &net);
        let boundary = self.boundary(file, &net);
        let sense = Flag(!inside_out);
        let bound = file.add(format_args!("FACE_OUTER_BOUND('',{boundary},{sense})"));
        file.add(format_args!("ADVANCED_FACE('',({bound}),{surface},{sense})"))
    }

    /// Whether the surface encloses a solid.
    fn is_whole(&self) -> bool {
        (0..2).all(|d| self.closed[d] || self.poles[d] == [true; 2])
    }

    fn surface(&self, file: &mut File, net: &[Vec<Id>]) -> Id {
        let rows: Vec<String> = net.iter().map(|row| List(row).to_string()).collect();
        let ([p, q], [u_closed, v_closed]) = (self.form.degrees, self.closed.map(Flag));
        let (knots, counts) = (&self.form.knots, &self.form.multiplicities);
        let rows = List(&rows);
        let net = format!("{p},{q},{rows},.UNSPECIFIED.,{u_closed},{v_closed},.U.");
        let (counts, knots) = (counts.each_ref().map(|it| List(it)), knots.each_ref().map(|it| reals(it)));
        let knots =
            format!("{},{},{},{},.UNSPECIFIED.", counts[0], counts[1], List(&knots[0]), List(&knots[1]));
        let Some(weights) = &self.form.weights else {
            return file.add(format_args!("B_SPLINE_SURFACE_WITH_KNOTS('',{net},{knots})"));
        };
        let weights: Vec<String> = weights.iter().map(|row| List(&reals(row)).to_string()).collect();
        file.add(format_args!(
            "(BOUNDED_SURFACE()B_SPLINE_SURFACE({net})B_SPLINE_SURFACE_WITH_KNOTS({knots})\
             GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_SURFACE({})REPRESENTATION_ITEM('')SURFACE())",
            List(&weights)
        ))
    }

    /// The loop around the parameters, counterclockwise: v first, u last, v last back, u first back.
    fn boundary(&self, file: &mut File, net: &[Vec<Id>]) -> Id {
        let mut vertices: [Option<Id>; 4] = [None; 4];
        let mut corner = |file: &mut File, u: usize, v: usize| {
            let [u, v] = self.stands_for(u, v);
            // Both are 0 or 1.
            let slot = vertices.get_mut(2 * u + v)?;
            if slot.is_none() {
                let row = if u == 0 { net.first() } else { net.last() }?;
                let point = if v == 0 { row.first() } else { row.last() }?;
                *slot = Some(file.add(format_args!("VERTEX_POINT('',{point})")));
            }
            *slot
        };
        let mut oriented = Vec::new();
        let mut edges: [[Option<Id>; 2]; 2] = [[None; 2]; 2];
        for (across, end, forward) in [(1, 0, true), (0, 1, true), (1, 1, false), (0, 0, false)] {
            if self.poles[across][end] {
                continue;
            }
            // Both sides of a seam share one edge.
            let end = if self.closed[across] { 0 } else { end };
            if edges[across][end].is_none() {
                let corners = if across == 1 { [[0, end], [1, end]] } else { [[end, 0], [end, 1]] };
                let [from, to] = corners.map(|[u, v]| corner(file, u, v));
                let curve = self.curve(file, net, across, end);
                edges[across][end] = from
                    .zip(to)
                    .map(|(from, to)| file.add(format_args!("EDGE_CURVE('',{from},{to},{curve},.T.)")));
            }
            if let Some(edge) = edges[across][end] {
                oriented.push(file.add(format_args!("ORIENTED_EDGE('',*,*,{edge},{})", Flag(forward))));
            }
        }
        match corner(file, 0, 0) {
            Some(vertex) if oriented.is_empty() => file.add(format_args!("VERTEX_LOOP('',{vertex})")),
            _ => file.add(format_args!("EDGE_LOOP('',{})", List(&oriented))),
        }
    }

    /// The representative of a corner among the corners with the same point.
    fn stands_for(&self, u: usize, v: usize) -> [usize; 2] {
        let u = if self.closed[0] { 0 } else { u };
        let v = if self.closed[1] { 0 } else { v };
        let u = if self.poles[1][v] { 0 } else { u };
        [u, if self.poles[0][u] { 0 } else { v }]
    }

    /// The border curve at the start (0) or end (1) of a direction.
    fn curve(&self, file: &mut File, net: &[Vec<Id>], across: usize, end: usize) -> Id {
        let along = 1 - across;
        let points = format!(
            "{},{},.UNSPECIFIED.,{},.U.",
            self.form.degrees[along],
            List(&line(net, across, end)),
            Flag(self.closed[along])
        );
        let knots = format!(
            "{},{},.UNSPECIFIED.",
            List(&self.form.multiplicities[along]),
            List(&reals(&self.form.knots[along]))
        );
        let Some(weights) = &self.form.weights else {
            return file.add(format_args!("B_SPLINE_CURVE_WITH_KNOTS('',{points},{knots})"));
        };
        file.add(format_args!(
            "(BOUNDED_CURVE()B_SPLINE_CURVE({points})B_SPLINE_CURVE_WITH_KNOTS({knots})CURVE()\
             GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE({})REPRESENTATION_ITEM(''))",
            List(&reals(&line(weights, across, end)))
        ))
    }
}

/// The row or the column of a net at the start (0) or end (1) of a direction.
fn line<T: Copy>(net: &[Vec<T>], across: usize, end: usize) -> Vec<T> {
    match (across, end) {
        (0, 0) => net.first().cloned().unwrap_or_default(),
        (0, _) => net.last().cloned().unwrap_or_default(),
        (_, 0) => net.iter().filter_map(|row| row.first().copied()).collect(),
        _ => net.iter().filter_map(|row| row.last().copied()).collect(),
    }
}

/// A reference to an entity.
#[derive(Clone, Copy)]
pub(super) struct Id(usize);

impl fmt::Display for Id {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "#{}", self.0)
    }
}

pub(super) struct Flag(pub(super) bool);

impl fmt::Display for Flag {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(if self.0 { ".T." } else { ".F." })
    }
}

pub(super) struct List<'a, T>(pub(super) &'a [T]);

impl<T: fmt::Display> fmt::Display for List<'_, T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_char('(')?;
        for (index, item) in self.0.iter().enumerate() {
            write!(f, "{}{item}", if index == 0 { "" } else { "," })?;
        }
        f.write_char(')')
    }
}

pub(super) fn reals(values: &[f64]) -> Vec<Real> {
    values.iter().copied().map(Real).collect()
}

/// A number with the decimal point that STEP requires. It reads back as the same double, except for the sign of
/// zero.
pub(super) struct Real(f64);

impl fmt::Display for Real {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = super::number::Number(self.0 + 0.0).to_string();
        match text.split_once('e') {
            Some((digits, power)) if digits.contains('.') => write!(f, "{digits}E{power}"),
            Some((digits, power)) => write!(f, "{digits}.E{power}"),
            None if text.contains('.') => f.write_str(&text),
            None => write!(f, "{text}."),
        }
    }
}

/// A text as a STEP string: letters beyond ASCII in hexadecimal.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("'");
    for ch in text.chars() {
        match ch {
            '\'' => quoted.push_str("''"),
            '\\' => quoted.push_str("\\\\"),
            ' '..='~' => quoted.push(ch),
            _ => {
                let _ = write!(quoted, "\\X4\\{:08X}\\X0\\", u32::from(ch));
            }
        }
    }
    quoted.push('\'');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_a_point() {
        let texts = [0.0, -0.0, 120.0, -0.5, 1e-9, -2.5e150].map(|x| Real(x).to_string());
        assert_eq!(texts, ["0.", "0.", "120.", "-0.5", "1.E-9", "-2.5E150"]);
    }

    #[test]
    fn names_are_quoted() {
        assert_eq!(quoted("a'b\\ő\n"), r"'a''b\\\X4\00000151\X0\\X4\0000000A\X0\'");
    }
}
