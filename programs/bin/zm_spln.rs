//! ZM_SPLN; all of it is [`grafika::programs::zm_spln`].

fn main() -> std::process::ExitCode {
    grafika::programs::zm_spln::PROGRAM.main()
}
