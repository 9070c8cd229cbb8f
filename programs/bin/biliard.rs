//! BILIARD; all of it is [`grafika::programs::biliard`].

fn main() -> std::process::ExitCode {
    grafika::programs::biliard::PROGRAM.main()
}
