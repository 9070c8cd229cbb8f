//! What a game of billiards tells about itself.

use crate::table::{Game, Surface};

/// Facts about the game, one a line.
pub(super) fn describe(game: &Game) -> Vec<String> {
    let surface = match game.surface {
        Surface::Smooth => "smooth",
        Surface::Rough => "rough",
    };
    let mut lines = vec![format!("game of billiards, {} {surface} balls", game.balls.len())];
    if let Some(points) = game.points {
        let [first, second] = points.scores;
        lines.push(format!("points {first} : {second}, player {} is to play", points.turn + 1));
    }
    if let Some(shot) = &game.last {
        let [x, y] = shot.velocity;
        lines.push(format!("last shot: ball {}, {x}, {y} pixels a second", shot.ball + 1));
    }
    let balls = (1..).zip(&game.balls);
    lines.extend(balls.map(|(number, [x, y])| format!("ball {number}: {x}, {y}")));
    lines
}
