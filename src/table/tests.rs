//! Tests of the whole table: what is kept in every hit, on the break and in clusters, and other ways to the
//! same result.

use super::*;
use proptest::prelude::*;

const SLIDING: Cloth = Cloth { damping: 1.0, stop: 0.0, surface: Surface::Smooth };

fn distance(a: &Ball, b: &Ball) -> f64 {
    let [x, y] = [a.at[0] - b.at[0], a.at[1] - b.at[1]];
    (x * x + y * y).sqrt()
}

/// How far the two balls that are deepest in each other overlap; negative if none touch.
fn overlap(balls: &[Ball]) -> f64 {
    let pairs =
        balls.iter().enumerate().flat_map(|(i, a)| balls[i + 1..].iter().map(move |b| distance(a, b)));
    2.0 * RADIUS - pairs.fold(f64::INFINITY, f64::min)
}

fn ball(at: Vector, velocity: Vector) -> Ball {
    Ball { at, velocity, spin: 0.0 }
}

fn table(cloth: Cloth, balls: &[Ball]) -> Table {
    Table::new(Field::BILIARD, cloth, balls.to_vec()).unwrap()
}

fn break_shot(velocity: Vector) -> Table {
    let mut table = Table::rack();
    table.shoot(0, velocity, 0.0).unwrap();
    table
}

/// Steps a table and checks energy, momentum between walls, and overlaps all the way.
fn check_steps(table: &mut Table, steps: u64) -> usize {
    let mut hits = 0;
    for _ in 0..steps {
        let damping = table.cloth().damping;
        let energy = table.energy() * damping * damping;
        let momentum = table.momentum().map(|p| p * damping);
        let mut walls = 0;
        table.step_seeing(|hit| {
            hits += 1;
            walls += usize::from(matches!(hit.obstacle, Obstacle::Wall(_)));
        });
        if table.at_rest() {
            break;
        }
        assert!((table.energy() - energy).abs() <= 1e-12 * energy, "{} {energy}", table.energy());
        if walls == 0 {
            let size = (2.0 * energy).sqrt();
            for (now, before) in table.momentum().into_iter().zip(momentum) {
                assert!((now - before).abs() <= 1e-12 * size);
            }
        }
        let overlap = overlap(table.balls());
        assert!(overlap <= OVERLAP, "{overlap}");
        assert!(table.balls().iter().all(|ball| table.field().holds(ball.at)));
    }
    hits
}

#[test]
fn breaks_lose_no_energy_and_no_ball_enters_another() {
    for velocity in [[300.0, 0.0], [500.0, 6.0], [140.0, -180.0], [535.0, 0.0], [4000.0, 17.0]] {
        let mut table = break_shot(velocity);
        let hits = check_steps(&mut table, 10_000);
        assert!(table.at_rest());
        assert!(hits > 20, "{hits}");
        println!("{velocity:?}: {hits} hits");
    }
}

#[test]
fn the_book_s_shot_agrees_up_to_the_first_hit() {
    let text = include_str!("../../tests/reference/games/biliard_shot1.csv");
    let mut table = break_shot([300.0, 0.0]);
    let mut compared = 0;
    for line in text.lines().skip(1) {
        let row: Vec<f64> = line.split(',').map(|number| number.parse().unwrap()).collect();
        for (ball, theirs) in table.balls().iter().zip(row[1..].chunks(4)) {
            let ours = [ball.at[0], ball.at[1], ball.velocity[0], -ball.velocity[1]];
            for (a, b) in ours.iter().zip(theirs) {
                assert!((a - b).abs() < 1e-6, "step {}: {a} {b}", row[0]);
            }
        }
        compared += 1;
        let mut hit = false;
        table.step_seeing(|_| hit = true);
        if hit {
            break;
        }
    }
    assert!(compared > 30, "{compared}");
}

#[test]
fn the_break_gives_the_same_bits_everywhere() {
    let mut table = break_shot([500.0, 6.0]);
    table.advance(1935);
    // FNV-1a over the bits of all numbers; a change here changes every recorded game.
    let numbers = table.balls().iter().flat_map(|ball| [ball.at, ball.velocity]).flatten();
    let bytes = numbers.flat_map(|number| number.to_bits().to_le_bytes());
    let hash = bytes.fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
    });
    assert_eq!(format!("{hash:016x}"), "26e9527767003c94");
}

