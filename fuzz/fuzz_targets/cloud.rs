//! Any bytes as a cloud of points: refused with a reason, or points that are written and read again without a change.
//! Pieces of any length make no difference. The format comes from the first byte, the length of the pieces from the
//! second.
#![no_main]

use grafika::file::{Cloud, CloudFormat, CloudReader, FileError, TableOptions};
use libfuzzer_sys::fuzz_target;

const FORMATS: [CloudFormat; 5] =
    [CloudFormat::Xyz, CloudFormat::Csv, CloudFormat::Ply, CloudFormat::Obj, CloudFormat::Stl];

fn in_pieces(format: CloudFormat, bytes: &[u8], length: usize) -> Result<Cloud, FileError> {
    let mut reader = CloudReader::new(format, &TableOptions::default())?;
    for piece in bytes.chunks(length) {
        reader.feed(piece)?;
    }
    reader.finish()
}

fuzz_target!(|bytes: &[u8]| {
    let [first, second, bytes @ ..] = bytes else { return };
    let format = FORMATS[usize::from(*first) % FORMATS.len()];
    let read = Cloud::read(format, bytes);
    assert_eq!(in_pieces(format, bytes, usize::from(*second).max(1)), read);
    match read {
        Ok(cloud) => {
            assert!(!cloud.describe().is_empty());
            for format in &FORMATS[..4] {
                let written = cloud.write(*format).expect("what was read can be written");
                assert_eq!(
                    Cloud::read(*format, &written).map(|cloud| cloud.points).as_ref(),
                    Ok(&cloud.points)
                );
            }
        }
        Err(error) => assert!(!error.to_string().is_empty()),
    }
});
