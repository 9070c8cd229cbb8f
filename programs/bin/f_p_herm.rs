//! F_P_HERM; all of it is [`grafika::programs::f_p_herm`].

fn main() -> std::process::ExitCode {
    grafika::programs::f_p_herm::PROGRAM.main()
}