#[test]
fn two_balls_head_on_swap_their_velocities() {
    let mut table = table(SLIDING, &[ball([100.0, 100.0], [310.0, 0.0]), ball([120.0, 100.0], [0.0, 0.0])]);
    table.step();
    assert!((table.balls()[0].at[0] - 104.0).abs() < 1e-12);
    assert!((table.balls()[1].at[0] - (120.0 + 310.0 * STEP - 4.0)).abs() < 1e-12);
    assert_eq!([table.balls()[0].velocity, table.balls()[1].velocity], [[0.0, 0.0], [310.0, 0.0]]);
}

#[test]
fn a_row_of_touching_balls_passes_the_hit_on_within_one_step() {
    let mut balls: Vec<Ball> =
        (0..10).map(|i| ball([100.0 + 16.0 * f64::from(i), 200.0], [0.0; 2])).collect();
    balls.push(ball([80.0, 200.0], [300.0, 0.0]));
    let mut table = table(SLIDING, &balls);
    let hits = check_steps(&mut table, 1);
    assert_eq!(hits, 10);
    assert_eq!(table.balls()[9].velocity, [300.0, 0.0]);
}

/// The picture of a ball in a mirror through the middle of the table, which is horizontal.
fn mirrored(ball: &Ball) -> Ball {
    let [[x, y], [vx, vy]] = [ball.at, ball.velocity];
    Ball { at: [x, 2.0 * 240.0 - y], velocity: [vx, -vy], spin: -ball.spin }
}

#[test]
fn a_ball_between_two_touching_ones_sends_them_off_symmetrically() {
    let pair = [ball([300.0, 232.0], [0.0; 2]), ball([300.0, 248.0], [0.0; 2])];
    for surface in [Surface::Smooth, Surface::Rough] {
        // Whatever the order of the balls' numbers.
        for at in 0..3 {
            let mut balls = pair.to_vec();
            balls.insert(at, ball([270.0, 240.0], [600.0, 0.0]));
            let mut table = table(Cloth { surface, ..SLIDING }, &balls);
            let foretold = table.first_hit(at, [600.0, 0.0], 0.0).unwrap();
            assert_eq!(check_steps(&mut table, 2), 2);
            let shot = table.balls()[at];
            assert!(shot.velocity[1].abs() < 1e-12 && shot.spin.abs() < 1e-12, "{shot:?}");
            let [one, other] = [(at + 1) % 3, (at + 2) % 3].map(|ball| table.balls()[ball]);
            let image = mirrored(&other);
            assert!(distance(&one, &image) < 1e-11 && (one.spin - image.spin).abs() < 1e-12);
            assert!(one.velocity[0] > 300.0 && (one.velocity[0] - image.velocity[0]).abs() < 1e-11);
            // The aiming line shows both.
            assert_eq!(foretold.passed_on.len(), 2);
            for (ball, velocity) in foretold.passed_on {
                for (foretold, now) in velocity.into_iter().zip(table.balls()[ball].velocity) {
                    assert!((foretold - now).abs() < 1e-9);
                }
            }
            assert!((foretold.after[0] - shot.velocity[0]).abs() < 1e-9);
        }
    }
}

#[test]
fn smooth_balls_hit_at_once_leave_along_their_lines_of_centres() {
    let h = 8.0 * 3f64.sqrt();
    let mut table = table(
        SLIDING,
        &[
            ball([300.0 - h, 240.0], [500.0, 0.0]),
            ball([300.0, 232.0], [0.0; 2]),
            ball([300.0, 248.0], [0.0; 2]),
        ],
    );
    check_steps(&mut table, 1);
    // By energy and momentum: the shot ball comes back with a fifth of its speed.
    let [shot, up, down] = [0, 1, 2].map(|ball| table.balls()[ball].velocity);
    assert!((shot[0] + 100.0).abs() < 1e-9 && (up[0] - 300.0).abs() < 1e-9 && (down[0] - 300.0).abs() < 1e-9);
    assert!((up[1] + 100.0 * 3f64.sqrt()).abs() < 1e-9 && (down[1] + up[1]).abs() < 1e-9);
}

