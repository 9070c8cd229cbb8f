//! F_P_SPLN; all of it is [`grafika::programs::f_p_spln`].

fn main() -> std::process::ExitCode {
    grafika::programs::f_p_spln::PROGRAM.main()
}
