//! Damaged data files: bits flipped, ends cut off, bytes replaced, parts of other files put in. Every one
//! is refused with a reason or gives a document that is written and read again without a change.
//!
//! `GRAFIKA_MUTATIONS` is the number of damaged files for each format (20 000 unless told).

use grafika::file::{CsangoCube, Document, Format, Net, NetKind};

/// xorshift64*: the same damage in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 >> 12;
        self.0 ^= self.0 << 25;
        self.0 ^= self.0 >> 27;
        self.0.wrapping_mul(0x2545_f491_4f6c_dd1d)
    }

    fn below(&mut self, end: usize) -> usize {
        (self.next() >> 33) as usize % end.max(1)
    }
}

/// Sound files of a format.
fn seeds(format: Format) -> Vec<Vec<u8>> {
    let reference: &[&[u8]] = match format {
        Format::Ip2 => &[include_bytes!("files/SIX.IP2"), include_bytes!("files/GAUSS.IP2")],
        Format::Ic2 => &[include_bytes!("files/CH.IC2")],
        Format::Ec2 => &[include_bytes!("files/CH.EC2")],
        Format::Gbp => &[include_bytes!("files/FIGA.GBP")],
        Format::Ip3 => &[include_bytes!("files/CUBE.IP3")],
        Format::Fhc => &[include_bytes!("files/TESZT.FHC")],
        Format::Fem => &[include_bytes!("files/TESZT.FEM")],
        Format::Zms => &[include_bytes!("files/TESZT.ZMS")],
        Format::Gyk => &[include_bytes!("files/AKB.GYK")],
        Format::Csk => &[include_bytes!("files/SOL1.CSK")],
        _ => &[],
    };
    let mut seeds: Vec<_> = reference.iter().map(|bytes| bytes.to_vec()).collect();
    if format == Format::Csk {
        seeds.push(Document::CsangoCube(CsangoCube::start()).write(format).unwrap());
    }
    if let (true, Some(kind)) = (seeds.is_empty(), NetKind::of(format)) {
        let [rows, columns] = kind.shape();
        let row = |k| (0..columns).map(|l| [k as f64 * 10.5, l as f64 - 2.0, -1e9]).collect();
        seeds.push(Document::Net(Net::new(kind, (0..rows).map(row).collect())).write(format).unwrap());
    }
    seeds
}

/// Damages a file in one of several ways, perhaps more than once.
fn damage(bytes: &mut Vec<u8>, seeds: &[Vec<u8>], random: &mut Random) {
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        match random.below(8) {
            0 => bytes.truncate(at),
            1 => bytes.extend(std::iter::repeat_n(0xaa, random.below(20))),
            2 => {
                // A part of another file, or of this one from elsewhere.
                let other = &seeds[random.below(seeds.len())];
                let from = random.below(other.len());
                let length = random.below(64).min(other.len() - from).min(bytes.len() - at);
                bytes[at..at + length].copy_from_slice(&other[from..from + length]);
            }
            3 => {
                let end = (at + 1 + random.below(16)).min(bytes.len());
                bytes[at.min(end)..end].fill([0, 0x7f, 0x80, 0xff][random.below(4)]);
            }
            4 | 5 => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte = random.next() as u8;
                }
            }
            _ => {
                if let Some(byte) = bytes.get_mut(at) {
                    *byte ^= 1 << random.below(8);
                }
            }
        }
    }
}

/// Reads damaged files of a format; how many of them were read.
fn sweep(format: Format, count: usize) -> usize {
    let seeds = seeds(format);
    let mut random = Random(0x9e37_79b9_7f4a_7c15 + format as u64);
    let mut read = 0;
    for number in 0..count {
        let mut bytes = seeds[random.below(seeds.len())].clone();
        damage(&mut bytes, &seeds, &mut random);
        match Document::read(format, &bytes) {
            Ok(document) => {
                read += 1;
                let written = document.write(format).unwrap_or_else(|e| panic!("{format} {number}: {e}"));
                assert_eq!(Document::read(format, &written).as_ref(), Ok(&document), "{format} {number}");
                // Text is slow: a part of them is enough.
                if read % 64 == 0 {
                    let json = document.to_json().unwrap_or_else(|e| panic!("{format} {number}: {e}"));
                    assert_eq!(Document::from_json(&json).as_ref(), Ok(&document), "{format} {number}");
                    assert!(!document.describe().is_empty());
                }
            }
            Err(error) => assert!(error.to_string().len() > 10, "{format} {number}: {error}"),
        }
    }
    read
}

#[test]
fn damaged_files_give_a_value_or_a_reason() {
    let count = std::env::var("GRAFIKA_MUTATIONS").ok().and_then(|n| n.parse().ok()).unwrap_or(20_000);
    for format in Format::dos() {
        let start = std::time::Instant::now();
        let read = sweep(format, count);
        println!("{format}: {count} files, {read} read, {:.1} s", start.elapsed().as_secs_f64());
        assert!(read > 0, "{format}: no damaged file was harmless");
    }
}

#[test]
fn damaged_json_gives_a_value_or_a_reason() {
    let mut random = Random(77);
    for format in Format::dos() {
        let texts: Vec<_> = seeds(format)
            .iter()
            .map(|bytes| Document::read(format, bytes).unwrap().to_json().unwrap().into_bytes())
            .collect();
        for _ in 0..200 {
            let mut bytes = texts[random.below(texts.len())].clone();
            damage(&mut bytes, &texts, &mut random);
            match Document::from_json(&String::from_utf8_lossy(&bytes)) {
                Ok(document) => {
                    let json = document.to_json().unwrap();
                    assert_eq!(Document::from_json(&json), Ok(document));
                }
                Err(error) => assert!(error.to_string().len() > 10, "{error}"),
            }
        }
    }
}
