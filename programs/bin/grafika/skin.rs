//! `grafika skin`: the skin of circles or spheres as a picture, as JSON, as a mesh or exactly for CAD programs, and
//! whether there is one.

mod spheres;

use crate::picture::{Format, picture};
use crate::sample::extension;
use crate::source::{Source, apart};
use clap::Args;
use grafika::design::skin::{circles, outlines};
use grafika::figure::{CURVE_INK, Figure, NOMINAL_WIDTH, curves_step, outline_step};
use grafika::file::Document;
use grafika::geometry::skin::{Circles, Clearing, Links, Piece, Side, Skin, SkinArc, Violation};
use grafika::launch::{Failure, Overwrite, progress, say, words, write_output};
use serde_json::{Value, json};
use std::path::PathBuf;

/// The command line of `grafika skin`.
#[derive(Args)]
#[command(after_help = "Examples:
  grafika skin KIGYO.KOR -o snake.svg --caps
  grafika skin VILLA.KOR -o fork.json
  grafika skin GYURU.KOR -o ring.step
  grafika skin CSIGA.GOM -o snail.stl
  grafika skin ROSSZ.KOR --check")]
pub(crate) struct SkinCommand {
    #[command(flatten)]
    source: Source,
    /// Leave arcs as they are that cut into their circles or spheres
    #[arg(long)]
    plain: bool,
    /// Close the outline around the end circles; the surface over spheres is always closed
    #[arg(long)]
    caps: bool,
    /// Tell whether the circles or spheres are admissible, and which rules they break, as JSON that counts them from 0;
    /// nothing is written
    #[arg(long, conflicts_with_all = ["plain", "caps", "output", "to", "force", "no_clobber"])]
    check: bool,
    /// Where to write: .svg, .pdf, .png, .json, .step; of spheres also .stl, .obj, .ply
    #[arg(short, long, value_name = "OUT", required_unless_present = "check")]
    output: Option<PathBuf>,
    /// Format of what is written (svg, pdf, png, json, step, stl, obj, ply), where no name says it
    #[arg(long, value_name = "EXT", value_parser = Wanted::parse, add = words(&NAMES))]
    to: Option<Wanted>,
    #[command(flatten)]
    overwrite: Overwrite,
}

/// What is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Wanted {
    Json,
    Other(Format),
}

impl Wanted {
    fn parse(text: &str) -> Result<Wanted, String> {
        if text.eq_ignore_ascii_case("json") {
            return Ok(Wanted::Json);
        }
        Format::parse(text).map(Wanted::Other).map_err(|_| FORMATS.to_owned())
    }
}

const NAMES: [&str; 8] = ["svg", "pdf", "png", "json", "step", "stl", "obj", "ply"];

const FORMATS: &str = "skins are written as .svg .pdf .png .json .step, of spheres also as .stl .obj .ply";

impl SkinCommand {
    /// Computes and writes.
    pub(crate) fn run(&self) -> Result<(), Failure> {
        let wanted = if self.check { Wanted::Json } else { self.wanted()? };
        apart(&self.source.file, self.output.as_deref())?;
        let opened = self.source.open()?;
        let name = opened.name;
        let document = match opened.document {
            Document::Circles(document) => document,
            Document::Spheres(document) => return self.of_spheres(&name, &document),
            _ => {
                let message = format!("{name} holds no circles or spheres; files .KOR and .GOM do");
                return Err(Failure::work(message));
            }
        };
        let circles = circles(&document).map_err(|error| Failure::work(format!("{name}: {error}")))?;
        let violations = circles.violations();
        if self.check {
            return check(&name, &violations, "circle");
        }
        let alive = progress::alive("putting on the skin");
        let skin = circles.skin(if self.plain { Clearing::Plain } else { Clearing::Scaled });
        if !skin.is_whole() {
            return Err(complain(&name, &violations, "circle", skin.missing.first().copied()));
        }
        if self.caps && wanted == Wanted::Json {
            return Err(Failure::usage(
                "--caps is for pictures and .step; JSON tells the arcs, and closes nothing",
            ));
        }
        let content = match wanted {
            Wanted::Json => format!("{}\n", written(&circles, &skin)).into_bytes(),
            Wanted::Other(format) => self.content(&circles, &skin, format)?,
        };
        drop(alive);
        if let Some(violation) = violations.first() {
            say("grafika", &format!("{name} is not admissible: {violation}"));
        }
        self.overwrite.write(self.output.as_deref(), &content)
    }

