//! Where the picture lies in a terminal.

use crate::screen::{HEIGHT, WIDTH};

/// The least columns and rows of a terminal that shows the picture in characters.
pub(super) const LEAST: (u16, u16) = (60, 20);

/// Columns and rows at which every letter of the picture has a cell of its own.
pub(super) const LETTERS: (usize, usize) = (80, 30);

/// A terminal's size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Extent {
    pub(super) columns: u16,
    pub(super) rows: u16,
    /// Width and height of a character cell in pixels, where the terminal tells.
    pub(super) cell: Option<(u16, u16)>,
}

/// The part of a terminal that the picture takes: cells for block characters, pixels for graphics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// The cell of the upper left corner, counted from 0.
    pub(super) column: u16,
    pub(super) row: u16,
    /// Width and height, in cells or pixels.
    pub(super) width: usize,
    pub(super) height: usize,
    /// Width and height of a cell in the unit of `width` and `height`.
    pub(super) cell: (u16, u16),
}

impl Place {
    /// The place for block characters; `None` when the terminal is too small.
    pub(super) fn of_blocks(extent: Extent) -> Option<Place> {
        let (columns, rows) = (usize::from(extent.columns), usize::from(extent.rows));
        if extent.columns < LEAST.0 || extent.rows < LEAST.1 {
            return None;
        }
        // The largest grid of the picture's proportions (a cell is twice as high as wide), but no column of letters
        // less for want of rows.
        let width = columns.min((rows * LETTERS.0 / LETTERS.1).max(LETTERS.0));
        let height = rows.min(width * LETTERS.1 / LETTERS.0);
        Some(Place {
            column: ((columns - width) / 2) as u16,
            row: ((rows - height) / 2) as u16,
            width,
            height,
            cell: (1, 1),
        })
    }

    /// The place for graphics: the largest whole factor, or the largest reduction of the picture to half
    /// its size at the least. `None` when the terminal is smaller than that or keeps its pixels secret.
    pub(super) fn of_graphics(extent: Extent) -> Option<Place> {
        let cell = extent.cell.filter(|&(width, height)| width > 0 && height > 0)?;
        // A picture that touches the last row would scroll some terminals.
        let rows = extent.rows.checked_sub(1)?;
        let room =
            (usize::from(extent.columns) * usize::from(cell.0), usize::from(rows) * usize::from(cell.1));
        let size = (WIDTH as usize, HEIGHT as usize);
        let (width, height) = match (room.0 / size.0).min(room.1 / size.1) {
            0 if room.0 * size.1 <= room.1 * size.0 => (room.0, room.0 * size.1 / size.0),
            0 => (room.1 * size.0 / size.1, room.1),
            factor => (size.0 * factor, size.1 * factor),
        };
        if width < size.0 / 2 || height < size.1 / 2 {
            return None;
        }
        // Less than a terminal's columns and rows, which are 16 bits each.
        let column = (room.0 - width) / 2 / usize::from(cell.0);
        let row = (room.1 - height) / 2 / usize::from(cell.1);
        Some(Place { column: column as u16, row: row as u16, width, height, cell })
    }

    /// The number of the picture's cell at a place of the terminal, where the picture is made of cells.
    pub(super) fn cell_at(&self, column: f64, row: f64) -> Option<usize> {
        let within = |cells: f64, from: u16, count: usize| {
            let at = (cells - f64::from(from)).floor();
            (at >= 0.0 && at < count as f64).then_some(at as usize)
        };
        let column = within(column, self.column, self.width)?;
        Some(within(row, self.row, self.height)? * self.width + column)
    }

    /// The same in whole cells, as Kitty's graphics are placed.
    pub(super) fn in_whole_cells(self) -> Place {
        let whole = |size: usize, cell: u16| size - size % usize::from(cell.max(1));
        Place { width: whole(self.width, self.cell.0), height: whole(self.height, self.cell.1), ..self }
    }

    /// The pixel of the picture under a place of the terminal, given in cells and parts of cells; outside
    /// of the picture the nearest one.
    pub(super) fn pixel_at(&self, column: f64, row: f64) -> (i32, i32) {
        let along = |cells: f64, cell: u16, shown: usize, size: i32| {
            let pixel = cells * f64::from(cell) * f64::from(size) / shown.max(1) as f64;
            // The conversion saturates and turns a NaN into 0.
            (pixel.floor() as i32).clamp(0, size - 1)
        };
        (
            along(column - f64::from(self.column), self.cell.0, self.width, WIDTH),
            along(row - f64::from(self.row), self.cell.1, self.height, HEIGHT),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn extent(columns: u16, rows: u16, cell: Option<(u16, u16)>) -> Extent {
        Extent { columns, rows, cell }
    }

    #[test]
    fn blocks_fill_a_terminal_of_the_least_size() {
        let place = Place::of_blocks(extent(80, 30, None)).unwrap();
        assert_eq!((place.column, place.row, place.width, place.height), (0, 0, 80, 30));
        assert_eq!(place.pixel_at(0.5, 0.5), (4, 8));
        assert_eq!(place.pixel_at(79.5, 29.5), (636, 472));
        assert_eq!(place.pixel_at(-3.0, 99.0), (0, 479));
        let wide = Place::of_blocks(extent(200, 45, None)).unwrap();
        assert_eq!((wide.column, wide.row, wide.width, wide.height), (40, 0, 120, 45));
        let size = |columns, rows| Place::of_blocks(extent(columns, rows, None)).map(|p| (p.width, p.height));
        assert_eq!(size(80, 24), Some((80, 24)));
        assert_eq!(size(120, 24), Some((80, 24)));
        assert_eq!(size(80, 60), Some((80, 30)));
        assert_eq!(size(60, 20), Some((60, 20)));
        assert_eq!(size(59, 20), None);
        assert_eq!(size(60, 19), None);
    }

    #[test]
    fn graphics_take_whole_factors_and_leave_the_last_row() {
        let place = Place::of_graphics(extent(100, 40, Some((10, 20)))).unwrap();
        assert_eq!((place.column, place.row, place.width, place.height), (18, 7, 640, 480));
        assert_eq!(place.pixel_at(18.0, 7.0), (0, 0));
        let large = Place::of_graphics(extent(200, 60, Some((10, 20)))).unwrap();
        assert_eq!((large.width, large.height), (1280, 960));
        let small = Place::of_graphics(extent(80, 24, Some((8, 16)))).unwrap();
        assert_eq!((small.width, small.height), (490, 368));
        assert_eq!(Place::of_graphics(extent(40, 12, Some((8, 16)))), None);
        assert_eq!(Place::of_graphics(extent(80, 24, None)), None);
        assert_eq!(Place::of_graphics(extent(80, 0, Some((8, 16)))), None);
    }
}
