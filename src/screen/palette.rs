//! How the 16 colours look on a display. A screen holds numbers; only a display turns them into light.

use super::Color;

/// A set of 16 shades for the 16 colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Palette {
    /// The shades of the VGA ([`Color::rgb`]).
    #[default]
    Vga,
    /// Amber on black, as monochrome monitors had it: every colour is as bright as its rank.
    Amber,
    /// Green on black, in the same way.
    Green,
    /// Dark shades darker and light ones lighter.
    Contrast,
    /// Shades that eyes with too little red or green still tell apart, after the colours of Okabe and Ito
    /// (2008).
    ColorBlind,
}

impl Palette {
    /// Every palette.
    pub const ALL: [Palette; 5] =
        [Palette::Vga, Palette::Amber, Palette::Green, Palette::Contrast, Palette::ColorBlind];

    /// The name by which settings know it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Palette::Vga => "vga",
            Palette::Amber => "amber",
            Palette::Green => "green",
            Palette::Contrast => "contrast",
            Palette::ColorBlind => "colorblind",
        }
    }

    /// The palette of a name.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Palette> {
        Palette::ALL.into_iter().find(|palette| palette.name() == name)
    }

    /// Red, green and blue of a colour.
    #[must_use]
    pub const fn rgb(self, color: Color) -> [u8; 3] {
        let index = color.index() as usize;
        match self {
            Palette::Vga => color.rgb(),
            Palette::Amber => glow([255, 176, 0], index),
            Palette::Green => glow([64, 255, 64], index),
            Palette::Contrast => CONTRAST[index],
            Palette::ColorBlind => COLOR_BLIND[index],
        }
    }
}

/// The ranks of the colours from the darkest to the lightest, by the luminance of their shades on the VGA.
const RANKS: [u16; 16] = [0, 1, 8, 9, 2, 4, 5, 11, 3, 6, 12, 13, 7, 10, 14, 15];

/// A monitor of one colour at the brightness of a rank.
const fn glow(full: [u8; 3], index: usize) -> [u8; 3] {
    let rank = RANKS[index];
    [
        (full[0] as u16 * rank / 15) as u8,
        (full[1] as u16 * rank / 15) as u8,
        (full[2] as u16 * rank / 15) as u8,
    ]
}

const CONTRAST: [[u8; 3]; 16] = [
    [0, 0, 0],
    [0, 0, 150],
    [0, 90, 0],
    [0, 95, 105],
    [150, 0, 0],
    [125, 0, 125],
    [105, 60, 0],
    [222, 222, 222],
    [50, 50, 50],
    [120, 170, 255],
    [110, 255, 110],
    [170, 255, 255],
    [255, 140, 130],
    [255, 165, 255],
    [255, 255, 60],
    [255, 255, 255],
];

const COLOR_BLIND: [[u8; 3]; 16] = [
    [0, 0, 0],
    [0, 60, 140],
    [18, 120, 70],
    [31, 143, 193],
    [103, 35, 12],
    [101, 79, 121],
    [136, 85, 5],
    [147, 147, 147],
    [75, 75, 75],
    [86, 150, 255],
    [0, 203, 135],
    [148, 198, 254],
    [235, 110, 20],
    [224, 187, 211],
    [240, 228, 66],
    [255, 255, 255],
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Light, linear, of a shade.
    fn linear(rgb: [u8; 3]) -> [f64; 3] {
        rgb.map(|level| {
            let level = f64::from(level) / 255.0;
            if level <= 0.04045 { level / 12.92 } else { ((level + 0.055) / 1.055).powf(2.4) }
        })
    }

    fn luminance(rgb: [u8; 3]) -> f64 {
        let [red, green, blue] = linear(rgb);
        0.2126 * red + 0.7152 * green + 0.0722 * blue
    }

    /// Lightness and two opponent colours (CIELAB, D65) of linear light.
    fn lab(light: [f64; 3]) -> [f64; 3] {
        let [r, g, b] = light.map(|x| x.clamp(0.0, 1.0));
        let xyz = [
            (0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.9505,
            0.2126 * r + 0.7152 * g + 0.0722 * b,
            (0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.089,
        ];
        let [x, y, z] = xyz.map(|t| if t > 0.008_856 { t.cbrt() } else { 7.787 * t + 16.0 / 116.0 });
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// What an eye without one kind of cones sees (Machado, Oliveira, Fernandes 2009, full severity).
    fn seen(matrix: [[f64; 3]; 3], rgb: [u8; 3]) -> [f64; 3] {
        let light = linear(rgb);
        lab(matrix.map(|row| row.iter().zip(light).map(|(a, b)| a * b).sum()))
    }

    const PROTANOPIA: [[f64; 3]; 3] = [
        [0.152_286, 1.052_583, -0.204_868],
        [0.114_503, 0.786_281, 0.099_216],
        [-0.003_882, -0.048_116, 1.051_998],
    ];
    const DEUTERANOPIA: [[f64; 3]; 3] = [
        [0.367_322, 0.860_646, -0.227_968],
        [0.280_085, 0.672_501, 0.047_413],
        [-0.011_820, 0.042_940, 0.968_881],
    ];

    /// The least distance of two colours of a palette as an eye sees them.
    fn least_distance(palette: Palette, matrix: [[f64; 3]; 3]) -> f64 {
        let shades = Color::ALL.map(|color| seen(matrix, palette.rgb(color)));
        let pairs = (0..16).flat_map(|a| (0..a).map(move |b| (a, b)));
        let distance = |(a, b): (usize, usize)| {
            shades[a].iter().zip(shades[b]).map(|(p, q)| (p - q).powi(2)).sum::<f64>().sqrt()
        };
        pairs.map(distance).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn every_palette_has_16_shades_from_black_to_its_lightest() {
        for palette in Palette::ALL {
            let shades = Color::ALL.map(|color| palette.rgb(color));
            assert_eq!(shades[0], [0, 0, 0]);
            for (a, shade) in shades.iter().enumerate() {
                assert!(shades[..a].iter().all(|other| other != shade), "{palette:?} {a}");
                assert!(luminance(*shade) <= luminance(shades[15]), "{palette:?} {a}");
            }
            assert_eq!(Palette::from_name(palette.name()), Some(palette));
        }
    }

    #[test]
    fn monitors_of_one_colour_keep_the_order_of_brightness() {
        for palette in [Palette::Amber, Palette::Green] {
            for a in Color::ALL {
                for b in Color::ALL {
                    let by_vga = luminance(a.rgb()).total_cmp(&luminance(b.rgb()));
                    assert_eq!(by_vga, luminance(palette.rgb(a)).total_cmp(&luminance(palette.rgb(b))));
                }
            }
        }
    }

    #[test]
    fn contrast_grows() {
        for color in Color::ALL {
            let (before, after) = (luminance(color.rgb()), luminance(Palette::Contrast.rgb(color)));
            let dark = color.index() < 7 || color == Color::DarkGray;
            assert!(
                if dark { after <= before } else { after >= before * 0.99 },
                "{color:?} {before} {after}"
            );
        }
    }

    #[test]
    fn eyes_without_red_or_green_tell_all_colours_apart() {
        for eye in [PROTANOPIA, DEUTERANOPIA] {
            let (vga, own) = (least_distance(Palette::Vga, eye), least_distance(Palette::ColorBlind, eye));
            assert!(own > 15.0 && own > 1.5 * vga, "{vga} {own}");
        }
    }
}
