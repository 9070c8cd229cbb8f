//! What the page does for the module.

use wasm_bindgen::prelude::*;

#[wasm_bindgen]
extern "C" {
    /// What outlives the page: an object of it with these methods.
    #[wasm_bindgen(typescript_type = "Host")]
    pub type Host;

    /// A text of a few lines by its name, if there is one.
    #[wasm_bindgen(method)]
    pub fn recall(this: &Host, name: &str) -> Option<String>;

    /// Keeps such a text. Throws why it cannot.
    #[wasm_bindgen(method, catch)]
    pub fn remember(this: &Host, name: &str, text: &str) -> Result<(), JsValue>;

    /// A file has been saved.
    #[wasm_bindgen(method)]
    pub fn saved(this: &Host, name: &str, content: &[u8]);

    /// Unsaved work, which replaces that of before.
    #[wasm_bindgen(method, js_name = keepWork)]
    pub fn keep_work(this: &Host, program: &str, file: Option<String>, content: &str);

    /// Nothing is unsaved any more.
    #[wasm_bindgen(method, js_name = forgetWork)]
    pub fn forget_work(this: &Host);

    /// What becomes of lost work: `taken`, `deleted`, `later` or `broken`.
    #[wasm_bindgen(method, js_name = settleWork)]
    pub fn settle_work(this: &Host, id: &str, verdict: &str);
}
