//! F_P_BSPL; all of it is [`grafika::programs::f_p_bspl`].

fn main() -> std::process::ExitCode {
    grafika::programs::f_p_bspl::PROGRAM.main()
}