#[test]
fn a_straight_break_begins_symmetrically() {
    let images = [(0, 0), (1, 1), (2, 3), (4, 6), (5, 5), (7, 10), (8, 9)];
    let mut table = break_shot([300.0, 0.0]);
    let mut hits = 0;
    while hits < 4 {
        table.step_seeing(|_| hits += 1);
        for (ball, image) in images {
            let [ball, image] = [table.balls()[ball], mirrored(&table.balls()[image])];
            assert!(distance(&ball, &image) < 1e-9, "{ball:?} {image:?}");
        }
    }
}

#[test]
fn a_loop_of_touching_balls_hit_from_all_sides_at_once_stays_regular() {
    // Seven balls in a hexagon; six come along its spokes. More contacts than directions that balls can move in.
    let around = |radius: f64| {
        (0..6).map(move |spoke| {
            let (sin, cos) = (f64::from(spoke) * std::f64::consts::FRAC_PI_3).sin_cos();
            ([320.0 + radius * cos, 240.0 + radius * sin], [-400.0 * cos, -400.0 * sin])
        })
    };
    let mut balls = vec![ball([320.0, 240.0], [0.0; 2])];
    balls.extend(around(16.0 + 1e-10).map(|(at, _)| ball(at, [0.0; 2])));
    balls.extend(around(36.0).map(|(at, velocity)| ball(at, velocity)));
    let mut table = table(SLIDING, &balls);
    check_steps(&mut table, 3);
    let center = table.balls()[0];
    assert!(distance(&center, &balls[0]) < 1e-6, "{center:?}");
    let far: Vec<f64> = table.balls()[7..].iter().map(|ball| distance(ball, &center)).collect();
    assert!(far.iter().all(|it| (it - far[0]).abs() < 1e-6), "{far:?}");
}

#[test]
fn clusters_hit_from_both_sides_at_once_come_to_an_end() {
    // A full hexagon of touching balls; three are shot at it at the same time.
    let h = 16.0 * 3f64.sqrt() / 2.0 + 1e-12;
    let mut balls = Vec::new();
    for (row, count) in (0..).zip([3, 4, 5, 4, 3]) {
        let y = 240.0 + h * f64::from(row - 2);
        let x = 320.0 - 8.0 * f64::from(count - 1);
        balls.extend((0..count).map(|i| ball([x + 16.0 * f64::from(i), y], [0.0; 2])));
    }
    balls.push(ball([220.0, 240.0], [400.0, 0.0]));
    balls.push(ball([420.0, 240.0], [-400.0, 0.0]));
    balls.push(ball([320.0, 150.0], [0.0, 400.0]));
    let mut table = table(Cloth::default(), &balls);
    assert!(check_steps(&mut table, 5000) > 100);
}

#[test]
fn a_ball_jammed_between_ball_and_wall_comes_free() {
    let mut table = table(SLIDING, &[ball([60.0, 44.0], [-500.0, -1.0]), ball([44.0, 44.0], [-10.0, -10.0])]);
    check_steps(&mut table, 1000);
}

#[test]
fn backwards_in_time_the_balls_come_back() {
    // The rack with gaps: hits at the very same time have an order, which backwards is another one.
    let spread = |at: Vector| [428.0 + 1.5 * (at[0] - 428.0), 240.0 + 1.5 * (at[1] - 240.0)];
    let mut balls: Vec<Ball> = RACK[1..].iter().map(|&at| Ball::resting(spread(at))).collect();
    balls.push(ball([60.0, 240.0], [300.0, 3.0]));
    let mut table = table(SLIDING, &balls);
    let before = table.clone();
    let mut hits = 0;
    for _ in 0..42 {
        table.step_seeing(|_| hits += 1);
    }
    assert!(hits > 2, "{hits}");
    for ball in &mut table.balls {
        ball.velocity = ball.velocity.map(|v| -v);
    }
    table.advance(42);
    for (a, b) in table.balls().iter().zip(before.balls()) {
        assert!(distance(a, b) < 1e-6, "{a:?} {b:?}");
    }
}

