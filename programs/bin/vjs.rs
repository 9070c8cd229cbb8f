//! VJS; all of it is [`grafika::programs::vjs`].

fn main() -> std::process::ExitCode {
    grafika::programs::vjs::PROGRAM.main()
}
