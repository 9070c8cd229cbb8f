//! What the system says of files, in words.

use std::io::{Error, ErrorKind};

/// Why the system refused something, without its numbers: "there is no such file or folder".
#[must_use]
pub fn reason(error: &Error) -> String {
    let words = match error.kind() {
        ErrorKind::NotFound => "there is no such file or folder",
        ErrorKind::PermissionDenied if error.raw_os_error().is_some() => "you have no permission for this",
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
        assert_eq!(reason(&Error::other("the file is torn")), "the file is torn");
        assert_eq!(reason(&Error::from(ErrorKind::StorageFull)), "the disk is full");
    }
}
