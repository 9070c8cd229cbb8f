//! ZY_SPLN; all of it is [`grafika::programs::zy_spln`].

fn main() -> std::process::ExitCode {
    grafika::programs::zy_spln::PROGRAM.main()
}
