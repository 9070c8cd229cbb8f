//! CSANGO_K; all of it is [`grafika::programs::csango_k`].

fn main() -> std::process::ExitCode {
    grafika::programs::csango_k::PROGRAM.main()
}
