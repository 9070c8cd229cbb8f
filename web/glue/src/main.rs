//! `glue MODULE.wasm FOLDER`: writes the module as a browser loads it, and the script that binds it.

#![forbid(unsafe_code)]

use std::process::ExitCode;
use wasm_bindgen_cli_support::Bindgen;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [module, folder] = arguments.as_slice() else {
        eprintln!("glue: give the module and the folder to write to");
        return ExitCode::from(2);
    };
    let mut glue = Bindgen::new();
    glue.input_path(module).typescript(false).remove_producers_section(true);
    let made = glue.web(true).and_then(|glue| glue.generate(folder));
    match made {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("glue: {module}: {error:#}");
            ExitCode::FAILURE
        }
    }
}
