//! ALAKPAR; all of it is [`grafika::programs::alakpar`].

fn main() -> std::process::ExitCode {
    grafika::programs::alakpar::PROGRAM.main()
}
