//! TELEPIT; all of it is [`grafika::programs::telepit`].

fn main() -> std::process::ExitCode {
    grafika::programs::telepit::PROGRAM.main()
}
