//! ZM_BETSP; all of it is [`grafika::programs::zm_betsp`].

fn main() -> std::process::ExitCode {
    grafika::programs::zm_betsp::PROGRAM.main()
}
