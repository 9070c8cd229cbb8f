//! F_EM_SPL; all of it is [`grafika::programs::f_em_spl`].

fn main() -> std::process::ExitCode {
    grafika::programs::f_em_spl::PROGRAM.main()
}
