//! F_P_BEZR; all of it is [`grafika::programs::f_p_bezr`].

fn main() -> std::process::ExitCode {
    grafika::programs::f_p_bezr::PROGRAM.main()
}
