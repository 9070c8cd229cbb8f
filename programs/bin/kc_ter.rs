//! KC_TER; all of it is [`grafika::programs::kc_ter`].

fn main() -> std::process::ExitCode {
    grafika::programs::kc_ter::PROGRAM.main()
}
