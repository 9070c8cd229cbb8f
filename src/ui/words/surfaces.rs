//! Words of the surface programs.

use super::{Hot, Phrase, Words, in_line};
use crate::file::Format;
use crate::geometry::{Border, GeometryError};

// The surface programs.
pub(crate) const SURFACE: Hot = Hot::new('F', "elület", "-surf.");
pub(crate) const NET_QUIT: Hot = Hot::new('Q', "- kilép", "- quit");
pub(crate) const NORMAL_BUTTON: Hot = Hot::new('N', "-normál", "-normal");
pub(crate) const OFFSET_BUTTON: Hot = Hot::new('P', "-párhuz", "-offset");
pub(crate) const HELP_NORMAL: Words =
    Words("normális választása, két új szöge", "choose a normal, then its two new angles");
pub(crate) const HELP_OFFSET: Words =
    Words("párhuzamos felület távolsága (0: nincs)", "distance of the offset along the normals (0: none)");
pub(crate) const HELP_AUTOMATIC_NORMALS: Words =
    Words("normálisok a pontok spline-felületéről", "normals from the spline through the points");
pub(crate) const HELP_SIDES: Words =
    Words("M mindkét oldalon, H héj peremfalakkal", "M on both sides, H shell with walls");
pub(crate) const HELP_NET_SIZE: Words =
    Words("a háló új mérete: 2 x 2 ... 8 x 8", "another size of the net: 2 x 2 to 8 x 8");
pub(crate) const HELP_COMPARE_PN: Words =
    Words("pn és pn-thesis együtt, majd csere", "pn and pn-thesis together, then exchanged");
pub(crate) const HELP_INSPECT_RADII: Words =
    Words("zebracsíkok, Gauss-görbület, sugarak, semmi", "zebra stripes, Gaussian curvature, radii, none");
pub(crate) const HELP_GAUSS: Words =
    Words("a normálisok képe a gömbön és a síkon", "image of the normals on sphere and plane");
pub(crate) const HELP_NORMALS_DRAG: Words =
    Words("pont vagy normális húzása", "drag a point or the tip of a normal");
pub(crate) const K0_BUTTON: Hot = Hot::new('C', " - k0", " - k0");
pub(crate) const ASK_DISPLAY: Words = Words("          Megjelenítés ?", "    Wireframe or solid?");
pub(crate) const WIRE: Hot = Hot::new('D', "rótváz", "-wire");
pub(crate) const FILLED: Hot = Hot::new('T', "ele", "-solid");
pub(crate) const ASK_DIRECTION: Words = Words("          Irány ?", "         Direction?");
pub(crate) const ALONG_U: Hot = Hot::new('U', "", "");
pub(crate) const ALONG_V: Hot = Hot::new('V', "", "");
pub(crate) const ASK_AXIS: Words = Words("Melyik tengely irányában ?", "Mirror along which axis?");
pub(crate) const AXES: [Hot; 3] = [Hot::new('X', "", ""), Hot::new('Y', "", ""), Hot::new('Z', "", "")];
pub(crate) const WHAT_CHANGES: Words = Words("Mi változik ?", "Change what?");
pub(crate) const TANGENT_TITLE: Words = Words("Érintő", "Tangent");
pub(crate) const TWIST: Hot = Hot::new('T', "wist", "wist");
pub(crate) const TANGENT_U: Hot = Hot::new('U', " irány", " dir.");
pub(crate) const TANGENT_V: Hot = Hot::new('V', " irány", " dir.");
pub(crate) const TANGENT_U_TITLE: Words = Words("Érintő-u", "Tangent-u");
pub(crate) const TANGENT_V_TITLE: Words = Words("Érintő-v", "Tangent-v");
pub(crate) const TWIST_TITLE: Words = Words("Twist", "Twist");
pub(crate) const HEIGHT_TITLE: Words = Words("Magasság:", "Height:");
pub(crate) const COEFFICIENT_ENTRY: Words = Words("Együttható:", "Coeff.:");
pub(crate) const WIRE_LEGEND: Words = Words("D - drótváz", "D - wireframe");
pub(crate) const FILLED_LEGEND: Words = Words("T - tele", "T - hidden lines");
pub(crate) const NO_SURFACE: Words = Words("Előbb felületet rajzoljon: F", "Draw a surface first (F)");
pub(crate) const SURFACE_FOLLOWS: Words = Words("A felület követi a hálót", "The surface follows the net");
pub(crate) const SURFACE_FOLLOWS_NOT: Words = Words("Csak húzáskor követ", "Follows only while dragging");
pub(crate) const BORDER_REACHED: Words = Words("A peremig ér", "It ends at the border");
pub(crate) const BORDER_DOUBLED: Words = Words("A perem előtt ér véget", "It ends before the border");
pub(crate) const BORDER_INNER: Words =
    Words("A perempontok segédpontok", "The border points are auxiliary points");
pub(crate) const POLES_FREE: Words = Words("Szabad végek a pólusokban", "Free ends at the poles");
pub(crate) const POLES_TRIPLE: Words = Words("A pólusok háromszoros pontok", "The poles are triple points");
pub(crate) const POLES_JOINED: Words =
    Words("A szemközti meridiánok összeérnek", "Opposite meridians are joined at the poles");