/// The same physics by tiny steps, checking every pair: slow, but with nothing in common.
fn creep(balls: &mut [Ball], field: &Field, seconds: f64, parts: u32) {
    let dt = seconds / f64::from(parts);
    for _ in 0..parts {
        for ball in balls.iter_mut() {
            for axis in 0..2 {
                ball.at[axis] += ball.velocity[axis] * dt;
                let out = ball.at[axis] < field.min[axis] && ball.velocity[axis] < 0.0
                    || ball.at[axis] > field.max[axis] && ball.velocity[axis] > 0.0;
                if out {
                    ball.velocity[axis] = -ball.velocity[axis];
                }
            }
        }
        for i in 0..balls.len() {
            for j in i + 1..balls.len() {
                let n = [0, 1].map(|k| (balls[j].at[k] - balls[i].at[k]) / distance(&balls[i], &balls[j]));
                let speed: f64 = (0..2).map(|k| (balls[i].velocity[k] - balls[j].velocity[k]) * n[k]).sum();
                if distance(&balls[i], &balls[j]) < 16.0 && speed > 0.0 {
                    for (k, along) in n.into_iter().enumerate() {
                        balls[i].velocity[k] -= speed * along;
                        balls[j].velocity[k] += speed * along;
                    }
                }
            }
        }
    }
}

#[test]
fn tiny_steps_come_to_the_same_place() {
    let start = [
        ball([100.0, 200.0], [300.0, 20.0]),
        ball([160.0, 210.0], [-20.0, 10.0]),
        ball([260.0, 208.0], [-100.0, 55.0]),
        ball([60.0, 52.0], [-140.0, -180.0]),
    ];
    let mut exact = table(SLIDING, &start);
    let mut hits = 0;
    for _ in 0..20 {
        exact.step_seeing(|_| hits += 1);
    }
    assert!(hits >= 3, "{hits}");
    let mut crept = start;
    creep(&mut crept, &Field::BILIARD, 20.0 * STEP, 2_000_000);
    for (a, b) in exact.balls().iter().zip(&crept) {
        assert!(distance(a, b) < 2e-3, "{a:?} {b:?}");
    }
}

#[test]
fn the_stop_rule_ends_all_at_once() {
    let mut table =
        table(Cloth::default(), &[ball([100.0, 100.0], [0.1, 0.1]), ball([200.0, 100.0], [0.0, 0.05])]);
    table.step();
    assert!(table.at_rest());
    assert_ne!(table.balls()[0].at, [100.0, 100.0]);
    let before = table.clone();
    assert_eq!(table.advance(5), 0);
    assert_eq!(table, before);
}

#[test]
fn what_lies_between_two_steps_leads_to_the_next() {
    let mut table = break_shot([500.0, 6.0]);
    table.advance(22);
    let whole = table.within_step(STEP);
    assert_eq!(table.within_step(0.0).balls()[3].at, table.balls()[3].at);
    assert!(table.within_step(f64::NAN).balls()[0].at == table.balls()[0].at);
    table.step();
    assert_eq!(whole, table);
}

#[test]
fn a_spinning_ball_bends_at_the_wall_and_energy_is_kept() {
    let rough = Cloth { surface: Surface::Rough, ..SLIDING };
    let mut spinning = table(rough, &[Ball { spin: 30.0, ..ball([100.0, 50.0], [0.0, -300.0]) }]);
    let energy = spinning.energy();
    spinning.step();
    let after = spinning.balls()[0];
    assert_eq!(after.velocity[1], 300.0);
    assert!(after.velocity[0].abs() > 50.0, "{after:?}");
    assert!((spinning.energy() - energy).abs() < 1e-12 * energy);
}

#[test]
fn what_cannot_be_is_refused() {
    let new = |balls: &[Ball]| Table::new(Field::BILIARD, Cloth::default(), balls.to_vec());
    let there = ball([100.0, 100.0], [0.0; 2]);
    let near = ball([110.0, 100.0], [0.0; 2]);
    assert_eq!(new(&[there, near]), Err(TableError::Overlap { balls: [0, 1], distance: 10.0 }));
    assert_eq!(new(&[ball([1.0, 100.0], [0.0; 2])]), Err(TableError::Outside { ball: 0 }));
    assert_eq!(new(&[ball([f64::NAN, 100.0], [0.0; 2])]), Err(TableError::Outside { ball: 0 }));
    assert_eq!(new(&[ball([100.0, 100.0], [f64::INFINITY, 0.0])]), Err(TableError::TooFast { ball: 0 }));
    let field = Field { min: [0.0, f64::NAN], max: [1.0, 1.0] };
    assert_eq!(Table::new(field, Cloth::default(), vec![]), Err(TableError::Field));
    let cloth = Cloth { damping: 1.5, ..Cloth::default() };
    assert_eq!(Table::new(Field::BILIARD, cloth, vec![]), Err(TableError::Cloth));
    assert_eq!(Table::rack().shoot(11, [0.0; 2], 0.0), Err(TableError::NoBall { ball: 11, count: 11 }));
    assert!(Table::rack().shoot(0, [0.0, f64::NAN], 0.0).is_err());
}

