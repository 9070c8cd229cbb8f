//! F_P_HSPL; all of it is [`grafika::programs::f_p_hspl`].

fn main() -> std::process::ExitCode {
    grafika::programs::f_p_hspl::PROGRAM.main()
}
