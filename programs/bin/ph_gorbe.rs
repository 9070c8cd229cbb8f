//! PH_GORBE; all of it is [`grafika::programs::ph_gorbe`].

fn main() -> std::process::ExitCode {
    grafika::programs::ph_gorbe::PROGRAM.main()
}
