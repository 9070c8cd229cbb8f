//! What the system says of files, in words.

use std::io::{Error, ErrorKind};

/// Why the system refused something, without its numbers: "there is no such file".
#[must_use]
pub fn reason(error: &Error) -> String {
    // What says itself what is wrong is not the system's.
    if error.get_ref().is_some() {
        return error.to_string();
    }
    let words = match error.kind() {
        ErrorKind::NotFound => "there is no such file",
        ErrorKind::PermissionDenied => "you have no permission for this",
        ErrorKind::AlreadyExists => "there is one of this name already",
        ErrorKind::IsADirectory => "this is a folder, not a file",
        ErrorKind::NotADirectory => "a part of the path is a file, not a folder",
        ErrorKind::StorageFull => "the disk is full",
        ErrorKind::QuotaExceeded => "you have no more room on this disk",
        ErrorKind::FileTooLarge => "the file would be too large for this disk",
        ErrorKind::ReadOnlyFilesystem => "the disk is write-protected",
        ErrorKind::ResourceBusy => "something else uses it now",
        ErrorKind::InvalidFilename => "this cannot be a name on this disk",
        _ => {
            let text = error.to_string();
            return text.split(" (os error").next().unwrap_or(&text).to_owned();
        }
    };
    words.to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_numbers_of_the_system_are_told() {
        for number in 1..=130 {
            let told = reason(&Error::from_raw_os_error(number));
            assert!(!told.contains("os error") && !told.is_empty(), "{number}: {told}");
        }
        assert_eq!(reason(&Error::from_raw_os_error(2)), "there is no such file");
        let own = |kind| reason(&Error::new(kind, "the file is torn"));
        assert_eq!(own(ErrorKind::Other), "the file is torn");
        assert_eq!(own(ErrorKind::FileTooLarge), "the file is torn");
        assert_eq!(reason(&Error::from(ErrorKind::StorageFull)), "the disk is full");
    }
}
