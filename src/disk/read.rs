//! Reading what a command line or the environment names, whatever it is, within a limit.

use super::write::is_special;
use crate::machine::Stream;
use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

/// More than any file of these programs can have but a cloud of points, which is read piece by piece; a larger one is
/// refused before it fills the memory.
pub const LARGEST_FILE: u64 = 64 * 1024 * 1024;

/// The content of a file, or what comes through a pipe or from a device until it ends.
///
/// # Errors
/// The system's, that it is a folder, or that there is more than [`LARGEST_FILE`].
pub fn read_limited(path: &Path) -> io::Result<Vec<u8>> {
    let about = fs::metadata(path)?;
    if about.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "this is a folder, not a file"));
    }
    if about.is_file() && about.len() > LARGEST_FILE {
        return Err(too_long());
    }
    read_stream(File::open(path)?)
}

/// The content of a regular file. What is found in a folder, and not named by the user, is not waited for: a pipe
/// might never end.
///
/// # Errors
/// Those of [`read_limited`], or that it is a pipe or a device.
pub fn read_regular(path: &Path) -> io::Result<Vec<u8>> {
    check_regular(path).and_then(|()| read_limited(path))
}

/// The content of a file, pipe or device piece by piece, whatever its length.
///
/// # Errors
/// The system's, or that it is a folder.
pub fn open_stream(path: &Path) -> io::Result<Stream> {
    let about = fs::metadata(path)?;
    if about.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "this is a folder, not a file"));
    }
    let length = about.is_file().then_some(about.len());
    Ok(Stream { length, content: Box::new(File::open(path)?) })
}

/// The content of a regular file piece by piece; see [`read_regular`].
///
/// # Errors
/// Those of [`open_stream`], or that it is a pipe or a device.
pub(super) fn open_regular(path: &Path) -> io::Result<Stream> {
    check_regular(path).and_then(|()| open_stream(path))
}

fn check_regular(path: &Path) -> io::Result<()> {
    if is_special(&fs::metadata(path)?) {
        return Err(io::Error::other("this is a pipe or a device, not a regular file"));
    }
    Ok(())
}

/// All that a stream gives, such as standard input. The limit counts what has been read, because pipes and devices
/// tell no length.
///
/// # Errors
/// The system's, or that there is more than [`LARGEST_FILE`].
pub fn read_stream(stream: impl Read) -> io::Result<Vec<u8>> {
    let mut content = Vec::new();
    stream.take(LARGEST_FILE + 1).read_to_end(&mut content)?;
    if content.len() as u64 > LARGEST_FILE { Err(too_long()) } else { Ok(content) }
}

/// The text of some bytes.
///
/// # Errors
/// That they are not UTF-8, and where.
pub fn text(content: Vec<u8>) -> io::Result<String> {
    String::from_utf8(content).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        io::Error::new(io::ErrorKind::InvalidData, format!("this is not text in UTF-8 (byte {})", at + 1))
    })
}

fn too_long() -> io::Error {
    let message = format!(
        "this has more than {} MB; no file of these programs but a cloud of points has",
        LARGEST_FILE >> 20
    );
    io::Error::new(io::ErrorKind::FileTooLarge, message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_limit_counts_what_has_been_read() {
        assert_eq!(read_stream(&b"abc"[..]).unwrap(), b"abc");
        assert_eq!(read_stream(io::repeat(0)).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(read_limited(folder.path()).unwrap_err().kind(), io::ErrorKind::IsADirectory);
        let path = folder.path().join("long");
        File::create(&path).unwrap().set_len(LARGEST_FILE + 1).unwrap();
        assert_eq!(read_limited(&path).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
        File::create(&path).unwrap().set_len(LARGEST_FILE).unwrap();
        assert_eq!(read_limited(&path).unwrap().len() as u64, LARGEST_FILE);
        let stream = open_regular(&path).unwrap();
        assert_eq!(stream.length, Some(LARGEST_FILE));
        assert_eq!(
            open_stream(folder.path()).err().map(|error| error.kind()),
            Some(io::ErrorKind::IsADirectory)
        );
    }

    #[cfg(unix)]
    #[test]
    fn pipes_and_devices_are_read() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let writer = std::thread::spawn({
            let pipe = pipe.clone();
            move || fs::write(pipe, vec![7; 200_000]).unwrap()
        });
        assert!(read_regular(&pipe).is_err() && open_regular(&pipe).is_err());
        assert_eq!(read_limited(&pipe).unwrap(), vec![7; 200_000]);
        writer.join().unwrap();
        assert_eq!(read_limited(Path::new("/dev/zero")).unwrap_err().kind(), io::ErrorKind::FileTooLarge);
    }

    #[test]
    fn what_is_no_text_is_told_with_its_place() {
        assert!(text(b"ab\xff".to_vec()).unwrap_err().to_string().contains("byte 3"));
    }
}
