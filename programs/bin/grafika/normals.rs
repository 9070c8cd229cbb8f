//! What the commands tell of surfaces with Pythagorean normals: quantities, measures and offsets.

use crate::at::Row;
use crate::curve::failure;
use grafika::design::{DesignError, NetDesign};
use grafika::file::{Document, PatchItem, Patches, number};
use grafika::geometry::{
    Jacobian, ParamSurface, PnSurface, RadiusRange, SafeDistances, SurfaceSample, surface_samples,
};
use grafika::launch::Failure;
use serde_json::{Value, json};

/// The columns of [`quantities`].
pub(crate) const QUANTITIES: [&str; 12] = ["i", "j", "u", "v", "x", "y", "z", "nx", "ny", "nz", "r1", "r2"];

/// The surface of a net; other methods have no exact offsets and are refused.
pub(crate) fn surface(net: &NetDesign, name: &str) -> Result<PnSurface, Failure> {
    if net.pn_method().is_none() {
        return Err(Failure::usage(format!(
            "{} has no exact normals and offsets; surfaces by --method pn do",
            net.method().name()
        )));
    }
    let surface = net.patches_with_normals().and_then(|patches| Ok(patches.surface()?));
    surface.map_err(|error: DesignError| failure(name, &error))
}

/// Points, unit normals and radii of curvature at equal steps of every patch.
pub(crate) fn quantities(
    surface: &PnSurface,
    per_span: usize,
) -> Result<impl Iterator<Item = Row> + '_, Failure> {
    let row = |sample: SurfaceSample| {
        let place = surface.place(sample.spans, sample.parameters)?;
        let spans = sample.spans.map(|span| span as f64);
        let parts = spans.into_iter().chain(sample.parameters).chain(place.point).chain(place.normal);
        Some(parts.chain(place.radii).map(Some).collect())
    };
    let flat = "a radius of curvature is too large for doubles: the surface is nearly flat somewhere";
    let samples = surface_samples(surface, per_span).map_err(Failure::work)?;
    Ok(samples.map(move |sample| row(sample).ok_or_else(|| Failure::work(flat))))
}

/// Between which distances offsets have no local folds, and every patch with its sign and its radii of curvature. A
/// patch that is parabolic somewhere has no radii.
pub(crate) fn measured(net: &NetDesign, name: &str) -> Result<Value, Failure> {
    let patches = measured_patches(net, name)?;
    let surface = net.patches_with_normals().and_then(|patches| Ok(patches.surface()?)).ok();
    let limits = surface.and_then(|surface| surface.safe_distances());
    let limits = limits.map(|SafeDistances { low, high }| [low, high]);
    let patch = |([i, j], sign, range): &([usize; 2], Jacobian, Option<RadiusRange>)| {
        let (r1, r2) = (range.map(|range| range.r1), range.map(|range| range.r2));
        json!({ "i": i, "j": j, "jacobian": sign.name(), "r1": r1, "r2": r2 })
    };
    Ok(json!({ "limits": limits, "patches": patches.iter().map(patch).collect::<Vec<_>>() }))
}

type MeasuredPatch = ([usize; 2], Jacobian, Option<RadiusRange>);

fn measured_patches(net: &NetDesign, name: &str) -> Result<Vec<MeasuredPatch>, Failure> {
    if net.pn_method().is_none() {
        surface(net, name)?;
    }
    let patches = net.patches_with_normals().map_err(|error| failure(name, &error))?;
    let [rows, columns] = patches.size();
    let places = (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
    let measured = places.filter_map(|[i, j]| {
        let surface = patches.patch_surface(i, j)?.ok();
        let range = surface.and_then(|surface| surface.radius_range([0, 0]));
        Some(([i, j], patches.jacobian(i, j)?, range))
    });
    Ok(measured.collect())
}

/// What [`measured`] tells, in lines.
pub(crate) fn told(measured: &Value) -> Vec<String> {
    let limit = |value: &Value, none: &str| value.as_f64().map_or_else(|| none.to_owned(), number);
    let first = match &measured["limits"] {
        Value::Array(limits) => {
            let [low, high] = [0, 1].map(|k| limits.get(k).cloned().unwrap_or_default());
            format!("offsets without folds: {} < d < {}", limit(&low, "any"), limit(&high, "any"))
        }
        _ => "no offset is without folds: the surface itself is parabolic or folded".to_owned(),
    };
    let range = |value: &Value| {
        let [low, high] = [0, 1].map(|k| limit(&value[k], "?"));
        format!("{low} .. {high}")
    };
    let patches = measured["patches"].as_array().into_iter().flatten().map(|patch| {
        let head =
            format!("patch {}, {}: J {}", patch["i"], patch["j"], patch["jacobian"].as_str().unwrap_or("?"));
        match patch["r1"].is_null() {
            true => head,
            false => format!("{head}, r1 {}, r2 {}", range(&patch["r1"]), range(&patch["r2"])),
        }
    });
    std::iter::once(first).chain(patches).collect()
}

/// The exact rational patches of a surface at a distance from that of the data, as the text of an `.RBS` document.
pub(crate) fn written(offset: &PnSurface) -> Result<String, Failure> {
    let [rows, columns] = offset.spans();
    let places = (0..rows).flat_map(|i| (0..columns).map(move |j| [i, j]));
    let patches = places.filter_map(|[i, j]| {
        let patch = offset.rational_patch([i, j])?;
        Some(PatchItem { i, j, degree: patch.degrees(), homogeneous: patch.points() })
    });
    let patches = Patches { distance: Some(offset.distance()), patches: patches.collect() };
    Document::Patches(Box::new(patches)).to_json().map_err(Failure::work)
}

/// What the user should know about the offset at a distance: where it has folds.
pub(crate) fn folded(surface: &PnSurface, distance: f64) -> Option<String> {
    let Some(SafeDistances { low, high }) = surface.safe_distances() else {
        return Some("the surface itself is folded, and its offsets are too".to_owned());
    };
    let outside = low.is_some_and(|low| distance <= low) || high.is_some_and(|high| distance >= high);
    let limits = match (low.map(number), high.map(number)) {
        (Some(low), Some(high)) => format!("{low} < d < {high}"),
        (Some(low), None) => format!("{low} < d"),
        (None, high) => format!("d < {}", high.unwrap_or_default()),
    };
    outside
        .then(|| format!("the offset at {} is folded; those without folds have {limits}", number(distance)))
}
