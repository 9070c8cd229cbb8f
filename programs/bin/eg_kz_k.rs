//! EG_KZ_K; all of it is [`grafika::programs::eg_kz_k`].

fn main() -> std::process::ExitCode {
    grafika::programs::eg_kz_k::PROGRAM.main()
}