    fn wanted(&self) -> Result<Wanted, Failure> {
        if let Some(to) = self.to {
            return Ok(to);
        }
        let path = self.output.as_deref();
        let extension = extension(path).ok_or_else(|| {
            Failure::usage(format!("-o - has no extension; say it, as in --to svg: {FORMATS}"))
        })?;
        let shown = path.map(|path| path.display().to_string()).unwrap_or_default();
        Wanted::parse(&extension).map_err(|why| Failure::usage(format!("-o {shown}: {why}")))
    }

    fn content(&self, circles: &Circles, skin: &Skin, format: Format) -> Result<Vec<u8>, Failure> {
        let outlines = outlines(skin, self.caps);
        if format == Format::Step {
            let curves: Vec<_> = outlines.iter().map(outline_step).collect();
            return curves_step(&curves, &self.part_name()).map(String::into_bytes).map_err(Failure::work);
        }
        if format.is_model() {
            return Err(Failure::usage("meshes are of spheres; the skin of circles is a curve"));
        }
        let mut figure = Figure::new();
        figure.plot_discs(circles.circles()).map_err(Failure::work)?;
        for outline in &outlines {
            figure.plot_outline(outline, CURVE_INK, false).map_err(Failure::work)?;
        }
        picture(&figure, format, NOMINAL_WIDTH)
    }

    /// The name of the part in .step.
    fn part_name(&self) -> String {
        let stem = self.output.as_deref().and_then(|path| path.file_stem());
        stem.map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
    }
}

/// Why something of a skin is missing: the rule that is broken, else where.
fn complain(name: &str, violations: &[Violation], noun: &str, missing: Option<usize>) -> Failure {
    let why = match (violations.first(), missing) {
        (Some(violation), _) => violation.sentence(noun),
        (None, Some(number)) => format!("nothing touches {noun} {}", number + 1),
        (None, None) => format!("a single {noun} has none"),
    };
    Failure::work(format!("{name}: there is no whole skin: {why}"))
}

/// Tells whether circles or spheres are admissible.
fn check(name: &str, violations: &[Violation], noun: &str) -> Result<(), Failure> {
    let rows: Vec<Value> =
        violations.iter().map(|it| json!({ "rule": it.rule(), "circles": it.numbers() })).collect();
    let answer = json!({ "admissible": rows.is_empty(), "violations": rows });
    write_output(format!("{answer}\n").as_bytes())?;
    match violations {
        [] => Ok(()),
        all => {
            let sentences: Vec<String> = all.iter().map(|violation| violation.sentence(noun)).collect();
            Err(Failure::work(format!("{name} is not admissible: {}", sentences.join("; "))))
        }
    }
}

/// A skin as JSON: chains and rings by their sides, trees by their outlines.
fn written(circles: &Circles, skin: &Skin) -> Value {
    if let Links::Edges(_) = circles.links() {
        let loops = skin.loops.iter().map(|outline| outline.pieces.iter().map(piece).collect::<Vec<_>>());
        return json!({
            "format": "SKN", "touch": [], "left": [], "right": [],
            "loops": loops.collect::<Vec<_>>(), "unclear": skin.unclear(),
        });
    }
    let touch = skin
        .sides()
        .into_iter()
        .enumerate()
        .map(|(circle, [left, right])| json!({ "circle": circle, "left": left, "right": right }));
    let sides = [Side::Left, Side::Right].map(|side| skin.side_arcs(side));
    let unclear = sides.iter().flatten().filter(|arc| !arc.clear).map(|arc| arc.circles);
    let [left, right] = sides.each_ref().map(|side| side.iter().map(arc).collect::<Vec<_>>());
    json!({
        "format": "SKN", "touch": touch.collect::<Vec<_>>(), "left": left, "right": right,
        "loops": [], "unclear": unclear.collect::<Vec<_>>(),
    })
}

fn piece(piece: &Piece) -> Value {
    match piece {
        Piece::Arc(it) => arc(it),
        Piece::Cap(cap) => json!({ "cap": cap.circle, "start": cap.start, "end": cap.end }),
    }
}

fn arc(arc: &SkinArc) -> Value {
    json!({ "circles": arc.circles, "bezier": arc.bezier.p, "scale": arc.scale })
}