#[test]
fn an_aimed_shot_hits_what_was_foretold() {
    for velocity in [[300.0, 0.0], [500.0, 6.0], [-3.0, 1.0], [20.0, -44.0], [0.5, 0.0], [100.0, 0.0]] {
        let mut table = break_shot(velocity);
        let foretold = Table::rack().first_hit(0, velocity, 0.0).unwrap();
        let mut first = None;
        while first.is_none() && !table.at_rest() {
            let before = table.clone();
            table.step_seeing(|hit| first = first.or(Some(hit)));
            if let Some(hit) = first {
                let at = before.within_step(hit.time).balls()[0].at;
                assert!(distance(&Ball::resting(at), &Ball::resting(foretold.at)) < 1e-6);
            }
        }
        assert_eq!(first.map(|hit| hit.obstacle), foretold.obstacle, "{velocity:?}");
        if first.is_none() {
            assert!(distance(&table.balls()[0], &Ball::resting(foretold.at)) < 0.02);
        }
    }
    assert_eq!(Table::rack().first_hit(0, [f64::NAN, 0.0], 0.0), None);
    assert_eq!(Table::rack().first_hit(99, [1.0, 0.0], 0.0), None);
    assert_eq!(Table::rack().first_hit(0, [0.0, 0.0], 0.0).unwrap().obstacle, None);
}

/// Many balls in a field of its own, on a loose grid so that none overlap.
fn crowd(count: usize, seed: u64) -> Table {
    let columns = (count as f64).sqrt().ceil() as usize;
    let mut state = seed;
    let mut random = || {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let balls = (0..count).map(|i| {
        let at = [(i % columns) as f64, (i / columns) as f64].map(|x| 20.0 * x + 10.0 + 2.0 * random());
        ball(at, [600.0 * random(), 600.0 * random()])
    });
    let side = 20.0 * columns as f64;
    Table::new(Field { min: [0.0; 2], max: [side; 2] }, SLIDING, balls.collect()).unwrap()
}

#[test]
fn cells_find_the_same_hits_as_comparing_all() {
    // A crowd of 24 is compared without cells; with a far-off row of resting balls added it goes by cells.
    let few = crowd(24, 5);
    let mut balls = few.balls().to_vec();
    balls.extend((0..40).map(|i| ball([20.0 * f64::from(i), 900.0], [0.0; 2])));
    let field = Field { min: [-200.0; 2], max: [1000.0; 2] };
    let mut alone = Table::new(field, SLIDING, few.balls().to_vec()).unwrap();
    let mut among = Table::new(field, SLIDING, balls).unwrap();
    for _ in 0..30 {
        let mut hits = [Vec::new(), Vec::new()];
        alone.step_seeing(|hit| hits[0].push(hit));
        among.step_seeing(|hit| hits[1].push(hit));
        assert_eq!(hits[0], hits[1]);
        assert_eq!(alone.balls(), &among.balls()[..24]);
    }
}

#[test]
fn a_crowd_keeps_its_energy_and_its_distance() {
    let mut table = crowd(300, 3);
    assert!(check_steps(&mut table, 60) > 1000);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn any_break_keeps_all_that_is_to_be_kept(x in -600.0..600.0f64, y in -400.0..400.0f64, ball in 0usize..11) {
        let mut table = Table::rack();
        table.shoot(ball, [x, y], 0.0).unwrap();
        check_steps(&mut table, 400);
    }

    #[test]
    fn rough_balls_keep_it_too(x in -600.0..600.0f64, y in -400.0..400.0f64, spin in -70.0..70.0f64) {
        let mut table = Table::rack();
        table.cloth.surface = Surface::Rough;
        table.shoot(0, [x, y], spin).unwrap();
        check_steps(&mut table, 400);
    }

    #[test]
    fn a_dense_crowd_at_any_speed_ends(seed in any::<u64>(), speed in 1.0..16.0f64) {
        let mut table = crowd(30, seed);
        for ball in &mut table.balls {
            ball.velocity = ball.velocity.map(|v| v * speed);
        }
        check_steps(&mut table, 10);
    }
}
