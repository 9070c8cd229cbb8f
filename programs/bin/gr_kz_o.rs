//! GR_KZ_O; all of it is [`grafika::programs::gr_kz_o`].

fn main() -> std::process::ExitCode {
    grafika::programs::gr_kz_o::PROGRAM.main()
}
