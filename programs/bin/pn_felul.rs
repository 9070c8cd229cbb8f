//! PN_FELUL; all of it is [`grafika::programs::pn_felul`].

fn main() -> std::process::ExitCode {
    grafika::programs::pn_felul::PROGRAM.main()
}
