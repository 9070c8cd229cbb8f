//! Tridiagonal systems of complex numbers, open and cyclic, by elimination with row exchanges.

use super::complex::Complex;

/// One row `[before, diagonal, after]`: the factors of the unknowns `i - 1`, `i` and `i + 1`. In the first and last
/// row of a cyclic system, neighbours are counted round the corner; in an open one these factors do not count.
pub(super) type Row = [Complex; 3];

/// Solves the system; `cyclic` ones have at least 3 rows. `None` where it is singular or a number overflows.
pub(super) fn solve(rows: &[Row], rhs: &[Complex], cyclic: bool) -> Option<Vec<Complex>> {
    if !cyclic || rows.len() < 3 {
        let [solution, _] = tridiagonal(rows, [rhs, rhs])?;
        return finite(solution);
    }
    // The last unknown apart: the others are `y - last * v`, where y solves the open system of the other rows for
    // the right-hand side, and v for the last unknown's column.
    let n = rows.len() - 1;
    let ([.., last_row], [.., last_value]) = (rows, rhs) else { return None };
    let mut column = vec![Complex::default(); n];
    column[0] = rows[0][0];
    column[n - 1] = column[n - 1] + rows[n - 1][2];
    let [mut solution, column] = tridiagonal(&rows[..n], [&rhs[..n], &column])?;
    let [before, diagonal, after] = *last_row;
    let pivot = diagonal - before * column[n - 1] - after * column[0];
    if pivot.norm() == 0.0 {
        return None;
    }
    let last = (*last_value - before * solution[n - 1] - after * solution[0]) / pivot;
    for (x, v) in solution.iter_mut().zip(&column) {
        *x = *x - last * *v;
    }
    solution.push(last);
    finite(solution)
}

/// The solutions of an open system for two right-hand sides.
fn tridiagonal(rows: &[Row], rhs: [&[Complex]; 2]) -> Option<[Vec<Complex>; 2]> {
    let n = rows.len();
    let mut solution = rhs.map(<[Complex]>::to_vec);
    // Row i once finished: the factors of the unknowns i, i + 1 and i + 2.
    let mut upper: Vec<Row> = Vec::with_capacity(n);
    let zero = Complex::default();
    let mut current = rows.first().map_or([zero; 3], |[_, diagonal, after]| [*diagonal, *after, zero]);
    for i in 0..n {
        if let Some(&[before, diagonal, after]) = rows.get(i + 1) {
            let mut below = [before, diagonal, after];
            if below[0].norm() > current[0].norm() {
                std::mem::swap(&mut below, &mut current);
                for side in &mut solution {
                    side.swap(i, i + 1);
                }
            }
            if current[0].norm() == 0.0 {
                return None;
            }
            let factor = below[0] / current[0];
            for side in &mut solution {
                side[i + 1] = side[i + 1] - factor * side[i];
            }
            upper.push(current);
            current = [below[1] - factor * current[1], below[2] - factor * current[2], zero];
        } else {
            if current[0].norm() == 0.0 {
                return None;
            }
            upper.push(current);
        }
    }
    for side in &mut solution {
        for i in (0..n).rev() {
            let [pivot, next, second] = upper[i];
            let mut value = side[i];
            if i + 1 < n {
                value = value - next * side[i + 1];
            }
            if i + 2 < n {
                value = value - second * side[i + 2];
            }
            side[i] = value / pivot;
        }
    }
    Some(solution)
}

fn finite(values: Vec<Complex>) -> Option<Vec<Complex>> {
    values.iter().all(|value| value.is_finite()).then_some(values)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn number() -> impl Strategy<Value = Complex> {
        (-3.0..3.0, -3.0..3.0).prop_map(|(re, im)| Complex::new(re, im))
    }

    proptest! {
        #[test]
        fn solutions_satisfy_the_equations(
            rows in proptest::collection::vec(proptest::array::uniform3(number()), 1..20),
            cyclic: bool,
            seed in number(),
        ) {
            // Row exchanges are needed here: the diagonal is not larger than the rest.
            let cyclic = cyclic && rows.len() >= 3;
            let n = rows.len();
            let rhs: Vec<Complex> = (0..n).map(|i| seed * Complex::unit(i as f64)).collect();
            let Some(x) = solve(&rows, &rhs, cyclic) else { return Ok(()) };
            let size = x.iter().fold(1.0_f64, |most, value| most.max(value.norm()));
            for (i, &[before, diagonal, after]) in rows.iter().enumerate() {
                let neighbour = |there: bool, k: usize| if there { x[k % n] } else { Complex::default() };
                let left = before * neighbour(cyclic || i > 0, i + n - 1)
                    + diagonal * x[i]
                    + after * neighbour(cyclic || i + 1 < n, i + 1);
                // The separate last unknown loses digits where the other rows are nearly singular.
                prop_assert!((left - rhs[i]).norm() < 1e-9 * size, "row {}", i);
            }
        }
    }

    #[test]
    fn singular_systems_have_no_solution() {
        let (one, zero) = (Complex::new(1.0, 0.0), Complex::default());
        assert_eq!(solve(&[[zero; 3]], &[one], false), None);
        assert_eq!(solve(&[[zero, one, one], [one, one, zero]], &[one, zero], false), None);
        // A zero on the diagonal alone does not matter.
        assert_eq!(
            solve(&[[zero, zero, one], [one, zero, zero]], &[one, zero], false),
            Some(vec![zero, one])
        );
    }
}
