//! BURKOLO; all of it is [`grafika::programs::burkolo`].

fn main() -> std::process::ExitCode {
    grafika::programs::burkolo::PROGRAM.main()
}
