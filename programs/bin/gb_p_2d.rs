//! GB_P_2D; all of it is [`grafika::programs::gb_p_2d`].

fn main() -> std::process::ExitCode {
    grafika::programs::gb_p_2d::PROGRAM.main()
}
