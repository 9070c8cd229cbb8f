//! Documents packed into addresses: their JSON, deflated, in the letters of addresses.

use base64::Engine;
use base64::engine::general_purpose::URL_SAFE_NO_PAD;
use miniz_oxide::deflate::compress_to_vec;
use miniz_oxide::inflate::decompress_to_vec_with_limit;

/// The largest text that is unpacked: an address that holds more was not made here.
const LARGEST: usize = 16 << 20;

/// A text as part of an address.
pub(crate) fn packed(text: &str) -> String {
    // Blanks and new lines are for people.
    let short = serde_json::from_str::<serde_json::Value>(text).ok().map(|value| value.to_string());
    URL_SAFE_NO_PAD.encode(compress_to_vec(short.as_deref().unwrap_or(text).as_bytes(), 9))
}

/// The text in a part of an address, if it is whole.
pub(crate) fn unpacked(packed: &str) -> Option<String> {
    let deflated = URL_SAFE_NO_PAD.decode(packed.trim()).ok()?;
    let text = decompress_to_vec_with_limit(&deflated, LARGEST).ok()?;
    String::from_utf8(text).ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_packed_is_unpacked() {
        let text = "{\n  \"format\": \"ip2\",\n  \"points\": [[0.1, 200.0]]\n}";
        let there = packed(text);
        assert!(there.chars().all(|sign| sign.is_ascii_alphanumeric() || "-_".contains(sign)), "{there}");
        let value = |text: &str| serde_json::from_str::<serde_json::Value>(text).unwrap();
        assert_eq!(value(&unpacked(&there).unwrap()), value(text));
        for damaged in ["", "A", "AAAA", "%%%", &there[..there.len() / 2]] {
            assert_eq!(unpacked(damaged), None, "{damaged}");
        }
    }
}
