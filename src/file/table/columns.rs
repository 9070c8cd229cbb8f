//! Which columns hold the coordinates: by their names, or because there are no others.

use super::options::{Column, Columns, TableOptions};

/// The names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Words that may stand beside the name of an axis: `X position`, `y_mm`, `x-coordinate`.
const BESIDE: [&str; 27] = [
    "axis",
    "coord",
    "coordinate",
    "coordinates",
    "data",
    "pos",
    "position",
    "point",
    "points",
    "value",
    "values",
    "koordináta",
    "tengely",
    "érték",
    "pont",
    "nm",
    "um",
    "µm",
    "mm",
    "cm",
    "dm",
    "m",
    "km",
    "in",
    "ft",
    "px",
    "pixel",
];

/// Names of columns that count or measure time: no axis of space.
const NO_AXIS: [&str; 33] = [
    "#",
    "count",
    "date",
    "dátum",
    "frame",
    "i",
    "id",
    "idx",
    "idő",
    "index",
    "j",
    "k",
    "line",
    "n",
    "no",
    "no.",
    "nr",
    "nr.",
    "number",
    "row",
    "sample",
    "sec",
    "second",
    "seconds",
    "sorszám",
    "span",
    "step",
    "t",
    "time",
    "timestamp",
    "u",
    "v",
    "zeit",
];

/// Columns that hold the coordinates, in the order of the axes; two or three.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::file) struct Chosen(pub(in crate::file) Vec<usize>);

/// Why no columns are chosen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(in crate::file) enum Unchosen {
    /// Names do not tell anything.
    Unknown,
    /// Several columns have the name of one axis, or the one that was asked for.
    Twice(String),
    /// No column has the name that was asked for.
    Missing(String),
    /// More columns than axes, or some that do not look like axes.
    Many,
    /// Fewer columns of numbers than two.
    Few(usize),
}

impl Unchosen {
    /// What is wrong and what would be right, in a table with these names; without any, with so many columns.
    pub(in crate::file) fn problem(&self, names: &[String], width: usize) -> String {
        let option = TableOptions::COLUMNS;
        let there = || match names.is_empty() {
            true => format!("there are {width} columns without names"),
            false => format!("there are {}", listed(names)),
        };
        match self {
            Self::Twice(name) => {
                format!("more than one column is called \"{name}\"; say which by numbers, as in {option} 1,2")
            }
            Self::Missing(name) => format!("no column is called \"{name}\"; {}", there()),
            Self::Many if names.is_empty() => format!(
                "{width} columns of numbers without names; say which are the coordinates, as in {option} 1,2"
            ),
            Self::Unknown | Self::Many => {
                format!("which columns are the coordinates? Say it, as in {option} 1,2; {}", there())
            }
            Self::Few(0) => "there are no columns of numbers; a point needs two or three".to_owned(),
            Self::Few(_) => "there is one column of numbers; a point needs two or three".to_owned(),
        }
    }
}

/// Some names in quotes.
fn listed(names: &[String]) -> String {
    const MOST: usize = 12;
    let mut words: Vec<String> = names.iter().take(MOST).map(|name| format!("\"{name}\"")).collect();
    if names.len() > MOST {
        words.push("...".to_owned());
    }
    words.join(", ")
}

/// The columns that are called x and y, and perhaps z.
pub(in crate::file) fn by_axes(names: &[String]) -> Result<Chosen, Unchosen> {
    let mut found: [Option<usize>; 3] = [None; 3];
    let mut twice = None;
    for (column, name) in names.iter().enumerate() {
        let Some(axis) = axis(name) else { continue };
        if let Some(place) = found.get_mut(axis) {
            twice = if place.is_some() { twice.or(Some(axis)) } else { twice };
            *place = place.or(Some(column));
        }
    }
    match (found, twice) {
        ([Some(_), Some(_), _], Some(axis)) => {
            Err(Unchosen::Twice(AXES.get(axis).copied().unwrap_or_default().to_owned()))
        }
        ([Some(x), Some(y), z], None) => Ok(Chosen([Some(x), Some(y), z].into_iter().flatten().collect())),
        _ => Err(Unchosen::Unknown),
    }
}

/// The columns that a user has named, among columns with these names.
pub(in crate::file) fn by_option(columns: &Columns, names: &[String]) -> Result<Chosen, Unchosen> {
    let number = |column: &Column| match column {
        Column::Number(number) => Ok(number.saturating_sub(1)),
        Column::Name(wanted) => {
            let exact = |name: &&String| name.trim().to_lowercase() == wanted.trim().to_lowercase();
            let bare = |name: &&String| base(name) == base(wanted);
            let count = |is: &dyn Fn(&&String) -> bool| names.iter().filter(is).count();
            let place = |is: &dyn Fn(&&String) -> bool| names.iter().position(|name| is(&name));
            match (count(&exact), count(&bare)) {
                (1, _) => Ok(place(&exact).unwrap_or_default()),
                (0, 1) => Ok(place(&bare).unwrap_or_default()),
                (0, 0) => Err(Unchosen::Missing(wanted.clone())),
                _ => Err(Unchosen::Twice(wanted.clone())),
            }
        }
    };
    columns.list().iter().map(number).collect::<Result<_, _>>().map(Chosen)
}

