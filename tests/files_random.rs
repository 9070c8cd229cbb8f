//! Random documents: text keeps every double, DOS files keep what they can.

use grafika::file::cube::{PIECES, ROTATIONS};
use grafika::file::{
    BeadWheel, CsangoCube, Document, Format, Fourier, Net, NetKind, PlanePoints, SpacePoints,
};
use proptest::prelude::*;

fn finite() -> impl Strategy<Value = f64> {
    prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO
}

/// The 40 significant bits of a 6-byte real.
fn nearest_real(value: f64) -> f64 {
    let step = 2f64.powi(value.abs().log2().floor() as i32 - 39);
    if value == 0.0 { 0.0 } else { (value / step).round_ties_even() * step }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn text_keeps_every_double(
        points in prop::collection::vec([finite(), finite(), finite()], 0..120),
        row in prop::collection::vec(finite(), 21),
    ) {
        let bits = |points: &[[f64; 3]]| points.iter().flatten().map(|v| v.to_bits()).collect::<Vec<_>>();
        let document = Document::SpacePoints(SpacePoints::new(points.clone()));
        for text in [Document::from_json(&document.to_json()?)?, Document::from_csv(&document.to_csv()?)?] {
            let Document::SpacePoints(SpacePoints { points: found, .. }) = text else { panic!("points in space") };
            prop_assert_eq!(bits(&found), bits(&points));
        }
        let mut fourier = Fourier::default();
        fourier.a.copy_from_slice(&row);
        fourier.q.copy_from_slice(&row);
        let document = Document::Fourier(Box::new(fourier));
        prop_assert_eq!(Document::from_json(&document.to_json()?)?, document);
    }

    #[test]
    fn plane_points_and_tangents_come_back(
        rows in prop::collection::vec((0i16..=560, 0i16..=380, any::<[i16; 2]>()), 0..=99),
    ) {
        let points = PlanePoints {
            points: rows.iter().map(|&(x, y, _)| [x, y].map(f64::from)).collect(),
            tangents: Some(rows.iter().map(|&(_, _, t)| t.map(f64::from)).collect()),
            ..PlanePoints::default()
        };
        let document = Document::PlanePoints(points.clone());
        let Document::PlanePoints(found) = Document::read(Format::Ic2, &document.write(Format::Ic2)?)? else {
            panic!("points")
        };
        let Document::Tangents(twin) = Document::read(Format::Ec2, &document.write(Format::Ec2)?)? else {
            panic!("tangents")
        };
        for (tangent, &(x, y, [u, v])) in twin.tangents.iter().zip(&rows) {
            // The tip is half the vector from the point, within the rounding of an odd vector.
            let [tip_x, tip_y] = tangent.tip.map(i32::from);
            prop_assert!((2 * (tip_x - 41 - i32::from(x)) - i32::from(u)).abs() <= 1);
            prop_assert!((2 * (450 - i32::from(y) - tip_y) - i32::from(v)).abs() <= 1);
        }
        prop_assert_eq!(found.with_tangents(&twin), points);
    }

    #[test]
    fn space_points_keep_forty_bits(points in prop::collection::vec(any::<[i32; 3]>(), 0..=99), scale in 1e-9..1e9f64) {
        let points: Vec<_> = points.iter().map(|p| p.map(|v| f64::from(v) * scale)).collect();
        let bytes = Document::SpacePoints(SpacePoints::new(points.clone())).write(Format::Ip3)?;
        let expected = points.iter().map(|p| p.map(nearest_real)).collect();
        prop_assert_eq!(Document::read(Format::Ip3, &bytes)?, Document::SpacePoints(SpacePoints::new(expected)));
        let mut order: Vec<_> = (1..=points.len()).map(|k| i16::from_le_bytes([bytes[30 * k + 28], bytes[30 * k + 29]])).collect();
        order.sort_unstable();
        prop_assert!(order.into_iter().eq(1..=points.len() as i16), "each point has its turn");
    }

    #[test]
    fn nets_keep_singles(kind in prop::sample::select(&NetKind::ALL[..]), seed in any::<[[f32; 3]; 40]>()) {
        let [rows, columns] = kind.shape();
        let value = |v: f32| f64::from(if v.is_finite() { v } else { 0.5 });
        let row = |k: usize| (0..columns).map(|l| seed[5 * k + l].map(value)).collect();
        let document = Document::Net(Net::new(kind, (0..rows).map(row).collect()));
        prop_assert_eq!(Document::read(kind.format(), &document.write(kind.format())?)?, document.clone());
        prop_assert_eq!(Document::from_json(&document.to_json()?)?, document);
    }

    #[test]
    fn wheels_after_any_moves_are_possible(moves in prop::collection::vec(0usize..9, 0..60)) {
        let mut wheel = BeadWheel::solved();
        for step in moves {
            match step {
                // Push a drawer in by one bead through the centre.
                arm @ 0..6 if wheel.drawers[arm] > -1 => {
                    let opposite = (arm + 3) % 6;
                    for ring in (1..5).rev() {
                        wheel.rings[ring][opposite] = wheel.rings[ring - 1][opposite];
                    }
                    wheel.rings[0][opposite] = wheel.centre;
                    wheel.centre = wheel.rings[0][arm];
                    for ring in 0..4 {
                        wheel.rings[ring][arm] = wheel.rings[ring + 1][arm];
                    }
                    wheel.rings[4][arm] = 15;
                    wheel.drawers[arm] -= 2;
                    wheel.drawers[opposite] += 2;
                }
                0..6 => {}
                ring => wheel.rings[ring - 6].rotate_right(1),
            }
        }
        let document = Document::BeadWheel(wheel);
        prop_assert_eq!(document.check(), Ok(()));
        prop_assert_eq!(Document::read(Format::Gyk, &document.write(Format::Gyk)?)?, document.clone());
        prop_assert_eq!(Document::from_json(&document.to_json()?)?, document);
    }

    #[test]
    fn cubes_with_turned_pieces_come_back(
        changes in prop::collection::vec((0..PIECES, 0..24usize, [0..10i8, 0..10i8, 0..7i8]), 0..40),
    ) {
        let mut cube = CsangoCube::start();
        for (piece, rotation, cell) in changes {
            let mut next = cube;
            next.pieces[piece].rotation = ROTATIONS[rotation];
            next.pieces[piece].cell = cell;
            if next.check().is_ok() {
                cube = next;
            }
        }
        let document = Document::CsangoCube(cube);
        prop_assert_eq!(Document::read(Format::Csk, &document.write(Format::Csk)?)?, document.clone());
        prop_assert_eq!(Document::from_json(&document.to_json()?)?, document);
    }
}