/// Where a surface ends now; of splines, what its poles are.
pub(crate) fn border(border: Border, splines: bool) -> Words {
    match border {
        Border::Free if splines => POLES_FREE,
        Border::Free => POLES_TRIPLE,
        Border::Doubled if splines => POLES_JOINED,
        Border::Doubled => BORDER_DOUBLED,
        Border::Reached => BORDER_REACHED,
        Border::Inner => BORDER_INNER,
    }
}
pub(crate) const COLLAPSED: Words = Words(
    "A háló egy vonalon fekszik: a felület vonallá zsugorodik",
    "The net lies on a line, and so does the surface",
);
pub(crate) const NOT_A_NET: Words =
    Words("Ebben a fájlban nincs kontrollháló", "This file holds no control net");
pub(crate) const HELP_NET_CHANGE: Words =
    Words("kontrollpont választása, új hely", "choose a control point, then its new place");
pub(crate) const HELP_SURFACE: Words = Words(
    "felület: drótváz, vagy takart vonalak nélkül (tele)",
    "surface: wireframe, or solid without hidden lines",
);
pub(crate) const HELP_SURFACE_RESULT: Words =
    Words("eredmény: a felület magában, keret nélkül (D, T)", "result: the surface alone (D, T)");
pub(crate) const HELP_NET_DRAG: Words =
    Words("pont húzása; kattintás a térképre: V", "drag a point; click a disc of the map: V");
pub(crate) const HELP_NET_FOLLOW: Words = Words(
    "a felület mindig látszik és követi a hálót: be, ki",
    "the surface stays and follows every change: on, off",
);
pub(crate) const HELP_BORDER: Words =
    Words("perem: kétszeres pontok, elért, segédpontok", "border: doubled, reached, auxiliary points");
pub(crate) const HELP_POLES: Words =
    Words("szabad végek a pólusokban: be, ki", "free ends at the poles: on, off");
pub(crate) const HELP_TRIPLE: Words =
    Words("pólus: kétszeres, elért, háromszoros", "poles: doubled, reached, triple points");
pub(crate) const HELP_JOIN: Words =
    Words("második folt; a csatlakozás feltétele", "a second patch; what is kept at the joint");
pub(crate) const HELP_FRAME: Words = Words(
    "K kontrollháló, konvex burok; W egy pont súlya",
    "K control net, convex hull; W weight of a point",
);
pub(crate) const HELP_HULL: Words = Words("kontrollháló, konvex burok", "control net, convex hull");
pub(crate) const HELP_INSPECT: Words =
    Words("zebracsíkok, Gauss-görbület, semmi", "zebra stripes, Gaussian curvature, none");
pub(crate) const HELP_SECTION: Words =
    Words("síkmetszet x, y, z mentén; + - tolja", "plane section along x, y, z; + - move it");
pub(crate) const HELP_MIRROR: Words = Words("a háló tükrözése", "mirror the net");
pub(crate) const HELP_REFINE: Words =
    Words("a háló finomítása, a felület ugyanaz", "refine the net; the surface stays the same");
pub(crate) const HELP_K0: Words =
    Words("az érintők együtthatója, u és v", "coefficient of the tangents, u and v");
pub(crate) const HELP_SHAPES: Words = Words("eltolás, feszültség, u és v", "bias, tension, u and v");
pub(crate) const INSPECTIONS: [Words; 3] =
    [Words("", ""), Words("zebracsíkok", "zebra stripes"), Words("Gauss-görbület", "Gaussian curvature")];

/// The line under the picture: a part of a control point of a net.
pub(crate) fn part_of([k, l]: [usize; 2], name: Words, place: [f64; 3]) -> Phrase {
    let [x, y, z] = place.map(in_line);
    let line = |number: &str, name: &str| format!("{number}: {k}, {l} {name}: x = {x} y = {y} z = {z}");
    Phrase::new(line("Sorszám", name.0), line("Number", name.1))
}

/// The line under the picture: a height.
pub(crate) fn height_of([k, l]: [usize; 2], height: f64) -> Phrase {
    let z = in_line(height);
    Phrase::new(format!("Sorszám: {k}, {l} Magasság: z ={z}"), format!("Number: {k}, {l} Height: z ={z}"))
}

/// A number has been clamped to its range.
pub(crate) fn taken_into(range: &std::ops::RangeInclusive<f64>) -> Phrase {
    let (least, most) = (range.start(), range.end());
    Phrase::new(
        format!("Csak {least} és {most} között lehet: a legközelebbi érték lett"),
        format!("It must be {least} to {most}: the nearest value is used"),
    )
}

/// Why there is no surface.
pub(crate) fn no_surface(error: &GeometryError) -> Phrase {
    let GeometryError::CriticalTension { bias, critical, .. } = error else { return Phrase::plain(error) };
    Phrase::new(
        format!("{bias:.2} eltolásnál a {critical:.2} feszültség kritikus: nincs felület. Más kell: C"),
        format!(
            "With bias {bias:.2} the tension {critical:.2} is critical: there is no surface. Choose another (C)"
        ),
    )
}

/// A file holds a net of another kind.
pub(crate) fn other_net(wanted: Format, found: Format) -> Phrase {
    Phrase::new(
        format!("Ez egy {found} háló; ide {wanted} való"),
        format!("This is a {found} net; a {wanted} net is needed"),
    )
}

/// A net is too small, too large or too far away.
pub(crate) fn net_size([rows, columns]: [usize; 2], [least_u, least_v]: [usize; 2], most: usize) -> Phrase {
    Phrase::new(
        format!(
            "A háló {rows} x {columns} pont; {least_u} x {least_v} és {most} x {most} közötti kell, koordináták 1000000-ig"
        ),
        format!(
            "The net has {rows} x {columns} points; {least_u} x {least_v} to {most} x {most} are possible, coordinates up to 1000000"
        ),
    )
}
