//! ZY_BETSP; all of it is [`grafika::programs::zy_betsp`].

fn main() -> std::process::ExitCode {
    grafika::programs::zy_betsp::PROGRAM.main()
}
