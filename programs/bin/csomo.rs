//! CSOMO; all of it is [`grafika::programs::csomo`].

fn main() -> std::process::ExitCode {
    grafika::programs::csomo::PROGRAM.main()
}
