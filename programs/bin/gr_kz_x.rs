//! GR_KZ_X; all of it is [`grafika::programs::gr_kz_x`].

fn main() -> std::process::ExitCode {
    grafika::programs::gr_kz_x::PROGRAM.main()
}
