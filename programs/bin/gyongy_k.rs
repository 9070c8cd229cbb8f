//! GYONGY_K; all of it is [`grafika::programs::gyongy_k`].

fn main() -> std::process::ExitCode {
    grafika::programs::gyongy_k::PROGRAM.main()
}
