//! Room under construction.
/// stub
pub fn screen_png(screen: &crate::screen::Screen) -> Result<Vec<u8>, String> {
    let mut out = Vec::new();
    let mut e = png::Encoder::new(&mut out, 640, 480);
    e.set_color(png::ColorType::Indexed);
    e.set_depth(png::BitDepth::Four);
    e.set_palette(crate::screen::Color::ALL.iter().flat_map(|c| c.rgb()).collect::<Vec<u8>>());
    let mut w = e.write_header().map_err(|e| e.to_string())?;
    let data: Vec<u8> = screen.pixels().chunks(2).map(|p| p[0] << 4 | p[1]).collect();
    w.write_image_data(&data).map_err(|e| e.to_string())?;
    w.finish().map_err(|e| e.to_string())?;
    Ok(out)
}

pub fn curve_csv<const D: usize>(rows: impl Iterator<Item = (usize, f64, [f64; D])>) -> String {
    let mut s = String::new();
    s.push_str(if D == 2 { "span,u,x,y\n" } else { "span,u,x,y,z\n" });
    for (a, u, p) in rows {
        s.push_str(&format!("{a},{u}"));
        for c in p {
            s.push_str(&format!(",{c}"));
        }
        s.push('\n');
    }
    s
}
pub fn curve_json<const D: usize>(_rows: impl Iterator<Item = (usize, f64, [f64; D])>) -> String {
    String::new()
}