/// The columns of numbers, if there are two, or three that may be those of space. There may be no names.
pub(in crate::file) fn by_numbers(numeric: Vec<usize>, names: &[String]) -> Result<Chosen, Unchosen> {
    let name = |column: &usize| names.get(*column).map_or("", String::as_str);
    let no_axis =
        |column: &usize| axis(name(column)).is_some() || NO_AXIS.contains(&base(name(column)).as_str());
    match numeric.len() {
        few @ 0..=1 => Err(Unchosen::Few(few)),
        2 => Ok(Chosen(numeric)),
        3 if !numeric.iter().any(no_axis) => Ok(Chosen(numeric)),
        _ => Err(Unchosen::Many),
    }
}

/// A name without its unit, in small letters: `x` of `X [mm]`, `x/mm`.
fn base(name: &str) -> String {
    let name = name.to_lowercase();
    let end = name.find(['[', '(', '{', '/', ':', '=']).unwrap_or(name.len());
    let bare = name.get(..end).unwrap_or("");
    let words: Vec<&str> =
        bare.split(['_', '-', ' ', ',', '\u{a0}', '\t']).filter(|word| !word.is_empty()).collect();
    words.join(" ")
}

/// The axis that a column is named after.
fn axis(name: &str) -> Option<usize> {
    // Another delimiter would take it off.
    if name.ends_with([',', ';']) {
        return None;
    }
    let base = base(name);
    let others = |axis: &str| {
        let rest: Vec<&str> = base.split(' ').filter(|word| *word != axis).collect();
        rest.len() + 1 == base.split(' ').count() && rest.iter().all(|word| BESIDE.contains(word))
    };
    AXES.iter().position(|axis| others(axis))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(text: &str) -> Vec<String> {
        text.split(';').map(str::to_owned).collect()
    }

    #[test]
    fn axes_have_many_names() {
        for name in
            ["x", "X", " x ", "X [mm]", "X, mm", "x (px)", "x/mm", "x_mm", "X-Axis", "pos_x", "X koordináta"]
        {
            assert_eq!(axis(name), Some(0), "{name}");
        }
        for name in ["", "xx", "x y", "max", "x1", "x error", "dx", "time", "mm", "x,"] {
            assert_eq!(axis(name), None, "{name}");
        }
        assert_eq!((axis("Y"), axis("z coord")), (Some(1), Some(2)));
    }

    #[test]
    fn columns_are_found_by_their_names() {
        let found = |text| by_axes(&names(text)).map(|chosen| chosen.0);
        assert_eq!(found("x;y"), Ok(vec![0, 1]));
        assert_eq!(found("Y [V];X [s]"), Ok(vec![1, 0]));
        assert_eq!(found("span;u;x;y;z"), Ok(vec![2, 3, 4]));
        assert_eq!(found("i;j;u;v;x;y;z"), Ok(vec![4, 5, 6]));
        assert_eq!(found("x;y;x"), Err(Unchosen::Twice("x".to_owned())));
        assert_eq!(found("x;z"), Err(Unchosen::Unknown));
        assert_eq!(found("time;volts"), Err(Unchosen::Unknown));
    }

    #[test]
    fn columns_are_found_because_there_are_no_others() {
        let found =
            |numeric: &[usize], text| by_numbers(numeric.to_vec(), &names(text)).map(|chosen| chosen.0);
        assert_eq!(found(&[0, 2], "time;note;volts"), Ok(vec![0, 2]));
        assert_eq!(found(&[0, 1, 2], "a;b;c"), Ok(vec![0, 1, 2]));
        assert_eq!(found(&[0, 1, 2], ""), Ok(vec![0, 1, 2]));
        assert_eq!(found(&[0, 1, 2], "Time (s);ch1;ch2"), Err(Unchosen::Many));
        assert_eq!(found(&[0, 1, 2], "x;y1;y2"), Err(Unchosen::Many));
        assert_eq!(found(&[0, 1, 2, 3], ""), Err(Unchosen::Many));
        assert_eq!(found(&[1], "a;b"), Err(Unchosen::Few(1)));
    }

    #[test]
    fn columns_are_found_as_the_user_says() {
        let found = |said: &str, text| by_option(&said.parse().unwrap(), &names(text)).map(|chosen| chosen.0);
        assert_eq!(found("volts,2", "time;note;Volts (V)"), Ok(vec![2, 1]));
        assert_eq!(found("Volts (V),Volts", "Volts;Volts (V)"), Ok(vec![1, 0]));
        assert_eq!(found("a,b", "a;c"), Err(Unchosen::Missing("b".to_owned())));
        assert_eq!(found("a,b", "a;b;b"), Err(Unchosen::Twice("b".to_owned())));
    }
}
